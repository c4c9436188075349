// SPDX-License-Identifier: BSD-3-Clause
#include "Sky/LightAccumulator.h"

#include "Reference/LightOracle.h"
#include "Sky/LightAzimuths.h"
#include "Testing/Module/KernelTesting.h"
#include "Testing/Module/ProcessorTargets.h"

#include <gtest/gtest.h>

#include <limits>

namespace skyline
{
namespace testing
{
namespace
{

// The error of sums of some hundred floats up to pi.
constexpr double SumError = 1.0e-5;

// The error for a sky of radiance 1 and tilted planes with 256 azimuths.
constexpr double AzimuthError = 3.0e-4;

const SwathQuadrature Quadratures[] = { SwathQuadrature::Constant, SwathQuadrature::Blend,
  SwathQuadrature::Linear };

LightAccumulator::Options With(SwathQuadrature quadrature)
{
  LightAccumulator::Options options;
  options.Quadrature = quadrature;
  return options;
}

const auto Open = [](double) { return 0.0; };

TEST(LightAccumulator, WhiteFurnace)
{
  const OwnedMap white(8, 4, 1.0f);
  const std::vector<TurnedLightMap> maps{ { white.View(), 0.4 } };
  ForEachProcessorTarget(
    [&]()
    {
      for (const SwathQuadrature quadrature : Quadratures)
      {
        for (const int count : { 3, 16, 256 })
        {
          const Color level =
            SumLight(maps, LightAzimuths(count, maps), With(quadrature), Open, 0.0, 0.0);
          for (const double light : level)
          {
            EXPECT_NEAR(light, Pi, SumError);
          }
        }
        // A plane with the inclination b sees (1 + cos b) / 2 of the sky.
        for (const double steep : { 0.3, 1.0, 5.0 })
        {
          const double inclination = std::atan(steep);
          const Color tilted = SumLight(
            maps, LightAzimuths(256, maps), With(quadrature), Open, 0.6 * steep, -0.8 * steep);
          EXPECT_NEAR(tilted[1], 0.5 * Pi * (1.0 + std::cos(inclination)), AzimuthError);
        }
      }
    });
}

TEST(LightAccumulator, ConstantQuadratureIsEquationFive)
{
  // SkyAccumulator has a closed form for uniform light. It applies to horizons of at least 0 and to
  // planes below them, so that the lower limit of the sky is the same.
  const OwnedMap white(8, 4, 1.0f);
  const std::vector<TurnedLightMap> maps{ { white.View(), 0.0 } };
  shapes::Random random(4);
  for (int post = 0; post < 10; ++post)
  {
    std::vector<double> slopes(32);
    for (double& slope : slopes)
    {
      slope = 0.5 + 2.0 * random();
    }
    const auto horizon = [&](double azimuth) {
      return std::atan(slopes[static_cast<std::size_t>(std::lround(azimuth / (2.0 * Pi) * 32.0))]);
    };
    const Color light =
      SumLight(maps, LightAzimuths(32, maps), With(SwathQuadrature::Constant), horizon, 0.3, -0.2);
    EXPECT_NEAR(light[0], Pi * SumSky(slopes, 0.3, -0.2).UniformAmbient, SumError);
  }
}

TEST(LightAccumulator, ConvergesToTheSumOverAllPixels)
{
  // A horizon of smooth waves and a map with a sun. For each quadrature the error decreases with
  // more azimuths.
  const OwnedMap map = SunnyMap(256, 128, 100.0, 38.0);
  const double rotation = 0.7;
  const std::vector<TurnedLightMap> maps{ { map.View(), rotation } };
  const auto horizon = [](double a) { return 0.35 + 0.3 * std::sin(2.0 * a + 0.3) * std::cos(a); };
  const Color truth = BruteLight(map, rotation, horizon, 0.3, 0.4, 256 * 256);
  for (const SwathQuadrature quadrature : Quadratures)
  {
    double last = 1.0;
    for (const int count : { 8, 32, 128 })
    {
      const Color light =
        SumLight(maps, LightAzimuths(count, maps), With(quadrature), horizon, 0.3, 0.4);
      double error = 0.0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        error = std::max(error, std::abs(light[c] / truth[c] - 1.0));
      }
      EXPECT_LT(error, 0.5 * last) << count;
      last = std::max(error, 2.0e-4);
    }
    EXPECT_LT(last, 1.0e-3);
  }
}

TEST(LightAccumulator, RunsAndPlacesDoNotChangeBits)
{
  const OwnedMap map = SunnyMap(64, 32, 100.0, 38.0);
  const OwnedMap other = NoisyMap(16, 8, 3);
  const std::vector<TurnedLightMap> maps{ { map.View(), 0.0 }, { other.View(), 1.0 } };
  constexpr std::ptrdiff_t columns = 149, rows = 3;
  constexpr std::size_t posts = static_cast<std::size_t>(columns * rows);
  shapes::Random random(6);
  std::vector<float> east(posts), north(posts);
  for (std::size_t i = 0; i < posts; ++i)
  {
    east[i] = static_cast<float>(random() - 0.5);
    north[i] = static_cast<float>(random() - 0.5);
  }
  for (const SwathQuadrature quadrature : Quadratures)
  {
    const auto run = [&](std::ptrdiff_t piece, std::uint64_t seed)
    {
      std::vector<float> light(3 * posts, -1.0f);
      LightAccumulator sum(columns, rows, maps, LightAzimuths(8, maps), With(quadrature),
        east.data(), north.data(), light.data());
      shapes::Random slopes(seed);
      for (const double azimuth : sum.HorizonAzimuths())
      {
        std::vector<float> line(posts);
        for (float& slope : line)
        {
          slope = static_cast<float>(3.0 * slopes() - 1.0);
        }
        sum.Begin(azimuth, 0.0);
        for (std::ptrdiff_t row = rows - 1; row >= 0; --row)
        {
          for (std::ptrdiff_t column = 0; column < columns; column += piece)
          {
            sum.Add(
              row, column, std::min(piece, columns - column), line.data() + row * columns + column);
          }
        }
      }
      sum.Finish(0, rows);
      return light;
    };
    const std::vector<float> whole = run(columns, 2);
    EXPECT_EQ(run(1, 2), whole);
    EXPECT_EQ(run(37, 2), whole);
  }
}

TEST(LightAccumulator, LevelReceiversNeedNoGradients)
{
  const OwnedMap map = NoisyMap(64, 32, 12);
  const std::vector<TurnedLightMap> maps{ { map.View(), 0.0 } };
  const std::vector<double> azimuths = LightAzimuths(16, maps);
  float light[3];
  LightAccumulator level(1, 1, maps, azimuths, {}, nullptr, nullptr, light);
  for (const double azimuth : azimuths)
  {
    const auto slope = static_cast<float>(std::tan(0.3 + 0.2 * std::sin(azimuth)));
    level.Begin(azimuth, 0.0);
    level.Add(0, 0, 1, &slope);
  }
  level.Finish(0, 1);
  const Color plane = SumLight(
    maps, azimuths, {}, [](double a) { return 0.3 + 0.2 * std::sin(a); }, 0.0, 0.0);
  for (std::size_t c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(light[c], plane[c], SumError);
  }
}

TEST(LightAccumulator, ExtremesStayInRange)
{
  const OwnedMap map = SunnyMap(64, 32, 100.0, 38.0);
  const std::vector<TurnedLightMap> maps{ { map.View(), 0.0 } };
  const std::vector<double> azimuths = LightAzimuths(24, maps);
  const double infinite = std::numeric_limits<double>::infinity();
  const auto slope = [](double value) { return [value](double) { return std::atan(value); }; };
  for (const SwathQuadrature quadrature : Quadratures)
  {
    for (const double value : { -infinite, -1.0e18, -3.0, 0.0, 1.0e18, infinite })
    {
      for (const double steep : { 0.0, 1.0e4, 1.0e8 })
      {
        const Color light = SumLight(maps, azimuths, With(quadrature), slope(value), steep, -steep);
        for (const double color : light)
        {
          EXPECT_TRUE(color >= 0.0 && std::isfinite(color)) << value << " " << steep;
          EXPECT_TRUE(value <= 0.0 || color < 1.0e-4) << value << " " << steep << " " << color;
        }
      }
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(SumLight(maps, azimuths, With(quadrature), Open, nan, nan)[0]));
  }
}

TEST(LightAzimuths, AreEvenUnlessTheMapIsBright)
{
  const OwnedMap white(8, 4, 1.0f);
  const std::vector<double> even = LightAzimuths(16, { { white.View(), 0.0 } });
  ASSERT_EQ(even.size(), 16u);
  for (std::size_t k = 0; k < even.size(); ++k)
  {
    EXPECT_DOUBLE_EQ(even[k], 2.0 * Pi * static_cast<double>(k) / 16.0);
  }
  const OwnedMap dark(8, 4, 0.0f);
  EXPECT_EQ(LightAzimuths(16, { { dark.View(), 0.0 } }).size(), 16u);
}

TEST(LightAzimuths, CrowdWhereTheSunIs)
{
  const OwnedMap map = SunnyMap(256, 128, 100.0, 38.0);
  for (const double rotation : { 0.0, -1.0, 9.0 })
  {
    const std::vector<TurnedLightMap> maps{ { map.View(), rotation } };
    const std::vector<double> azimuths = LightAzimuths(64, maps);
    EXPECT_GT(azimuths.size(), 70u);
    EXPECT_LT(azimuths.size(), 110u);
    EXPECT_EQ(LightAzimuths(64, maps, false).size(), 64u);
    const double pixel = 2.0 * Pi / 256.0;
    int inside = 0;
    for (std::size_t k = 0; k < azimuths.size(); ++k)
    {
      EXPECT_TRUE(k == 0 || azimuths[k] > azimuths[k - 1]);
      const double sun =
        2.0 * Pi * (std::floor(280.0 / 360.0 * 256.0) + 0.5) / 256.0 - Pi + rotation;
      inside += std::abs(std::remainder(azimuths[k] - sun, 2.0 * Pi)) <= 0.5 * pixel ? 1 : 0;
    }
    EXPECT_GE(inside, 8);
  }
}

} // namespace
} // namespace testing
} // namespace skyline
