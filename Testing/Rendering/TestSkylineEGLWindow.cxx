// SPDX-License-Identifier: BSD-3-Clause
#include "MapperTesting.h"

#include "vtkRendererCollection.h"

namespace skyline
{
namespace testing
{
namespace
{

class EGLWindow : public Drawing
{
protected:
  // Fills a window with a colour, without a mapper.
  static Byte3 Paint(vtkSkylineEGLWindow* window, double red)
  {
    vtkRenderer* renderer = window->GetRenderers()->GetFirstRenderer();
    if (!renderer)
    {
      vtkNew<vtkRenderer> made;
      window->AddRenderer(made);
      renderer = made;
    }
    renderer->SetBackground(red, 0.0, 1.0);
    window->Render();
    vtkNew<vtkUnsignedCharArray> pixel;
    window->GetPixelData(3, 2, 3, 2, 0, pixel, 0);
    return { { pixel->GetValue(0), pixel->GetValue(1), pixel->GetValue(2) } };
  }
};

TEST_F(EGLWindow, DrawsWithoutAWindowSystem)
{
  vtkNew<vtkSkylineEGLWindow> window;
  window->SetSize(8, 6);
  EXPECT_EQ(Paint(window, 1.0), (Byte3{ { 255, 0, 255 } }));
  EXPECT_EQ(window->GetReason(), "");
  EXPECT_TRUE(vtkSkylineEGLWindow::IsSupported());
}

TEST_F(EGLWindow, GrowsAndShrinks)
{
  vtkNew<vtkSkylineEGLWindow> window;
  for (int size : { 8, 300, 5 })
  {
    window->SetSize(size, size);
    EXPECT_EQ(Paint(window, 0.2), (Byte3{ { 51, 0, 255 } }));
    vtkNew<vtkUnsignedCharArray> pixels;
    window->GetPixelData(0, 0, size - 1, size - 1, 0, pixels, 0);
    EXPECT_EQ(pixels->GetNumberOfTuples() * pixels->GetNumberOfComponents(), 3 * size * size);
  }
}

TEST_F(EGLWindow, TwoWindowsTakeTurns)
{
  vtkNew<vtkSkylineEGLWindow> one;
  vtkNew<vtkSkylineEGLWindow> two;
  one->SetSize(8, 6);
  two->SetSize(9, 7);
  for (int turn = 0; turn < 3; ++turn)
  {
    EXPECT_EQ(Paint(one, 1.0)[0], 255);
    EXPECT_EQ(Paint(two, 0.0)[0], 0);
  }
}

TEST_F(EGLWindow, ComesBackAfterFinalize)
{
  vtkNew<vtkSkylineEGLWindow> window;
  window->SetSize(8, 6);
  EXPECT_EQ(Paint(window, 1.0)[0], 255);
  window->Finalize();
  EXPECT_FALSE(window->IsCurrent());
  EXPECT_EQ(Paint(window, 0.0)[0], 0);
}

TEST_F(EGLWindow, GivesTheContextBack)
{
  vtkNew<vtkSkylineEGLWindow> window;
  window->SetSize(8, 6);
  Paint(window, 1.0);
  EXPECT_TRUE(window->IsCurrent());
  window->ReleaseCurrent();
  EXPECT_FALSE(window->IsCurrent());
  EXPECT_EQ(Paint(window, 0.0)[0], 0);
}

// Runs without a context too: the message is the same.
TEST(EGLWindowFailures, AreReportedOnceInOneLine)
{
  vtkNew<vtkSkylineEGLWindow> window;
  vtkNew<ErrorCatcher> errors;
  window->AddObserver(vtkCommand::ErrorEvent, errors);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  window->SetDevice(12345);
  window->Render();
  window->Render();
  EXPECT_EQ(errors->Count, 1);
  EXPECT_NE(errors->Text.find("no OpenGL without a window system"), std::string::npos)
    << errors->Text;
  EXPECT_NE(window->GetReason(), "");
  EXPECT_EQ(window->GetReason().find('\n'), std::string::npos);
}

} // namespace
} // namespace testing
} // namespace skyline
