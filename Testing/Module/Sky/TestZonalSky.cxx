// SPDX-License-Identifier: BSD-3-Clause
#include "Sky/ZonalSky.h"

#include "Shared/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{

using skyline::Pi;

// The error of the linear interpolation of the table.
constexpr double TableTolerance = 1e-5;

// 360 azimuths on a tilted plane: the integrand has a kink where the plane crosses the horizontal.
constexpr double AzimuthTolerance = 5e-5;

constexpr int Types[] = { 1, 3, 5, 16 };

// The share of the light that reaches one post with a gradient, above a horizon given as a function
// of azimuth.
template <typename Slope>
double Share(int type, float east, float north, const Slope& slope, int azimuths = 360)
{
  const skyline::ZonalSky sky(type);
  float share = -7.0f; // the earlier content of the buffer must not count
  skyline::ZonalSkyAccumulator accumulator(sky, 1, &east, &north, &share);
  for (int k = 0; k < azimuths; ++k)
  {
    const double azimuth = 2.0 * Pi * k / azimuths;
    const float horizon = static_cast<float>(slope(azimuth));
    accumulator.Begin(azimuth, 2.0 * Pi / azimuths);
    accumulator.Add(0, 0, 1, &horizon);
  }
  accumulator.Finish(0, 1);
  return share;
}

// The same by simple sums over the hemisphere.
double BruteForce(int type, double east, double north, double horizon)
{
  constexpr int azimuths = 720;
  constexpr int elevations = 2000;
  const double up = 1.0 / std::sqrt(1.0 + east * east + north * north);
  double light = 0.0;
  double open = 0.0;
  for (int j = 0; j < elevations; ++j)
  {
    const double e = 0.5 * Pi * (j + 0.5) / elevations;
    const double radiance = skyline::ZonalSky::Radiance(type, std::sin(e)) * std::cos(e);
    for (int i = 0; i < azimuths; ++i)
    {
      const double a = 2.0 * Pi * (i + 0.5) / azimuths;
      const double facing =
        up * (std::sin(e) - (east * std::sin(a) + north * std::cos(a)) * std::cos(e));
      open += radiance * std::sin(e);
      light += e > horizon ? radiance * std::max(0.0, facing) : 0.0;
    }
  }
  return light / open;
}

const auto Level = [](double) { return 0.0; };

TEST(ZonalSky, OpenLevelGroundIsOne)
{
  for (int type : Types)
  {
    EXPECT_NEAR(Share(type, 0.0f, 0.0f, Level), 1.0, TableTolerance) << type;
    // No light comes from below the horizontal.
    const auto noTerrain = [](double) { return skyline::NoTerrainSlope; };
    EXPECT_NEAR(Share(type, 0.0f, 0.0f, noTerrain), 1.0, TableTolerance) << type;
  }
}

// A level receiver in a round pit whose rim has the elevation h.
TEST(ZonalSky, RoundPit)
{
  for (double h : { 5.0, 30.0, 60.0, 89.0 })
  {
    const double angle = h * skyline::RadiansPerDegree;
    const auto rim = [&](double) { return std::tan(angle); };
    const double s = std::sin(angle);
    // Uniform sky: cos^2 h. Traditional overcast sky: the integral of (1 + 2 x) x from s to 1,
    // divided by 7 / 6.
    EXPECT_NEAR(Share(5, 0.0f, 0.0f, rim), 1.0 - s * s, TableTolerance);
    const double overcast = ((1.0 - s * s) / 2.0 + 2.0 * (1.0 - s * s * s) / 3.0) / (7.0 / 6.0);
    EXPECT_NEAR(Share(16, 0.0f, 0.0f, rim), overcast, TableTolerance);
    EXPECT_NEAR(Share(1, 0.0f, 0.0f, rim), BruteForce(1, 0.0, 0.0, angle), 1e-3);
    EXPECT_NEAR(Share(3, 0.0f, 0.0f, rim), BruteForce(3, 0.0, 0.0, angle), 1e-3);
  }
}

TEST(ZonalSky, InclinedPlane)
{
  // A uniform sky on a plane with the inclination b: (1 + cos b) / 2.
  const float east = 0.6f;
  const float north = -0.8f;
  const auto plane = [&](double a) { return east * std::sin(a) + north * std::cos(a); };
  EXPECT_NEAR(Share(5, east, north, plane), 0.5 * (1.0 + std::sqrt(0.5)), AzimuthTolerance);
  for (int type : Types)
  {
    // Sums of midpoints with steps of 0.045 degrees in elevation and 0.5 degrees in azimuth.
    EXPECT_NEAR(Share(type, east, north, plane), BruteForce(type, east, north, 0.0), 2e-4);
    // The plane hides the sky below it, even if the horizon is lower.
    EXPECT_NEAR(Share(type, east, north, Level), Share(type, east, north, plane), 1e-6);
  }
}

TEST(ZonalSky, ExtremesStayInRange)
{
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int type : Types)
  {
    EXPECT_EQ(Share(type, 0.0f, 0.0f, [](double) { return 1e18; }), 0.0);
    EXPECT_NEAR(Share(type, 0.0f, 0.0f, [&](double) { return infinity; }), 0.0, TableTolerance);
    const double cliff = Share(type, 1e6f, 0.0f, Level);
    EXPECT_TRUE(cliff >= 0.0 && cliff < 0.6) << cliff;
    EXPECT_TRUE(std::isnan(Share(type, nan, nan, Level)));
  }
}

TEST(ZonalSky, RadianceOfTheStandard)
{
  for (int type : Types)
  {
    EXPECT_TRUE(skyline::ZonalSky::Knows(type));
    EXPECT_NEAR(skyline::ZonalSky::Radiance(type, 1.0), 1.0, 1e-15);
  }
  EXPECT_NEAR(skyline::ZonalSky::Radiance(16, 0.0), 1.0 / 3.0, 1e-15);
  EXPECT_NEAR(skyline::ZonalSky::Radiance(1, 0.0), 1.0 / (1.0 + 4.0 * std::exp(-0.7)), 1e-15);
  for (int type : { -1, 0, 2, 4, 12, 17 })
  {
    EXPECT_FALSE(skyline::ZonalSky::Knows(type));
    EXPECT_THROW(skyline::ZonalSky sky(type), std::invalid_argument);
  }
}

} // namespace
