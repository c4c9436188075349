// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/SunDisc.h"

#include "Shared/Constants.h"

#include <gtest/gtest.h>

#include <cmath>

namespace skyline
{
namespace testing
{
namespace
{

/// Gauss rules with three points over pieces of pi / 8. The parts of a disc add up to the disc with
/// this relative error.
constexpr double GaussBound = 1.0e-6;

double AngleBetween(double azimuth, double elevation, const SunDisc& disc)
{
  const double dot = std::sin(elevation) * std::sin(disc.Elevation) +
    std::cos(elevation) * std::cos(disc.Elevation) * std::cos(azimuth);
  return std::acos(std::clamp(dot, -1.0, 1.0));
}

TEST(SunDisc, ChordEndsLieOnTheRim)
{
  for (const double elevation : { -1.5, -0.3, 0.0, 0.6, 1.4, 1.57 })
  {
    for (const double radius : { 0.005, 0.2, 1.2 })
    {
      const SunDisc disc{ 0.0, elevation, radius };
      const double swath = HalfSwath(elevation, radius);
      for (const double part : { -0.99, -0.5, 0.0, 0.3, 0.8 })
      {
        const DiscChord chord = ChordOfDisc(disc, part * swath);
        for (const double end : { chord.Low, chord.High })
        {
          const double e = elevation + end;
          if (chord.Low < chord.High && std::abs(e) < 0.5 * Pi - 1e-9)
          {
            EXPECT_NEAR(AngleBetween(part * swath, e, disc), radius, 1e-7) << elevation;
          }
          EXPECT_LE(std::abs(e), 0.5 * Pi + 1e-12);
        }
      }
    }
  }
}

TEST(SunDisc, SwathTouchesTheRim)
{
  EXPECT_NEAR(HalfSwath(0.0, 0.1), 0.1, 1e-12);
  EXPECT_NEAR(HalfSwath(Pi / 3.0, 0.005), std::asin(2.0 * std::sin(0.005)), 1e-12);
  EXPECT_EQ(HalfSwath(0.5 * Pi - 0.004, 0.005), Pi);
  EXPECT_EQ(HalfSwath(-0.5 * Pi, 0.005), Pi);
  EXPECT_EQ(HalfSwath(1.0, 0.0), 0.0);
  const SunDisc disc{ 0.0, 1.0, 0.1 };
  const double swath = HalfSwath(1.0, 0.1);
  EXPECT_GT(ChordOfDisc(disc, 0.999 * swath).Half, 0.0);
  EXPECT_EQ(ChordOfDisc(disc, 1.001 * swath).Half, 0.0);
}

TEST(SunDisc, SlicesMakeUpTheDisc)
{
  for (const double elevation : { 0.0, 0.5, 1.3, 0.5 * Pi - 0.001, 0.5 * Pi, -1.569 })
  {
    for (const double radius : { 1e-6, 0.005, 0.3 })
    {
      for (const double u : { 0.0, EddingtonLimbDarkening })
      {
        if (u > 0.0 && radius > 0.01)
        {
          continue; // limb darkening is accurate to radius^2
        }
        const SunDisc disc{ 0.0, elevation, radius };
        const double swath = HalfSwath(elevation, radius);
        double light = 0.0;
        const int slices = 24;
        for (int k = 0; k < slices; ++k)
        {
          DiscSlice slice;
          slice.Set(
            disc, swath * (2.0 * k / slices - 1.0), swath * (2.0 * (k + 1) / slices - 1.0), u);
          light += slice.Whole();
        }
        // The solid angle times the mean of 1 - u (1 - mu) over a disc, 1 - u / 3.
        const double half = std::sin(0.5 * radius);
        const double truth = 4.0 * Pi * half * half * (1.0 - u / 3.0);
        // Around the zenith, the chords change direction within a slice where the rim passes near
        // it.
        const double bound = swath == Pi && elevation != 0.5 * Pi ? 1.0e-3 : 50.0 * GaussBound;
        EXPECT_NEAR(light / truth, 1.0, bound) << elevation << " " << radius << " " << u;
      }
    }
  }
}

TEST(SunDisc, CoveredOrClearIsExact)
{
  const SunDisc disc{ 0.0, 0.3, 0.005 };
  for (const double u : { 0.0, EddingtonLimbDarkening })
  {
    DiscSlice slice;
    slice.Set(disc, -0.003, 0.001, u);
    EXPECT_EQ(slice.Hidden(-0.005, -0.0051), 0.0);
    EXPECT_EQ(slice.Hidden(0.0051, 0.006), slice.Whole());
    const double part = slice.Hidden(-0.005, 0.005);
    EXPECT_GT(part, 0.0);
    EXPECT_LT(part, slice.Whole());
    slice.Set(disc, 0.006, 0.01, u);
    EXPECT_EQ(slice.Whole(), 0.0);
  }
}

TEST(SunDisc, AzimuthsCoverTheSwathAndAreFew)
{
  const double radius = MeanSunRadius * RadiansPerDegree;
  const std::vector<double> one = SunAzimuths(3.0, 3.0, 0.5, 0.5, radius);
  EXPECT_EQ(one.size(), 17u);
  EXPECT_NEAR(one.front(), 3.0 - HalfSwath(0.5, radius), 1e-12);
  EXPECT_NEAR(one.back(), 3.0 + HalfSwath(0.5, radius), 1e-12);

  EXPECT_EQ(SunAzimuths(1.0, 1.0, 0.5, 0.5, 0.0), std::vector<double>{ 1.0 });

  const std::vector<double> zenith = SunAzimuths(1.0, 1.0, 1.57, 1.57, radius);
  EXPECT_EQ(zenith.size(), 25u);
  EXPECT_NEAR(zenith.back() - zenith.front(), 2.0 * Pi, 1e-12);

  // Suns over 3 degrees of azimuth across north: the nodes are as close as for the lowest sun.
  const std::vector<double> many = SunAzimuths(6.25, 6.25 + 0.05, 0.1, 0.4, radius);
  EXPECT_LE(many.front(), 6.25 - HalfSwath(0.4, radius) + 1e-12);
  EXPECT_GE(many.back(), 6.30 + HalfSwath(0.4, radius) - 1e-12);
  for (std::size_t k = 0; k + 1 < many.size(); ++k)
  {
    EXPECT_GT(many[k + 1], many[k]);
    EXPECT_LE(many[k + 1] - many[k], 0.25 * HalfSwath(0.1, radius) + 1e-12);
  }
}

} // namespace
} // namespace testing
} // namespace skyline
