// SPDX-License-Identifier: BSD-3-Clause
// Light as spherical harmonics, fitted only above the horizontal plane and in a swath.
#ifndef skyline_LightFit_h
#define skyline_LightFit_h

#include "Harmonics/SphericalHarmonics.h"
#include "Horizon/Swath.h"
#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// Weight of the mean square of the coefficients relative to the error of the fit. Without it, the
/// fit would still be defined, but more than 5 bands would have coefficients of thousands that
/// cancel. 1e-4 costs 0.01 % of the irradiance of an overcast sky.
constexpr double LightFitRidge = 1.0e-4;

/// Fits a series of 1 to 8 bands to a light, with the least mean square error over the upper
/// hemisphere in a swath. `projected`: the projection of the light over that part, that is the
/// integrals of radiance times each of the bands * bands harmonics. `fitted`: the bands * bands
/// coefficients; may be the same memory as `projected`.
///
/// TransferSH is an integral over the sky that a post sees, so that E = sum of c_k TransferSH_k is
/// the irradiance of the light c_k Y_k in that part of the sky. The values of the series below the
/// horizontal plane or outside the swath do not matter. Snyder & Nowrouzezahrai 2008 fit their 16
/// coefficients to the whole sphere: the projection of a sky then has a dark half, and rings along
/// its edge. The error of the clear sky of Documentation/sn08.md is then 3 to 4 %, but 0.2 to 2 %
/// with this fit. (The fit is for transfer vectors only: the product of a visibility and a cosine
/// series needs the projection of the light.)
SKYLINECORE_EXPORT void FitLight(const Swath& swath, int bands, const double* projected,
  double* fitted, double ridge = LightFitRidge);

} // namespace skyline

#endif
