// SPDX-License-Identifier: BSD-3-Clause
// Time scales and the rotation of the Earth, as the positions of the sun and of the Moon need them.
#ifndef skyline_Astronomy_h
#define skyline_Astronomy_h

#include "SkylineCoreModule.h" // for the export macro
#include "Sun/UtcTime.h"

#include <array>

namespace skyline
{

/// A moment on the two time scales of astronomy, each as a sum of two numbers of days.
struct AstronomicalTimes
{
  double Tt1 = 0.0, Tt2 = 0.0;   ///< terrestrial time
  double Ut11 = 0.0, Ut12 = 0.0; ///< UT1, the rotation of the Earth
};

/// Throws what the constructor of SunEphemeris throws.
SKYLINECORE_EXPORT AstronomicalTimes ConvertUtc(const UtcTime& time, double ut1MinusUtc);

/// Computes the matrix that rotates celestial axes (GCRS) to axes fixed to the Earth: frame bias,
/// precession and nutation by eraC2i06a (IAU 2006/2000A), rotation by eraEra00; without polar
/// motion.
void CelestialToTerrestrial(const AstronomicalTimes& times, double matrix[3][3]);

/// The position of a place on the Earth: metres from the centre, on axes fixed to the Earth.
/// Arguments and errors are those of SunEphemeris::At.
SKYLINECORE_EXPORT std::array<double, 3> FromEarthCentre(
  double longitude, double latitude, double height);

/// The vector from a place to a body: metres on the local axes of the place.
struct LocalVector
{
  double East = 0.0, North = 0.0, Up = 1.0;
};

/// `body`: metres from the centre of the Earth, on axes fixed to the Earth. The other arguments,
/// and the errors, are those of SunEphemeris::At.
SKYLINECORE_EXPORT LocalVector SeenFrom(
  const std::array<double, 3>& body, double longitude, double latitude, double height);

} // namespace skyline

#endif
