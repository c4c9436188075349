// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/CoveredDisc.h"

#include "Shared/Constants.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace skyline;

namespace
{

/// The covered light by brute force: the disc is divided into small squares.
double Counted(double distance, double cover, double limbDarkening)
{
  constexpr int Side = 700;
  double whole = 0.0, hidden = 0.0;
  for (int j = 0; j < Side; ++j)
  {
    for (int i = 0; i < Side; ++i)
    {
      const double x = (2.0 * i + 1.0) / Side - 1.0, y = (2.0 * j + 1.0) / Side - 1.0;
      const double square = x * x + y * y;
      if (square < 1.0)
      {
        const double light = 1.0 - limbDarkening * (1.0 - std::sqrt(1.0 - square));
        whole += light;
        hidden += std::hypot(x - distance, y) < cover ? light : 0.0;
      }
    }
  }
  return hidden / whole;
}

/// The error of the squares at the rims, half of which are counted wrongly.
constexpr double CountError = 2e-4;

} // namespace

TEST(CoveredDisc, AgreesWithCountedSquares)
{
  for (const double cover : { 0.3, 0.95, 1.0, 1.06 })
  {
    for (const double distance : { 0.0, 0.02, 0.3, 0.71, 1.2, 1.9 })
    {
      for (const double darkening : { 0.0, 0.6 })
      {
        EXPECT_NEAR(
          CoveredShare(distance, cover, darkening), Counted(distance, cover, darkening), CountError)
          << distance << " " << cover << " " << darkening;
      }
    }
  }
}

TEST(CoveredDisc, ClosedForms)
{
  // Two equal discs, each with its rim through the centre of the other: 2/3 - sqrt(3) / (2 pi).
  EXPECT_NEAR(CoveredShare(1.0, 1.0), 2.0 / 3.0 - std::sqrt(3.0) / (2.0 * Pi), 1e-14);
  EXPECT_NEAR(CoveredShare(0.0, 0.5), 0.25, 1e-15);
  // The integral of mu is 2/3 (1 - (1 - k^2)^(3/2)) of the area.
  EXPECT_NEAR(CoveredShare(0.0, 0.5, 1.0), 1.0 - std::pow(0.75, 1.5), 1e-14);
  EXPECT_NEAR(CoveredShare(0.1, 0.5, 1.0), CoveredShare(0.1 + 1e-9, 0.5, 1.0), 1e-8);
}

TEST(CoveredDisc, ExactlyNothingAndAll)
{
  for (const double darkening : { 0.0, 0.6, 1.0 })
  {
    EXPECT_EQ(CoveredShare(2.1, 1.1, darkening), 0.0);
    EXPECT_EQ(CoveredShare(5.0, 1.1, darkening), 0.0);
    EXPECT_EQ(CoveredShare(0.09, 1.1, darkening), 1.0);
    EXPECT_EQ(CoveredShare(0.0, 1.0, darkening), 1.0);
    // The share changes continuously and monotonically towards both limits.
    EXPECT_LT(CoveredShare(2.1 - 1e-6, 1.1, darkening), 1e-8);
    EXPECT_GT(CoveredShare(0.1 + 1e-6, 1.1, darkening), 1.0 - 1e-6);
    double before = 1.0;
    for (double distance = 0.0; distance < 2.2; distance += 0.001)
    {
      const double share = CoveredShare(distance, 1.1, darkening);
      EXPECT_LE(share, before) << distance;
      before = share;
    }
  }
}

TEST(CoveredDisc, MagnitudeAsInTables)
{
  EXPECT_DOUBLE_EQ(CoveredMagnitude(1.0, 1.0), 0.5);
  EXPECT_DOUBLE_EQ(CoveredMagnitude(0.01, 1.03), 1.03);
  EXPECT_DOUBLE_EQ(CoveredMagnitude(0.01, 0.95), 0.95);
  EXPECT_EQ(CoveredMagnitude(2.5, 1.03), 0.0);
}
