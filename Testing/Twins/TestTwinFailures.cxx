// SPDX-License-Identifier: BSD-3-Clause
#include "TwinTesting.h"

#include "vtkOpenGLHeightFieldVisibility.h"

#include "vtkRenderWindow.h"
#include "vtkSkylineEGLWindow.h"

#include <cstdlib>

namespace skyline
{
namespace testing
{
namespace
{

void Configure(vtkHeightFieldVisibility* filter, vtkImageData* image)
{
  filter->SetInputData(image);
  filter->SetMethodToPyramid();
  filter->SetNumberOfAzimuths(4);
}

/// What the host makes of the same.
vtkSmartPointer<vtkFloatArray> OfHost(vtkImageData* image)
{
  vtkNew<vtkHeightFieldVisibility> host;
  Configure(host, image);
  host->Update();
  return ArrayOf(host, "VisibilitySH");
}

// Needs no context: on every machine there is no device 12345.
TEST(TwinFailures, WithoutAContextTheHostComputesAndSaysSoOnce)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  vtkNew<vtkSkylineEGLWindow> window;
  window->SetDevice(12345);
  vtkNew<ErrorCatcher> silence;
  window->AddObserver(vtkCommand::ErrorEvent, silence);
  vtkNew<vtkOpenGLHeightFieldVisibility> twin;
  vtkNew<ErrorCatcher> errors;
  errors->Watch(twin);
  twin->GetDevice()->SetRenderWindow(window);
  Configure(twin, image);
  twin->ReadBackOff();
  for (int update = 0; update < 2; ++update)
  {
    twin->Modified();
    twin->Update();
    EXPECT_FALSE(twin->IsOnDevice());
    EXPECT_EQ(twin->GetTexture(0), nullptr);
    EXPECT_EQ(Difference(ArrayOf(twin, "VisibilitySH"), OfHost(image)), 0.0);
  }
  EXPECT_EQ(errors->Count, 1);
  EXPECT_NE(
    errors->Text.find("the host computes in place of the graphics processor"), std::string::npos)
    << errors->Text;
  EXPECT_NE(twin->GetDevice()->GetReason(), "");
  EXPECT_EQ(twin->GetDevice()->GetReason().find('\n'), std::string::npos);
}

class TwinContexts : public Twins
{
};

TEST_F(TwinContexts, MethodsWithoutATwinAreTheHosts)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  vtkNew<vtkOpenGLHeightFieldVisibility> twin;
  vtkNew<ErrorCatcher> errors;
  errors->Watch(twin);
  twin->SetDevice(this->Device);
  Configure(twin, image);
  twin->SetMethodToSweep();
  twin->Update();
  EXPECT_FALSE(twin->IsOnDevice());
  EXPECT_NE(ArrayOf(twin, "VisibilitySH"), nullptr);
  EXPECT_EQ(errors->Count, 0);
}

TEST_F(TwinContexts, ALostOneIsReplaced)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  vtkNew<vtkSkylineEGLWindow> window;
  if (!vtkSkylineEGLWindow::IsSupported())
  {
    GTEST_SKIP() << "EGL gives no context";
  }
  vtkNew<vtkOpenGLHeightFieldVisibility> twin;
  twin->GetDevice()->SetRenderWindow(window);
  Configure(twin, image);
  twin->Update();
  const auto before = vtkSmartPointer<vtkFloatArray>(ArrayOf(twin, "VisibilitySH"));
  ASSERT_TRUE(twin->IsOnDevice());
  ASSERT_NE(twin->GetTexture(0), nullptr);
  window->Finalize();
  EXPECT_EQ(twin->GetTexture(0), nullptr); // gone with the context
  twin->Modified();
  twin->Update();
  EXPECT_TRUE(twin->IsOnDevice());
  EXPECT_EQ(Difference(ArrayOf(twin, "VisibilitySH"), before), 0.0);
  EXPECT_EQ(twin->GetDevice()->GetGeneration(), 2);
}

TEST_F(TwinContexts, AWindowMayComeLater)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  vtkNew<vtkOpenGLHeightFieldVisibility> twin;
  Configure(twin, image);
  twin->Update();
  const auto before = vtkSmartPointer<vtkFloatArray>(ArrayOf(twin, "VisibilitySH"));
  vtkNew<vtkSkylineEGLWindow> window;
  if (!vtkSkylineEGLWindow::IsSupported())
  {
    GTEST_SKIP() << "EGL gives no context";
  }
  twin->GetDevice()->SetRenderWindow(window);
  twin->Update();
  EXPECT_TRUE(twin->IsOnDevice());
  EXPECT_EQ(Difference(ArrayOf(twin, "VisibilitySH"), before), 0.0);
  twin->GetDevice()->SetRenderWindow(nullptr);
  twin->Update();
  EXPECT_TRUE(twin->IsOnDevice());
}

TEST_F(TwinContexts, AnXServerDoesToo)
{
  const auto window = vtkSmartPointer<vtkRenderWindow>::New();
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display || !window->IsA("vtkXOpenGLRenderWindow"))
  {
    GTEST_SKIP() << "no X server";
  }
  window->SetOffScreenRendering(1);
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  vtkNew<vtkOpenGLHeightFieldVisibility> twin;
  Configure(twin, image);
  twin->Update();
  const auto before = vtkSmartPointer<vtkFloatArray>(ArrayOf(twin, "VisibilitySH"));
  twin->GetDevice()->SetRenderWindow(window);
  twin->Update();
  EXPECT_TRUE(twin->IsOnDevice());
  constexpr double rounding = 1.0e-5; // another driver perhaps
  EXPECT_LT(Difference(ArrayOf(twin, "VisibilitySH"), before), rounding);
}

TEST_F(TwinContexts, BadSettingsAreErrorsAsOnTheHost)
{
  vtkNew<vtkOpenGLHeightFieldVisibility> twin;
  vtkNew<ErrorCatcher> errors;
  errors->Watch(twin);
  twin->SetDevice(this->Device);
  Configure(twin, ImageOf<vtkDoubleArray>(Hills(30, 20)));
  twin->SetLevelStep(99.0);
  twin->Update();
  EXPECT_EQ(errors->Count, 1);
  EXPECT_NE(errors->Text.find("levels an octave"), std::string::npos) << errors->Text;
}

} // namespace
} // namespace testing
} // namespace skyline
