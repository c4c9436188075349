// SPDX-License-Identifier: BSD-3-Clause
#include "SunLight.h"

#include "Failure.h"
#include "Geo/Azimuth.h"
#include "Geo/GroundMetric.h"
#include "Shared/Constants.h"
#include "Sun/SunPosition.h"
#include "Sun/UtcTime.h"

#include "vtkSkylineSunLight.h"

#include <cmath>

namespace skyline
{

SunLight FindSun(const SunDescription& asked, const Georeference& place, double height)
{
  SunLight sun;
  sun.Radius = MeanSunRadius;
  const double column = 0.5 * static_cast<double>(place.Columns - 1);
  const double row = 0.5 * static_cast<double>(place.Rows - 1);
  sun.TrueNorth = place.OnBody();
  if (!asked.Time.empty())
  {
    if (!place.OnBody())
    {
      throw Failure(
        "--time needs a DEM with a CRS, which gives the place; give the sun by --sun AZ,EL");
    }
    if (!place.Earth)
    {
      throw Failure("--time works on the Earth only; give the sun by --sun AZ,EL");
    }
    double longitude, latitude;
    place.LonLatAt(column, row, longitude, latitude);
    const SunDirection there =
      ComputeSun(ParseUtcTime(asked.Time), longitude, latitude, height, StandardAir(height));
    sun.FromTime = true;
    sun.TrueAzimuth = there.Azimuth;
    sun.GridAzimuth = place.GridAzimuthAt(column, row, there.Azimuth);
    sun.Elevation = there.Elevation;
    sun.ApparentElevation = there.ApparentElevation;
    sun.Radius = there.AngularRadius;
  }
  else
  {
    const SunAngles angles = asked.Direction.value_or(SunAngles());
    sun.GridAzimuth = NormalizedAzimuth(angles.Azimuth);
    sun.Elevation = angles.Elevation;
    sun.ApparentElevation = sun.Elevation;
    sun.TrueAzimuth =
      sun.TrueNorth ? place.TrueAzimuthAt(column, row, sun.GridAzimuth) : sun.GridAzimuth;
  }
  sun.SkyAzimuth = sun.GridAzimuth;
  if (sun.TrueNorth)
  {
    // On a map that preserves angles both are the same.
    const double ground = place.GroundAzimuthAt(column, row, sun.TrueAzimuth);
    if (std::abs(std::remainder(ground - sun.GridAzimuth, 360.0)) > AzimuthTolerance)
    {
      sun.SkyAzimuth = ground;
    }
  }
  sun.Radius = asked.Radius.value_or(sun.Radius);
  return sun;
}

void ApplySun(const SunDescription& asked, const SunLight& sun, vtkSkylineSunLight* light)
{
  light->SetAzimuth(sun.GridAzimuth);
  light->SetElevation(sun.ApparentElevation);
  light->SetAngularRadius(sun.Radius);
  light->SetTrueRadius(!asked.Radius);
  light->SetUseTime(sun.FromTime);
  light->SetTime(asked.Time.c_str());
  light->SetLimbDarkening(asked.LimbDarkening);
}

} // namespace skyline
