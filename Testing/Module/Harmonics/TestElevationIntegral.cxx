// SPDX-License-Identifier: BSD-3-Clause
#include "Harmonics/ElevationIntegral.h"

#include "Harmonics/SphericalHarmonics.h"
#include "Shared/Constants.h"

#include <gtest/gtest.h>

#include <cmath>

namespace skyline
{
namespace testing
{
namespace
{

/// N_lm P_l^m(sin e) from the harmonics, in the azimuth in which their azimuthal factor is 1.
double AtElevation(int l, int m, double elevation)
{
  // cos(m p) = 1 for p = 0, which is east.
  double values[HarmonicCount(MaxHarmonicBands)];
  EvaluateHarmonics(MaxHarmonicBands, std::cos(elevation), 0.0, std::sin(elevation), values);
  return values[HarmonicIndex(l, m)];
}

double Weighted(ElevationWeight weight, double elevation)
{
  return weight == ElevationWeight::One ? 1.0
    : weight == ElevationWeight::Upward ? std::sin(elevation)
                                        : std::cos(elevation);
}

/// Simpson's rule: the error (h / n)^4 / 180 times a fourth derivative of up to 9^4 is 1e-13.
double Simpson(int l, int m, ElevationWeight weight, double horizon)
{
  const int n = 4000;
  double sum = 0.0;
  for (int k = 0; k <= n; ++k)
  {
    const double e = horizon * k / n;
    const double factor = k == 0 || k == n ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
    sum += factor * AtElevation(l, m, e) * Weighted(weight, e) * std::cos(e);
  }
  return sum * horizon / (3.0 * n);
}

constexpr double QuadratureBound = 1.0e-11; // of Simpson's rule and of the rounding of polynomials

TEST(ElevationIntegral, EqualsQuadrature)
{
  for (const ElevationWeight weight :
    { ElevationWeight::One, ElevationWeight::Upward, ElevationWeight::Forward })
  {
    for (int l = 0; l < MaxHarmonicBands; ++l)
    {
      for (int m = 0; m <= l; ++m)
      {
        const ElevationIntegral integral = MakeElevationIntegral(l, m, weight);
        for (const double horizon : { -1.5, -0.4, 0.01, 0.3, 1.1, 0.5 * Pi })
        {
          EXPECT_NEAR(integral.Lost(horizon), Simpson(l, m, weight, horizon), QuadratureBound)
            << l << " " << m << " " << static_cast<int>(weight) << " " << horizon;
        }
        EXPECT_NEAR(integral.Lost(0.0), 0.0, 1.0e-14);
      }
    }
  }
}

TEST(ElevationIntegral, ZonalOnesAreTheHemisphereAndTheClampedCosine)
{
  for (int l = 0; l < MaxHarmonicBands; ++l)
  {
    EXPECT_NEAR(2.0 * Pi * MakeElevationIntegral(l, 0, ElevationWeight::One).Whole,
      HemisphereZonal(l), 1.0e-12);
    EXPECT_NEAR(2.0 * Pi * MakeElevationIntegral(l, 0, ElevationWeight::Upward).Whole,
      ClampedCosineZonal(l), 1.0e-12);
  }
}

TEST(ElevationIntegral, ListsOrdersOneAfterAnother)
{
  const auto integrals = ElevationIntegrals(4, ElevationWeight::One);
  ASSERT_EQ(integrals.size(), 10u);
  EXPECT_EQ(integrals[3].Whole, MakeElevationIntegral(3, 0, ElevationWeight::One).Whole);
  EXPECT_EQ(integrals[5].Whole, MakeElevationIntegral(2, 1, ElevationWeight::One).Whole);
  EXPECT_EQ(integrals[9].Whole, MakeElevationIntegral(3, 3, ElevationWeight::One).Whole);
}

} // namespace
} // namespace testing
} // namespace skyline
