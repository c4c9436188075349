// SPDX-License-Identifier: BSD-3-Clause
#include "Sky/SkyAccumulator.h"

#include "Reference/Shapes.h"
#include "Testing/Module/KernelTesting.h"
#include "Testing/Module/ProcessorTargets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace skyline
{
namespace testing
{
namespace
{

std::vector<double> RandomSlopes(shapes::Random& random, int count)
{
  std::vector<double> slopes;
  for (int k = 0; k < count; ++k)
  {
    const double u = random();
    slopes.push_back(u < 0.1 ? oracle::NoTerrain : std::tan((u - 0.3) * 2.0));
  }
  return slopes;
}

TEST(SkyAccumulator, AgreesWithQuadratureInDouble)
{
  ForEachProcessorTarget(
    []()
    {
      shapes::Random random(11);
      for (int post = 0; post < 20; ++post)
      {
        const std::vector<double> slopes = RandomSlopes(random, 24);
        const double steep = post % 2 == 0 ? 1.0 : 5.0;
        const double east = steep * (2.0 * random() - 1.0), north = steep * (2.0 * random() - 1.0);
        const oracle::Sky sum = SumSky(slopes, east, north);
        const oracle::Sky truth = oracle::SkyFromHorizons(slopes, east, north);
        EXPECT_NEAR(sum.SkyViewFactor, truth.SkyViewFactor, SumBound);
        EXPECT_NEAR(sum.SkyViewFactorHorizontal, truth.SkyViewFactorHorizontal, SumBound);
        EXPECT_NEAR(sum.VisibleSkyFraction, truth.VisibleSkyFraction, SumBound);
        EXPECT_NEAR(sum.PositiveOpenness, truth.PositiveOpenness, OpennessBound);
        EXPECT_NEAR(sum.UniformAmbient, truth.UniformAmbient, SumBound);
      }
    });
}

TEST(SkyAccumulator, UniformAmbientIsEquationFive)
{
  // Timonen & Westerholm (2010), equations 4 and 5, as printed: angles from the zenith, c = 1.
  shapes::Random random(5);
  const int n = 32;
  const std::vector<double> slopes = RandomSlopes(random, n);
  const double east = 0.4, north = -0.9;
  const double length = std::sqrt(1.0 + east * east + north * north);
  const double nx = -east / length, ny = -north / length, nz = 1.0 / length;
  double first = 0.0, second = 0.0;
  for (int k = 0; k < n; ++k)
  {
    const double azimuth = Pi / n * 2 * k;
    const double toward = nx * std::sin(azimuth) + ny * std::cos(azimuth);
    const double horizon = 0.5 * Pi - std::atan(slopes[static_cast<std::size_t>(k)]);
    const double theta = std::min(horizon, 0.5 * Pi + std::atan(toward / nz));
    first += std::sin(theta) * std::sin(theta);
    second += (theta - 0.5 * std::sin(2.0 * theta)) * toward;
  }
  EXPECT_NEAR(SumSky(slopes, east, north).UniformAmbient,
    nz / n * first + std::sin(Pi / n) / Pi * second, SumBound);
}

TEST(SkyAccumulator, OpenLevelGroundIsExactlyOne)
{
  ForEachProcessorTarget(
    []()
    {
      for (const double slope : { oracle::NoTerrain, -0.3, 0.0 })
      {
        const oracle::Sky sky = SumSky(std::vector<double>(72, slope), 0.0, 0.0);
        EXPECT_EQ(sky.SkyViewFactor, 1.0);
        EXPECT_EQ(sky.SkyViewFactorHorizontal, 1.0);
        EXPECT_EQ(sky.VisibleSkyFraction, 1.0);
        EXPECT_EQ(sky.UniformAmbient, 1.0);
      }
      EXPECT_NEAR(
        SumSky(std::vector<double>(36, oracle::NoTerrain), 0.0, 0.0).PositiveOpenness, 180.0, 1e-4);
      EXPECT_EQ(SumSky(std::vector<double>(36, 0.0), 0.0, 0.0).PositiveOpenness, 90.0);
    });
}

TEST(SkyAccumulator, NothingIsSeenFromTheBottomOfAShaft)
{
  for (const double slope : { 1.0e12, 1.0e18, std::numeric_limits<double>::infinity() })
  {
    const oracle::Sky sky = SumSky(std::vector<double>(36, slope), 0.3, 0.0);
    EXPECT_NEAR(sky.SkyViewFactor, 0.0, SumBound);
    EXPECT_NEAR(sky.SkyViewFactorHorizontal, 0.0, SumBound);
    EXPECT_NEAR(sky.VisibleSkyFraction, 0.0, SumBound);
    EXPECT_NEAR(sky.PositiveOpenness, 0.0, OpennessBound);
    EXPECT_NEAR(sky.UniformAmbient, 0.0, SumBound);
  }
}

TEST(SkyAccumulator, SteepestPlanesSeeHalfTheSky)
{
  // The plane only hides its own part: (1 + cos s) / 2 tends to 1/2. 36 azimuths represent the
  // circle.
  for (const double steep : { 1.0e4, 1.0e8, 1.0e12 })
  {
    std::vector<double> slopes;
    for (int k = 0; k < 36; ++k)
    {
      slopes.push_back(steep * std::sin(2.0 * Pi * (k + 0.5) / 36.0));
    }
    const oracle::Sky sky = SumSky(slopes, steep, 0.0, 0.5);
    EXPECT_NEAR(sky.SkyViewFactor, 0.5, 1.0e-3) << steep;  // pi^2 / 6 N^2
    EXPECT_NEAR(sky.UniformAmbient, 1.0, 1.0e-3) << steep; // only the plane hides the sky
  }
}

TEST(SkyAccumulator, OutputsDoNotDependOnEachOther)
{
  // Each quantity alone, in a buffer that held other values before.
  shapes::Random random(3);
  const std::vector<double> slopes = RandomSlopes(random, 16);
  const oracle::Sky all = SumSky(slopes, 0.5, -0.2);
  const double expected[5] = { all.SkyViewFactor, all.SkyViewFactorHorizontal,
    all.VisibleSkyFraction, all.PositiveOpenness, all.UniformAmbient };
  const float gradient[2] = { 0.5f, -0.2f };
  for (int wanted = 0; wanted < 5; ++wanted)
  {
    float value = std::numeric_limits<float>::quiet_NaN();
    SkyBuffers buffers;
    PostBuffer* const places[5] = { &buffers.SkyViewFactor, &buffers.SkyViewFactorHorizontal,
      &buffers.VisibleSkyFraction, &buffers.PositiveOpenness, &buffers.UniformAmbient };
    places[wanted]->Values = &value;
    const bool plane = wanted == 0 || wanted == 4;
    SkyAccumulator sky(1, buffers, plane ? &gradient[0] : nullptr, plane ? &gradient[1] : nullptr);
    for (std::size_t k = 0; k < slopes.size(); ++k)
    {
      const auto slope = static_cast<float>(slopes[k]);
      sky.Begin(2.0 * Pi * static_cast<double>(k) / 16.0, 2.0 * Pi / 16.0);
      sky.Add(0, 0, 1, &slope);
    }
    sky.Finish(0, 1);
    EXPECT_NEAR(value, expected[wanted], wanted == 3 ? OpennessBound : SumBound) << wanted;
  }
}

/// All quantities of a small field, added in runs of `run` posts, with `stride` floats per post.
std::vector<float> FieldSky(std::ptrdiff_t run, std::ptrdiff_t stride)
{
  const std::ptrdiff_t columns = 301, rows = 3, posts = columns * rows;
  shapes::Random random(9);
  std::vector<float> east, north;
  for (std::ptrdiff_t i = 0; i < posts; ++i)
  {
    east.push_back(static_cast<float>(random() - 0.5));
    north.push_back(static_cast<float>(random() - 0.5));
  }
  std::vector<float> out(static_cast<std::size_t>(5 * posts * stride));
  SkyBuffers buffers;
  PostBuffer* const places[5] = { &buffers.SkyViewFactor, &buffers.SkyViewFactorHorizontal,
    &buffers.VisibleSkyFraction, &buffers.PositiveOpenness, &buffers.UniformAmbient };
  for (int q = 0; q < 5; ++q)
  {
    places[q]->Values = out.data() + q * posts * stride;
    places[q]->Stride = stride;
  }
  SkyAccumulator sky(columns, buffers, east.data(), north.data());
  for (int k = 0; k < 7; ++k)
  {
    sky.Begin(2.0 * Pi * k / 7.0, 2.0 * Pi / 7.0);
    for (std::ptrdiff_t row = 0; row < rows; ++row)
    {
      for (std::ptrdiff_t column = 0; column < columns; column += run)
      {
        std::vector<float> slopes;
        for (std::ptrdiff_t i = column; i < std::min(columns, column + run); ++i)
        {
          slopes.push_back(
            static_cast<float>(std::sin(0.1 * static_cast<double>(i * (k + 1) + row))));
        }
        sky.Add(row, column, static_cast<std::ptrdiff_t>(slopes.size()), slopes.data());
      }
    }
  }
  sky.Finish(0, 1);
  sky.Finish(1, rows);
  std::vector<float> result;
  for (std::size_t i = 0; i < out.size(); i += static_cast<std::size_t>(stride))
  {
    result.push_back(out[i]);
  }
  return result;
}

TEST(SkyAccumulator, RunsAndStridesDoNotChangeABit)
{
  ForEachProcessorTarget(
    []()
    {
      const std::vector<float> whole = FieldSky(301, 1);
      for (const std::ptrdiff_t run : { 1, 3, 16, 17, 64, 300 })
      {
        EXPECT_EQ(FieldSky(run, 1), whole) << run;
      }
      EXPECT_EQ(FieldSky(301, 5), whole);
      EXPECT_EQ(FieldSky(40, 2), whole);
    });
}

TEST(SkyAccumulator, MissingPostsStayMissing)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const oracle::Sky sky = SumSky(std::vector<double>(8, 0.0), nan, nan);
  EXPECT_TRUE(std::isnan(sky.SkyViewFactor));
  EXPECT_TRUE(std::isnan(sky.UniformAmbient));
  EXPECT_EQ(sky.VisibleSkyFraction, 1.0);
}

} // namespace
} // namespace testing
} // namespace skyline
