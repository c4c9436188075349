// SPDX-License-Identifier: BSD-3-Clause
#include "SunPosition.h"

#include "Azimuth.h"
#include "Constants.h"

#include <erfa.h>
#include <erfam.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace skyline
{
namespace
{

struct AstronomicalTimes
{
  double Tt1 = 0.0, Tt2 = 0.0;   // terrestrial time, days
  double Ut11 = 0.0, Ut12 = 0.0; // UT1, days
};

AstronomicalTimes Convert(const UtcTime& time, double ut1MinusUtc)
{
  double utc1 = 0.0, utc2 = 0.0;
  const int status = eraDtf2d(
    "UTC", time.Year, time.Month, time.Day, time.Hour, time.Minute, time.Second, &utc1, &utc2);
  // -1 is a year before ERFA's calendar begins; 1 warns of a year without known leap seconds.
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

} // namespace

SunEphemeris::SunEphemeris(const UtcTime& time, double ut1MinusUtc)
{
  const AstronomicalTimes times = Convert(time, ut1MinusUtc);

  double heliocentric[2][3], barycentric[2][3];
  if (eraEpv00(times.Tt1, times.Tt2, heliocentric, barycentric) != 0)
  {
    throw std::out_of_range("time " + ToText(time) +
      " is outside the sun's ephemeris (1900-01-01 to 2100-01-01); give a time in these years");
  }

  // From the Earth to the sun. The sun hardly moves in the 8 minutes its light takes (0.01 arcsec).
  double distance = 0.0, natural[3];
  double earthToSun[3] = { -heliocentric[0][0], -heliocentric[0][1], -heliocentric[0][2] };
  eraPn(earthToSun, &distance, natural);

  double velocity[3], speed2 = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    velocity[axis] = barycentric[1][axis] * ERFA_AULT / ERFA_DAYSEC; // AU/day to light's speed
    speed2 += velocity[axis] * velocity[axis];
  }
  double proper[3];
  eraAb(natural, velocity, distance, std::sqrt(1.0 - speed2), proper);

  double celestialToIntermediate[3][3], direction[3];
  eraC2i06a(times.Tt1, times.Tt2, celestialToIntermediate);
  eraRz(eraEra00(times.Ut11, times.Ut12), celestialToIntermediate);
  eraRxp(celestialToIntermediate, proper, direction);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Sun[axis] = distance * ERFA_DAU * direction[axis];
  }
}

SunDirection SunEphemeris::At(
  double longitude, double latitude, double height, const Air& air) const
{
  if (!std::isfinite(longitude) || !std::isfinite(height) || !(std::abs(latitude) <= 90.0))
  {
    throw std::out_of_range("place " + std::to_string(longitude) + "," + std::to_string(latitude) +
      "," + std::to_string(height) +
      " is not on the Earth; give longitude and latitude in degrees and a height in metres");
  }
  const double lambda = longitude * RadiansPerDegree;
  const double phi = latitude * RadiansPerDegree;
  double place[3];
  eraGd2gc(ERFA_WGS84, lambda, phi, height, place);

  const double x = this->Sun[0] - place[0];
  const double y = this->Sun[1] - place[1];
  const double z = this->Sun[2] - place[2];
  const double sinLambda = std::sin(lambda), cosLambda = std::cos(lambda);
  const double sinPhi = std::sin(phi), cosPhi = std::cos(phi);
  const double outward = cosLambda * x + sinLambda * y; // away from the Earth's axis
  const double east = cosLambda * y - sinLambda * x;
  const double north = cosPhi * z - sinPhi * outward;
  const double up = sinPhi * z + cosPhi * outward;
  const double distance = std::sqrt(x * x + y * y + z * z);

  SunDirection sun;
  sun.Azimuth = AzimuthOf(east, north);
  sun.Elevation = std::atan2(up, std::hypot(east, north)) * DegreesPerRadian;
  sun.ApparentElevation = sun.Elevation + Refraction(sun.Elevation, air);
  sun.AngularRadius = std::asin(SolarRadius / distance) * DegreesPerRadian;
  return sun;
}

SunDirection ComputeSun(const UtcTime& time, double longitude, double latitude, double height,
  const Air& air, double ut1MinusUtc)
{
  return SunEphemeris(time, ut1MinusUtc).At(longitude, latitude, height, air);
}

} // namespace skyline
