// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/KeyLight.h"
#include "Reference/SharedSwaths.h"

#include "Harmonics/VisibilityAccumulator.h"
#include "Shared/Constants.h"
#include "WedgeTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

constexpr double Degree = RadiansPerDegree;

KeyLight Light(double azimuth, double elevation, double radius)
{
  return { azimuth * Degree, elevation * Degree, radius * Degree };
}

/// The irradiance of a post by its transfer over a swath, with horizons given as a function of
/// azimuth.
double Lit(const std::vector<double>& light, const Swath& swath, int azimuths,
  const std::function<double(double)>& slope, double east = 0.0, double north = 0.0)
{
  const int bands = static_cast<int>(std::lround(std::sqrt(light.size())));
  std::vector<float> values(light.size());
  const auto x = static_cast<float>(east), y = static_cast<float>(north);
  VisibilityAccumulator sums({ 1, 1, bands, values.data(), SkyPart::Upper }, &x, &y);
  for (const double azimuth : AzimuthsOf(swath, azimuths))
  {
    const auto here = static_cast<float>(slope(azimuth));
    sums.Begin(azimuth, swath.Width / azimuths);
    sums.Add(0, 0, 1, &here);
  }
  sums.Finish(0, 1);
  return Dot({ values.begin(), values.end() }, light);
}

double Irradiance(const KeyLight& light, const Swath& swath, int azimuths, int bands,
  const std::function<double(double)>& slope, double east = 0.0, double north = 0.0)
{
  std::vector<double> coefficients(static_cast<std::size_t>(HarmonicCount(bands)));
  KeyLightHarmonics(light, swath, bands, coefficients.data());
  return Lit(coefficients, swath, azimuths, slope, east, north);
}

TEST(KeyLight, SwathIsThatOfTheDisc)
{
  // The swath of a disc on the horizon is as wide as the disc. Higher up the meridians converge.
  EXPECT_NEAR(SwathOf(Light(30.0, 0.0, 5.0)).Width, 10.0 * Degree, 1.0e-12);
  EXPECT_NEAR(
    SwathOf(Light(30.0, 60.0, 5.0)).Width, 2.0 * std::asin(2.0 * std::sin(5.0 * Degree)), 1.0e-12);
  EXPECT_NEAR(SwathOf(Light(-30.0, 60.0, 5.0)).Azimuth, 330.0 * Degree, 1.0e-12);
  EXPECT_TRUE(SwathOf(Light(30.0, 86.0, 5.0)).IsCircle());
  EXPECT_TRUE(SwathOf(Light(30.0, 90.0, 5.0)).IsCircle());
  EXPECT_TRUE(SwathOf(Light(30.0, 0.0, 90.0)).IsCircle());
  EXPECT_EQ(SwathOf(Light(30.0, 10.0, 0.0)).Width, LeastSwath);
}

TEST(KeyLight, AzimuthsAreTheMiddlesOfParts)
{
  const auto azimuths = AzimuthsOf({ 1.0, 0.6 }, 3);
  ASSERT_EQ(azimuths.size(), 3u);
  EXPECT_NEAR(azimuths[0], 0.8, 1.0e-15);
  EXPECT_NEAR(azimuths[1], 1.0, 1.0e-15);
  EXPECT_NEAR(azimuths[2], 1.2, 1.0e-15);
}

TEST(KeyLight, OverlappingSwathsAreShared)
{
  // On the horizon the widths are the diameters: 350..10, 5..15, 100..120, 119..141, 200..210.
  const std::vector<KeyLight> lights{ Light(205.0, 0.0, 5.0), Light(0.0, 0.0, 10.0),
    Light(110.0, 0.0, 10.0), Light(10.0, 0.0, 5.0), Light(130.0, 0.0, 11.0) };
  const auto shared = ShareSwaths(lights);
  ASSERT_EQ(shared.size(), 3u);
  double width = 0.0;
  for (const SharedSwath& swath : shared)
  {
    width += swath.Extent.Width;
    for (const std::size_t i : swath.Lights)
    {
      const Swath own = SwathOf(lights[i]);
      EXPECT_TRUE(swath.Extent.Holds(own.Azimuth - 0.5 * own.Width));
      EXPECT_TRUE(swath.Extent.Holds(own.Azimuth + 0.5 * own.Width));
    }
  }
  EXPECT_NEAR(width, (25.0 + 41.0 + 10.0) * Degree, 1.0e-9);
  EXPECT_EQ(shared[0].Lights, (std::vector<std::size_t>{ 2, 4 }));
  EXPECT_EQ(shared[1].Lights, (std::vector<std::size_t>{ 0 }));
  EXPECT_EQ(shared[2].Lights, (std::vector<std::size_t>{ 1, 3 }));
}

TEST(KeyLight, SharesTheWholeCircleWhereOneNeedsIt)
{
  const auto shared = ShareSwaths({ Light(10.0, 80.0, 20.0), Light(90.0, 0.0, 5.0) });
  ASSERT_EQ(shared.size(), 1u);
  EXPECT_TRUE(shared[0].Extent.IsCircle());
  EXPECT_TRUE(ShareSwaths({}).empty());
}

TEST(KeyLight, FacingIrradianceIsThatOfTheDisc)
{
  for (const double elevation : { 0.0, 3.0, 20.0 })
  {
    const KeyLight light = Light(40.0, elevation, 20.0);
    const Vector toward = DirectionOf(light.Azimuth, light.Elevation);
    double sum = 0.0;
    ForSky(
      0.0, 2.0 * Pi, 2000, 1000, [](double) { return 0.0; },
      [&](const Vector& d, double solid)
      {
        const double cosine = d.X * toward.X + d.Y * toward.Y + d.Z * toward.Z;
        sum += cosine > std::cos(light.Radius) ? cosine * solid : 0.0;
      });
    EXPECT_NEAR(FacingIrradiance(light), sum, 2.0e-3 * sum); // the rim of the disc on a lattice
  }
}

// Without terrain the irradiance is that of the disc, for any swath and order.
TEST(KeyLight, UnshadowedIrradianceIsExact)
{
  for (const int bands : { 2, 4, 8 })
  {
    for (const double elevation : { 20.0, 45.0, 70.0 })
    {
      const KeyLight light = Light(70.0, elevation, 6.0);
      const Vector toward = DirectionOf(light.Azimuth, light.Elevation);
      const double truth = Pi * std::pow(std::sin(light.Radius), 2.0);
      for (const Swath& swath : { SwathOf(light), Swath{ light.Azimuth, 1.0 }, Swath{} })
      {
        EXPECT_NEAR(Irradiance(
                      light, swath, 64, bands, [](double) { return -1.0; }, -toward.X / toward.Z,
                      -toward.Y / toward.Z),
          truth, 0.01 * truth); // kinks of the plane's own horizon between 64 azimuths
      }
    }
  }
}

/// The irradiance of a level receiver behind a horizon of constant elevation: that of the disc, and
/// that of the series, cut off at 0. Each is relative to its value without terrain.
struct Shadow
{
  double Rms = 0.0, Lowest = 1.0, Open = 0.0; ///< Open: relative to the disc
};

Shadow ShadowOf(const KeyLight& light, int bands, KeyLightSeries series)
{
  const Swath swath = SwathOf(light);
  const Vector toward = DirectionOf(light.Azimuth, light.Elevation);
  std::vector<double> coefficients(static_cast<std::size_t>(HarmonicCount(bands)));
  KeyLightHarmonics(light, swath, bands, coefficients.data(), series);
  Shadow shadow;
  double open[2] = {}, squares = 0.0;
  const int steps = 45;
  for (int k = 0; k <= steps; ++k)
  {
    const double horizon = 0.5 * Pi * k / steps;
    double truth = 0.0;
    ForSky(
      swath.Azimuth - 0.5 * swath.Width, swath.Azimuth + 0.5 * swath.Width, 60, 1000,
      [&](double) { return horizon; },
      [&](const Vector& d, double solid)
      {
        const double cosine = d.X * toward.X + d.Y * toward.Y + d.Z * toward.Z;
        truth += cosine > std::cos(light.Radius) ? d.Z * solid : 0.0;
      });
    const double found = Lit(coefficients, swath, 3, [&](double) { return std::tan(horizon); });
    open[0] = k == 0 ? truth : open[0];
    open[1] = k == 0 ? found : open[1];
    const double error = std::max(found, 0.0) / open[1] - truth / open[0];
    squares += error * error / (steps + 1);
    shadow.Lowest = std::min(shadow.Lowest, found / open[1]);
  }
  shadow.Rms = std::sqrt(squares);
  shadow.Open = open[1] / open[0];
  return shadow;
}

TEST(KeyLight, FittedShadowsAreTwiceAsSharp)
{
  std::printf("elevation radius bands   rms of fitted, projected; lowest; open level ground\n");
  for (const double elevation : { 15.0, 30.0, 50.0 })
  {
    for (const double radius : { 2.0, 5.0, 15.0 })
    {
      for (const int bands : { 4, 8 })
      {
        const KeyLight light = Light(57.0, elevation, radius);
        const Shadow fitted = ShadowOf(light, bands, KeyLightSeries::Fitted);
        const Shadow projected = ShadowOf(light, bands, KeyLightSeries::Projected);
        std::printf("%9.0f %6.0f %5d   %.3f %.3f   %+.3f %+.3f   %.3f %.3f\n", elevation, radius,
          bands, fitted.Rms, projected.Rms, fitted.Lowest, projected.Lowest, fitted.Open,
          projected.Open);
        EXPECT_LT(fitted.Rms, 0.75 * projected.Rms);
        EXPECT_NEAR(fitted.Open, 1.0, 0.005);
      }
    }
  }
}

TEST(KeyLight, NothingIsLeftUnderTheZenith)
{
  const KeyLight light = Light(120.0, 15.0, 5.0);
  const double open = Irradiance(light, SwathOf(light), 3, 4, [](double) { return -1.0; });
  const double hidden = Irradiance(light, SwathOf(light), 3, 4, [](double) { return 1.0e9; });
  EXPECT_GT(open, 0.0);
  EXPECT_NEAR(hidden, 0.0, 1.0e-3 * open); // floats, with coefficients of some tens
}

TEST(KeyLight, OutsideOfTheSwathIsNoLight)
{
  double coefficients[16];
  KeyLightHarmonics(Light(120.0, 15.0, 5.0), { 4.0, 0.2 }, 4, coefficients);
  for (const double value : coefficients)
  {
    EXPECT_EQ(value, 0.0);
  }
  KeyLightHarmonics(Light(120.0, 15.0, 0.0), { 2.0, 0.2 }, 4, coefficients);
  EXPECT_EQ(coefficients[0], 0.0);
}

// SN08, section 5: terrain outside the swath has no effect, while it would have one with a whole
// circle.
TEST(KeyLight, TerrainOutsideTheSwathDoesNotCount)
{
  const KeyLight light = Light(120.0, 30.0, 5.0);
  const Swath swath = SwathOf(light);
  const auto besides = [&](double azimuth)
  { return swath.Holds(azimuth) ? -1.0 : std::tan(70.0 * Degree); };
  const auto nothing = [](double) { return -1.0; };
  EXPECT_EQ(Irradiance(light, swath, 3, 4, besides), Irradiance(light, swath, 3, 4, nothing));
  EXPECT_LT(
    Irradiance(light, Swath(), 64, 4, besides), 0.5 * Irradiance(light, Swath(), 64, 4, nothing));
}

} // namespace
} // namespace testing
} // namespace skyline
