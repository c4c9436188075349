// SPDX-License-Identifier: BSD-3-Clause
#include "SunLight.h"

#include "Constants.h"
#include "Failure.h"
#include "GroundMetric.h"
#include "SunPosition.h"

#include "vtkHeightFieldSunShadow.h"

#include <cmath>
#include <exception>
#include <sstream>

namespace
{

// Two numbers and a comma; false for anything else.
bool ParseDirection(const std::string& text, double& azimuth, double& elevation)
{
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos)
  {
    return false;
  }
  return CLI::detail::lexical_cast(text.substr(0, comma), azimuth) &&
    CLI::detail::lexical_cast(text.substr(comma + 1), elevation);
}

double Turned(double degrees)
{
  const double turned = std::fmod(degrees, 360.0);
  return turned < 0.0 ? turned + 360.0 : turned;
}

std::string Text(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

} // namespace

namespace skyline
{

void SunOptions::AddTo(CLI::App& command)
{
  CLI::Option* time = command
                        .add_option("--time", this->Time,
                          "The sun of this moment at the place of the DEM, such as "
                          "2026-06-21T06:00Z or\n2026-06-21T08:00+02:00 (UTC without a zone); 1900 "
                          "to 2100")
                        ->type_name("TIME");
  command
    .add_option("--sun", this->Direction,
      "The sun in this direction: azimuth in degrees clockwise from grid north (any number),\n"
      "apparent elevation in degrees, -90 to 90. Default without --time: 315,45")
    ->type_name("AZ,EL")
    ->check(CLI::Validator(
      [](std::string& text)
      {
        double azimuth, elevation;
        return ParseDirection(text, azimuth, elevation) ? std::string()
                                                        : "needs two numbers AZ,EL, not " + text;
      },
      ""))
    ->excludes(time);
  command
    .add_option("--sun-radius", this->Radius,
      "Angular radius of the sun's disc in degrees, 0 to less than 90; 0: hard shadows.\n"
      "Default: the true one with --time, 0.26645 otherwise")
    ->type_name("DEG");
  command.add_flag("--limb-darkening", this->LimbDarkening,
    "Let the sun's disc be darker at its edge, as the true one is");
}

SunLight FindSun(const SunOptions& options, const Georeference& place, double height)
{
  SunLight sun;
  sun.Radius = MeanSunRadius;
  const double column = 0.5 * static_cast<double>(place.Columns - 1);
  const double row = 0.5 * static_cast<double>(place.Rows - 1);
  sun.TrueNorth = place.OnBody();
  if (!options.Time.empty())
  {
    if (!place.OnBody())
    {
      throw Failure(
        "--time needs a DEM with a CRS, to know the place; give the sun by --sun AZ,EL");
    }
    if (!place.Earth)
    {
      throw Failure("--time knows the sun over the Earth alone; give the sun by --sun AZ,EL");
    }
    double longitude, latitude;
    place.LonLatAt(column, row, longitude, latitude);
    const SunDirection there =
      ComputeSun(ParseUtcTime(options.Time), longitude, latitude, height, StandardAir(height));
    sun.FromTime = true;
    sun.TrueAzimuth = there.Azimuth;
    sun.GridAzimuth = place.GridAzimuthAt(column, row, there.Azimuth);
    sun.Elevation = there.Elevation;
    sun.ApparentElevation = there.ApparentElevation;
    sun.Radius = there.AngularRadius;
  }
  else if (!options.Direction.empty())
  {
    ParseDirection(options.Direction, sun.GridAzimuth, sun.Elevation);
  }
  if (!sun.FromTime)
  {
    if (!std::isfinite(sun.GridAzimuth))
    {
      throw Failure("sun azimuth " + Text(sun.GridAzimuth) + " is no angle");
    }
    if (!(std::abs(sun.Elevation) <= 90.0))
    {
      throw Failure("sun elevation " + Text(sun.Elevation) + " is out of range: -90 to 90 degrees");
    }
    sun.GridAzimuth = Turned(sun.GridAzimuth);
    sun.ApparentElevation = sun.Elevation;
    sun.TrueAzimuth =
      sun.TrueNorth ? place.TrueAzimuthAt(column, row, sun.GridAzimuth) : sun.GridAzimuth;
  }
  sun.SkyAzimuth = sun.GridAzimuth;
  if (sun.TrueNorth)
  {
    // Where the map keeps its angles both are one.
    const double ground = place.GroundAzimuthAt(column, row, sun.TrueAzimuth);
    if (std::abs(std::remainder(ground - sun.GridAzimuth, 360.0)) > AzimuthTolerance)
    {
      sun.SkyAzimuth = ground;
    }
  }
  if (options.Radius != TrueRadius)
  {
    if (!(options.Radius >= 0.0 && options.Radius < 90.0))
    {
      throw Failure(
        "sun radius " + Text(options.Radius) + " is out of range: 0 to less than 90 degrees");
    }
    sun.Radius = options.Radius;
  }
  return sun;
}

void ApplySun(const SunOptions& options, const SunLight& sun, vtkHeightFieldSunShadow* shadow)
{
  shadow->SetSunAzimuth(sun.GridAzimuth);
  shadow->SetSunElevation(sun.ApparentElevation);
  shadow->SetSunAngularRadius(sun.Radius);
  shadow->SetTrueRadius(options.Radius == TrueRadius);
  shadow->SetUseTime(sun.FromTime);
  shadow->SetTime(options.Time.c_str());
  shadow->SetLimbDarkening(options.LimbDarkening);
}

} // namespace skyline
