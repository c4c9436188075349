// SPDX-License-Identifier: BSD-3-Clause
// Reads many files in one process, for TestMutations.py and TestHostileFiles.py, because a process
// with sanitizers takes seconds to start. Connections are refused and logged (Connections.cxx).
//
//   SkylineReadFiles SECONDS < LIST      each line of LIST is "raster FILE" or "light FILE"
//
// For each file the program prints "reading FILE". Then it prints "read", "refused REASON" or
// "wrong REASON", with the seconds and the greatest size of the process so far in MB. If it
// crashes, or if a file takes longer than SECONDS, the output ends after "reading FILE".
#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkHeightFieldHorizon.h"
#include "vtkHeightFieldReader.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkSkylineLightMapReader.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include <sys/resource.h>
#include <unistd.h>

namespace
{

// For larger fields no horizon is computed.
constexpr vtkIdType SmallField = 64 * 64;

std::string Reason;

/// Updates without printing. The first error is stored in Reason.
void Update(vtkAlgorithm* algorithm)
{
  vtkNew<vtkCallbackCommand> note;
  note->SetCallback(
    [](vtkObject*, unsigned long, void*, void* text)
    {
      std::string reason = static_cast<const char*>(text);
      // The text that VTK adds before the reason.
      const std::size_t frame = reason.find("): ");
      reason = reason.substr(frame == std::string::npos ? 0 : frame + 3);
      reason = reason.substr(0, reason.find_last_not_of('\n') + 1);
      Reason = Reason.empty() ? reason : Reason;
    });
  algorithm->AddObserver(vtkCommand::ErrorEvent, note);
  algorithm->Update();
}

/// Returns an empty string, or what is wrong with the values that were read.
std::string ReadRaster(const char* file)
{
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(file);
  Update(reader);
  vtkImageData* const image = reader->GetOutput();
  if (!Reason.empty() || image->GetNumberOfPoints() == 0)
  {
    return Reason.empty() ? "nothing was read, and no reason given" : "";
  }
  const double* const spacing = image->GetSpacing();
  if (!(spacing[0] > 0.0 && spacing[1] > 0.0))
  {
    return "a spacing that is not above 0";
  }
  if (image->GetNumberOfPoints() <= SmallField)
  {
    vtkNew<vtkHeightFieldHorizon> horizon;
    horizon->SetInputConnection(reader->GetOutputPort());
    horizon->SetNumberOfAzimuths(3);
    Update(horizon);
  }
  return "";
}

std::string ReadLight(const char* file)
{
  vtkNew<vtkSkylineLightMapReader> reader;
  reader->SetFileName(file);
  Update(reader);
  vtkDataArray* const pixels = reader->GetOutput()->GetPointData()->GetScalars();
  if (!Reason.empty() || !pixels)
  {
    return Reason.empty() ? "nothing was read, and no reason given" : "";
  }
  for (vtkIdType pixel = 0; pixel < pixels->GetNumberOfTuples(); ++pixel)
  {
    for (int channel = 0; channel < pixels->GetNumberOfComponents(); ++channel)
    {
      const double value = pixels->GetComponent(pixel, channel);
      if (!std::isfinite(value) || value < 0.0)
      {
        return "light that is not finite or below 0";
      }
    }
  }
  return "";
}

double Megabytes()
{
  rusage used;
  (void)::getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024.0; // Linux counts in kB
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::fprintf(stderr, "usage: %s SECONDS < LIST\n", argv[0]);
    return 2;
  }
  const auto patience = static_cast<unsigned int>(std::strtoul(argv[1], nullptr, 10));
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever(); // for errors without an observer
  std::string kind, file;
  while (std::cin >> kind && std::getline(std::cin >> std::ws, file))
  {
    std::printf("reading %s\n", file.c_str());
    std::fflush(stdout);
    Reason.clear();
    ::alarm(patience); // its signal ends the process
    const auto start = std::chrono::steady_clock::now();
    std::string wrong;
    try
    {
      wrong = kind == "light" ? ReadLight(file.c_str()) : ReadRaster(file.c_str());
    }
    catch (const std::exception& error)
    {
      wrong = std::string("an exception: ") + error.what();
    }
    ::alarm(0);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    if (wrong.empty() && Reason.find('\n') != std::string::npos)
    {
      wrong = "a reason of many lines: " + Reason.substr(0, Reason.find('\n'));
    }
    const char* const verdict = !wrong.empty() ? "wrong" : !Reason.empty() ? "refused" : "read";
    std::printf("%s %.3f %.0f %s\n", verdict, seconds.count(), Megabytes(),
      wrong.empty() ? Reason.c_str() : wrong.c_str());
    std::fflush(stdout);
  }
  return 0;
}
