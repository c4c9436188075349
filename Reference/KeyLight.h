// SPDX-License-Identifier: BSD-3-Clause
// Lights that cover only a part of the circle of azimuths: the key lights of Snyder &
// Nowrouzezahrai 2008 (SN08), sections 4 to 6.
#ifndef skyline_KeyLight_h
#define skyline_KeyLight_h

#include "Harmonics/SphericalHarmonics.h"
#include "Horizon/Swath.h"
#include "Shared/Constants.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace skyline
{

/// The narrowest swath, 0.05 degrees: a narrower one resolves nothing, and one of width 0 has no
/// weight.
constexpr double LeastSwath = 0.05 * RadiansPerDegree;

/// The full circle, and an angle modulo the full circle, in radians: 0 or more, below 2 pi.
constexpr double Circle = 2.0 * Pi;
inline double ModuloCircle(double angle)
{
  const double rest = std::fmod(angle, Circle);
  return rest < 0.0 ? rest + Circle : rest;
}

/// A distant disc of uniform radiance. Angles in radians.
struct KeyLight
{
  double Azimuth = 0.0;   ///< of its centre, clockwise from grid north
  double Elevation = 0.5; ///< of its centre, 0 to pi / 2
  double Radius = 0.1;    ///< angular, above 0, at most pi / 2
};

/// The range of azimuths that the disc of a light covers: asin(sin r / cos e) to each side of its
/// centre, or the full circle if the disc contains the zenith.
Swath SwathOf(const KeyLight& light);

/// How a key light is converted to a series.
enum class KeyLightSeries
{
  Fitted,   ///< closest to the disc in the swath and above the horizontal plane (LightFit.h)
  Projected ///< over the whole sphere, as in SN08
};

/// The coefficients of the light, with radiance 1, for transfer vectors of a swath. A truncated
/// series spreads a disc, and a swath keeps only a part of it. Therefore the series is scaled so
/// that an unshadowed receiver that faces the light gets the irradiance of the disc, which is pi
/// sin^2 r or that of the part above the horizontal plane (SN08, figure 6: unit unshadowed
/// shading). All coefficients are 0 if the light lies outside the swath. bands: 1 to 8.
void KeyLightHarmonics(const KeyLight& light, const Swath& swath, int bands, double* coefficients,
  KeyLightSeries series = KeyLightSeries::Fitted);

/// Irradiance from the part of a disc of radiance 1 above the horizontal plane on a receiver that
/// faces the disc: pi sin^2 r if the whole disc lies above. Computed by quadrature, with a relative
/// error of 1e-6.
double FacingIrradiance(const KeyLight& light);

} // namespace skyline

#endif
