// SPDX-License-Identifier: BSD-3-Clause
// Compares pictures with stored ones, with a strict tolerance.
#ifndef skyline_BaselineTesting_h
#define skyline_BaselineTesting_h

#include "vtkImageData.h"
#include "vtkImageDifference.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>

namespace skyline
{
namespace testing
{

/// The difference of codes that the rounding of drivers can cause in a pixel.
constexpr int CodeThreshold = 2;

/// The allowed difference of a picture in whole pixels: at the rim of the mesh, the centre of a
/// pixel may fall on the other side with another driver. A picture that is 7 % darker differs by
/// more.
constexpr double RimPixels = 4.0;

inline vtkSmartPointer<vtkImageData> PictureOf(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels, 0);
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(size[0], size[1], 1);
  picture->GetPointData()->SetScalars(pixels);
  return picture;
}

/// The difference in whole pixels, as vtkImageDifference counts it above the threshold, without
/// shift or averaging. VTK's usual comparison accepts a picture with 0.6 of the brightness.
inline double Difference(vtkImageData* picture, vtkImageData* baseline)
{
  const int* seen = picture->GetDimensions();
  const int* kept = baseline->GetDimensions();
  if (seen[0] != kept[0] || seen[1] != kept[1] ||
    picture->GetNumberOfScalarComponents() != baseline->GetNumberOfScalarComponents())
  {
    return 1.0e9;
  }
  vtkNew<vtkImageDifference> difference;
  difference->SetInputData(picture);
  difference->SetImageData(baseline);
  difference->SetThreshold(CodeThreshold);
  difference->AllowShiftOff();
  difference->AveragingOff();
  difference->Update();
  return difference->GetThresholdedError();
}

/// Compares the picture of the window with Testing/Data/Baseline/<name>.png. If they differ, the
/// picture is saved in the output folder of the test; copied over the baseline, it becomes the new
/// one.
inline void ExpectBaseline(vtkRenderWindow* window, const std::string& name)
{
  const auto picture = PictureOf(window);
  const std::string file = std::string(SKYLINE_TEST_DATA) + "/Baseline/" + name + ".png";
  double difference = 1.0e9;
  if (std::filesystem::exists(file))
  {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    difference = Difference(picture, reader->GetOutput());
  }
  const std::string seen = std::string(SKYLINE_TEST_OUTPUT) + "/" + name + ".png";
  if (difference > RimPixels)
  {
    vtkNew<vtkPNGWriter> writer;
    writer->SetFileName(seen.c_str());
    writer->SetInputData(picture);
    writer->Write();
  }
  EXPECT_LE(difference, RimPixels) << "compare " << seen << " with " << file;
}

} // namespace testing
} // namespace skyline

#endif
