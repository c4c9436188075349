// SPDX-License-Identifier: BSD-3-Clause
#include "PlacedSun.h"

#include "Sun/HoursAfter.h"
#include "Sun/SunDisc.h"
#include "vtkSkylineSunLight.h"

#include <stdexcept>
#include <string>

namespace skyline
{

namespace
{

UtcTime MomentOf(vtkSkylineSunLight* sun)
{
  const std::string time = sun->GetTime();
  if (time.empty())
  {
    throw std::invalid_argument("the sun has no time; set its Time, such as 2026-06-21T14:00Z");
  }
  return HoursAfter(ParseUtcTime(time), sun->GetHoursLater());
}

} // namespace

SunField SunFieldOf(vtkSkylineSunLight* sun, const Georeference& place, double meanHeight)
{
  return sun->GetUseTime()
    ? SunField(place, MomentOf(sun), meanHeight)
    : SunField::OnImage(place, sun->GetAzimuth(), sun->GetElevation(), sun->GetAngularRadius());
}

EclipseField EclipseFieldOf(vtkSkylineSunLight* sun, const Georeference& place, double meanHeight)
{
  return sun->GetUseTime() ? EclipseField(place, MomentOf(sun), meanHeight) : EclipseField();
}

double RadiusOf(vtkSkylineSunLight* sun, const SunField& field)
{
  const double radius =
    sun->GetUseTime() && sun->GetTrueRadius() ? field.Radius() : sun->GetAngularRadius();
  if (!(radius >= 0.0 && radius < 90.0))
  {
    throw std::out_of_range(
      "sun radius " + std::to_string(radius) + " is outside 0 to below 90; give degrees");
  }
  return radius;
}

double LimbDarkeningOf(vtkSkylineSunLight* sun)
{
  return sun->GetLimbDarkening() ? EddingtonLimbDarkening : 0.0;
}

} // namespace skyline
