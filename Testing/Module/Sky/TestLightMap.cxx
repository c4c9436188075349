// SPDX-License-Identifier: BSD-3-Clause
#include "Sky/LightMap.h"

#include "LightMapTesting.h"
#include "Shared/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

/// The error of sums of some thousand pixels in double precision, for results up to 10.
constexpr double SumBound = 1.0e-11;

constexpr float Infinity = std::numeric_limits<float>::infinity();
constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

const double SphereConstant = std::sqrt(4.0 * Pi);

TEST(LightMap, DirectionsOfThePixels)
{
  const OwnedMap map(8, 4);
  const LightMap view = map.View();
  const double up = std::cos(Pi / 8.0), level = std::sin(Pi / 8.0);
  const LightMapDirection first = PixelDirection(view, 0, 0); // left of the seam in the south
  EXPECT_NEAR(first.X, -level * std::sin(Pi / 8.0), SumBound);
  EXPECT_NEAR(first.Y, -level * std::cos(Pi / 8.0), SumBound);
  EXPECT_NEAR(first.Z, up, SumBound);
  const LightMapDirection centre = PixelDirection(view, 3, 4); // right of the centre
  EXPECT_NEAR(centre.X, level * std::sin(Pi / 8.0), SumBound);
  EXPECT_NEAR(centre.Y, level * std::cos(Pi / 8.0), SumBound);
  EXPECT_NEAR(centre.Z, -up, SumBound);
}

TEST(LightMap, SolidAnglesMakeUpTheSphere)
{
  for (const std::ptrdiff_t rows : { 1, 2, 7, 512 })
  {
    const OwnedMap map(2 * rows, rows);
    double sum = 0.0;
    for (std::ptrdiff_t row = 0; row < rows; ++row)
    {
      sum += 2.0 * rows * PixelSolidAngle(map.View(), row);
    }
    EXPECT_NEAR(sum, 4.0 * Pi, SumBound);
  }
}

TEST(LightMap, BothOrdersOfRowsAreOneMap)
{
  const OwnedMap map = RandomMap(6, 3, 1);
  std::vector<float> flipped;
  for (std::ptrdiff_t row = 2; row >= 0; --row)
  {
    const float* begin = map.View().Pixel(row, 0);
    flipped.insert(flipped.end(), begin, begin + 18);
  }
  const LightMap view = ViewBottomUp(flipped.data(), 6, 3);
  for (std::ptrdiff_t row = 0; row < 3; ++row)
  {
    for (std::ptrdiff_t column = 0; column < 6; ++column)
    {
      EXPECT_EQ(view.Pixel(row, column)[1], map.View().Pixel(row, column)[1]);
    }
  }
  EXPECT_EQ(ProjectLightMap(view, 8), ProjectLightMap(map.View(), 8));
}

TEST(LightMap, DefectsAreCountedAndMended)
{
  std::vector<float> values{ 1.0f, 2.0f, 3.0f, // valid
    -1.0f, 5.0f, -2.0f,                        // one negative pixel
    NaN, 1.0f, NaN,                            // one NaN pixel
    Infinity, -Infinity, 7.0f,                 // infinite and negative
    -0.0f, 1.0e30f, 0.0f };                    // valid
  const LightMapDefects defects = SanitizeLightMap(values.data(), 5);
  EXPECT_EQ(defects.Negative, 2);
  EXPECT_EQ(defects.NotNumbers, 1);
  EXPECT_EQ(defects.Infinite, 1);
  const std::vector<float> expected{ 1.0f, 2.0f, 3.0f, 0.0f, 5.0f, 0.0f, 0.0f, 1.0f, 0.0f, 1.0f,
    0.0f, 7.0f, 0.0f, 1.0e30f, 0.0f };
  EXPECT_EQ(values, expected);
  EXPECT_FALSE(std::signbit(values[12]));

  std::vector<float> hopeless(6, Infinity);
  EXPECT_EQ(SanitizeLightMap(hopeless.data(), 2).Infinite, 2);
  EXPECT_EQ(hopeless, std::vector<float>(6, 0.0f));

  const LightMapDefects none = SanitizeLightMap(hopeless.data(), 2);
  EXPECT_EQ(none.Negative + none.NotNumbers + none.Infinite, 0);
  EXPECT_EQ(SanitizeLightMap(nullptr, 0).Infinite, 0);
}

TEST(LightMapProjection, WhiteIsTheConstantAlone)
{
  for (const std::ptrdiff_t rows : { 1, 2, 5, 64 })
  {
    OwnedMap map(2 * rows, rows);
    std::fill(map.Values.begin(), map.Values.end(), 0.5f);
    for (int bands = 1; bands <= MaxHarmonicBands; ++bands)
    {
      const int count = HarmonicCount(bands);
      const std::vector<double> coefficients = ProjectLightMap(map.View(), bands);
      ASSERT_EQ(coefficients.size(), 3u * count);
      for (int i = 0; i < 3 * count; ++i)
      {
        EXPECT_NEAR(coefficients[i], i % count == 0 ? 0.5 * SphereConstant : 0.0, SumBound)
          << rows << " rows, " << bands << " bands, " << i;
      }
    }
  }
}

TEST(LightMapProjection, SkyHalfIsTheHemisphere)
{
  OwnedMap map(20, 10);
  std::fill(map.Values.begin(), map.Values.begin() + 3 * 20 * 5, 1.0f);
  const std::vector<double> coefficients = ProjectLightMap(map.View(), 8);
  for (int l = 0; l < 8; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      EXPECT_NEAR(coefficients[HarmonicIndex(l, m)], m == 0 ? HemisphereZonal(l) : 0.0, SumBound);
    }
  }
}

// The definition of the reference, as a simple sum.
TEST(LightMapProjection, CentreRuleIsTheSumOverPixels)
{
  for (const int bands : { 3, 4, 5, 8 })
  {
    const OwnedMap map = RandomMap(14, 7, 2);
    const LightMap view = map.View();
    const int count = HarmonicCount(bands);
    std::vector<double> expected(3 * count, 0.0);
    for (std::ptrdiff_t row = 0; row < view.Rows; ++row)
    {
      for (std::ptrdiff_t column = 0; column < view.Columns; ++column)
      {
        const LightMapDirection d = PixelDirection(view, row, column);
        std::vector<double> values(count);
        EvaluateHarmonics(bands, d.X, d.Y, d.Z, values.data());
        for (int i = 0; i < 3 * count; ++i)
        {
          expected[i] +=
            PixelSolidAngle(view, row) * values[i % count] * view.Pixel(row, column)[i / count];
        }
      }
    }
    const std::vector<double> coefficients = ProjectLightMap(view, bands, PixelRule::Centre);
    for (int i = 0; i < 3 * count; ++i)
    {
      EXPECT_NEAR(coefficients[i], expected[i], SumBound) << i;
    }
  }
}

// A step function is the same map at any finer resolution, so the rule must be exact for the solid
// angle of a pixel.
TEST(LightMapProjection, IntegralRuleDoesNotSeeTheGrid)
{
  const OwnedMap coarse = RandomMap(6, 3, 3);
  const std::vector<double> expected = ProjectLightMap(coarse.View(), 8);
  for (const std::ptrdiff_t factor : { 2, 5, 40 })
  {
    OwnedMap fine(6 * factor, 3 * factor);
    for (std::ptrdiff_t row = 0; row < fine.Rows; ++row)
    {
      for (std::ptrdiff_t column = 0; column < fine.Columns; ++column)
      {
        std::memcpy(fine.Pixel(row, column), coarse.View().Pixel(row / factor, column / factor),
          3 * sizeof(float));
      }
    }
    const std::vector<double> coefficients = ProjectLightMap(fine.View(), 8);
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      EXPECT_NEAR(coefficients[i], expected[i], SumBound) << factor << " " << i;
    }
    if (factor == 40)
    {
      // The centre rule converges with the square of the pixel size: (pi / 120)^2 = 7e-4.
      const std::vector<double> centres = ProjectLightMap(fine.View(), 8, PixelRule::Centre);
      for (std::size_t i = 0; i < expected.size(); ++i)
      {
        EXPECT_NEAR(centres[i], expected[i], 4.0e-3) << i;
      }
    }
  }
}

TEST(LightMapProjection, ShiftedColumnsAreTurnedCoefficients)
{
  const OwnedMap map = RandomMap(16, 8, 4);
  for (const int shift : { 1, 4, 11 })
  {
    OwnedMap shifted(16, 8);
    for (std::ptrdiff_t row = 0; row < 8; ++row)
    {
      for (std::ptrdiff_t column = 0; column < 16; ++column)
      {
        std::memcpy(shifted.Pixel(row, (column + shift) % 16), map.View().Pixel(row, column),
          3 * sizeof(float));
      }
    }
    for (const int bands : { 4, 8 })
    {
      std::vector<double> turned = ProjectLightMap(map.View(), bands);
      const std::vector<double> expected = ProjectLightMap(shifted.View(), bands);
      for (int c = 0; c < 3; ++c)
      {
        double* channel = &turned[c * HarmonicCount(bands)];
        RotateAboutVertical(bands, shift * 2.0 * Pi / 16.0, channel, channel);
      }
      for (std::size_t i = 0; i < expected.size(); ++i)
      {
        EXPECT_NEAR(turned[i], expected[i], SumBound) << shift << " " << i;
      }
    }
  }
}

// One pixel of 1e5 times the mean, on a sky of 1: the energies of both are kept.
TEST(LightMapProjection, HugeSunKeepsItsEnergy)
{
  OwnedMap map(512, 256);
  std::fill(map.Values.begin(), map.Values.end(), 1.0f);
  const double sun = 1.0e5;
  float* pixel = map.Pixel(40, 300);
  pixel[0] = pixel[1] = pixel[2] = static_cast<float>(sun);
  const double solid = PixelSolidAngle(map.View(), 40);
  const std::vector<double> coefficients = ProjectLightMap(map.View(), 4);
  EXPECT_NEAR(coefficients[0] * SphereConstant, 4.0 * Pi + (sun - 1.0) * solid, SumBound);
  // Apart from the constant function, a sun of one pixel gives the harmonics of its direction, up
  // to the size of the pixel.
  const LightMapDirection d = PixelDirection(map.View(), 40, 300);
  double values[16];
  EvaluateHarmonics(4, d.X, d.Y, d.Z, values);
  const double pixelSquare = std::pow(Pi / 256.0, 2);
  for (int i = 1; i < 16; ++i)
  {
    EXPECT_NEAR(coefficients[i] / ((sun - 1.0) * solid), values[i], pixelSquare) << i;
  }
}

TEST(LightMapProjection, PartsOfTheRowsAddUp)
{
  const OwnedMap map = RandomMap(10, 5, 5);
  const LightMapProjection projection(10, 5, 4);
  std::vector<double> sum(48, 0.0);
  projection.AddRows(map.View(), 3, 5, sum.data());
  projection.AddRows(map.View(), 0, 3, sum.data());
  const std::vector<double> whole = ProjectLightMap(map.View(), 4);
  for (int i = 0; i < 48; ++i)
  {
    EXPECT_NEAR(sum[i], whole[i], SumBound);
  }
}

// E(n) = sum of A_l L_lm Y_lm(n), compared with the sum over all pixels, for smooth light: a map
// that consists of harmonics below band 3.
TEST(LightMapProjection, IrradianceOfSmoothLight)
{
  OwnedMap map(256, 128);
  const double light[9] = { 3.0, 0.3, 0.8, -0.4, 0.2, -0.1, 0.3, 0.15, -0.2 };
  for (std::ptrdiff_t row = 0; row < map.Rows; ++row)
  {
    for (std::ptrdiff_t column = 0; column < map.Columns; ++column)
    {
      const LightMapDirection d = PixelDirection(map.View(), row, column);
      double values[9];
      EvaluateHarmonics(3, d.X, d.Y, d.Z, values);
      const double radiance = std::inner_product(values, values + 9, light, 0.0);
      ASSERT_GT(radiance, 0.0);
      std::fill_n(map.Pixel(row, column), 3, static_cast<float>(radiance));
    }
  }
  const std::vector<double> coefficients = ProjectLightMap(map.View(), 3);
  for (const LightMapDirection& n :
    { LightMapDirection{ 0, 0, 1 }, { 1, 0, 0 }, { 0, -1, 0 }, { 0.6, 0.0, -0.8 } })
  {
    double values[9], irradiance = 0.0;
    EvaluateHarmonics(3, n.X, n.Y, n.Z, values);
    for (int l = 0; l < 3; ++l)
    {
      const double factor = std::sqrt(4.0 * Pi / (2.0 * l + 1.0)) * ClampedCosineZonal(l);
      for (int i = HarmonicIndex(l, -l); i <= HarmonicIndex(l, l); ++i)
      {
        irradiance += factor * coefficients[i] * values[i];
      }
    }
    const double pixelBound = 2.0e-4; // both sums treat pixels of 0.025 radians as points
    EXPECT_NEAR(irradiance / BruteIrradiance(map.View(), n)[0], 1.0, pixelBound);
  }
}

} // namespace
} // namespace testing
} // namespace skyline
