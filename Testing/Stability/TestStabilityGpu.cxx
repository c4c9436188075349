// SPDX-License-Identifier: BSD-3-Clause
// The graphics processor on all extreme fields, compared with the host. Skipped, with the reason,
// if there is no context.
#include "HorizonBounds.h"
#include "StabilityScenes.h"

#include "Testing/Rendering/GpuTesting.h"

#include "vtkOpenGLHeightFieldHorizon.h"
#include "vtkOpenGLHeightFieldIrradiance.h"
#include "vtkOpenGLHeightFieldTransfer.h"
#include "vtkOpenGLHeightFieldVisibility.h"

#include "vtkSkylineEnvironmentLight.h"

namespace skyline
{
namespace testing
{
namespace
{

class StabilityOfGpu : public GpuTest
{
protected:
  /// Updates both filters and compares their arrays for all scenes. bound(field): the allowed
  /// difference.
  template <typename Gpu, typename Host, typename Bound>
  void CompareAll(Gpu* gpu, Host* host, const char* name, const Bound& bound)
  {
    gpu->SetDevice(this->Device);
    for (const StabilityScene& scene : StabilityScenes())
    {
      for (const bool floats : { false, true })
      {
        oracle::OracleField field = scene.Make();
        field = floats ? AsFloats(field) : field;
        const auto image = floats ? ImageOf<vtkFloatArray>(field) : ImageOf<vtkDoubleArray>(field);
        gpu->SetInputData(image);
        host->SetInputData(image);
        gpu->Update();
        host->Update();
        EXPECT_TRUE(gpu->IsOnDevice()) << scene.Name;
        EXPECT_LE(Difference(ArrayOf(gpu, name), ArrayOf(host, name)), bound(field))
          << scene.Name << (floats ? " of floats" : " of doubles");
      }
    }
  }
};

/// The same differences of floats, summed in another order. Both have the rounding error of a level
/// horizon, where a difference of slopes is the greatest angle.
double HorizonBound(const oracle::OracleField& field)
{
  return std::min(180.0, 2.0 * ElevationRounding(field, 0.0) + 6.0e-5);
}

TEST_F(StabilityOfGpu, ExactHorizons)
{
  vtkNew<vtkOpenGLHeightFieldHorizon> gpu;
  vtkNew<vtkHeightFieldHorizon> host;
  for (vtkHeightFieldHorizon* filter :
    { static_cast<vtkHeightFieldHorizon*>(gpu), host.GetPointer() })
  {
    filter->SetNumberOfAzimuths(16);
  }
  this->CompareAll(gpu.GetPointer(), host.GetPointer(), "HorizonElevation", HorizonBound);
}

TEST_F(StabilityOfGpu, PyramidHorizons)
{
  vtkNew<vtkOpenGLHeightFieldHorizon> gpu;
  vtkNew<vtkHeightFieldHorizon> host;
  for (vtkHeightFieldHorizon* filter :
    { static_cast<vtkHeightFieldHorizon*>(gpu), host.GetPointer() })
  {
    filter->SetMethodToPyramid();
    filter->SetNumberOfAzimuths(12);
  }
  // Sixteen heights and as many levels are summed in another order.
  this->CompareAll(gpu.GetPointer(), host.GetPointer(), "HorizonElevation",
    [](const auto& field) { return std::min(90.0, 8.0 * HorizonBound(field) + 1.0e-3); });
}

/// The change of a coefficient is at most a few times that of the horizon.
double HarmonicBound(const oracle::OracleField& field)
{
  return std::min(3.0, 2.0e-5 + 8.0 * HorizonBound(field) * RadiansPerDegree);
}

TEST_F(StabilityOfGpu, Visibility)
{
  vtkNew<vtkOpenGLHeightFieldVisibility> gpu;
  vtkNew<vtkHeightFieldVisibility> host;
  gpu->SetNumberOfAzimuths(8);
  host->SetNumberOfAzimuths(8);
  this->CompareAll(gpu.GetPointer(), host.GetPointer(), "VisibilitySH", HarmonicBound);
}

TEST_F(StabilityOfGpu, Transfer)
{
  vtkNew<vtkOpenGLHeightFieldTransfer> gpu;
  vtkNew<vtkHeightFieldTransfer> host;
  gpu->SetNumberOfAzimuths(8);
  host->SetNumberOfAzimuths(8);
  this->CompareAll(gpu.GetPointer(), host.GetPointer(), "TransferSH", HarmonicBound);
}

TEST_F(StabilityOfGpu, Irradiance)
{
  vtkNew<vtkSkylineEnvironmentLight> sky;
  sky->SetSource(vtkSkylineEnvironmentLight::CIE);
  vtkNew<vtkOpenGLHeightFieldIrradiance> gpu;
  vtkNew<vtkHeightFieldIrradiance> host;
  for (vtkHeightFieldIrradiance* filter :
    { static_cast<vtkHeightFieldIrradiance*>(gpu), host.GetPointer() })
  {
    filter->SetNumberOfAzimuths(8);
    filter->SetLightMethodToHarmonics();
    filter->AddLight(sky);
  }
  // Sixteen coefficients times those of a sky with an irradiance of a few units.
  this->CompareAll(gpu.GetPointer(), host.GetPointer(), "Irradiance",
    [](const auto& field) { return 16.0 * HarmonicBound(field); });
}

} // namespace
} // namespace testing
} // namespace skyline
