// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/Astronomy.h"

#include "Shared/Constants.h"

#include <erfa.h>
#include <erfam.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace skyline
{

AstronomicalTimes ConvertUtc(const UtcTime& time, double ut1MinusUtc)
{
  double utc1 = 0.0, utc2 = 0.0;
  const int status = eraDtf2d(
    "UTC", time.Year, time.Month, time.Day, time.Hour, time.Minute, time.Second, &utc1, &utc2);
  // -1: a year before the calendar of ERFA begins; 1: a warning about a year without known leap
  // seconds.
  if (status == -1)
  {
    throw std::out_of_range(
      "time " + ToText(time) + " is too early for the calendar; give a time from 1900 to 2100");
  }
  if ((status != 0 && status != 1) || !std::isfinite(time.Second))
  {
    throw std::invalid_argument(
      "time " + ToText(time) + " does not exist; give one like 2026-06-21T06:00Z");
  }
  if (!(std::abs(ut1MinusUtc) <= 1.0))
  {
    throw std::out_of_range("UT1 - UTC of " + std::to_string(ut1MinusUtc) +
      " s is not within -1 to 1 s; use 0 if it is not known");
  }

  AstronomicalTimes times;
  double tai1 = 0.0, tai2 = 0.0;
  eraUtctai(utc1, utc2, &tai1, &tai2);
  eraTaitt(tai1, tai2, &times.Tt1, &times.Tt2);
  eraUtcut1(utc1, utc2, ut1MinusUtc, &times.Ut11, &times.Ut12);
  return times;
}

void CelestialToTerrestrial(const AstronomicalTimes& times, double matrix[3][3])
{
  eraC2i06a(times.Tt1, times.Tt2, matrix);
  eraRz(eraEra00(times.Ut11, times.Ut12), matrix);
}

std::array<double, 3> FromEarthCentre(double longitude, double latitude, double height)
{
  if (!std::isfinite(longitude) || !std::isfinite(height) || !(std::abs(latitude) <= 90.0))
  {
    throw std::out_of_range("place " + std::to_string(longitude) + "," + std::to_string(latitude) +
      "," + std::to_string(height) +
      " is not on the Earth; give longitude and latitude in degrees and a height in metres");
  }
  double place[3];
  eraGd2gc(ERFA_WGS84, longitude * RadiansPerDegree, latitude * RadiansPerDegree, height, place);
  return { place[0], place[1], place[2] };
}

LocalVector SeenFrom(
  const std::array<double, 3>& body, double longitude, double latitude, double height)
{
  const std::array<double, 3> place = FromEarthCentre(longitude, latitude, height);
  const double lambda = longitude * RadiansPerDegree;
  const double phi = latitude * RadiansPerDegree;
  const double x = body[0] - place[0];
  const double y = body[1] - place[1];
  const double z = body[2] - place[2];
  const double sinLambda = std::sin(lambda), cosLambda = std::cos(lambda);
  const double sinPhi = std::sin(phi), cosPhi = std::cos(phi);
  const double outward = cosLambda * x + sinLambda * y; // away from the axis of the Earth
  LocalVector seen;
  seen.East = cosLambda * y - sinLambda * x;
  seen.North = cosPhi * z - sinPhi * outward;
  seen.Up = sinPhi * z + cosPhi * outward;
  return seen;
}

} // namespace skyline
