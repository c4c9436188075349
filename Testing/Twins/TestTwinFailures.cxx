// SPDX-License-Identifier: BSD-3-Clause
#include "TwinTesting.h"

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

// Degrees and irradiance: see TestTwinHorizon and TestTwinIrradiance, which are stricter.
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

/// A twin whose errors are counted, with what its host makes of the same.
template <typename Twin, typename Host>
struct Pair
{
  vtkNew<Twin> There;
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

  /// Its difference from the host after an update.
  double Update()
  {
    this->There->Modified();
    this->There->Update();
    return Difference(ArrayOf(this->There, this->Name), this->Expected);
  }

  /// Updates twice: the host computes to the last bit, and one error of one line gives the reason.
  void ExpectHost(const std::string& reason)
  {
    for (int update = 0; update < 2; ++update)
    {
      EXPECT_EQ(this->Update(), 0.0) << this->Name;
      EXPECT_FALSE(this->There->IsOnDevice());
    }
    EXPECT_EQ(this->Errors->Count, 1) << this->Errors->Text;
    for (const std::string& part :
      { std::string("the host computes in place of the graphics processor"), reason })
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

/// Calls test(pair) for a twin of each kind.
template <typename Test>
void ForEveryTwin(vtkImageData* image, const Test& test)
{
  test(VisibilityPair(image, "VisibilitySH"));
  test(TransferPair(image, "TransferSH"));
  test(HorizonPair(image, "HorizonElevation"));
  test(IrradiancePair(image, "Irradiance"));
}

// Needs no context: on every machine there is no device 12345.
TEST(TwinFailures, WithoutAContextTheHostComputesAndSaysSoOnce)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  vtkNew<vtkSkylineEGLWindow> window;
  window->SetDevice(NoDevice);
  vtkNew<ErrorCatcher> silence;
  window->AddObserver(vtkCommand::ErrorEvent, silence);
  ForEveryTwin(image,
    [&](auto&& pair)
    {
      pair.There->GetDevice()->SetRenderWindow(window);
      pair.ExpectHost("");
      EXPECT_NE(pair.There->GetDevice()->GetReason(), "");
      EXPECT_EQ(pair.There->GetDevice()->GetReason().find('\n'), std::string::npos);
    });
}

TEST(TwinFailures, WithoutAContextThereAreNoTextures)
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

TEST_F(TwinContexts, ALostOneThatStaysAwayIsMissed)
{
  if (!vtkSkylineEGLWindow::IsSupported())
  {
    GTEST_SKIP() << "EGL gives no context";
  }
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  ForEveryTwin(image,
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
      // It is used again when it is there again.
      window->Finalize();
      window->SetDevice(-1);
      EXPECT_LT(pair.Update(), RoundingTolerance);
      EXPECT_TRUE(pair.There->IsOnDevice());
      EXPECT_EQ(pair.Errors->Count, 0) << pair.Errors->Text;
    });
}

TEST_F(TwinContexts, TexturesThatHoldNothingAreAnError)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  ForEveryTwin(image,
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

/// Updates a twin, which must give an error of its host's own, once, and no array.
void ExpectRefused(vtkHeightFieldAlgorithm* twin, ErrorCatcher* errors, const std::string& reason)
{
  errors->Count = 0;
  errors->Text.clear();
  twin->Modified();
  twin->Update();
  EXPECT_EQ(errors->Count, 1);
  EXPECT_NE(errors->Text.find(reason), std::string::npos) << errors->Text;
  EXPECT_EQ(errors->Text.find("the host computes"), std::string::npos) << errors->Text;
  EXPECT_EQ(vtkImageData::SafeDownCast(twin->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
}

TEST_F(TwinContexts, BadSettingsAreErrorsAsOnTheHost)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  const auto refuses = [&](auto& pair)
  {
    auto* twin = pair.There.GetPointer();
    twin->SetDevice(this->Device);
    for (const double width : { 0.0, -1.0, 360.1, std::nan("") })
    {
      twin->SetSwathWidth(width);
      ExpectRefused(twin, pair.Errors, "give more than 0 and at most 360");
    }
    twin->SetSwathWidth(360.0);
    for (const int bands : { 1, 9 })
    {
      twin->SetNumberOfBands(bands);
      ExpectRefused(twin, pair.Errors, "give 2 to 8");
    }
    twin->SetNumberOfBands(4);
    for (const int azimuths : { 0, 3601 })
    {
      twin->SetNumberOfAzimuths(azimuths);
      ExpectRefused(twin, pair.Errors, "give 1 to 3600");
    }
    twin->SetNumberOfAzimuths(4);
    twin->SetLevelStep(99.0);
    ExpectRefused(twin, pair.Errors, "levels an octave");
    twin->SetLevelStep(4.0);
    twin->SetLevelOffset(-1.0);
    ExpectRefused(twin, pair.Errors, "level offset");
    twin->SetLevelOffset(2.0);
    // What is put right is computed.
    EXPECT_LT(pair.Update(), RoundingTolerance);
    EXPECT_TRUE(twin->IsOnDevice());
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

TEST_F(TwinContexts, BadLightsAreErrorsAsOnTheHost)
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
