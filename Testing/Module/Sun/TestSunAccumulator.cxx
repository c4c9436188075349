// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/SunAccumulator.h"

#include "Reference/Oracle.h"
#include "Reference/Shapes.h"
#include "Shared/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

/// Whether the sun is given once or for each post. Both must give the same result.
enum class Given
{
  Once,
  EachPost
};

constexpr Given Both[] = { Given::Once, Given::EachPost };

/// The error with 30 chords per disc, three per piece: a level cut has a kink in the piece where it
/// leaves the disc.
constexpr double ChordBound = 5.0e-4;

/// The same for a broken horizon with a kink in most pieces, plus the error of the reference's
/// samples.
constexpr double RoughBound = 0.005;

constexpr double Radius = 0.27 * RadiansPerDegree;

SunDirections Everywhere(const SunDisc& sun)
{
  return [sun](std::ptrdiff_t, std::ptrdiff_t, std::ptrdiff_t count, float* x, float* y, float* z)
  {
    for (std::ptrdiff_t i = 0; i < count; ++i)
    {
      x[i] = static_cast<float>(std::cos(sun.Elevation) * std::sin(sun.Azimuth));
      y[i] = static_cast<float>(std::cos(sun.Elevation) * std::cos(sun.Azimuth));
      z[i] = static_cast<float>(std::sin(sun.Elevation));
    }
  };
}

SunAccumulator Make(Given given, std::ptrdiff_t columns, std::ptrdiff_t rows, const SunDisc& sun,
  float* lit, double limbDarkening = 0.0)
{
  const PostBuffer buffer{ lit, 1 };
  return given == Given::Once
    ? SunAccumulator(columns, rows, sun, buffer, limbDarkening)
    : SunAccumulator(columns, rows, Everywhere(sun), sun.Radius, buffer, limbDarkening);
}

/// The visible fraction of the disc at one post, from the slopes of a horizon in the azimuths of
/// SunAzimuths.
template <class Slope>
double Lit(Given given, const SunDisc& sun, const Slope& slope, double limbDarkening = 0.0)
{
  float lit = -1.0f;
  SunAccumulator accumulator = Make(given, 1, 1, sun, &lit, limbDarkening);
  for (const double azimuth :
    SunAzimuths(sun.Azimuth, sun.Azimuth, sun.Elevation, sun.Elevation, sun.Radius))
  {
    const auto value = static_cast<float>(slope(azimuth));
    accumulator.Begin(azimuth, 0.0);
    accumulator.Add(0, 0, 1, &value);
  }
  accumulator.Finish(0, 1);
  return lit;
}

double LitAbove(Given given, const SunDisc& sun, double elevation, double limbDarkening = 0.0)
{
  return Lit(
    given, sun, [=](double) { return std::tan(elevation); }, limbDarkening);
}

double CutDisc(double t)
{
  return 0.5 - (t * std::sqrt(1.0 - t * t) + std::asin(t)) / Pi;
}

TEST(SunAccumulator, DiscCutByALevelHorizon)
{
  // At an elevation of 2 degrees, a level horizon is still a straight line across the disc.
  const SunDisc sun{ 0.001, 2.0 * RadiansPerDegree, Radius };
  for (const Given given : Both)
  {
    for (int k = -3; k <= 3; ++k)
    {
      EXPECT_NEAR(
        LitAbove(given, sun, sun.Elevation + 0.25 * k * Radius), CutDisc(0.25 * k), ChordBound);
    }
  }
}

TEST(SunAccumulator, CoveredOrClearIsExact)
{
  for (const Given given : Both)
  {
    for (const double elevation : { 0.3, 30.0, 80.0, 89.0, 89.9, 90.0 })
    {
      for (const double u : { 0.0, EddingtonLimbDarkening })
      {
        const SunDisc sun{ 5.0, elevation * RadiansPerDegree, Radius };
        EXPECT_EQ(LitAbove(given, sun, sun.Elevation - 1.001 * Radius, u), 1.0) << elevation;
        if (elevation < 89.5)
        {
          EXPECT_EQ(LitAbove(given, sun, sun.Elevation + 1.001 * Radius, u), 0.0) << elevation;
        }
      }
    }
  }
}

TEST(SunAccumulator, PlainHidesTheSunBelowIt)
{
  const auto none = [](double) { return NoTerrainSlope; };
  for (const Given given : Both)
  {
    EXPECT_EQ(Lit(given, { 1.0, -1.0 * RadiansPerDegree, Radius }, none), 0.0);
    EXPECT_EQ(Lit(given, { 1.0, -0.5 * Pi, Radius }, none), 0.0);
    EXPECT_EQ(Lit(given, { 1.0, 0.3 * RadiansPerDegree, Radius }, none), 1.0);
    EXPECT_NEAR(Lit(given, { 1.0, 0.0, Radius }, none), 0.5, ChordBound);
    EXPECT_NEAR(Lit(given, { 1.0, -0.5 * Radius, Radius }, none), CutDisc(0.5), ChordBound);
    // A horizon below the horizontal counts as level.
    EXPECT_EQ(LitAbove(given, { 1.0, -2.0 * RadiansPerDegree, Radius }, -0.2), 0.0);
  }
}

TEST(SunAccumulator, AgreesWithSamplesOfTheDisc)
{
  const double cases[][2] = { { 20.0, 0.27 }, { 60.0, 0.27 }, { 89.5, 0.27 }, { 89.8, 0.27 },
    { 90.0, 0.27 }, { 0.1, 0.27 }, { 80.0, 15.0 }, { 45.0, 30.0 }, { 10.0, 0.001 } };
  shapes::Random random(7);
  for (const auto& c : cases)
  {
    const SunDisc sun{ 2.0 * Pi * random(), c[0] * RadiansPerDegree, c[1] * RadiansPerDegree };
    oracle::HorizonCurve curve;
    curve.Azimuths =
      SunAzimuths(sun.Azimuth, sun.Azimuth, sun.Elevation, sun.Elevation, sun.Radius);
    for (std::size_t k = 0; k < curve.Azimuths.size(); ++k)
    {
      const double e = sun.Elevation + 1.2 * (2.0 * random() - 1.0) * sun.Radius;
      curve.Elevations.push_back(std::clamp(e, 0.0, 0.5 * Pi - 1.0e-4));
    }
    if (HalfSwath(sun.Elevation, sun.Radius) == Pi)
    {
      curve.Elevations.back() = curve.Elevations.front(); // closes the circle
    }
    const auto slope = [&](double azimuth) { return std::tan(curve(azimuth)); };
    for (const double u : { 0.0, EddingtonLimbDarkening })
    {
      if (u > 0.0 && c[1] > 1.0)
      {
        continue; // limb darkening is accurate to radius^2
      }
      const double truth =
        oracle::LitFraction(sun.Azimuth, sun.Elevation, sun.Radius, curve, u, 300, 600);
      for (const Given given : Both)
      {
        EXPECT_NEAR(Lit(given, sun, slope, u), truth, RoughBound)
          << c[0] << " " << c[1] << " " << u;
      }
    }
  }
}

TEST(SunAccumulator, ZenithSunInAShaft)
{
  // The walls leave a cap of 0.1 degrees around the zenith.
  const double cap = 0.1 * RadiansPerDegree;
  const double truth = std::pow(std::sin(0.5 * cap) / std::sin(0.5 * Radius), 2.0);
  for (const Given given : Both)
  {
    EXPECT_NEAR(LitAbove(given, { 0.0, 0.5 * Pi, Radius }, 0.5 * Pi - cap), truth, ChordBound);
  }
}

TEST(SunAccumulator, TinyDiscsKeepTheirDigits)
{
  // A slope of 1 is exact, so the horizon cuts discs of any size in half.
  for (const double radius : { 1.0e-4, 1.0e-6, 1.0e-8 })
  {
    EXPECT_NEAR(
      Lit(Given::Once, { 1.0, 0.25 * Pi, radius }, [](double) { return 1.0; }), 0.5, ChordBound)
      << radius;
  }
}

TEST(SunAccumulator, PointSunIsLitOrNot)
{
  for (const Given given : Both)
  {
    const SunDisc sun{ 2.0, 0.4, 0.0 };
    EXPECT_EQ(LitAbove(given, sun, 0.3999), 1.0);
    EXPECT_EQ(LitAbove(given, sun, 0.4001), 0.0);
    EXPECT_EQ(LitAbove(given, { 2.0, 0.5 * Pi, 0.0 }, 1.5), 1.0);

    // Between two azimuths the horizon is linear: 0.3 at 1.9 and 0.5 at 2.1, so 0.4 at 2.
    float lit = -1.0f;
    SunAccumulator low = Make(given, 1, 1, { 2.0, 0.401, 0.0 }, &lit);
    const float slopes[3] = { 0.0f, std::tan(0.3f), std::tan(0.5f) };
    const double azimuths[3] = { 1.5, 1.9, 2.1 };
    for (int k = 0; k < 3; ++k)
    {
      low.Begin(azimuths[k], 0.0);
      low.Add(0, 0, 1, &slopes[k]);
    }
    low.Finish(0, 1);
    EXPECT_EQ(lit, 1.0f);
  }
}

TEST(SunAccumulator, EdgeHidesTheSideItStandsOn)
{
  // A wall up to the azimuth of the sun and nothing beyond: half of the disc, also across north.
  for (const double azimuth : { 0.0, 3.0, 6.28 })
  {
    const SunDisc sun{ azimuth, 0.5, Radius };
    for (const Given given : Both)
    {
      // The step is spread over the interval beside the centre, an eighth of the swath.
      const double lit =
        Lit(given, sun, [=](double a) { return a < azimuth - 1.0e-6 ? 1.0 : 0.1; });
      EXPECT_NEAR(lit, 0.5, 0.13) << azimuth;
      EXPECT_GT(lit, 0.5) << azimuth;
    }
  }
}

TEST(SunAccumulator, EachPostHasItsSun)
{
  // Suns along a row, from 4 degrees west to 4 degrees east of north, and a broken ridge.
  const std::ptrdiff_t columns = 40;
  const double elevation = 0.3;
  const auto azimuthOf = [](std::ptrdiff_t column)
  { return (static_cast<double>(column) * 0.2 - 4.0) * RadiansPerDegree; };
  const auto ridge = [=](double a)
  { return std::tan(elevation + 1.5 * Radius * std::sin(300.0 * a)); };
  const SunDirections directions =
    [&](std::ptrdiff_t, std::ptrdiff_t column, std::ptrdiff_t count, float* x, float* y, float* z)
  {
    for (std::ptrdiff_t i = 0; i < count; ++i)
    {
      const double a = azimuthOf(column + i);
      x[i] = static_cast<float>(std::cos(elevation) * std::sin(a));
      y[i] = static_cast<float>(std::cos(elevation) * std::cos(a));
      z[i] = static_cast<float>(std::sin(elevation));
    }
  };
  for (const double u : { 0.0, EddingtonLimbDarkening })
  {
    std::vector<float> lit(static_cast<std::size_t>(columns));
    SunAccumulator accumulator(columns, 1, directions, Radius, PostBuffer{ lit.data(), 1 }, u);
    // The nodes are so close that the ridge between them has no effect.
    for (int k = 0; k <= 1000; ++k)
    {
      const double azimuth = (-5.0 + 0.01 * k) * RadiansPerDegree;
      const std::vector<float> slopes(
        static_cast<std::size_t>(columns), static_cast<float>(ridge(azimuth)));
      accumulator.Begin(azimuth + 2.0 * Pi, 0.0);
      accumulator.Add(0, 0, 17, slopes.data());
      accumulator.Add(0, 17, columns - 17, slopes.data());
    }
    accumulator.Finish(0, 1);
    for (std::ptrdiff_t column = 0; column < columns; column += 3)
    {
      const double truth = oracle::LitFraction(
        azimuthOf(column), elevation, Radius, [&](double a) { return std::atan(ridge(a)); }, u, 200,
        400);
      EXPECT_NEAR(lit[static_cast<std::size_t>(column)], truth, RoughBound) << column;
    }
  }
}

TEST(SunAccumulator, RunsDoNotChangeABit)
{
  const std::ptrdiff_t columns = 61, rows = 2;
  const SunDisc sun{ 1.0, 0.3, Radius };
  for (const Given given : Both)
  {
    std::vector<std::vector<float>> results;
    for (const std::ptrdiff_t run : { 61, 1, 16, 17 })
    {
      std::vector<float> lit(static_cast<std::size_t>(columns * rows));
      SunAccumulator accumulator = Make(given, columns, rows, sun, lit.data());
      for (const double azimuth : SunAzimuths(1.0, 1.0, 0.3, 0.3, Radius))
      {
        accumulator.Begin(azimuth, 0.0);
        for (std::ptrdiff_t row = 0; row < rows; ++row)
        {
          for (std::ptrdiff_t column = 0; column < columns; column += run)
          {
            std::vector<float> slopes;
            for (std::ptrdiff_t i = column; i < std::min(columns, column + run); ++i)
            {
              const double wave = std::sin(static_cast<double>(3 * i + row) + 200.0 * azimuth);
              slopes.push_back(static_cast<float>(std::tan(0.3 + 2.0 * Radius * wave)));
            }
            accumulator.Add(row, column, static_cast<std::ptrdiff_t>(slopes.size()), slopes.data());
          }
        }
      }
      accumulator.Finish(0, 1);
      accumulator.Finish(1, 2);
      results.push_back(lit);
    }
    for (const std::vector<float>& result : results)
    {
      EXPECT_EQ(result, results.front());
      for (const float value : result)
      {
        EXPECT_TRUE(value >= 0.0f && value <= 1.0f);
      }
    }
  }
}

TEST(SunAccumulator, DiscThatNoAzimuthMeetsIsUnknown)
{
  for (const Given given : Both)
  {
    float lit = 0.0f;
    const float slope = 0.1f;
    SunAccumulator accumulator = Make(given, 1, 1, { 1.0, 0.3, Radius }, &lit);
    for (const double azimuth : { 2.0, 2.1 })
    {
      accumulator.Begin(azimuth, 0.0);
      accumulator.Add(0, 0, 1, &slope);
    }
    accumulator.Finish(0, 1);
    EXPECT_TRUE(std::isnan(lit));
  }
}

} // namespace
} // namespace testing
} // namespace skyline
