// SPDX-License-Identifier: BSD-3-Clause
// Lights that stand in a part of the horizon alone: the key lights of Snyder & Nowrouzezahrai 2008
// (SN08), sections 4 to 6.
#ifndef skyline_KeyLight_h
#define skyline_KeyLight_h

#include "Harmonics/SphericalHarmonics.h"
#include "Horizon/Swath.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <vector>

namespace skyline
{

/// A distant disc of even radiance. Angles in radians.
struct KeyLight
{
  double Azimuth = 0.0;   ///< of its middle, clockwise from grid north
  double Elevation = 0.5; ///< of its middle, 0 to pi / 2
  double Radius = 0.1;    ///< angular, above 0, up to pi / 2
};

/// The azimuths that a light's disc covers: asin(sin r / cos e) to either side; the circle if the disc
/// holds the zenith.
SKYLINECORE_EXPORT Swath SwathOf(const KeyLight& light);

/// How a key light becomes a series.
enum class KeyLightSeries
{
  Fitted,   ///< closest to the disc in the swath, above the horizontal plane (LightFit.h)
  Projected ///< of the whole sphere, as SN08 have it
};

/// The light's coefficients (radiance 1) for transfer vectors of a swath. A truncated series spreads
/// a disc and a swath keeps a part of that; so it is scaled until a receiver that faces the light,
/// with nothing in the way, gets the disc's own irradiance, pi sin^2 r or what of it stands above the
/// horizontal plane (SN08, figure 6: unit unshadowed shading). All 0 for a light outside of the swath.
/// 1 to 8 bands.
SKYLINECORE_EXPORT void KeyLightHarmonics(const KeyLight& light, const Swath& swath, int bands,
  double* coefficients, KeyLightSeries series = KeyLightSeries::Fitted);

/// Irradiance of a disc of radiance 1 on a receiver that faces it, from above the horizontal plane
/// alone: pi sin^2 r where it stands clear of it. By quadrature, to 1e-6 of itself.
SKYLINECORE_EXPORT double FacingIrradiance(const KeyLight& light);

} // namespace skyline

#endif
