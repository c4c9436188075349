// SPDX-License-Identifier: BSD-3-Clause
// Shadow heights and line sweeps on the graphics processor, compared with the host.
#include "GpuTesting.h"

#include "vtkOpenGLHeightFieldHorizon.h"
#include "vtkOpenGLHeightFieldShadowHeight.h"

#include "Data/ImageGeoreference.h"
#include "vtkSkylineEGLWindow.h"

namespace skyline
{
namespace testing
{
namespace
{

// Metres. Heights of 1500 m and the fall of the light round differently: four times the distance of
// floats there.
constexpr double RoundingTolerance = 5.0e-4;

// Metres. The recurrence passes the rounding from line to line, down to kilometres below the
// ground.
constexpr double SweepTolerance = 1.0e-2;

// Degrees. The host stores hulls in double precision. If two edges have the same horizon up to
// rounding, either can be chosen.
constexpr double HullTolerance = 2.0e-3;

class ShadowGpu : public GpuTest
{
protected:
  struct Light
  {
    double Azimuth, Elevation;
  };

  void Compare(vtkImageData* image, int method, double tolerance, const std::vector<Light>& lights)
  {
    vtkNew<vtkOpenGLHeightFieldShadowHeight> gpu;
    gpu->SetDevice(this->Device);
    vtkNew<vtkHeightFieldShadowHeight> host;
    for (const Light& light : lights)
    {
      for (vtkHeightFieldShadowHeight* filter :
        { static_cast<vtkHeightFieldShadowHeight*>(gpu), host.GetPointer() })
      {
        filter->SetInputData(image);
        filter->SetMethod(method);
        filter->SetSunAzimuth(light.Azimuth);
        filter->SetSunElevation(light.Elevation);
        filter->SetSunAngularRadius(1.0);
        filter->SoftOn();
        filter->BelowTerrainOn();
        filter->Update();
      }
      EXPECT_TRUE(gpu->IsOnDevice());
      for (const char* name : { "ShadowHeight", "ShadowHeightUpper", "ShadowHeightLower" })
      {
        const double difference = Difference(ArrayOf(gpu, name), ArrayOf(host, name));
        this->Most = std::max(this->Most, difference);
        EXPECT_LT(difference, tolerance) << name << " " << light.Azimuth << " " << light.Elevation;
      }
    }
  }

  void TearDown() override { RecordProperty("Most", std::to_string(this->Most)); }

  double Most = 0.0; // of all differences, for the XML report

  static std::vector<Light> AllAround()
  {
    std::vector<Light> lights;
    for (int k = 0; k < 16; ++k)
    {
      lights.push_back({ 22.5 * k + (k % 2 ? 0.0 : 3.7 * (k % 3)), 3.0 + 4.0 * (k % 5) });
    }
    return lights;
  }
};

TEST_F(ShadowGpu, ExactInAllOctants)
{
  this->Compare(ImageOf<vtkDoubleArray>(Hills(131, 97)), vtkHeightFieldShadowHeight::EXACT,
    RoundingTolerance, AllAround());
}

TEST_F(ShadowGpu, ExactBesideMissingPosts)
{
  this->Compare(ImageOf<vtkDoubleArray>(HillsWithHoles(97, 131)), vtkHeightFieldShadowHeight::EXACT,
    RoundingTolerance, AllAround());
}

TEST_F(ShadowGpu, ExactOnABody)
{
  const auto image = ImageOf<vtkDoubleArray>(shapes::Fractal(40, 50, 2000.0, 3000.0, 6));
  Georeference place;
  place.EquatorialRadius = 6371000.0;
  place.Earth = true;
  place.Columns = 40;
  place.Rows = 50;
  place.LatticeColumns = place.LatticeRows = 2;
  place.Longitude = { 0.0, 1.0, 0.0, 1.0 };
  place.Latitude = { 0.0, 0.0, 1.0, 1.0 };
  for (int row = 0; row < 50; ++row)
  {
    place.RowSpacingX.push_back(2000.0 * std::cos(row * 0.015));
    place.RowSpacingY.push_back(2000.0);
  }
  StoreGeoreference(place, image);
  constexpr double far = 3.0e-3; // here shadows fall by kilometres
  this->Compare(image, vtkHeightFieldShadowHeight::EXACT, far, { { 200.0, 2.0 }, { 77.0, 4.0 } });
}

class SweepGpu : public ShadowGpu
{
protected:
  void SetUp() override
  {
    ShadowGpu::SetUp();
    if (this->IsSkipped())
    {
      return;
    }
    vtkNew<vtkOpenGLHeightFieldShadowHeight> probe;
    vtkNew<ErrorCatcher> errors;
    errors->Watch(probe);
    probe->SetDevice(this->Device);
    probe->SetInputData(ImageOf<vtkDoubleArray>(Hills(3, 3)));
    probe->SetMethodToSweep();
    probe->Update();
    if (!probe->IsOnDevice())
    {
      ASSERT_EQ(errors->Text, "");
      GTEST_SKIP() << "no compute shaders (OpenGL 4.3)";
    }
  }
};

// More lanes than a work group and more lines than a run.
TEST_F(SweepGpu, AsPublishedInAllOctants)
{
  this->Compare(ImageOf<vtkDoubleArray>(Hills(531, 197)), vtkHeightFieldShadowHeight::SWEEP,
    SweepTolerance, AllAround());
}

TEST_F(SweepGpu, AsPublishedOverHolesAndOnTheSmallestFields)
{
  this->Compare(ImageOf<vtkDoubleArray>(HillsWithHoles(131, 97)), vtkHeightFieldShadowHeight::SWEEP,
    SweepTolerance, AllAround());
  this->Compare(ImageOf<vtkDoubleArray>(Hills(2, 9)), vtkHeightFieldShadowHeight::SWEEP,
    SweepTolerance, AllAround());
}

TEST_F(SweepGpu, HullsAsTheHostKeepsThem)
{
  for (const auto& field : { Hills(131, 97), HillsWithHoles(97, 131), Hills(2, 9) })
  {
    const auto image = ImageOf<vtkDoubleArray>(field);
    vtkNew<vtkOpenGLHeightFieldHorizon> gpu;
    gpu->SetDevice(this->Device);
    vtkNew<vtkHeightFieldHorizon> host;
    for (vtkHeightFieldHorizon* filter :
      { static_cast<vtkHeightFieldHorizon*>(gpu), host.GetPointer() })
    {
      filter->SetInputData(image);
      filter->SetMethodToSweep();
      filter->SetNumberOfAzimuths(13);
      filter->Update();
    }
    EXPECT_TRUE(gpu->IsOnDevice());
    const double difference =
      Difference(ArrayOf(gpu, "HorizonElevation"), ArrayOf(host, "HorizonElevation"));
    this->Most = std::max(this->Most, difference);
    EXPECT_LT(difference, HullTolerance);
  }
}

TEST_F(SweepGpu, ALostContextIsReplaced)
{
  if (!vtkSkylineEGLWindow::IsSupported())
  {
    GTEST_SKIP() << "EGL gives no context";
  }
  const auto image = ImageOf<vtkDoubleArray>(Hills(50, 30));
  vtkNew<vtkSkylineEGLWindow> window;
  vtkNew<vtkOpenGLHeightFieldShadowHeight> gpu;
  gpu->GetDevice()->SetRenderWindow(window);
  gpu->SetInputData(image);
  gpu->SetMethodToSweep();
  gpu->Update();
  const auto before = vtkSmartPointer<vtkFloatArray>(ArrayOf(gpu, "ShadowHeight"));
  window->Finalize();
  gpu->Modified();
  gpu->Update();
  EXPECT_TRUE(gpu->IsOnDevice());
  EXPECT_EQ(Difference(ArrayOf(gpu, "ShadowHeight"), before), 0.0);
  gpu->SetDevice(this->Device);
  gpu->Update();
  EXPECT_TRUE(gpu->IsOnDevice());
  EXPECT_EQ(Difference(ArrayOf(gpu, "ShadowHeight"), before), 0.0);
}

TEST_F(ShadowGpu, AFieldBeyondTheLargestTextureIsTheHosts)
{
  this->Device->SetTextureLimit(40);
  const auto image = ImageOf<vtkDoubleArray>(Hills(50, 30));
  vtkNew<vtkOpenGLHeightFieldShadowHeight> gpu;
  vtkNew<ErrorCatcher> errors;
  errors->Watch(gpu);
  gpu->SetDevice(this->Device);
  gpu->SetInputData(image);
  gpu->Update();
  gpu->Modified();
  gpu->Update();
  EXPECT_FALSE(gpu->IsOnDevice());
  EXPECT_EQ(errors->Count, 1);
  EXPECT_NE(errors->Text.find("50 x 30 posts exceed the largest texture, 40 posts per side"),
    std::string::npos)
    << errors->Text;
  vtkNew<vtkHeightFieldShadowHeight> host;
  host->SetInputData(image);
  host->Update();
  EXPECT_EQ(Difference(ArrayOf(gpu, "ShadowHeight"), ArrayOf(host, "ShadowHeight")), 0.0);
}

TEST_F(ShadowGpu, BadSettingsAreErrorsAsOnTheHost)
{
  vtkNew<vtkOpenGLHeightFieldShadowHeight> gpu;
  vtkNew<ErrorCatcher> errors;
  errors->Watch(gpu);
  gpu->SetDevice(this->Device);
  gpu->SetInputData(ImageOf<vtkDoubleArray>(Hills(30, 20)));
  gpu->SetMethodToPyramid();
  gpu->Update();
  EXPECT_EQ(errors->Count, 1);
  EXPECT_NE(errors->Text.find("the pyramid has no shadow heights"), std::string::npos)
    << errors->Text;
}

// Runs without a context too: no machine has a device 12345.
TEST(ShadowGpuFailures, WithoutAContextTheHostComputesAndSaysSoOnce)
{
  const auto image = ImageOf<vtkDoubleArray>(Hills(30, 20));
  vtkNew<vtkSkylineEGLWindow> window;
  window->SetDevice(12345);
  vtkNew<ErrorCatcher> silence;
  window->AddObserver(vtkCommand::ErrorEvent, silence);
  vtkNew<vtkOpenGLHeightFieldShadowHeight> gpu;
  vtkNew<ErrorCatcher> errors;
  errors->Watch(gpu);
  gpu->GetDevice()->SetRenderWindow(window);
  gpu->SetInputData(image);
  gpu->Update();
  gpu->Modified();
  gpu->Update();
  EXPECT_FALSE(gpu->IsOnDevice());
  EXPECT_EQ(errors->Count, 1);
  vtkNew<vtkHeightFieldShadowHeight> host;
  host->SetInputData(image);
  host->Update();
  EXPECT_EQ(Difference(ArrayOf(gpu, "ShadowHeight"), ArrayOf(host, "ShadowHeight")), 0.0);
}

} // namespace
} // namespace testing
} // namespace skyline
