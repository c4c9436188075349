// SPDX-License-Identifier: BSD-3-Clause
// Integrals of spherical harmonics over elevation, in closed form: what a horizon takes from each.
//
// In one azimuth the function of band l and order m is a factor of the azimuth times
// N_lm P_l^|m|(sin e), and P_l^m(sin e) = cos^m e Q(sin e) with a polynomial Q of one parity. So
//
//   Lost(h) = N_lm Int_0^h P_l^m(sin e) sin^i e cos^j e cos e de
//
// is an integral of cos^n e times even or odd powers of sin e, and with s = sin h, c = cos h, q = s^2
// and a polynomial p there are four kinds of it (N. B.: no series, no table):
//
//   n odd,  even powers:  s p(q)               n even, even powers:  A h + s c p(q)
//   n odd,  odd powers:   q p(q)               n even, odd powers:   A + c p(q)
//
// i = j = 0 gives the projection of the sky's visibility, i = 1 or j = 1 that of the visibility times
// the upward and the forward part of a cosine.
#ifndef skyline_ElevationIntegral_h
#define skyline_ElevationIntegral_h

#include "Harmonics/SphericalHarmonics.h"
#include "SkylineCoreModule.h" // for the export macro

#include <array>
#include <vector>

namespace skyline
{

enum class ElevationKind
{
  Sine,       ///< s p(q)
  Square,     ///< q p(q)
  SineCosine, ///< A h + s c p(q)
  Cosine      ///< A + c p(q)
};

/// The factor that goes with cos e in an integral.
enum class ElevationWeight
{
  One,    ///< the visibility itself
  Upward, ///< times sin e: a level receiver's cosine
  Forward ///< times cos e: the cosine of a vertical receiver that faces the azimuth
};

/// The integral of one harmonic from the horizontal plane up to a horizon.
struct SKYLINECORE_EXPORT ElevationIntegral
{
  static constexpr int MaxTerms = 6;

  ElevationKind Kind = ElevationKind::Sine;
  double Constant = 0.0; ///< A
  int Terms = 0;         ///< of p, 1 to MaxTerms
  std::array<double, MaxTerms> Polynomial{};
  double Whole = 0.0; ///< the integral up to the zenith

  /// What lies between the horizontal plane and an elevation of -90 to 90 degrees (radians); below 0
  /// it is what lies under the plane, negated. The sky keeps Whole - Lost.
  double Lost(double horizon) const;
};

/// The integral of band l, 0 to 7, and order m, 0 to l; the normalisation counts the sqrt(2) of m > 0,
/// the factor of the azimuth (cos(m p), sin(m p)) is left out.
SKYLINECORE_EXPORT ElevationIntegral MakeElevationIntegral(int l, int m, ElevationWeight weight);

/// The integrals of all l and m >= 0 of some bands, m by m: (m, l) = (0, 0), (0, 1) .. (1, 1) ..
SKYLINECORE_EXPORT std::vector<ElevationIntegral> ElevationIntegrals(
  int bands, ElevationWeight weight);

} // namespace skyline

#endif
