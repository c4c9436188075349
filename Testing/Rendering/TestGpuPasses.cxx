// SPDX-License-Identifier: BSD-3-Clause
// Counts the passes, horizons and pyramids: the filter must omit those that a scene does not need.
#include "GpuTesting.h"

#include "vtkOpenGLHeightFieldIrradiance.h"
#include "vtkOpenGLHeightFieldVisibility.h"

#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineKeyLight.h"
#include "vtkSkylineLampLight.h"
#include "vtkSkylineSunLight.h"

namespace skyline
{
namespace testing
{
namespace
{

class Passes : public GpuTest
{
protected:
  void SetUp() override
  {
    this->GpuTest::SetUp();
    this->Light->SetDevice(this->Device);
    this->Light->SetInputData(this->Image);
    this->Light->SetMethodToPyramid();
    this->Light->SetNumberOfAzimuths(6);
    this->Lamp->SetPosition(800.0, 700.0, 2000.0);
    this->Lamp->SetRadius(50.0);
  }

  /// The numbers of searched azimuths and of the passes for distant lights, suns and lamps.
  std::array<int, 4> Counts(vtkHeightFieldIrradiance* filter)
  {
    filter->Update();
    return { { filter->GetSearchedAzimuths(), filter->GetEnvironmentPasses(),
      filter->GetSunPasses(), filter->GetLampPasses() } };
  }

  const vtkSmartPointer<vtkImageData> Image = ImageOf<vtkDoubleArray>(Hills(60, 50));
  vtkNew<vtkOpenGLHeightFieldIrradiance> Light;
  vtkNew<vtkSkylineEnvironmentLight> Sky;
  vtkNew<vtkSkylineKeyLight> Key;
  vtkNew<vtkSkylineLampLight> Lamp;
};

using Count = std::array<int, 4>;

TEST_F(Passes, NoLampNoLampPass)
{
  this->Light->AddLight(this->Sky);
  EXPECT_EQ(this->Counts(this->Light), (Count{ { 6, 1, 0, 0 } }));
  this->Light->AddLight(this->Lamp);
  EXPECT_EQ(this->Counts(this->Light), (Count{ { 0, 0, 0, 1 } })) << "the transfer is there";
  this->Lamp->SwitchOff();
  EXPECT_EQ(this->Counts(this->Light), (Count{ { 0, 0, 0, 0 } }));
}

TEST_F(Passes, LampsAloneTakeNothingThere)
{
  this->Light->AddLight(this->Lamp);
  EXPECT_EQ(this->Counts(this->Light), (Count{ { 0, 0, 0, 1 } }));
  EXPECT_FALSE(this->Light->IsOnDevice());
  EXPECT_EQ(this->Light->GetTexture(), nullptr);
  EXPECT_EQ(this->Light->GetPyramidBuilds(), 0);
}

TEST_F(Passes, ASunAloneSweepsItsSwath)
{
  vtkNew<vtkSkylineSunLight> sun;
  sun->SetAzimuth(200.0);
  sun->SetElevation(20.0);
  vtkNew<vtkHeightFieldIrradiance> host;
  host->SetInputData(this->Image);
  host->SetMethodToPyramid();
  host->AddLight(sun);
  this->Light->AddLight(sun);
  this->Light->SetLightMethodToTable(); // harmonics do not include a sun
  this->Light->SetNumberOfAzimuths(128);
  const Count counts = this->Counts(host);
  EXPECT_EQ(this->Counts(this->Light), counts);
  EXPECT_LT(counts[0], 128 / 4);
  EXPECT_EQ(counts, (Count{ { counts[0], 0, 1, 0 } }));
}

TEST_F(Passes, ChangedLightsTakeNoHorizonsAndNoPyramid)
{
  this->Light->AddLight(this->Key);
  EXPECT_EQ(this->Counts(this->Light), (Count{ { 6, 1, 0, 0 } }));
  EXPECT_EQ(this->Light->GetPyramidBuilds(), 1);
  this->Key->SetElevation(12.0);
  EXPECT_EQ(this->Counts(this->Light), (Count{ { 0, 0, 0, 0 } }));
  EXPECT_EQ(this->Light->GetPyramidBuilds(), 0);
  this->Light->SetNumberOfAzimuths(8);
  EXPECT_EQ(this->Counts(this->Light), (Count{ { 8, 1, 0, 0 } }));
  EXPECT_EQ(this->Light->GetPyramidBuilds(), 0) << "the heights are the same";
}

// In one tile, and in several.
TEST_F(Passes, UnchangedHeightsKeepTheirPyramid)
{
  for (const int limit : { 0, 32 })
  {
    vtkNew<vtkOpenGLHeightFieldVisibility> gpu;
    vtkNew<vtkHeightFieldVisibility> host;
    this->Device->SetTextureLimit(limit);
    gpu->SetDevice(this->Device);
    const auto builds = [&](double azimuth, double distance)
    {
      for (vtkHeightFieldVisibility* filter :
        { static_cast<vtkHeightFieldVisibility*>(gpu), host.GetPointer() })
      {
        filter->SetInputData(this->Image);
        filter->SetMethodToPyramid();
        filter->SetNumberOfAzimuths(3);
        filter->SetSwathWidth(20.0);
        filter->SetSwathAzimuth(azimuth);
        filter->SetLevelDistance(distance);
        filter->Update();
      }
      EXPECT_TRUE(gpu->IsOnDevice());
      constexpr double rounding = 1.0e-5; // as in TestGpuHarmonics
      EXPECT_LT(Difference(ArrayOf(gpu, "VisibilitySH"), ArrayOf(host, "VisibilitySH")), rounding);
      return gpu->GetPyramidBuilds();
    };
    EXPECT_EQ(builds(40.0, 1.0), 1);
    EXPECT_EQ(builds(130.0, 1.0), 0);
    EXPECT_EQ(builds(130.0, 1.7), 0);
    vtkDataArray* heights = this->Image->GetPointData()->GetScalars();
    heights->SetComponent(1234, 0, heights->GetComponent(1234, 0) + 90.0);
    this->Image->Modified();
    EXPECT_EQ(builds(130.0, 1.7), 1);
  }
}

} // namespace
} // namespace testing
} // namespace skyline
