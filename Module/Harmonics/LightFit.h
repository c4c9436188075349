// SPDX-License-Identifier: BSD-3-Clause
// Light as spherical harmonics where it is asked for alone: above the horizontal plane, in a swath.
#ifndef skyline_LightFit_h
#define skyline_LightFit_h

#include "Harmonics/SphericalHarmonics.h"
#include "Horizon/Swath.h"
#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// How much of the mean square of the coefficients counts as error, in units of that of the light.
/// Without it the fit is still defined, but orders above 5 would have coefficients of thousands that
/// cancel. 1e-4 costs 0.01 % of an overcast sky's irradiance.
constexpr double LightFitRidge = 1.0e-4;

/// The series of 1 to 8 bands that comes closest, in the mean square over the upper hemisphere in a
/// swath, to a light given by its projection over that part: the integrals of radiance times
/// harmonics over it, bands * bands of them. `fitted`: bands * bands; may be `projected`.
///
/// TransferSH is an integral over the sky that a post sees, so E = sum of c_k TransferSH_k is the
/// irradiance of the light c_k Y_k there, and what the series does below the horizontal plane or
/// outside of the swath is free. Snyder & Nowrouzezahrai 2008 spend their 16 numbers on the whole
/// sphere: a sky projected so has a dark half, and rings along its rim; the clear sky of
/// Documentation/sn08.md then errs by 3 to 4 %, and by 0.2 to 2 % if fitted. (It helps transfer
/// vectors alone: the product of a visibility and a cosine series needs the light's projection.)
SKYLINECORE_EXPORT void FitLight(const Swath& swath, int bands, const double* projected,
  double* fitted, double ridge = LightFitRidge);

} // namespace skyline

#endif
