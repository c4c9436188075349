// SPDX-License-Identifier: BSD-3-Clause
#include "Sky/SkyModel.h"

#include "Reference/LightOracle.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace skyline
{
namespace testing
{
namespace
{

// The error of pixels of half a degree with four samples each.
constexpr double PixelError = 5.0e-4;

// The irradiance of open level ground divided by the radiance of the zenith.
double DiffuseOverZenith(const SkyModel& sky, double sunElevation)
{
  OwnedMap map(SkyWidth, SkyHeight);
  FillSky(sky, 1.0, sunElevation, {}, SkyWidth, SkyHeight, map.Pixels.data());
  return BruteLight(
    map, 0.0, [](double) { return 0.0; }, 0.0, 0.0, SkyWidth)[1];
}

TEST(SkyModel, ZonalSkiesInClosedForm)
{
  EXPECT_NEAR(DiffuseOverZenith(CieSky(5), 0.5), Pi, 1e-5);
  // Moon & Spencer: 7 pi / 9.
  EXPECT_NEAR(DiffuseOverZenith(CieSky(TraditionalOvercast), 0.5), 7.0 * Pi / 9.0, PixelError);
}

TEST(SkyModel, ZenithOfTheStandardSkiesAsPublished)
{
  // Kittler, Perez & Darula (1997), "A new generation of sky standards", and Darula & Kittler
  // (2002), "CIE general sky standard defining luminance distributions", table 2. For each type,
  // the ratio of the luminance of the zenith to the diffuse illuminance is
  //   Lz / Dv = (B sin^C g / cos^D g + E sin g) / (133.8 sin g),  g: elevation of the sun.
  // It was fitted to the sky models.
  constexpr double Published[15][4] = { { 54.63, 1.00, 0.00, 0.00 }, { 12.35, 3.68, 0.59, 50.47 },
    { 48.30, 1.00, 0.00, 0.00 }, { 12.23, 3.57, 0.57, 44.27 }, { 42.59, 1.00, 0.00, 0.00 },
    { 11.84, 3.53, 0.55, 38.78 }, { 21.72, 4.52, 0.64, 34.56 }, { 29.35, 4.94, 0.70, 30.41 },
    { 10.34, 3.45, 0.50, 27.47 }, { 18.41, 4.27, 0.63, 24.04 }, { 24.41, 4.60, 0.72, 20.76 },
    { 23.00, 4.43, 0.74, 18.52 }, { 27.45, 4.61, 0.76, 16.59 }, { 25.54, 4.40, 0.79, 14.56 },
    { 28.08, 4.13, 0.79, 13.00 } };
  constexpr double FitError = 0.03;
  for (int type = 1; type <= 15; ++type)
  {
    const double* row = Published[type - 1];
    for (const double degrees : { 20.0, 40.0, 60.0 })
    {
      const double g = degrees * RadiansPerDegree;
      const double fit = (row[0] * std::pow(std::sin(g), row[1]) / std::pow(std::cos(g), row[2]) +
                           row[3] * std::sin(g)) /
        (133.8 * std::sin(g));
      EXPECT_NEAR(1.0 / DiffuseOverZenith(CieSky(type), g) / fit, 1.0, FitError)
        << "type " << type << ", sun at " << degrees;
    }
  }
}

TEST(SkyModel, FormulaOfTheStandard)
{
  // Type 12, the clear sky: (1 - e^(-0.32 / s)) (1 + 10 (e^(-3x) - e^(-3 pi / 2)) + 0.45 cos^2 x).
  const double s = 0.4, x = 0.9;
  const double truth = (1.0 - std::exp(-0.32 / s)) *
    (1.0 + 10.0 * (std::exp(-3.0 * x) - std::exp(-1.5 * Pi)) + 0.45 * std::pow(std::cos(x), 2));
  EXPECT_NEAR(CieSky(12).Radiance(s, std::cos(x)), truth, 1e-12);
  for (const int type : { 1, 3, 5, 16 })
  {
    EXPECT_TRUE(CieSky(type).Zonal());
  }
  for (const int type : { 2, 4, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15 })
  {
    EXPECT_FALSE(CieSky(type).Zonal());
  }
  for (const int type : { -1, 0, 17 })
  {
    EXPECT_THROW(CieSky(type), std::invalid_argument);
  }
}

TEST(SkyModel, PerezGetsTheIrradianceGiven)
{
  struct Weather
  {
    double Direct, Diffuse, Elevation;
  };
  // One for each bin of clearness, and the extremes.
  for (const Weather& weather : { Weather{ 0.0, 100.0, 30.0 }, { 20.0, 180.0, 40.0 },
         { 60.0, 250.0, 50.0 }, { 150.0, 250.0, 35.0 }, { 300.0, 250.0, 45.0 },
         { 500.0, 200.0, 45.0 }, { 650.0, 120.0, 40.0 }, { 900.0, 100.0, 60.0 },
         { 1000.0, 50.0, 89.9 }, { 5.0, 5.0, 0.5 }, { 0.0, 1e-3, 90.0 }, { 1e4, 1e-3, 90.0 } })
  {
    const SkyModel sky =
      PerezSky(weather.Direct, weather.Diffuse, weather.Elevation * RadiansPerDegree);
    OwnedMap map(SkyWidth, SkyHeight);
    FillSky(sky, 2.0, weather.Elevation * RadiansPerDegree, { true, weather.Diffuse }, SkyWidth,
      SkyHeight, map.Pixels.data());
    EXPECT_NEAR(BruteLight(
                  map, 0.0, [](double) { return 0.0; }, 0.0, 0.0, SkyWidth)[0] /
        weather.Diffuse,
      1.0, 1e-4);
    for (const float value : map.Pixels)
    {
      ASSERT_TRUE(value >= 0.0f && std::isfinite(value));
    }
  }
}

// Found by a fuzzer: the direct light of noon with the diffuse light of dusk, and the sun on the
// horizon, made the sky infinite.
TEST(SkyModel, PerezIsFiniteInWeatherThatNeverWas)
{
  constexpr int width = 32, height = 16;
  int skies = 0;
  for (const double elevation : { 1e-6, 0.01, 1.0, 30.0, 90.0 })
  {
    for (const double direct : { 0.0, 1.0, 700.0, 1e6 })
    {
      for (const double diffuse : { 1e-3, 1.0, 42.0, 120.0, 1e6 })
      {
        std::vector<float> pixels(3 * width * height);
        const double sun = elevation * RadiansPerDegree;
        try
        {
          FillSky(PerezSky(direct, diffuse, sun), 1.0, sun, { true, diffuse }, width, height,
            pixels.data());
        }
        catch (const std::invalid_argument&)
        {
          continue; // no such weather exists, and the sky is black
        }
        ++skies;
        for (const float pixel : pixels)
        {
          ASSERT_TRUE(std::isfinite(pixel) && pixel >= 0.0f)
            << elevation << " degrees, " << direct << " and " << diffuse << " W/m2";
        }
      }
    }
  }
  EXPECT_GT(skies, 50);
}

TEST(SkyModel, PerezChoosesByClearnessAndBrightness)
{
  // Computed by hand from Perez et al. (1993), table 1: sun at 30 degrees, direct 800 W/m2, diffuse
  // 100 W/m2. The zenith angle z is 60 degrees: 1.041 z^3 = 1.19546. The clearness is (9 + 1.19546)
  // / 2.19546 = 4.64387, in the seventh bin. The air mass is 1.99 (Kasten & Young: 1.9940), the
  // brightness 0.14587.
  const SkyModel sky = PerezSky(800.0, 100.0, 30.0 * RadiansPerDegree);
  const double z = Pi / 3.0, brightness = 1.9940 * 100.0 / 1367.0;
  EXPECT_NEAR(sky.A, -1.0 + 0.0211 * z + brightness * (0.5025 - 0.5119 * z), 1e-4);
  EXPECT_NEAR(sky.B, -0.3 + 0.1922 * z + brightness * (0.7023 - 1.6317 * z), 1e-4);
  EXPECT_NEAR(sky.C, 19.0 - 5.0 * z + brightness * (1.2438 - 1.9094 * z), 1e-4);
  EXPECT_NEAR(sky.D, -4.0 + 0.025 * z + brightness * (0.3844 + 0.2656 * z), 1e-4);
  EXPECT_NEAR(sky.E, 1.0468 - 0.3788 * z + brightness * (-2.4517 + 1.4656 * z), 1e-4);
  EXPECT_EQ(sky.Base, 1.0);
  // Without direct light the sky is brightest at the zenith; on a clear day it is brightest around
  // the sun.
  const SkyModel overcast = PerezSky(0.0, 150.0, 0.6);
  EXPECT_GT(overcast.Radiance(1.0, 0.5), overcast.Radiance(0.1, 0.5));
  EXPECT_GT(sky.Radiance(0.5, 0.99), 3.0 * sky.Radiance(0.5, -0.5));
}

TEST(SkyModel, RefusesWhatIsNoWeather)
{
  EXPECT_THROW(PerezSky(-1.0, 100.0, 0.5), std::invalid_argument);
  EXPECT_THROW(PerezSky(100.0, 0.0, 0.5), std::invalid_argument);
  EXPECT_THROW(PerezSky(100.0, 100.0, 0.0), std::invalid_argument);
  EXPECT_THROW(PerezSky(std::nan(""), 100.0, 0.5), std::invalid_argument);
}

TEST(SkyModel, SunStandsWhereItIsSaidTo)
{
  OwnedMap map(SkyWidth, SkyHeight);
  const double azimuth = 100.25 * RadiansPerDegree, elevation = 35.25 * RadiansPerDegree;
  FillSky(CieSky(15), azimuth, elevation, {}, SkyWidth, SkyHeight, map.Pixels.data());
  const auto brightest =
    std::max_element(map.Pixels.begin(), map.Pixels.end()) - map.Pixels.begin();
  const auto pixel = brightest / 3;
  EXPECT_EQ(pixel % SkyWidth, 560); // 100 to 100.5 degrees
  const auto row = pixel / SkyWidth;
  EXPECT_TRUE(row >= 108 && row <= 110) << row; // 35 to 35.5 degrees
  for (std::ptrdiff_t below = SkyHeight / 2; below < SkyHeight; ++below)
  {
    EXPECT_EQ(map.At(7, below)[2], 0.0f);
  }
}

} // namespace
} // namespace testing
} // namespace skyline
