// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldSunShadow.h"

#include "HorizonDriver.h"
#include "PlacedSun.h"
#include "PostArrays.h"
#include "Sun/SunAccumulator.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeightFieldSunShadow);

namespace
{

void TakeEclipse(const skyline::EclipseField& eclipse, const skyline::Grid& posts,
  double limbDarkening, float* visibility)
{
  vtkSMPTools::For(0, posts.Rows,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<float> left(static_cast<std::size_t>(posts.Columns));
      for (vtkIdType row = begin; row < end; ++row)
      {
        eclipse.Uncovered(row, 0, posts.Columns, limbDarkening, left.data());
        float* lit = visibility + row * posts.Columns;
        std::transform(left.begin(), left.end(), lit, lit, std::multiplies<>());
      }
    });
}

} // namespace

void vtkHeightFieldSunShadow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SearchedAzimuths: " << this->SearchedAzimuths << "\n";
}

bool vtkHeightFieldSunShadow::Compute(skyline::HorizonDriver& driver, vtkImageData* output)
{
  constexpr double radians = skyline::RadiansPerDegree;
  const skyline::SunField sun =
    skyline::SunFieldOf(this->Sun, driver.Input().Place(), driver.Input().BaseHeight());
  const skyline::EclipseField eclipse =
    skyline::EclipseFieldOf(this->Sun, driver.Input().Place(), driver.Input().BaseHeight());
  const double radius = skyline::RadiusOf(this->Sun, sun);
  double firstAzimuth = 0.0;
  double lastAzimuth = 0.0;
  double least = 0.0;
  double greatest = 0.0;
  sun.AzimuthBounds(firstAzimuth, lastAzimuth);
  sun.ElevationBounds(least, greatest);
  const std::vector<double> azimuths = skyline::SunAzimuths(firstAzimuth * radians,
    lastAzimuth * radians, least * radians, greatest * radians, radius * radians);
  this->SearchedAzimuths = static_cast<int>(azimuths.size());

  driver.DemandFloats("shadows of the sun", sun.Same() ? 2 : 3, azimuths);
  vtkFloatArray* visibility = skyline::AddPostArray(output, "SunVisibility");
  const skyline::PostBuffer buffer{ visibility->GetPointer(0), 1 };
  const skyline::Grid& posts = driver.Input().Posts();
  const double darkening = skyline::LimbDarkeningOf(this->Sun);
  const auto run = [&](skyline::SunAccumulator&& disc) { return driver.Run(azimuths, 0.0, disc); };
  bool finished = false;
  if (!sun.Same())
  {
    const auto directions = [&sun](std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count,
                              float* x, float* y, float* z)
    { sun.Row(row, column, count, x, y, z); };
    finished = run(skyline::SunAccumulator(
      posts.Columns, posts.Rows, directions, radius * radians, buffer, darkening));
  }
  else
  {
    const skyline::SunDisc disc{ std::fmod(this->GetSunAzimuth(), 360.0) * radians,
      this->GetSunElevation() * radians, radius * radians };
    finished = run(skyline::SunAccumulator(posts.Columns, posts.Rows, disc, buffer, darkening));
  }
  if (finished)
  {
    if (eclipse.Any())
    {
      TakeEclipse(eclipse, posts, darkening, visibility->GetPointer(0));
    }
    skyline::BlankMissing(driver.Input().Field(), visibility);
  }
  return finished;
}
