// SPDX-License-Identifier: BSD-3-Clause
// Integrals of spherical harmonics over elevation in closed form: what a horizon takes from each
// harmonic.
//
// In one azimuth, the function of band l and order m is an azimuthal factor times
// N_lm P_l^|m|(sin e), and P_l^m(sin e) = cos^m e Q(sin e), where Q is a polynomial
// with only even or only odd powers. So
//
//   Lost(h) = N_lm Int_0^h P_l^m(sin e) sin^i e cos^j e cos e de
//
// is an integral of cos^n e times even or odd powers of sin e. With s = sin h, c = cos h, q = s^2
// and a polynomial p, there are four forms, none of which needs a series or a table:
//
//   n odd,  even powers:  s p(q)               n even, even powers:  A h + s c p(q)
//   n odd,  odd powers:   q p(q)               n even, odd powers:   A + c p(q)
//
// i = j = 0 gives the projection of the visibility of the sky. i = 1 or j = 1 gives that of the
// visibility times the upward or the forward part of a cosine.
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

/// The factor by which cos e is multiplied in an integral.
enum class ElevationWeight
{
  One,    ///< the visibility itself
  Upward, ///< times sin e: the cosine of incidence on a level receiver
  Forward ///< times cos e: the cosine of incidence on a vertical receiver that faces the azimuth
};

/// The integral of one harmonic from the horizontal plane up to the horizon.
struct SKYLINECORE_EXPORT ElevationIntegral
{
  static constexpr int MaxTerms = 6;

  ElevationKind Kind = ElevationKind::Sine;
  double Constant = 0.0; ///< A
  int Terms = 0;         ///< number of terms of p, 1 to MaxTerms
  std::array<double, MaxTerms> Polynomial{};
  double Whole = 0.0; ///< the integral up to the zenith

  /// The integral from the horizontal plane up to an elevation of -90 to 90 degrees (in radians).
  /// Below 0 it is the negated integral from that elevation up to the plane. The sky keeps Whole -
  /// Lost.
  double Lost(double horizon) const;
};

/// The integral of band l, 0 to 7, and order m, 0 to l. The normalisation includes the sqrt(2)
/// of m > 0. The azimuthal factor (cos(m p) or sin(m p)) is left out.
SKYLINECORE_EXPORT ElevationIntegral MakeElevationIntegral(int l, int m, ElevationWeight weight);

/// The integrals of all l and all m >= 0 of the bands, ordered by m:
/// (m, l) = (0, 0), (0, 1) .. (1, 1) ..
SKYLINECORE_EXPORT std::vector<ElevationIntegral> ElevationIntegrals(
  int bands, ElevationWeight weight);

} // namespace skyline

#endif
