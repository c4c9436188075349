// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineLightMapReader.h"

#include "Data/LightMapImage.h"
#include "IoTesting.h"
#include "Sky/LightMap.h"
#include "Testing/Module/Sky/LightMapTesting.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include <sys/stat.h>

using namespace skyline_test;
using skyline::LightMap;
using skyline::ViewLightMap;

namespace
{

/// Half a unit in the last place of 11 bits.
constexpr double HalfBound = 1.0 / 2048.0;

/// Radiance files store 8 bits with the exponent of the greatest channel.
constexpr double RgbeBound = 1.0 / 128.0;

/// An image to write. Value is a function of column, line and channel; line 0 is the top.
struct Picture
{
  int Columns = 8, Lines = 4, Channels = 3;
  OIIO::TypeDesc Type = OIIO::TypeDesc::FLOAT;
  std::vector<std::string> Names;
  int Tile = 0;
  bool Mips = false;
  bool EnvironmentCube = false;
  int FullX = 0, FullY = 0, FullColumns = 0, FullLines = 0; ///< display window, if any
  std::function<double(int, int, int)> Value = [](int column, int line, int channel)
  { return 0.5 + column + 10.0 * line + 0.25 * channel; };
};

std::string Write(const std::string& name, const Picture& picture)
{
  const std::string path = OutputPath(name);
  const auto output = OIIO::ImageOutput::create(path);
  EXPECT_TRUE(output) << path;
  OIIO::ImageSpec spec(picture.Columns, picture.Lines, picture.Channels, picture.Type);
  if (!picture.Names.empty())
  {
    spec.channelnames = picture.Names;
    spec.alpha_channel = -1;
  }
  if (picture.Tile > 0)
  {
    spec.tile_width = spec.tile_height = picture.Tile;
    spec.tile_depth = 1;
  }
  if (picture.Mips)
  {
    spec.attribute("textureformat", "LatLong Environment"); // allows mipmap levels
  }
  if (picture.EnvironmentCube)
  {
    spec.attribute("textureformat", "CubeFace Environment");
  }
  if (picture.FullColumns > 0)
  {
    spec.full_x = picture.FullX;
    spec.full_y = picture.FullY;
    spec.full_width = picture.FullColumns;
    spec.full_height = picture.FullLines;
  }
  const auto mode = [](int level)
  { return level == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendMIPLevel; };
  for (int level = 0; level == 0 || picture.Mips; ++level)
  {
    spec.width = std::max(1, picture.Columns >> level);
    spec.height = std::max(1, picture.Lines >> level);
    if (picture.FullColumns == 0)
    {
      spec.full_width = spec.width;
      spec.full_height = spec.height;
    }
    if (!output->open(path, spec, mode(level)))
    {
      ADD_FAILURE() << output->geterror();
      break;
    }
    std::vector<float> values;
    for (int line = 0; line < spec.height; ++line)
    {
      for (int column = 0; column < spec.width; ++column)
      {
        for (int channel = 0; channel < picture.Channels; ++channel)
        {
          // Coarser levels hold other values, so that reading them would be noticed.
          values.push_back(
            static_cast<float>(picture.Value(column, line, channel) + 1000.0 * level));
        }
      }
    }
    EXPECT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data())) << output->geterror();
    if (spec.width == 1 && spec.height == 1)
    {
      break;
    }
  }
  output->close();
  return path;
}

vtkSmartPointer<vtkSkylineLightMapReader> ReadMap(const std::string& file)
{
  auto reader = vtkSmartPointer<vtkSkylineLightMapReader>::New();
  const Errors errors(reader);
  reader->SetFileName(file.c_str());
  reader->Update();
  EXPECT_EQ(errors.First(), "");
  EXPECT_EQ(reader->GetErrorCode(), vtkErrorCode::NoError);
  return reader;
}

void ExpectPixels(
  vtkSkylineLightMapReader* reader, const Picture& picture, double bound, bool grey = false)
{
  int size[3];
  reader->GetOutput()->GetDimensions(size);
  ASSERT_EQ(size[0], picture.Columns);
  ASSERT_EQ(size[1], picture.Lines);
  const LightMap map = ViewLightMap(reader->GetOutput());
  for (int line = 0; line < picture.Lines; ++line)
  {
    for (int column = 0; column < picture.Columns; ++column)
    {
      const double largest =
        std::max(picture.Value(column, line, 0), picture.Value(column, line, 2));
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(
          map.Pixel(line, column)[c], picture.Value(column, line, grey ? 0 : c), bound * largest)
          << column << " " << line << " " << c;
      }
    }
  }
}

struct Failure
{
  std::string Message;
  unsigned long Code = 0;
};

void ExpectFailure(const std::string& file, unsigned long code, const std::string& words)
{
  vtkNew<vtkSkylineLightMapReader> reader;
  const Errors errors(reader);
  reader->SetFileName(file.c_str());
  reader->Update();
  EXPECT_EQ(errors.Count(), 1u) << file;
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0) << file;
  EXPECT_EQ(reader->GetErrorCode(), code) << errors.First();
  const std::string message = errors.First();
  EXPECT_NE(message.find(words), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_TRUE(file.empty() || message.find("'" + file + "'") != std::string::npos) << message;
  EXPECT_NE(message.find(';'), std::string::npos) << "no cure: " << message;
}

} // namespace

TEST(LightMapReader, OpenExrInEveryPrecision)
{
  Picture picture;
  ExpectPixels(ReadMap(Write("float.exr", picture)), picture, 0.0);
  picture.Type = OIIO::TypeDesc::HALF;
  ExpectPixels(ReadMap(Write("half.exr", picture)), picture, HalfBound);
}

TEST(LightMapReader, Radiance)
{
  Picture picture;
  picture.Columns = 64; // runs are packed from 8 columns on
  picture.Lines = 32;
  ExpectPixels(ReadMap(Write("map.hdr", picture)), picture, RgbeBound);
}

TEST(LightMapReader, TheFileSaysWhatItIsNotItsName)
{
  Picture picture;
  const std::string path = OutputPath("renamed.hdr");
  std::filesystem::copy_file(
    Write("plain.exr", picture), path, std::filesystem::copy_options::overwrite_existing);
  ExpectPixels(ReadMap(path), picture, 0.0);
}

TEST(LightMapReader, TilesAndMipMaps)
{
  Picture picture;
  picture.Columns = 64;
  picture.Lines = 32;
  picture.Tile = 16;
  ExpectPixels(ReadMap(Write("tiled.exr", picture)), picture, 0.0);
  picture.Mips = true;
  ExpectPixels(ReadMap(Write("mips.exr", picture)), picture, 0.0);
}

TEST(LightMapReader, AlphaIsLeftOutAndGreyFillsAllChannels)
{
  Picture picture;
  picture.Channels = 4;
  ExpectPixels(ReadMap(Write("alpha.exr", picture)), picture, 0.0);
  picture.Channels = 1;
  picture.Names = { "Y" };
  ExpectPixels(ReadMap(Write("grey.exr", picture)), picture, 0.0, true);
  picture.Channels = 6;
  picture.Names = { "diffuse.R", "diffuse.G", "diffuse.B", "mask.X", "mask.Y", "mask.Z" };
  ExpectPixels(ReadMap(Write("layers.exr", picture)), picture, 0.0);
}

TEST(LightMapReader, RowZeroOfTheImageIsTheNadir)
{
  Picture picture;
  const auto reader = ReadMap(Write("rows.exr", picture));
  vtkImageData* image = reader->GetOutput();
  vtkDataArray* radiance = image->GetPointData()->GetScalars();
  ASSERT_TRUE(radiance);
  EXPECT_STREQ(radiance->GetName(), "Radiance");
  EXPECT_EQ(radiance->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(radiance->GetNumberOfComponents(), 3);
  EXPECT_EQ(radiance->GetComponent(0, 0), picture.Value(0, 3, 0));
  // Points lie at the azimuth and elevation of the centres of the pixels, in degrees.
  const double coordinateBound = 1e-12;
  EXPECT_NEAR(image->GetPoint(0)[0], -180.0 + 22.5, coordinateBound);
  EXPECT_NEAR(image->GetPoint(0)[1], -90.0 + 22.5, coordinateBound);
  EXPECT_NEAR(image->GetPoint(31)[0], 180.0 - 22.5, coordinateBound);
  EXPECT_NEAR(image->GetPoint(31)[1], 90.0 - 22.5, coordinateBound);
}

TEST(LightMapReader, DefectsAreMendedAndCounted)
{
  Picture picture;
  picture.Value = [](int column, int line, int channel)
  {
    const int pixel = 8 * line + column;
    return pixel == 3 ? -0.5 : pixel == 4 && channel == 1 ? NaN : pixel == 5 ? Infinity : 2.0;
  };
  const auto reader = ReadMap(Write("defects.exr", picture));
  EXPECT_EQ(reader->GetNumberOfNegativePixels(), 1);
  EXPECT_EQ(reader->GetNumberOfNaNPixels(), 1);
  EXPECT_EQ(reader->GetNumberOfInfinitePixels(), 1);
  const LightMap map = ViewLightMap(reader->GetOutput());
  EXPECT_EQ(map.Pixel(0, 3)[0], 0.0f);
  EXPECT_EQ(map.Pixel(0, 4)[0], 2.0f);
  EXPECT_EQ(map.Pixel(0, 4)[1], 0.0f);
  EXPECT_EQ(map.Pixel(0, 5)[2], 2.0f);

  reader->SetFileName(Write("sound.exr", Picture()).c_str());
  reader->Update();
  EXPECT_EQ(reader->GetNumberOfNegativePixels(), 0);
  EXPECT_EQ(reader->GetNumberOfNaNPixels(), 0);
  EXPECT_EQ(reader->GetNumberOfInfinitePixels(), 0);
}

TEST(LightMapReader, MendedPixelsAreSaid)
{
  Picture picture;
  picture.Value = [](int column, int line, int) {
    return line > 0 ? 2.0 : column < 2 ? -0.5 : column < 5 ? NaN : column == 5 ? Infinity : 2.0;
  };
  for (const bool defects : { true, false })
  {
    vtkNew<vtkSkylineLightMapReader> reader;
    std::vector<std::string> said;
    vtkNew<vtkCallbackCommand> listen;
    listen->SetClientData(&said);
    listen->SetCallback([](vtkObject*, unsigned long, void* texts, void* text)
      { static_cast<std::vector<std::string>*>(texts)->emplace_back(static_cast<char*>(text)); });
    reader->AddObserver(vtkCommand::WarningEvent, listen);
    reader->SetFileName(Write("said.exr", defects ? picture : Picture()).c_str());
    reader->Update();
    ASSERT_EQ(said.size(), defects ? 1u : 0u);
    if (defects)
    {
      EXPECT_NE(said[0].find("2 negative, 3 not a number, 1 infinite; assuming 0 for them, the "
                             "greatest finite value of their channel for the infinite ones"),
        std::string::npos)
        << said[0];
    }
  }
}

TEST(LightMapReader, HugeSunStaysAsItIs)
{
  Picture picture;
  picture.Value = [](int column, int line, int) { return column == 3 && line == 1 ? 1.0e5 : 1.0; };
  const auto reader = ReadMap(Write("sun.exr", picture));
  EXPECT_EQ(ViewLightMap(reader->GetOutput()).Pixel(1, 3)[1], 1.0e5f);
}

TEST(LightMapReader, OpenExrCube)
{
  // Each face has its own grey value. The display window is one face, as in the images of the
  // OpenEXR project.
  Picture picture;
  picture.Columns = 16;
  picture.Lines = 96;
  picture.Type = OIIO::TypeDesc::HALF;
  picture.FullColumns = picture.FullLines = 16;
  picture.EnvironmentCube = true;
  picture.Value = [](int, int line, int) { return 1.0 + line / 16; };
  const auto reader = ReadMap(Write("cube.exr", picture));
  int size[3];
  reader->GetOutput()->GetDimensions(size);
  ASSERT_EQ(size[0], 64);
  ASSERT_EQ(size[1], 32);
  const LightMap map = ViewLightMap(reader->GetOutput());
  const double energyBound = 1.0e-2; // edges of faces are blurred, then all is scaled
  EXPECT_NEAR(map.Pixel(16, 16)[0], 1.0, energyBound) << "+X: west";
  EXPECT_NEAR(map.Pixel(16, 48)[0], 2.0, 2.0 * energyBound) << "-X: east";
  EXPECT_NEAR(map.Pixel(0, 5)[0], 3.0, 3.0 * energyBound) << "+Y: up";
  EXPECT_NEAR(map.Pixel(31, 5)[0], 4.0, 4.0 * energyBound) << "-Y: down";
  EXPECT_NEAR(map.Pixel(16, 32)[0], 5.0, 5.0 * energyBound) << "+Z: north";
  EXPECT_NEAR(map.Pixel(16, 0)[0], 6.0, 6.0 * energyBound) << "-Z: south";
  const double floatBound = 1.0e-5;
  EXPECT_NEAR(skyline::testing::Energy(map)[2], 4.0 * std::acos(-1.0) * 3.5, floatBound * 44.0);
}

TEST(LightMapReader, CrossOfAnHdrFile)
{
  Picture picture;
  picture.Columns = 64;
  picture.Lines = 48;
  picture.Value = [](int column, int line, int) {
    return line / 16 == 1 ? 2.0 + column / 16 : column / 16 == 1 ? 1.0 : 0.0;
  };
  const auto reader = ReadMap(Write("cross.hdr", picture));
  const LightMap map = ViewLightMap(reader->GetOutput());
  const double bound = 0.05;
  EXPECT_NEAR(map.Pixel(16, 16)[0], 2.0, bound) << "west";
  EXPECT_NEAR(map.Pixel(16, 32)[0], 3.0, bound) << "north";
  EXPECT_NEAR(map.Pixel(16, 48)[0], 4.0, bound) << "east";
  EXPECT_NEAR(map.Pixel(16, 0)[0], 5.0, bound) << "south";
  EXPECT_NEAR(map.Pixel(0, 9)[0], 1.0, bound) << "up";
}

// The pixels may cover only a part of the display window, or more than it.
TEST(LightMapReader, DisplayWindowIsTheSphere)
{
  Picture picture;
  picture.Columns = 4;
  picture.Lines = 3;
  picture.FullX = -2; // the pixels begin two columns right of the window's corner and one row below
  picture.FullY = -1;
  picture.FullColumns = 8;
  picture.FullLines = 4;
  const auto part = ReadMap(Write("part.exr", picture));
  const LightMap map = ViewLightMap(part->GetOutput());
  ASSERT_EQ(map.Columns, 8);
  ASSERT_EQ(map.Rows, 4);
  EXPECT_EQ(map.Pixel(0, 2)[0], 0.0f);
  EXPECT_EQ(map.Pixel(1, 1)[0], 0.0f);
  EXPECT_EQ(map.Pixel(1, 2)[0], static_cast<float>(picture.Value(0, 0, 0)));
  EXPECT_EQ(map.Pixel(3, 5)[1], static_cast<float>(picture.Value(3, 2, 1)));
  EXPECT_EQ(map.Pixel(3, 6)[1], 0.0f);

  picture.Columns = 12;
  picture.Lines = 6;
  picture.FullX = 2;
  picture.FullY = 1;
  const auto more = ReadMap(Write("more.exr", picture));
  const LightMap inner = ViewLightMap(more->GetOutput());
  ASSERT_EQ(inner.Columns, 8);
  EXPECT_EQ(inner.Pixel(0, 0)[0], static_cast<float>(picture.Value(2, 1, 0)));
  EXPECT_EQ(inner.Pixel(3, 7)[2], static_cast<float>(picture.Value(9, 4, 2)));
}

TEST(LightMapReader, AbortLeavesNothing)
{
  Picture picture;
  picture.Columns = 512;
  picture.Lines = 256;
  vtkNew<vtkSkylineLightMapReader> reader;
  const Errors errors(reader);
  reader->SetFileName(Write("large.exr", picture).c_str());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  reader->AddObserver(vtkCommand::ProgressEvent, stop);
  reader->Update();
  EXPECT_EQ(errors.First(), "");
  EXPECT_EQ(reader->GetErrorCode(), vtkErrorCode::UserError);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(LightMapReaderFailures, NoFileName)
{
  ExpectFailure("", vtkErrorCode::NoFileNameError, "SetFileName");
}

TEST(LightMapReaderFailures, MissingFile)
{
  ExpectFailure(OutputPath("absent.hdr"), vtkErrorCode::FileNotFoundError, "No such file");
}

TEST(LightMapReaderFailures, NotALightMapFile)
{
  const std::string notes = OutputPath("notes.exr");
  std::ofstream(notes) << "this is no light\n";
  ExpectFailure(
    notes, vtkErrorCode::UnrecognizedFileTypeError, "neither a Radiance nor an OpenEXR");
  ExpectFailure(Write("picture.png", Picture()), vtkErrorCode::UnrecognizedFileTypeError,
    "neither a Radiance nor an OpenEXR");
  const std::string empty = OutputPath("empty.hdr");
  std::ofstream(empty) << "";
  ExpectFailure(empty, vtkErrorCode::UnrecognizedFileTypeError, "it is empty");
  ExpectFailure(SKYLINE_TEST_OUTPUT, vtkErrorCode::CannotOpenFileError, "it is a folder");
}

TEST(LightMapReaderFailures, Damaged)
{
  const std::string header = OutputPath("header.exr");
  std::ofstream(header) << "\x76\x2f\x31\x01 and no more";
  ExpectFailure(header, vtkErrorCode::FileFormatError, "may be damaged");

  Picture picture;
  picture.Columns = 256;
  picture.Lines = 128;
  for (const std::string name : { "cut.exr", "cut.hdr" })
  {
    const std::string cut = Write(name, picture);
    std::filesystem::resize_file(cut, std::filesystem::file_size(cut) / 2);
    ExpectFailure(cut, vtkErrorCode::PrematureEndOfFileError, "cannot read the pixels");
  }
}

TEST(LightMapReaderFailures, ZeroSized)
{
  const std::string path = OutputPath("zero.hdr");
  for (const auto& [columns, rows] : { std::array<int, 2>{ 0, 0 }, { 4, 0 }, { 0, 4 } })
  {
    std::ofstream(path) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " << rows << " +X " << columns
                        << "\n";
    ExpectFailure(path, vtkErrorCode::FileFormatError,
      std::to_string(columns) + " x " + std::to_string(rows) + " pixels");
  }
}

// Sizes that a damaged header may state. No memory of this size may be filled before the pixels are
// read.
TEST(LightMapReaderFailures, HugeHeader)
{
  const std::string path = OutputPath("huge.hdr");
  std::ofstream(path) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1000000 +X 2000000\n";
  ExpectFailure(path, vtkErrorCode::FileFormatError, "32768 x 16384 at most");
  std::ofstream(path) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8192 +X 16384\n";
  ExpectFailure(path, vtkErrorCode::FileFormatError, "64 pixels per byte");
  std::ofstream(path) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2048 +X 4096\n"; // believed
  ExpectFailure(path, vtkErrorCode::PrematureEndOfFileError, "cannot read the pixels");
}

// A display window of gigabytes around a few pixels, and tiles of gigabytes in a small image.
TEST(LightMapReaderFailures, ClaimsBeyondTheFile)
{
  Picture picture;
  picture.FullColumns = 32768;
  picture.FullLines = 16384;
  ExpectFailure(Write("window.exr", picture), vtkErrorCode::FileFormatError, "64 pixels per byte");

  picture = Picture();
  picture.Tile = 4;
  const std::string tiled = Write("tiles.exr", picture);
  std::fstream file(tiled, std::ios::in | std::ios::out | std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(file), {} };
  const std::string attribute("tiles\0tiledesc\0", 15);
  const std::size_t at = bytes.find(attribute);
  ASSERT_NE(at, std::string::npos);
  file.clear();
  file.seekp(static_cast<std::streamoff>(at + attribute.size() + 4));
  const std::array<std::uint32_t, 2> size{ 8192, 8192 };
  file.write(reinterpret_cast<const char*>(size.data()), sizeof(size));
  file.close();
  ExpectFailure(tiled, vtkErrorCode::FileFormatError, "tiles with 3 channels take 768 MB");
}

// Reading a pipe would wait for a writer.
TEST(LightMapReaderFailures, Pipe)
{
  const std::string path = FreshFolder("pipes") + "/pipe.exr";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  ExpectFailure(path, vtkErrorCode::CannotOpenFileError, "a pipe or a device");
}

TEST(LightMapReaderFailures, NotTwoToOneAndNoCube)
{
  Picture picture;
  picture.Columns = 9;
  ExpectFailure(Write("odd.exr", picture), vtkErrorCode::FileFormatError, "9 x 4 pixels");
  picture.Columns = 4;
  ExpectFailure(Write("square.exr", picture), vtkErrorCode::FileFormatError, "4 x 4 pixels");
  picture.Columns = 16;
  picture.Lines = 12; // the size of a photograph
  ExpectFailure(Write("photo.exr", picture), vtkErrorCode::FileFormatError, "not a cross");
}

TEST(LightMapReaderFailures, ChannelsThatAreNoColours)
{
  Picture picture;
  picture.Names = { "u", "v", "w" };
  ExpectFailure(Write("names.exr", picture), vtkErrorCode::FileFormatError, "channels u, v, w");
}

TEST(LightMapReaderFailures, AFailureIsForgottenBySuccess)
{
  vtkNew<vtkSkylineLightMapReader> reader;
  {
    const Errors errors(reader);
    reader->SetFileName(OutputPath("absent.exr").c_str());
    reader->Update();
    EXPECT_EQ(errors.Count(), 1u);
  }
  const Picture picture;
  reader->SetFileName(Write("present.exr", picture).c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), vtkErrorCode::NoError);
  ExpectPixels(reader, picture, 0.0);
}

TEST(ViewLightMap, RefusesOtherImages)
{
  EXPECT_THROW(ViewLightMap(nullptr), std::invalid_argument);
  vtkNew<vtkImageData> image;
  EXPECT_THROW(ViewLightMap(image), std::invalid_argument);
  image->SetDimensions(4, 2, 1);
  EXPECT_THROW(ViewLightMap(image), std::invalid_argument) << "no array";
  image->AllocateScalars(VTK_DOUBLE, 3);
  image->GetPointData()->GetScalars()->SetName("Radiance");
  EXPECT_THROW(ViewLightMap(image), std::invalid_argument) << "not float";
  image->SetDimensions(4, 2, 2);
  EXPECT_THROW(ViewLightMap(image), std::invalid_argument) << "not flat";
}
