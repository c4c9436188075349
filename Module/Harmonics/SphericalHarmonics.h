// SPDX-License-Identifier: BSD-3-Clause
// Real spherical harmonics: values, rotations, zonal functions in closed form.
//
// Orthonormal over the sphere, without the Condon-Shortley phase, in the frame x east, y north,
// z up. The function of band l and order m, -l <= m <= l, has the index l * l + l + m; "n bands"
// are the n * n functions with l < n. With t from the zenith and p counter-clockwise from east:
//   Y_l,m = N_lm P_l^|m|(cos t) * { sqrt(2) cos(m p), m > 0;  1, m = 0;  sqrt(2) sin(-m p), m < 0 }
//   N_lm  = sqrt((2 l + 1) / (4 pi) * (l - |m|)! / (l + |m|)!)
// with the associated Legendre functions P_l^m = (1 - z^2)^(m/2) d^m P_l / dz^m. So the functions
// of band 1 are sqrt(3 / (4 pi)) times y, z, x. Ramamoorthi & Hanrahan 2001, equation 1 and figure 1.
//
// Where a function is a template, Real is float or double.
#ifndef skyline_SphericalHarmonics_h
#define skyline_SphericalHarmonics_h

#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// The most bands of the functions below (the zonal ones take any band).
constexpr int MaxHarmonicBands = 8;

/// Bands where nothing else is said: 16 coefficients, Snyder & Nowrouzezahrai 2008's order 4.
constexpr int DefaultHarmonicBands = 4;

/// Coefficients of so many bands.
constexpr int HarmonicCount(int bands)
{
  return bands * bands;
}

/// Where the coefficient of band l and order m stands.
constexpr int HarmonicIndex(int l, int m)
{
  return l * l + l + m;
}

/// The values of all functions of 1 to 8 bands in the unit direction (x, y, z): bands * bands of
/// them.
template <typename Real>
SKYLINECORE_EXPORT void EvaluateHarmonics(int bands, Real x, Real y, Real z, Real* values);

/// The coefficients of a function turned about the vertical by an angle (radians, clockwise seen
/// from above, as azimuths count): what lay at azimuth a lies at a + angle. 1 to 8 bands; in and out
/// may be the same.
template <typename Real>
SKYLINECORE_EXPORT void RotateAboutVertical(
  int bands, double angleClockwise, const Real* in, Real* out);

/// The coefficients of a function around the vertical when its axis is turned to the unit direction
/// (x, y, z): sqrt(4 pi / (2 l + 1)) zonal_l Y_l,m(x, y, z). zonal: the `bands` coefficients of m =
/// 0; out: bands * bands. 1 to 8 bands. Sloan 2008, "Stupid Spherical Harmonics Tricks", rotation of
/// zonal harmonics.
template <typename Real>
SKYLINECORE_EXPORT void RotateZonal(
  int bands, const Real* zonal, Real x, Real y, Real z, Real* out);

/// The coefficient of Y_l,0 of max(0, z), any l >= 0. Its convolution with radiance is irradiance:
/// E(n) = sum of A_l L_l,m Y_l,m(n) with A_l = sqrt(4 pi / (2 l + 1)) times this (pi, 2 pi / 3,
/// pi / 4, 0, ...). Ramamoorthi & Hanrahan 2001, equations 7 and 8.
SKYLINECORE_EXPORT double ClampedCosineZonal(int l);

/// The coefficient of Y_l,0 of the function that is 1 above the horizontal plane and 0 below.
SKYLINECORE_EXPORT double HemisphereZonal(int l);

/// The coefficient of Y_l,0 of the function that is 1 on the cap around the zenith whose rim has the
/// given cosine of its angular radius, -1 (the sphere) to 1 (nothing), and 0 elsewhere.
SKYLINECORE_EXPORT double CapZonal(int l, double cosRadius);

} // namespace skyline

#endif
