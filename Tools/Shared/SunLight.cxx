// SPDX-License-Identifier: BSD-3-Clause
#include "SunLight.h"

#include "Failure.h"
#include "Geo/GroundMetric.h"
#include "IdleOptions.h"
#include "Shared/Constants.h"
#include "Sun/SunPosition.h"
#include "Sun/UtcTime.h"
#include "Values.h"

#include "vtkHeightFieldSunShadow.h"

#include <cmath>
#include <exception>

namespace
{

constexpr double MostElevation = 90.0; // degrees

const skyline::Limits RadiusLimits{ "0 to less than 90 degrees", 0.0, 90.0, false, true };

std::string CheckTime(const std::string& text)
{
  try
  {
    const skyline::SunEphemeris years(skyline::ParseUtcTime(text));
    return "";
  }
  catch (const std::exception& reason)
  {
    return reason.what();
  }
}

std::string CheckDirection(const std::string& text)
{
  const auto numbers = skyline::ReadNumbers(text);
  if (!numbers)
  {
    return skyline::WhyNoNumbers(text) + "; give two numbers AZ,EL";
  }
  if (numbers->size() != 2)
  {
    return text + " is no direction; give two numbers AZ,EL";
  }
  return std::abs((*numbers)[1]) > MostElevation
    ? "elevation " + skyline::NumberText((*numbers)[1]) + " is out of range; give -90 to 90 degrees"
    : "";
}

double Turned(double degrees)
{
  const double turned = std::fmod(degrees, 360.0);
  return turned < 0.0 ? turned + 360.0 : turned;
}

} // namespace

namespace skyline
{

void SunOptions::AddTo(CLI::App& command, bool limbDarkening)
{
  CLI::Option* time = command
                        .add_option("--time", this->Time,
                          "The sun of this moment at the place of the DEM, such as "
                          "2026-06-21T06:00Z or\n2026-06-21T08:00+02:00 (UTC without a zone); 1900 "
                          "to 2100")
                        ->type_name("TIME")
                        ->check(Checked(CheckTime));
  command
    .add_option("--sun", this->Direction,
      "The sun in this direction: azimuth in degrees clockwise from grid north (any number),\n"
      "apparent elevation in degrees, -90 to 90. Default without --time: 315,45")
    ->type_name("AZ,EL")
    ->check(Checked(CheckDirection))
    ->excludes(time);
  AddNumber(command, "--sun-radius", this->Radius, RadiusLimits,
    "Angular radius of the sun's disc in degrees, 0 to less than 90; 0: hard shadows.\n"
    "Default: the true one with --time, " +
      NumberText(MeanSunRadius) + " otherwise")
    ->type_name("DEG");
  if (limbDarkening)
  {
    command.add_flag("--limb-darkening", this->LimbDarkening,
      "Let the sun's disc be darker at its edge, as the true one is");
  }
}

void SunOptions::RefuseIdle(const IdleOptions& options) const
{
  options.Refuse(this->Radius == 0.0, { "--limb-darkening" },
    "a sun of --sun-radius 0 is a point without a limb; leave one of the two out");
}

void SunOptions::WarnOfZone(const Talk& talk) const
{
  if (!this->Time.empty() && !NamesZone(this->Time))
  {
    PrintWarning(Doubt{ "the time " + this->Time + " has no zone", "UTC",
                   "--time " + ToText(ParseUtcTime(this->Time)) },
      talk);
  }
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
    const auto numbers = ReadNumbers(options.Direction);
    sun.GridAzimuth = (*numbers)[0];
    sun.Elevation = (*numbers)[1];
  }
  if (!sun.FromTime)
  {
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
  sun.Radius = options.Radius.value_or(sun.Radius);
  return sun;
}

void ApplySun(const SunOptions& options, const SunLight& sun, vtkHeightFieldSunShadow* shadow)
{
  shadow->SetSunAzimuth(sun.GridAzimuth);
  shadow->SetSunElevation(sun.ApparentElevation);
  shadow->SetSunAngularRadius(sun.Radius);
  shadow->SetTrueRadius(!options.Radius);
  shadow->SetUseTime(sun.FromTime);
  shadow->SetTime(options.Time.c_str());
  shadow->SetLimbDarkening(options.LimbDarkening);
}

} // namespace skyline
