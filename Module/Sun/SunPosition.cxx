// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/SunPosition.h"

#include "Geo/Azimuth.h"
#include "Shared/Constants.h"
#include "Sun/Astronomy.h"

#include <erfa.h>
#include <erfam.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace skyline
{

SunEphemeris::SunEphemeris(const UtcTime& time, double ut1MinusUtc)
{
  const AstronomicalTimes times = ConvertUtc(time, ut1MinusUtc);

  double heliocentric[2][3], barycentric[2][3];
  if (eraEpv00(times.Tt1, times.Tt2, heliocentric, barycentric) != 0)
  {
    throw std::out_of_range("time " + ToText(time) +
      " is outside the sun's ephemeris (1900-01-01 to 2100-01-01); give a time in these years");
  }

  // From the Earth to the sun. The sun moves only 0.01 arcseconds in the 8 minutes that its light
  // takes.
  double distance = 0.0, natural[3];
  double earthToSun[3] = { -heliocentric[0][0], -heliocentric[0][1], -heliocentric[0][2] };
  eraPn(earthToSun, &distance, natural);

  double velocity[3], speed2 = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    velocity[axis] = barycentric[1][axis] * ERFA_AULT / ERFA_DAYSEC; // from AU/day to units of the
                                                                     // speed of light
    speed2 += velocity[axis] * velocity[axis];
  }
  double proper[3];
  eraAb(natural, velocity, distance, std::sqrt(1.0 - speed2), proper);

  double toTerrestrial[3][3], direction[3];
  CelestialToTerrestrial(times, toTerrestrial);
  eraRxp(toTerrestrial, proper, direction);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Sun[axis] = distance * ERFA_DAU * direction[axis];
  }
}

SunDirection SunEphemeris::At(
  double longitude, double latitude, double height, const Air& air) const
{
  const LocalVector seen = SeenFrom(this->Sun, longitude, latitude, height);
  const double level = std::hypot(seen.East, seen.North);
  SunDirection sun;
  sun.Azimuth = AzimuthOf(seen.East, seen.North);
  sun.Elevation = std::atan2(seen.Up, level) * DegreesPerRadian;
  sun.ApparentElevation = sun.Elevation + Refraction(sun.Elevation, air);
  sun.AngularRadius = std::asin(SolarRadius / std::hypot(level, seen.Up)) * DegreesPerRadian;
  return sun;
}

SunDirection ComputeSun(const UtcTime& time, double longitude, double latitude, double height,
  const Air& air, double ut1MinusUtc)
{
  return SunEphemeris(time, ut1MinusUtc).At(longitude, latitude, height, air);
}

} // namespace skyline
