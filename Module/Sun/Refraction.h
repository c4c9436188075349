// SPDX-License-Identifier: BSD-3-Clause
// Refraction: by how much the air lifts the sun.
#ifndef skyline_Refraction_h
#define skyline_Refraction_h

#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// The air at the observer.
struct Air
{
  double PressureHPa = 1010.0; ///< hectopascal (millibar), at least 0
  double TemperatureC = 10.0;  ///< degrees Celsius, above -273
  bool Refracts = true;        ///< false: no atmosphere; the other members have no meaning
};

/// The ICAO standard atmosphere (ISO 2533) at a height in metres above the sea: 15 C and 1013.25
/// hPa at 0, 6.5 C/km less up to 11 km, constant temperature above. Heights below -5 km, where the
/// standard begins, get the air of -5 km. Throws std::invalid_argument for NaN and infinities.
SKYLINECORE_EXPORT Air StandardAir(double height);

/// Degrees by which air lifts a body at `elevation` (degrees, without air, -90 to 90):
/// Saemundsson's formula (Meeus, Astronomical Algorithms, 2nd edition, eq. 16.4) times P / 1010 *
/// 283 / (273 + T), accurate to 0.1 arcminutes above the horizon, for yellow light. The maximum
/// (0.74 degrees in the default air) is at -1.90 degrees. Further down, where the sun is visible
/// only from high mountains and the value depends on the actual air, a parabola leads to 0 at the
/// nadir, so that value and slope are continuous everywhere. Near the zenith the formula is
/// slightly negative and is replaced by 0. The result is 0 in air that does not refract.
SKYLINECORE_EXPORT double Refraction(double elevation, const Air& air);

} // namespace skyline

#endif
