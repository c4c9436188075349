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

/// Largest number of bands of the functions below. The zonal functions take any band.
constexpr int MaxHarmonicBands = 8;

/// Default number of bands: 16 coefficients, order 4 of Snyder & Nowrouzezahrai 2008.
constexpr int DefaultHarmonicBands = 4;

/// Number of coefficients for a number of bands.
constexpr int HarmonicCount(int bands)
{
  return bands * bands;
}

/// Index of the coefficient of band l and order m.
constexpr int HarmonicIndex(int l, int m)
{
  return l * l + l + m;
}

/// The values of all functions of 1 to 8 bands in the unit direction (x, y, z): bands * bands
/// numbers.
template <typename Real>
SKYLINECORE_EXPORT void EvaluateHarmonics(int bands, Real x, Real y, Real z, Real* values);

/// The coefficients of a function that is rotated about the vertical by an angle (radians,
/// clockwise seen from above, as azimuths are counted): the value at azimuth a moves to a + angle.
/// 1 to 8 bands. `in` and `out` may be the same.
template <typename Real>
SKYLINECORE_EXPORT void RotateAboutVertical(
  int bands, double angleClockwise, const Real* in, Real* out);

/// The coefficients of a zonal function (symmetric about the vertical) whose axis is rotated to the
/// unit direction (x, y, z): sqrt(4 pi / (2 l + 1)) zonal_l Y_l,m(x, y, z). zonal: the `bands`
/// coefficients of m = 0; out: bands * bands coefficients. 1 to 8 bands. Sloan 2008, "Stupid
/// Spherical Harmonics Tricks", rotation of zonal harmonics.
template <typename Real>
SKYLINECORE_EXPORT void RotateZonal(
  int bands, const Real* zonal, Real x, Real y, Real z, Real* out);

/// The coefficient of Y_l,0 of max(0, z), for any l >= 0. The convolution of this function with
/// radiance is irradiance: E(n) = sum of A_l L_l,m Y_l,m(n), where A_l is sqrt(4 pi / (2 l + 1))
/// times this coefficient (pi, 2 pi / 3, pi / 4, 0, ...). Ramamoorthi & Hanrahan 2001, equations 7
/// and 8.
SKYLINECORE_EXPORT double ClampedCosineZonal(int l);

/// The coefficient of Y_l,0 of the function that is 1 above the horizontal plane and 0 below.
SKYLINECORE_EXPORT double HemisphereZonal(int l);

/// The coefficient of Y_l,0 of the function that is 1 on a cap around the zenith and 0 elsewhere.
/// cosRadius: cosine of the angular radius of the cap, -1 (the whole sphere) to 1 (empty).
SKYLINECORE_EXPORT double CapZonal(int l, double cosRadius);

} // namespace skyline

#endif
