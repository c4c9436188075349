// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldShadowHeight.h"

#include "HorizonDriver.h"
#include "PlacedSun.h"
#include "PostArrays.h"
#include "ShadowHeight/ShadowHeight.h"
#include "ShadowHeight/ShadowHeightSweep.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>

vtkStandardNewMacro(vtkHeightFieldShadowHeight);

namespace
{

// Stores what a method of shadow heights finds, and converts it to heights in the frame of the
// input at the end.
class ShadowStore : public skyline::Accumulator
{
public:
  ShadowStore(const skyline::HorizonDriver& driver, vtkDataArray* heights, vtkFloatArray* shadows,
    bool belowTerrain)
    : Driver(driver)
    , Heights(heights)
    , Shadows(shadows->GetPointer(0))
    , Columns(driver.Input().Posts().Columns)
    , BelowTerrain(belowTerrain)
  {
  }

  void Begin(double, double) override {}

  void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* heights) override
  {
    std::copy_n(heights, count, this->Shadows + row * this->Columns + column);
  }

  void Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd) override
  {
    const double base = this->Driver.Input().BaseHeight();
    std::vector<float> buffer;
    for (std::ptrdiff_t row = rowBegin; row < rowEnd; ++row)
    {
      const float* receivers = this->Driver.Input().Field().Receivers(false, row, buffer);
      for (std::ptrdiff_t column = 0; column < this->Columns; ++column)
      {
        const vtkIdType post = row * this->Columns + column;
        float& shadow = this->Shadows[post];
        // Compares in the values of the kernel, so that rounding does not darken lit posts.
        const bool dark = shadow > receivers[column];
        const auto ground = static_cast<float>(this->Heights->GetComponent(post, 0));
        const auto found = static_cast<float>(base + static_cast<double>(shadow));
        if (dark)
        {
          shadow = std::max(found, std::nextafter(ground, std::numeric_limits<float>::max()));
        }
        else
        {
          shadow =
            this->BelowTerrain && shadow != skyline::NoShadow ? std::min(found, ground) : ground;
        }
      }
    }
  }

private:
  const skyline::HorizonDriver& Driver;
  vtkDataArray* Heights;
  float* Shadows;
  std::ptrdiff_t Columns;
  bool BelowTerrain;
};

// The sun as one direction on the image; with UseTime that over the middle of the posts.
skyline::GridSun OneSun(vtkSkylineSunLight* light, const skyline::HorizonDriver& driver)
{
  skyline::Georeference place = driver.Input().Place();
  place.GroundAxes = false;
  const skyline::SunField field = skyline::SunFieldOf(light, place, driver.Input().BaseHeight());
  if (!light->GetUseTime())
  {
    return { light->GetAzimuth(), light->GetElevation(), light->GetAngularRadius() };
  }
  skyline::GridSun sun = skyline::InTheMiddle(field, place);
  sun.Radius = skyline::RadiusOf(light, field);
  return sun;
}

} // namespace

void vtkHeightFieldShadowHeight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Soft: " << this->Soft << "\n"
     << indent << "BelowTerrain: " << this->BelowTerrain << "\n";
}

std::unique_ptr<skyline::HorizonMethod> vtkHeightFieldShadowHeight::MakeMethod(
  skyline::HorizonDriver& driver, double slope)
{
  if (this->Method == SWEEP)
  {
    return std::make_unique<skyline::ShadowHeightSweep>(driver.Input().Field(), slope);
  }
  return std::make_unique<skyline::ShadowHeightExact>(
    driver.Input().Field(), slope, driver.UsedSettings().CurvatureDrop);
}

bool vtkHeightFieldShadowHeight::AddShadow(skyline::HorizonDriver& driver, vtkImageData* output,
  const char* name, double azimuth, double elevation, bool risen, bool belowTerrain)
{
  vtkFloatArray* shadows = skyline::AddPostArray(output, name);
  if (!risen)
  {
    shadows->FillValue(std::numeric_limits<float>::infinity());
    skyline::BlankMissing(driver.Input().Field(), shadows);
    return true;
  }
  const auto method = this->MakeMethod(driver, skyline::ShadowSlope(elevation));
  ShadowStore store(driver, this->GetInputArrayToProcess(0, output), shadows, belowTerrain);
  const bool finished = driver.Run(
    *method, { azimuth * skyline::RadiansPerDegree }, 0.0, store, skyline::AzimuthAxes::Image);
  skyline::BlankMissing(driver.Input().Field(), shadows);
  return finished;
}

bool vtkHeightFieldShadowHeight::Compute(skyline::HorizonDriver& driver, vtkImageData* output)
{
  if (this->Method == PYRAMID)
  {
    throw std::invalid_argument("the pyramid has no shadow heights; use exact or sweep");
  }
  if (this->Surface != TRIANGLES)
  {
    throw std::invalid_argument("shadow heights are those of the triangles; set that surface");
  }
  const skyline::GridSun sun = OneSun(this->Sun, driver);
  const double azimuth = std::fmod(sun.Azimuth, 360.0);
  driver.DemandFloats(
    "shadow heights", this->Soft ? 3 : 1, { azimuth * skyline::RadiansPerDegree });
  driver.DoubtOneMetric("shadow heights", driver.Input().CentreMetric());
  const double elevation = sun.Elevation * skyline::RadiansPerDegree;
  const double radius = sun.Radius * skyline::RadiansPerDegree;
  if (elevation <= 0.0)
  {
    std::ostringstream degrees;
    degrees << sun.Elevation;
    driver.AddDoubt(
      { "the sun's centre stands at " + degrees.str() + " degrees, not above the horizontal plane",
        "everything is in shadow at any height: ShadowHeight is infinite, and nodata in a raster",
        "" });
  }
  bool finished = this->AddShadow(
    driver, output, "ShadowHeight", azimuth, elevation, elevation > 0.0, this->BelowTerrain);
  if (this->Soft && finished)
  {
    const bool risen = elevation + radius > 0.0;
    finished = this->AddShadow(
                 driver, output, "ShadowHeightUpper", azimuth, elevation + radius, risen, true) &&
      this->AddShadow(
        driver, output, "ShadowHeightLower", azimuth, elevation - radius, risen, true);
  }
  vtkNew<vtkDoubleArray> used;
  used->SetName("ShadowSun");
  used->SetNumberOfComponents(3);
  used->InsertNextTuple3(sun.Azimuth, sun.Elevation, sun.Radius);
  output->GetFieldData()->AddArray(used);
  return finished;
}
