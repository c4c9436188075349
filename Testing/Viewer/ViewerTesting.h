// SPDX-License-Identifier: BSD-3-Clause
// A viewer on the bundled DEM, and the pixels it shows.
#ifndef skyline_ViewerTesting_h
#define skyline_ViewerTesting_h

#include "Passes.h"
#include "Viewer.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace skyline
{
namespace testing
{

constexpr Modifiers Plain{};
constexpr Modifiers Shift{ true, false };
constexpr Modifiers Control{ false, true };

inline std::string Data(const std::string& name)
{
  return std::string(SKYLINE_TEST_DATA) + "/" + name;
}

/// An empty folder of a test's own for screenshots.
inline std::string ShotFolder()
{
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder =
    std::filesystem::path(SKYLINE_TEST_OUTPUT) / (std::string(test->name()) + "-shots");
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder.string();
}

/// Few azimuths: quick.
inline ViewerOptions Quick()
{
  ViewerOptions options;
  options.Terrain.File = Data("dem/SainteHelens.tif");
  options.Horizon.Azimuths = 16;
  options.Colors = "hypsometric";
  options.Lights.Sun.Time = "2026-06-21T23:00Z";
  options.ShotFolder = ShotFolder();
  return options;
}

inline Talk Silent()
{
  Talk talk;
  talk.Quiet = true;
  return talk;
}

/// Draws until the picture is as good as it gets; `now` goes on. False after too many pictures.
inline bool Settle(Viewer& viewer, double& now)
{
  for (int turn = 0; turn < 20; ++turn)
  {
    now += 0.3;
    viewer.Draw(now);
    if (viewer.GetPatience(now) < 0.0)
    {
      return true;
    }
  }
  return false;
}

/// Mean code, 0 to 255, of a box of pixels.
inline double Brightness(vtkRenderWindow* window, int x0, int y0, int x1, int y1)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(x0, y0, x1, y1, 0, pixels, 0);
  double sum = 0.0;
  for (vtkIdType k = 0; k < pixels->GetNumberOfValues(); ++k)
  {
    sum += pixels->GetValue(k);
  }
  return sum / static_cast<double>(pixels->GetNumberOfValues());
}

inline double Brightness(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  return Brightness(window, 0, 0, size[0] - 1, size[1] - 1);
}

} // namespace testing
} // namespace skyline

#endif
