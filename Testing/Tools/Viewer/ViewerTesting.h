// SPDX-License-Identifier: BSD-3-Clause
// A viewer of the included DEM, and the pixels that it shows.
#ifndef skyline_ViewerTesting_h
#define skyline_ViewerTesting_h

#include "RunPass.h"
#include "Viewer.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkSkylineEGLWindow.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

namespace skyline
{
namespace testing
{

constexpr int Width = 640;
constexpr int Height = 400;

constexpr Modifiers Plain{};
constexpr Modifiers Shift{ true, false };
constexpr Modifiers Control{ false, true };

inline std::string Data(const std::string& name)
{
  return std::string(SKYLINE_TEST_DATA) + "/" + name;
}

/// Makes an empty folder for the screenshots of this test alone.
inline std::string ShotFolder()
{
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder =
    std::filesystem::path(SKYLINE_TEST_OUTPUT) / (std::string(test->name()) + "-shots");
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder.string();
}

/// Few azimuths, so that the tests are fast.
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

inline CommonOptions Silent()
{
  CommonOptions common;
  common.Quiet = true;
  return common;
}

/// Draws until the picture is final, while `now` increases. Returns false after too many pictures.
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

/// The mean code, 0 to 255, in a rectangle of pixels.
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

/// A viewer in a window that needs no window system.
class ViewerTest : public ::testing::Test
{
protected:
  void SetUp() override
  {
    PrepareVtk(Silent());
    vtkNew<vtkSkylineEGLWindow> probe;
    if (!probe->SupportsOpenGL())
    {
      GTEST_SKIP() << "no OpenGL context without a window system: " << probe->GetReason();
    }
    this->Window->SetMultiSamples(0);
  }

  void TearDown() override
  {
    this->View.reset();
    this->Window->Finalize();
  }

  void Open(const ViewerOptions& options = Quick())
  {
    this->View = std::make_unique<Viewer>(this->Window, options, Silent());
    this->View->Resize(Width, Height, 1.0);
    this->Rest();
  }

  void Rest() { ASSERT_TRUE(Settle(*this->View, this->Now)); }
  void Draw() { this->View->Draw(this->Now += 0.01); }

  void DragTo(
    double x, double y, MouseButton button = MouseButton::Left, const Modifiers& with = Plain)
  {
    this->View->MousePress(button, true, with);
    this->View->MouseMove(x, y);
    this->Draw();
    this->View->MousePress(button, false, with);
  }

  vtkNew<vtkSkylineEGLWindow> Window;
  std::unique_ptr<Viewer> View;
  double Now = 0.0;
};

} // namespace testing
} // namespace skyline

#endif
