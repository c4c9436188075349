// SPDX-License-Identifier: BSD-3-Clause
#include "GpuTesting.h"

#include "vtkOpenGLHeightFieldHorizon.h"
#include "vtkOpenGLHeightFieldIrradiance.h"
#include "vtkOpenGLHeightFieldTransfer.h"
#include "vtkOpenGLHeightFieldVisibility.h"

#include "vtkRenderWindow.h"
#include "vtkSkylineEGLWindow.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineKeyLight.h"

#include <cstdlib>

namespace skyline
{
namespace testing
{
namespace
{

constexpr int NoDevice = 12345;

// Degrees and irradiance. TestGpuHorizon and TestGpuIrradiance are stricter.
constexpr double RoundingTolerance = 1.0e-4;

void Configure(vtkHeightFieldVisibility* filter, vtkImageData* image)
{
  filter->SetInputData(image);
  filter->SetMethodToPyramid();
  filter->SetNumberOfAzimuths(4);
}

void Configure(vtkHeightFieldHorizon* filter, vtkImageData* image)
{
  filter->SetInputData(image);
  filter->SetNumberOfAzimuths(4);
}

void Configure(vtkHeightFieldIrradiance* filter, vtkImageData* image)
{
  vtkNew<vtkSkylineKeyLight> key;
  filter->SetInputData(image);
  filter->SetNumberOfAzimuths(4);
  filter->SetLightMethodToHarmonics();
  filter->AddLight(key);
}

/// A filter on the graphics processor whose errors are counted, and its counterpart on the host.
template <typename Gpu, typename Host>
struct Pair
{
  vtkNew<Gpu> There;
  vtkNew<ErrorCatcher> Errors;
  vtkSmartPointer<vtkFloatArray> Expected;
  const char* Name;

  Pair(vtkImageData* image, const char* name)
    : Name(name)
  {
    this->Errors->Watch(this->There);
    Configure(this->There, image);
    vtkNew<Host> host;
    Configure(host, image);
    host->Update();
    this->Expected = ArrayOf(host, name);
  }

  /// The difference from the host after an update.
  double Update()
  {
    this->There->Modified();
    this->There->Update();
    return Difference(ArrayOf(this->There, this->Name), this->Expected);
  }

  /// Updates twice. The result must be that of the host to the last bit, and one error of one line
  /// must give the reason.
  void ExpectHost(const std::string& reason)
  {
    for (int update = 0; update < 2; ++update)
    {
      EXPECT_EQ(this->Update(), 0.0) << this->Name;
      EXPECT_FALSE(this->There->IsOnDevice());
    }
    EXPECT_EQ(this->Errors->Count, 1) << this->Errors->Text;
    for (const std::string& part :
      { std::string("the host computes instead of the graphics processor"), reason })
    {
      EXPECT_NE(this->Errors->Text.find(part), std::string::npos) << this->Errors->Text;
    }
    this->Errors->Count = 0;
    this->Errors->Text.clear();
  }
};

using VisibilityPair = Pair<vtkOpenGLHeightFieldVisibility, vtkHeightFieldVisibility>;
using TransferPair = Pair<vtkOpenGLHeightFieldTransfer, vtkHeightFieldTransfer>;
using HorizonPair = Pair<vtkOpenGLHeightFieldHorizon, vtkHeightFieldHorizon>;
using IrradiancePair = Pair<vtkOpenGLHeightFieldIrradiance, vtkHeightFieldIrradiance>;

/// Calls test(pair) for each filter on the graphics processor.
template <typename Test>
void ForEveryGpu(vtkImageData* image, const Test& test)
{
  test(VisibilityPair(image, "VisibilitySH"));
  test(TransferPair(image, "TransferSH"));
  test(HorizonPair(image, "HorizonElevation"));
  test(IrradiancePair(image, "Irradiance"));
}

// Runs without a context too: no machine has a device 12345.
TEST(GpuFailures, WithoutAContextTheHostComputesAndSaysSoOnce)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  vtkNew<vtkSkylineEGLWindow> window;
  window->SetDevice(NoDevice);
  vtkNew<ErrorCatcher> silence;
  window->AddObserver(vtkCommand::ErrorEvent, silence);
  ForEveryGpu(image,
    [&](auto&& pair)
    {
      pair.There->GetDevice()->SetRenderWindow(window);
      pair.ExpectHost("");
      EXPECT_NE(pair.There->GetDevice()->GetReason(), "");
      EXPECT_EQ(pair.There->GetDevice()->GetReason().find('\n'), std::string::npos);
    });
}

TEST(GpuFailures, WithoutAContextThereAreNoTextures)
{
  vtkNew<vtkSkylineEGLWindow> window;
  window->SetDevice(NoDevice);
  vtkNew<ErrorCatcher> silence;
  window->AddObserver(vtkCommand::ErrorEvent, silence);
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  VisibilityPair visibility(image, "VisibilitySH");
  visibility.There->GetDevice()->SetRenderWindow(window);
  visibility.There->ReadBackOff();
  visibility.ExpectHost("");
  EXPECT_EQ(visibility.There->GetTexture(0), nullptr);
  IrradiancePair light(image, "Irradiance");
  light.There->GetDevice()->SetRenderWindow(window);
  light.There->ReadBackOff();
  light.ExpectHost("");
  EXPECT_EQ(light.There->GetTexture(), nullptr);
}

class GpuContexts : public GpuTest
{
};

TEST_F(GpuContexts, MethodsWithoutAGpuAreTheHosts)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  vtkNew<vtkOpenGLHeightFieldVisibility> gpu;
  vtkNew<ErrorCatcher> errors;
  errors->Watch(gpu);
  gpu->SetDevice(this->Device);
  Configure(gpu, image);
  gpu->SetMethodToSweep();
  gpu->Update();
  EXPECT_FALSE(gpu->IsOnDevice());
  EXPECT_NE(ArrayOf(gpu, "VisibilitySH"), nullptr);
  EXPECT_EQ(errors->Count, 0);
}

TEST_F(GpuContexts, ALostOneIsReplaced)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  vtkNew<vtkSkylineEGLWindow> window;
  if (!vtkSkylineEGLWindow::IsSupported())
  {
    GTEST_SKIP() << "EGL gives no context";
  }
  vtkNew<vtkOpenGLHeightFieldVisibility> gpu;
  gpu->GetDevice()->SetRenderWindow(window);
  Configure(gpu, image);
  gpu->Update();
  const auto before = vtkSmartPointer<vtkFloatArray>(ArrayOf(gpu, "VisibilitySH"));
  ASSERT_TRUE(gpu->IsOnDevice());
  ASSERT_NE(gpu->GetTexture(0), nullptr);
  window->Finalize();
  EXPECT_EQ(gpu->GetTexture(0), nullptr); // lost with the context
  gpu->Modified();
  gpu->Update();
  EXPECT_TRUE(gpu->IsOnDevice());
  EXPECT_EQ(Difference(ArrayOf(gpu, "VisibilitySH"), before), 0.0);
  EXPECT_EQ(gpu->GetDevice()->GetGeneration(), 2);
}

TEST_F(GpuContexts, AWindowMayComeLater)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  vtkNew<vtkOpenGLHeightFieldVisibility> gpu;
  Configure(gpu, image);
  gpu->Update();
  const auto before = vtkSmartPointer<vtkFloatArray>(ArrayOf(gpu, "VisibilitySH"));
  vtkNew<vtkSkylineEGLWindow> window;
  if (!vtkSkylineEGLWindow::IsSupported())
  {
    GTEST_SKIP() << "EGL gives no context";
  }
  gpu->GetDevice()->SetRenderWindow(window);
  gpu->Update();
  EXPECT_TRUE(gpu->IsOnDevice());
  EXPECT_EQ(Difference(ArrayOf(gpu, "VisibilitySH"), before), 0.0);
  gpu->GetDevice()->SetRenderWindow(nullptr);
  gpu->Update();
  EXPECT_TRUE(gpu->IsOnDevice());
}

TEST_F(GpuContexts, AnXServerDoesToo)
{
  const auto window = vtkSmartPointer<vtkRenderWindow>::New();
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display || !window->IsA("vtkXOpenGLRenderWindow"))
  {
    GTEST_SKIP() << "no X server";
  }
  window->SetOffScreenRendering(1);
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  vtkNew<vtkOpenGLHeightFieldVisibility> gpu;
  Configure(gpu, image);
  gpu->Update();
  const auto before = vtkSmartPointer<vtkFloatArray>(ArrayOf(gpu, "VisibilitySH"));
  gpu->GetDevice()->SetRenderWindow(window);
  gpu->Update();
  EXPECT_TRUE(gpu->IsOnDevice());
  constexpr double rounding = 1.0e-5; // the driver may differ
  EXPECT_LT(Difference(ArrayOf(gpu, "VisibilitySH"), before), rounding);
}

TEST_F(GpuContexts, ALostOneThatStaysAwayIsMissed)
{
  if (!vtkSkylineEGLWindow::IsSupported())
  {
    GTEST_SKIP() << "EGL gives no context";
  }
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  ForEveryGpu(image,
    [&](auto&& pair)
    {
      vtkNew<vtkSkylineEGLWindow> window;
      vtkNew<ErrorCatcher> silence;
      window->AddObserver(vtkCommand::ErrorEvent, silence);
      pair.There->GetDevice()->SetRenderWindow(window);
      pair.Update();
      EXPECT_TRUE(pair.There->IsOnDevice());
      window->Finalize();
      window->SetDevice(NoDevice);
      pair.ExpectHost("");
      // It is used again when it is available again.
      window->Finalize();
      window->SetDevice(-1);
      EXPECT_LT(pair.Update(), RoundingTolerance);
      EXPECT_TRUE(pair.There->IsOnDevice());
      EXPECT_EQ(pair.Errors->Count, 0) << pair.Errors->Text;
    });
}

TEST_F(GpuContexts, TexturesThatHoldNothingAreAnError)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  ForEveryGpu(image,
    [&](auto&& pair)
    {
      this->Device->SetTextureLimit(1);
      pair.There->SetDevice(this->Device);
      pair.ExpectHost("raise the texture limit");
      this->Device->SetTextureLimit(0);
      EXPECT_LT(pair.Update(), RoundingTolerance);
      EXPECT_TRUE(pair.There->IsOnDevice());
    });
}

/// Updates a filter on the graphics processor, which must report an error of its base class once
/// and make no array.
void ExpectRefused(vtkHeightFieldAlgorithm* gpu, ErrorCatcher* errors, const std::string& reason)
{
  errors->Count = 0;
  errors->Text.clear();
  gpu->Modified();
  gpu->Update();
  EXPECT_EQ(errors->Count, 1);
  EXPECT_NE(errors->Text.find(reason), std::string::npos) << errors->Text;
  EXPECT_EQ(errors->Text.find("the host computes"), std::string::npos) << errors->Text;
  EXPECT_EQ(vtkImageData::SafeDownCast(gpu->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
}

TEST_F(GpuContexts, BadSettingsAreErrorsAsOnTheHost)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  const auto refuses = [&](auto& pair)
  {
    auto* gpu = pair.There.GetPointer();
    gpu->SetDevice(this->Device);
    for (const double width : { 0.0, -1.0, 360.1, std::nan("") })
    {
      gpu->SetSwathWidth(width);
      ExpectRefused(gpu, pair.Errors, "give more than 0 and at most 360");
    }
    gpu->SetSwathWidth(360.0);
    for (const int bands : { 1, 9 })
    {
      gpu->SetNumberOfBands(bands);
      ExpectRefused(gpu, pair.Errors, "give 2 to 8");
    }
    gpu->SetNumberOfBands(4);
    for (const int azimuths : { 0, 3601 })
    {
      gpu->SetNumberOfAzimuths(azimuths);
      ExpectRefused(gpu, pair.Errors, "give 1 to 3600");
    }
    gpu->SetNumberOfAzimuths(4);
    gpu->SetLevelStep(99.0);
    ExpectRefused(gpu, pair.Errors, "levels per octave");
    gpu->SetLevelStep(4.0);
    gpu->SetLevelOffset(-1.0);
    ExpectRefused(gpu, pair.Errors, "level offset");
    gpu->SetLevelOffset(2.0);
    // After the correction the filter computes.
    EXPECT_LT(pair.Update(), RoundingTolerance);
    EXPECT_TRUE(gpu->IsOnDevice());
  };
  VisibilityPair visibility(image, "VisibilitySH");
  refuses(visibility);
  TransferPair transfer(image, "TransferSH");
  refuses(transfer);
  HorizonPair horizon(image, "HorizonElevation");
  horizon.There->SetDevice(this->Device);
  horizon.There->SetNumberOfAzimuths(0);
  ExpectRefused(horizon.There, horizon.Errors, "give 1 to 3600");
}

TEST_F(GpuContexts, BadLightsAreErrorsAsOnTheHost)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  IrradiancePair pair(image, "Irradiance");
  pair.There->SetDevice(this->Device);
  for (const int bands : { 1, 9 })
  {
    pair.There->SetHarmonicBands(bands);
    ExpectRefused(pair.There, pair.Errors, "give 2 to 8");
  }
  pair.There->SetHarmonicBands(4);
  pair.There->RemoveAllLights();
  ExpectRefused(pair.There, pair.Errors, "no light shines");
  vtkNew<vtkSkylineEnvironmentLight> sky;
  sky->SetSourceToImage();
  pair.There->AddLight(sky);
  ExpectRefused(pair.There, pair.Errors, "the light map has 0 x 0");
  sky->SetImage(image);
  ExpectRefused(pair.There, pair.Errors, "the light map has no point array 'Radiance'");
}

} // namespace
} // namespace testing
} // namespace skyline
