// SPDX-License-Identifier: BSD-3-Clause
// No writer leaves an incomplete file, wherever it stops.
#include "AtomicFile.h"
#include "IoTesting.h"

#include "vtkFloatArray.h"
#include "vtkHeightFieldPictureWriter.h"
#include "vtkHeightFieldWriter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>

#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace skyline_test;

namespace
{

/// An image whose arrays still have some tens of kB after compression.
vtkSmartPointer<vtkImageData> Noise(int columns, int rows)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, 1);
  vtkNew<vtkFloatArray> heights, light;
  vtkNew<vtkUnsignedCharArray> colors;
  heights->SetName("Elevation");
  light->SetName("Light");
  light->SetNumberOfComponents(3);
  colors->SetName("Colors");
  colors->SetNumberOfComponents(3);
  unsigned int state = 1;
  const auto next = [&state]
  {
    state = state * 1664525u + 1013904223u;
    return state >> 8;
  };
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(static_cast<float>(next()));
    light->InsertNextTuple3(next(), next(), next());
    colors->InsertNextTuple3(next() & 255, next() & 255, next() & 255);
  }
  image->GetPointData()->SetScalars(heights);
  image->GetPointData()->AddArray(light);
  image->GetPointData()->AddArray(colors);
  return image;
}

/// One of the five ways to write.
struct Way
{
  const char* Name;
  vtkSmartPointer<vtkHeightFieldFileWriter> Writer;
};

std::vector<Way> AllWays(vtkImageData* image)
{
  auto tiff = vtkSmartPointer<vtkHeightFieldWriter>::New();
  auto cloud = vtkSmartPointer<vtkHeightFieldWriter>::New();
  cloud->CloudOptimizedOn();
  const auto picture = [](const char* array)
  {
    auto writer = vtkSmartPointer<vtkHeightFieldPictureWriter>::New();
    writer->SetArrayName(array);
    return writer;
  };
  std::vector<Way> ways{ { "out.tif", tiff }, { "cog.tif", cloud },
    { "out.png", picture("Colors") }, { "out.exr", picture("Light") },
    { "picture.tif", picture("Light") } };
  for (Way& way : ways)
  {
    way.Writer->SetInputData(image);
  }
  return ways;
}

/// Returns the message of a write that must fail.
std::string Fail(vtkHeightFieldFileWriter* writer, const std::string& file)
{
  const Errors errors(writer);
  writer->SetFileName(file.c_str());
  EXPECT_EQ(writer->Write(), 0) << file;
  EXPECT_NE(writer->GetErrorCode(), vtkErrorCode::NoError) << file;
  EXPECT_EQ(errors.Count(), 1u) << file;
  EXPECT_EQ(errors.First().find('\n'), std::string::npos) << errors.First();
  return errors.First();
}

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

// The size of all files that the process writes is limited, from 0 to one byte less than the
// complete file needs. Each failing write must be noticed, even if it only happens when the file is
// closed.
TEST(WriterFailures, NoSpaceAtAnyPoint)
{
  const std::string folder = FreshFolder("limit");
  const auto image = Noise(150, 101);
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit unlimited;
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &unlimited), 0);
  for (const Way& way : AllWays(image))
  {
    const std::string file = folder + "/" + way.Name;
    way.Writer->SetFileName(file.c_str());
    ASSERT_EQ(way.Writer->Write(), 1) << way.Name;
    const auto size = static_cast<rlim_t>(std::filesystem::file_size(file));
    std::filesystem::remove(file);
    std::vector<rlim_t> limits{ 0, 1, 7, 8, 100, size - 1, size - 2, size - 100 };
    for (rlim_t part = 1; part < 16; ++part)
    {
      limits.push_back(size * part / 16);
    }
    for (const rlim_t limit : limits)
    {
      rlimit limited = unlimited;
      limited.rlim_cur = limit;
      ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limited), 0);
      const Errors errors(way.Writer);
      const int written = way.Writer->Write();
      ::setrlimit(RLIMIT_FSIZE, &unlimited);
      EXPECT_EQ(written, 0) << way.Name << " within " << limit << " of " << size;
      EXPECT_EQ(errors.Count(), 1u) << way.Name << " within " << limit;
      EXPECT_TRUE(Contains(errors.First(), "cannot write '" + file + "'")) << errors.First();
      EXPECT_TRUE(FilesIn(folder).empty()) << way.Name << " within " << limit;
    }
  }
  std::signal(SIGXFSZ, SIG_DFL);
}

TEST(WriterFailures, FullDisk)
{
  const std::string folder = FreshFolder("tmpfs");
  if (::mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=64k") != 0)
  {
    GTEST_SKIP() << "needs the right to mount a small file system";
  }
  const auto image = Noise(400, 300);
  for (const Way& way : AllWays(image))
  {
    const std::string message = Fail(way.Writer, folder + "/" + way.Name);
    EXPECT_TRUE(Contains(message, "No space left on device; free some space")) << message;
    EXPECT_EQ(way.Writer->GetErrorCode(), vtkErrorCode::OutOfDiskSpaceError);
    EXPECT_TRUE(FilesIn(folder).empty()) << way.Name;
  }
  ::umount(folder.c_str());
}

TEST(WriterFailures, FullDevice)
{
  const auto image = Noise(20, 10);
  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetInputData(image);
  EXPECT_TRUE(Contains(Fail(writer, "/dev/full"), "No space left on device"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));

  const std::string folder = FreshFolder("full");
  std::filesystem::create_symlink("/dev/full", folder + "/full.png");
  vtkNew<vtkHeightFieldPictureWriter> picture;
  picture->SetInputData(image);
  picture->SetArrayName("Colors");
  EXPECT_TRUE(Contains(Fail(picture, folder + "/full.png"), "No space left on device"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(WriterFailures, FolderThatIsNotThere)
{
  const std::string file = FreshFolder("absent") + "/none/out.tif";
  vtkNew<vtkHeightFieldWriter> writer;
  const auto image = Noise(20, 10);
  writer->SetInputData(image);
  EXPECT_EQ(Fail(writer, file),
    "cannot write '" + file + "': No such file or directory; make its folder first");
  EXPECT_EQ(writer->GetErrorCode(), vtkErrorCode::CannotOpenFileError);
}

TEST(WriterFailures, WrongExtensionArrayOrInput)
{
  const auto image = Noise(20, 10);
  vtkNew<vtkHeightFieldWriter> writer;
  EXPECT_TRUE(Contains(Fail(writer, OutputPath("x.tif")), "no input"));
  writer->SetInputData(image);
  EXPECT_TRUE(Contains(Fail(writer, ""), "SetFileName"));
  EXPECT_TRUE(Contains(Fail(writer, OutputPath("x.jpg")), "end the name in .tif"));
  writer->AddArray("Absent");
  const std::string message = Fail(writer, OutputPath("x.tif"));
  EXPECT_TRUE(Contains(message, "'Absent'; choose from: Elevation, Light, Colors")) << message;

  vtkNew<vtkHeightFieldPictureWriter> picture;
  picture->SetInputData(image);
  EXPECT_TRUE(Contains(Fail(picture, OutputPath("x.gif")), ".png, .exr or .tif"));
  EXPECT_TRUE(Contains(Fail(picture, OutputPath("x.png")), "unsigned char for .png"));
  picture->SetArrayName("Colors");
  EXPECT_TRUE(Contains(Fail(picture, OutputPath("x.exr")), "float for .exr"));

  vtkNew<vtkImageData> volume;
  volume->SetDimensions(3, 3, 3);
  volume->AllocateScalars(VTK_FLOAT, 1);
  vtkNew<vtkHeightFieldWriter> flat;
  flat->SetInputData(volume);
  EXPECT_TRUE(Contains(Fail(flat, OutputPath("x.tif")), "3 layers"));
}

// A crop made without the reader would be written to the wrong position.
TEST(WriterFailures, StaleGeoreference)
{
  const auto image = Noise(20, 10);
  skyline::Georeference place;
  place.Columns = 40;
  place.Rows = 10;
  place.HasGeoTransform = true;
  place.GeoTransform = { 0.0, 1.0, 0.0, 10.0, 0.0, -1.0 };
  skyline::StoreGeoreference(place, image);
  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetInputData(image);
  EXPECT_TRUE(
    Contains(Fail(writer, OutputPath("x.tif")), "40 x 10 posts, the height field has 20 x 10"));
}

TEST(WriterFailures, FailedInputWritesNothing)
{
  const std::string folder = FreshFolder("upstream");
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName((folder + "/absent.tif").c_str());
  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetInputConnection(reader->GetOutputPort());
  const Errors upstream(reader);
  const Errors errors(writer);
  writer->SetFileName((folder + "/out.tif").c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(upstream.Count(), 1u);
  EXPECT_EQ(errors.Count(), 0u);
  EXPECT_NE(writer->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_TRUE(FilesIn(folder).empty());
}

TEST(WriterFailures, AbortLeavesNothing)
{
  const std::string folder = FreshFolder("abort");
  const auto image = Noise(700, 600);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* object, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(object)->SetAbortExecute(1); });
  for (const Way& way : AllWays(image))
  {
    const std::string file = folder + "/" + way.Name;
    const Errors errors(way.Writer);
    const unsigned long tag = way.Writer->AddObserver(vtkCommand::ProgressEvent, stop);
    way.Writer->SetFileName(file.c_str());
    EXPECT_EQ(way.Writer->Write(), 0) << way.Name;
    EXPECT_EQ(errors.Count(), 0u) << errors.First();
    EXPECT_EQ(way.Writer->GetErrorCode(), vtkErrorCode::UserError) << way.Name;
    EXPECT_TRUE(FilesIn(folder).empty()) << way.Name;
    // A second attempt succeeds.
    way.Writer->RemoveObserver(tag);
    way.Writer->SetAbortExecute(0);
    EXPECT_EQ(way.Writer->Write(), 1) << way.Name;
    std::filesystem::remove(file);
  }
}

TEST(WriterFailures, SignalLeavesNothing)
{
  const std::string folder = FreshFolder("interrupt");
  const auto image = Noise(300, 200);
  for (const Way& way : AllWays(image))
  {
    const pid_t child = ::fork();
    if (child == 0)
    {
      std::signal(SIGINT,
        [](int)
        {
          skyline::RemoveTemporaries();
          ::_exit(130);
        });
      vtkNew<vtkCallbackCommand> interrupt;
      interrupt->SetCallback([](vtkObject*, unsigned long, void*, void*) { ::raise(SIGINT); });
      way.Writer->AddObserver(vtkCommand::ProgressEvent, interrupt);
      way.Writer->SetFileName((folder + "/" + way.Name).c_str());
      way.Writer->Write();
      ::_exit(1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status)) << way.Name;
    EXPECT_EQ(WEXITSTATUS(status), 130) << way.Name;
    EXPECT_TRUE(FilesIn(folder).empty()) << way.Name;
  }
}

// At the end the file is compared with the arrays. A number that changes in memory during the write
// is found, as one that was stored wrongly would be. So is a byte that changes in the file.
TEST(WriterFailures, WhatIsReadBackMustBeWhatWasWritten)
{
  const std::string folder = FreshFolder("verify");
  for (const bool inFile : { false, true })
  {
    const auto image = Noise(300, 200);
    struct Spoiler
    {
      vtkImageData* Image;
      std::string Folder;
      bool InFile;
      bool Done;
    };
    for (const Way& way : AllWays(image))
    {
      if (inFile && std::string(way.Name) == "picture.tif")
      {
        continue; // GDAL buffers everything until the file is closed
      }
      Spoiler spoiler{ image, folder, inFile, false };
      vtkNew<vtkCallbackCommand> spoil;
      spoil->SetClientData(&spoiler);
      spoil->SetCallback(
        [](vtkObject* object, unsigned long, void* data, void*)
        {
          auto* self = static_cast<Spoiler*>(data);
          constexpr double written = 0.89; // then the file is checked
          if (self->Done || vtkAlgorithm::SafeDownCast(object)->GetProgress() < written)
          {
            return;
          }
          self->Done = true;
          if (!self->InFile)
          {
            vtkPointData* points = self->Image->GetPointData();
            for (int i = 0; i < points->GetNumberOfArrays(); ++i)
            {
              vtkDataArray* array = points->GetArray(i);
              array->SetComponent(100, 0, array->GetComponent(100, 0) == 7.0 ? 8.0 : 7.0);
            }
            return;
          }
          for (const std::string& name : FilesIn(self->Folder))
          {
            std::fstream file(self->Folder + "/" + name);
            const auto middle = static_cast<std::streamoff>(
              std::filesystem::file_size(self->Folder + "/" + name) / 2);
            file.seekg(middle);
            const int byte = file.get();
            file.seekp(middle);
            file.put(static_cast<char>(~byte));
          }
        });
      const unsigned long tag = way.Writer->AddObserver(vtkCommand::ProgressEvent, spoil);
      const std::string message = Fail(way.Writer, folder + "/" + way.Name);
      way.Writer->RemoveObserver(tag);
      EXPECT_TRUE(spoiler.Done) << way.Name;
      const bool different =
        Contains(message, "is not what was written; the memory or the disk may be at fault");
      EXPECT_TRUE(different || (inFile && Contains(message, "read back")))
        << way.Name << ": " << message;
      EXPECT_TRUE(FilesIn(folder).empty()) << way.Name;
    }
  }
}

TEST(WriterFailures, SourcesAreNotReplaced)
{
  const std::string folder = FreshFolder("source");
  const std::string dem = folder + "/dem.tif";
  const auto image = Noise(30, 20);
  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(dem.c_str());
  ASSERT_EQ(writer->Write(), 1);
  std::filesystem::create_hard_link(dem, folder + "/hard.tif");
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(("GTIFF_DIR:1:" + dem).c_str());
  writer->SetInputConnection(reader->GetOutputPort());
  for (const char* name : { "/dem.tif", "/hard.tif", "/../source/dem.tif" })
  {
    const std::string message = Fail(writer, folder + name);
    EXPECT_TRUE(Contains(message, "part of the input")) << message;
  }
  writer->SetFileName((folder + "/other.tif").c_str());
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(FilesIn(folder).size(), 3u);
}

TEST(WriterFailures, ProgressRises)
{
  const std::string folder = FreshFolder("progress");
  const auto image = Noise(700, 600);
  for (const Way& way : AllWays(image))
  {
    std::vector<double> seen;
    vtkNew<vtkCallbackCommand> watch;
    watch->SetClientData(&seen);
    watch->SetCallback(
      [](vtkObject* object, unsigned long, void* list, void*)
      {
        static_cast<std::vector<double>*>(list)->push_back(
          vtkAlgorithm::SafeDownCast(object)->GetProgress());
      });
    way.Writer->AddObserver(vtkCommand::ProgressEvent, watch);
    way.Writer->SetFileName((folder + "/" + way.Name).c_str());
    EXPECT_EQ(way.Writer->Write(), 1);
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end())) << way.Name;
    ASSERT_FALSE(seen.empty());
    EXPECT_EQ(seen.back(), 1.0) << way.Name;
  }
}
