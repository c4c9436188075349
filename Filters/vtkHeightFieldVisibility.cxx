// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldVisibility.h"

#include "Azimuths.h"
#include "HarmonicBands.h"
#include "Harmonics/VisibilityAccumulator.h"
#include "Horizon/Swath.h"
#include "HorizonDriver.h"
#include "PostArrays.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeightFieldVisibility);

namespace
{

// The azimuths in a swath given in degrees, in radians clockwise from grid north.
std::vector<double> AzimuthsInside(double azimuth, double width, int count)
{
  std::vector<double> azimuths = skyline::EvenAzimuths(count); // checks the count
  if (!std::isfinite(azimuth))
  {
    throw std::invalid_argument("the swath's azimuth is not a finite number; give degrees");
  }
  if (!(width > 0.0 && width <= 360.0))
  {
    throw std::invalid_argument(
      "the swath is " + std::to_string(width) + " degrees wide; give more than 0 and at most 360");
  }
  if (width < 360.0)
  {
    const skyline::Swath swath{ azimuth * skyline::RadiansPerDegree,
      width * skyline::RadiansPerDegree };
    return skyline::AzimuthsOf(swath, count);
  }
  return azimuths;
}

} // namespace

void vtkHeightFieldVisibility::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfBands: " << this->NumberOfBands << "\n"
     << indent << "NumberOfAzimuths: " << this->NumberOfAzimuths << "\n"
     << indent << "SwathAzimuth: " << this->SwathAzimuth << "\n"
     << indent << "SwathWidth: " << this->SwathWidth << "\n";
}

bool vtkHeightFieldVisibility::Compute(skyline::HorizonDriver& driver, vtkImageData* output)
{
  return this->Project(driver, output, "VisibilitySH", false);
}

bool vtkHeightFieldVisibility::Project(
  skyline::HorizonDriver& driver, vtkImageData* output, const char* name, bool withCosine)
{
  skyline::CheckHarmonicBands(this->NumberOfBands);
  const std::vector<double> azimuths =
    AzimuthsInside(this->SwathAzimuth, this->SwathWidth, this->NumberOfAzimuths);
  const double width =
    this->SwathWidth * skyline::RadiansPerDegree / static_cast<double>(azimuths.size());
  // The sums, the azimuths of a group that wait, and the gradients.
  driver.DemandFloats("spherical harmonics",
    skyline::HarmonicCount(this->NumberOfBands) + skyline::WedgeGroup - 1 + (withCosine ? 2 : 0),
    azimuths);

  std::vector<float> gradients;
  const auto posts = static_cast<std::size_t>(output->GetNumberOfPoints());
  if (withCosine)
  {
    gradients.resize(2 * posts);
    driver.Input().FillGradients(gradients.data(), gradients.data() + posts);
  }
  vtkFloatArray* array =
    skyline::AddPostArray(output, name, skyline::HarmonicCount(this->NumberOfBands));
  if (!this->Sum(driver, azimuths, width, withCosine ? gradients.data() : nullptr,
        withCosine ? gradients.data() + posts : nullptr, array->GetPointer(0)))
  {
    return false;
  }
  skyline::BlankMissing(driver.Input().Field(), array);
  return true;
}

bool vtkHeightFieldVisibility::Sum(skyline::HorizonDriver& driver,
  const std::vector<double>& azimuths, double width, const float* east, const float* north,
  float* values)
{
  skyline::HarmonicBuffers buffers;
  buffers.Columns = driver.Input().Posts().Columns;
  buffers.Rows = driver.Input().Posts().Rows;
  buffers.Bands = this->NumberOfBands;
  buffers.Values = values;
  skyline::VisibilityAccumulator sky(buffers, east, north);
  return driver.Run(azimuths, width, sky);
}
