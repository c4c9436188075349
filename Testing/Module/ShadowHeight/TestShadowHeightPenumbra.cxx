// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowHeight/ShadowHeightPenumbra.h"

#include <gtest/gtest.h>

#include <cmath>

namespace skyline
{
namespace testing
{
namespace
{

constexpr double Exact = 1e-12; // closed forms in double precision

TEST(ShadowHeightPenumbra, DepthAsPublished)
{
  EXPECT_EQ(LitByPenumbraDepth(100.0, 101.0, 8.0), 1.0);
  EXPECT_EQ(LitByPenumbraDepth(100.0, 100.0, 8.0), 1.0);
  EXPECT_NEAR(LitByPenumbraDepth(100.0, 98.0, 8.0), 0.75, Exact); // alpha = 2 / 8
  EXPECT_EQ(LitByPenumbraDepth(100.0, 90.0, 8.0), 0.0);
  EXPECT_EQ(LitByPenumbraDepth(100.0, 100.0, 0.0), 1.0);
  EXPECT_EQ(LitByPenumbraDepth(100.0, 99.999, 0.0), 0.0);
}

TEST(ShadowHeightPenumbra, ChordOfADisc)
{
  EXPECT_NEAR(LitAboveChord(-1.0), 1.0, Exact);
  EXPECT_NEAR(LitAboveChord(0.0), 0.5, Exact);
  EXPECT_NEAR(LitAboveChord(1.0), 0.0, Exact);
  EXPECT_NEAR(LitAboveChord(0.5), 1.0 / 3.0 - std::sqrt(3.0) / (4.0 * Pi), Exact);
}

// An edge with the height h at the distance d: from the height z, it stands at atan((h - z) / d).
TEST(ShadowHeightPenumbra, OfOneEdge)
{
  const double elevation = 12.0 * RadiansPerDegree, radius = 0.5 * RadiansPerDegree;
  const ShadowHeightPenumbra sun(elevation, radius);
  const double height = 700.0;
  for (const double distance : { 0.5, 40.0, 9000.0 })
  {
    const double upper = height - distance * sun.UpperSlope();
    const double lower = height - distance * sun.LowerSlope();
    for (double part = -0.5; part < 1.5; part += 0.03)
    {
      const double z = upper + part * (lower - upper);
      const double edge = std::atan((height - z) / distance);
      EXPECT_NEAR(sun.Lit(upper, lower, z), LitAboveChord((edge - elevation) / radius), 1e-9)
        << distance << ", " << part;
    }
  }
}

TEST(ShadowHeightPenumbra, OfAPointIsAStep)
{
  const ShadowHeightPenumbra sun(0.3, 0.0);
  EXPECT_EQ(sun.Lit(50.0, 50.0, 50.0), 1.0);
  EXPECT_EQ(sun.Lit(50.0, 50.0, 49.9), 0.0);
}

// The part of a disc below the horizontal plane gives no light, at any height of the receiver.
TEST(ShadowHeightPenumbra, OfARisingSun)
{
  const double radius = 0.25 * RadiansPerDegree;
  EXPECT_NEAR(ShadowHeightPenumbra(0.0, radius).Lit(10.0, 20.0, 1000.0), 0.5, Exact);
  EXPECT_NEAR(
    ShadowHeightPenumbra(0.5 * radius, radius).Lit(10.0, 20.0, 1000.0), LitAboveChord(-0.5), Exact);
  EXPECT_EQ(ShadowHeightPenumbra(-radius, radius).Lit(10.0, 20.0, 1000.0), 0.0);
  EXPECT_FALSE(ShadowHeightPenumbra(-radius, radius).Risen());
  EXPECT_EQ(ShadowHeightPenumbra(0.0, 0.0).Lit(10.0, 10.0, 1000.0), 0.0);
  EXPECT_EQ(ShadowHeightPenumbra(0.0, radius).LowerSlope(), 0.0);
}

// The result is never NaN, lies in 0 to 1, and increases with height.
TEST(ShadowHeightPenumbra, RisesWithHeight)
{
  for (const double elevation : { -0.01, 0.0, 0.001, 0.7, 1.55, 0.5 * Pi })
  {
    for (const double radius : { 0.0, 1e-7, 0.0047, 0.5 })
    {
      const ShadowHeightPenumbra sun(elevation, radius);
      double before = 0.0;
      for (double z = -1.0; z <= 12.0; z += 0.125)
      {
        const double lit = sun.Lit(0.0, 10.0, z);
        EXPECT_GE(lit, before);
        EXPECT_LE(lit, 1.0);
        before = lit;
      }
    }
  }
}

} // namespace
} // namespace testing
} // namespace skyline
