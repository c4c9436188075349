// SPDX-License-Identifier: BSD-3-Clause
// What the places of the sun and of the Moon have in common: times, and the Earth's rotation.
#ifndef skyline_Astronomy_h
#define skyline_Astronomy_h

#include "SkylineCoreModule.h" // for the export macro
#include "Sun/UtcTime.h"

#include <array>

namespace skyline
{

/// One moment on the two time scales of astronomy, each a sum of two numbers of days.
struct AstronomicalTimes
{
  double Tt1 = 0.0, Tt2 = 0.0;   ///< terrestrial time
  double Ut11 = 0.0, Ut12 = 0.0; ///< UT1, the Earth's rotation
};

/// Throws as the constructor of SunEphemeris says.
SKYLINECORE_EXPORT AstronomicalTimes ConvertUtc(const UtcTime& time, double ut1MinusUtc);

/// Turns celestial axes (GCRS) into those fixed to the Earth: frame bias, precession and nutation by
/// eraC2i06a (IAU 2006/2000A), rotation by eraEra00; without polar motion.
void CelestialToTerrestrial(const AstronomicalTimes& times, double matrix[3][3]);

/// A place on the Earth: metres from the centre, Earth-fixed axes. The arguments as of
/// SunEphemeris::At, with its errors.
SKYLINECORE_EXPORT std::array<double, 3> FromEarthCentre(
  double longitude, double latitude, double height);

/// From a place to a body: metres on the place's own axes.
struct LocalVector
{
  double East = 0.0, North = 0.0, Up = 1.0;
};

/// `body`: metres from the Earth's centre, Earth-fixed axes. The place as SunEphemeris::At takes it,
/// and with its errors.
SKYLINECORE_EXPORT LocalVector SeenFrom(
  const std::array<double, 3>& body, double longitude, double latitude, double height);

} // namespace skyline

#endif
