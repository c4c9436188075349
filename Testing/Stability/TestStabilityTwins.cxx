// SPDX-License-Identifier: BSD-3-Clause
// The graphics processor on every extreme field, beside the host; skipped, with the reason, where no
// context can be had.
#include "HorizonBounds.h"
#include "StabilityScenes.h"

#include "../Twins/TwinTesting.h"

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

class StabilityOfTwins : public Twins
{
protected:
  /// Updates both and compares the arrays, on all scenes: bound(scene) is what they may differ by.
  template <typename Twin, typename Host, typename Bound>
  void CompareAll(Twin* twin, Host* host, const char* name, const Bound& bound)
  {
    twin->SetDevice(this->Device);
    for (const StabilityScene& scene : StabilityScenes())
    {
      for (const bool floats : { false, true })
      {
        oracle::OracleField field = scene.Make();
        field = floats ? AsFloats(field) : field;
        const auto image = floats ? ImageOf<vtkFloatArray>(field) : ImageOf<vtkDoubleArray>(field);
        twin->SetInputData(image);
        host->SetInputData(image);
        twin->Update();
        host->Update();
        EXPECT_TRUE(twin->IsOnDevice()) << scene.Name;
        EXPECT_LE(Difference(ArrayOf(twin, name), ArrayOf(host, name)), bound(field))
          << scene.Name << (floats ? " of floats" : " of doubles");
      }
    }
  }
};

/// The same differences of floats, summed in another order: both err by what rounding allows at the
/// steepest, which is where an angle spans most of it, near level ground.
double HorizonBound(const oracle::OracleField& field)
{
  return std::min(180.0, 2.0 * ElevationRounding(field, 0.0) + 6.0e-5);
}

TEST_F(StabilityOfTwins, ExactHorizons)
{
  vtkNew<vtkOpenGLHeightFieldHorizon> twin;
  vtkNew<vtkHeightFieldHorizon> host;
  for (vtkHeightFieldHorizon* filter :
    { static_cast<vtkHeightFieldHorizon*>(twin), host.GetPointer() })
  {
    filter->SetNumberOfAzimuths(16);
  }
  this->CompareAll(twin.GetPointer(), host.GetPointer(), "HorizonElevation", HorizonBound);
}

TEST_F(StabilityOfTwins, PyramidHorizons)
{
  vtkNew<vtkOpenGLHeightFieldHorizon> twin;
  vtkNew<vtkHeightFieldHorizon> host;
  for (vtkHeightFieldHorizon* filter :
    { static_cast<vtkHeightFieldHorizon*>(twin), host.GetPointer() })
  {
    filter->SetMethodToPyramid();
    filter->SetNumberOfAzimuths(12);
  }
  // Sixteen heights and as many levels are summed in another order.
  this->CompareAll(twin.GetPointer(), host.GetPointer(), "HorizonElevation",
    [](const auto& field) { return std::min(90.0, 8.0 * HorizonBound(field) + 1.0e-3); });
}

/// A coefficient changes with a horizon by no more than a few times the angle.
double HarmonicBound(const oracle::OracleField& field)
{
  return std::min(3.0, 2.0e-5 + 8.0 * HorizonBound(field) * RadiansPerDegree);
}

TEST_F(StabilityOfTwins, Visibility)
{
  vtkNew<vtkOpenGLHeightFieldVisibility> twin;
  vtkNew<vtkHeightFieldVisibility> host;
  twin->SetNumberOfAzimuths(8);
  host->SetNumberOfAzimuths(8);
  this->CompareAll(twin.GetPointer(), host.GetPointer(), "VisibilitySH", HarmonicBound);
}

TEST_F(StabilityOfTwins, Transfer)
{
  vtkNew<vtkOpenGLHeightFieldTransfer> twin;
  vtkNew<vtkHeightFieldTransfer> host;
  twin->SetNumberOfAzimuths(8);
  host->SetNumberOfAzimuths(8);
  this->CompareAll(twin.GetPointer(), host.GetPointer(), "TransferSH", HarmonicBound);
}

TEST_F(StabilityOfTwins, Irradiance)
{
  vtkNew<vtkSkylineEnvironmentLight> sky;
  sky->SetSource(vtkSkylineEnvironmentLight::CIE);
  vtkNew<vtkOpenGLHeightFieldIrradiance> twin;
  vtkNew<vtkHeightFieldIrradiance> host;
  for (vtkHeightFieldIrradiance* filter :
    { static_cast<vtkHeightFieldIrradiance*>(twin), host.GetPointer() })
  {
    filter->SetNumberOfAzimuths(8);
    filter->SetLightMethodToHarmonics();
    filter->AddLight(sky);
  }
  // Sixteen coefficients times those of a sky of some units of irradiance.
  this->CompareAll(twin.GetPointer(), host.GetPointer(), "Irradiance",
    [](const auto& field) { return 16.0 * HarmonicBound(field); });
}

} // namespace
} // namespace testing
} // namespace skyline
