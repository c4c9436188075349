// SPDX-License-Identifier: BSD-3-Clause
#include "Harmonics/VisibilityAccumulator.h"

#include "Harmonics/HarmonicProduct.h"
#include "Reference/Shapes.h"
#include "Reference/VisibilityWedge.h"
#include "Sky/SkyAccumulator.h"
#include "Testing/Module/ProcessorTargets.h"
#include "WedgeTesting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace skyline
{
namespace testing
{
namespace
{

constexpr double HalfPi = 0.5 * Pi;

/// The error of sums of a hundred floats up to 1, plus 1.4e-7 of the arc. The polynomials of higher
/// bands have greater coefficients, which cancel (up to 430 for band 7).
double SumBound(int bands)
{
  return bands <= 4 ? 2.0e-6 : 6.0e-5;
}

struct Gradient
{
  double East = 0.0, North = 0.0;
};

/// The coefficients of one post, from slopes in the azimuths (k + shift) 2 pi / N.
std::vector<double> SumPost(int bands, const std::vector<double>& slopes,
  const Gradient* gradient = nullptr, SkyPart sky = SkyPart::Upper, double swath = 2.0 * Pi,
  double start = 0.0)
{
  std::vector<float> values(
    static_cast<std::size_t>(HarmonicCount(bands)), std::numeric_limits<float>::quiet_NaN());
  const float east = gradient ? static_cast<float>(gradient->East) : 0.0f;
  const float north = gradient ? static_cast<float>(gradient->North) : 0.0f;
  VisibilityAccumulator sums(
    { 1, 1, bands, values.data(), sky }, gradient ? &east : nullptr, gradient ? &north : nullptr);
  const double width = swath / static_cast<double>(slopes.size());
  for (std::size_t k = 0; k < slopes.size(); ++k)
  {
    const auto slope = static_cast<float>(slopes[k]);
    sums.Begin(start + static_cast<double>(k) * width, width);
    sums.Add(0, 0, 1, &slope);
  }
  sums.Finish(0, 1);
  return { values.begin(), values.end() };
}

std::vector<double> RandomSlopes(shapes::Random& random, int count)
{
  std::vector<double> slopes;
  for (int k = 0; k < count; ++k)
  {
    const double u = random();
    slopes.push_back(u < 0.1 ? static_cast<double>(NoTerrainSlope) : std::tan((u - 0.3) * 2.0));
  }
  return slopes;
}

TEST(VisibilityAccumulator, SumsStepWedges)
{
  ForEachProcessorTarget(
    []()
    {
      shapes::Random random(5);
      for (int bands = 1; bands <= 8; ++bands)
      {
        for (const int n : { 1, 3, 4, 7, 24 })
        {
          for (const SkyPart sky : { SkyPart::Upper, SkyPart::Sphere })
          {
            const std::vector<double> slopes = RandomSlopes(random, n);
            const std::vector<double> sum = SumPost(bands, slopes, nullptr, sky);
            std::vector<double> truth(sum.size(), 0.0), wedge(sum.size());
            for (int k = 0; k < n; ++k)
            {
              const double horizon = std::atan(slopes[static_cast<std::size_t>(k)]);
              StepWedge(bands, 2.0 * Pi * k / n, 2.0 * Pi / n,
                sky == SkyPart::Upper ? std::max(horizon, 0.0) : horizon, wedge.data());
              for (std::size_t c = 0; c < wedge.size(); ++c)
              {
                truth[c] += wedge[c];
              }
            }
            for (std::size_t c = 0; c < wedge.size(); ++c)
            {
              EXPECT_NEAR(sum[c], truth[c], SumBound(bands)) << bands << " " << n << " " << c;
            }
          }
        }
      }
    });
}

// The sum contains what horizons hide, so flat horizons cause no rounding.
TEST(VisibilityAccumulator, FlatHorizonsAreTheHemisphere)
{
  for (int n = 3; n <= 256; ++n)
  {
    for (const double slope : { 0.0, -0.2, static_cast<double>(NoTerrainSlope) })
    {
      const auto sum = SumPost(8, std::vector<double>(static_cast<std::size_t>(n), slope));
      for (int l = 0; l < 8; ++l)
      {
        for (int m = -l; m <= l; ++m)
        {
          EXPECT_NEAR(sum[static_cast<std::size_t>(HarmonicIndex(l, m))],
            m == 0 ? HemisphereZonal(l) : 0.0, 2.0e-7)
            << n;
        }
      }
    }
  }
}

TEST(VisibilityAccumulator, NothingIsSeenFromTheBottomOfAShaft)
{
  const Gradient level;
  for (const double slope : { 1.0e12, 1.0e18, std::numeric_limits<double>::infinity() })
  {
    for (const Gradient* gradient : { static_cast<const Gradient*>(nullptr), &level })
    {
      for (const double value : SumPost(4, std::vector<double>(36, slope), gradient))
      {
        EXPECT_NEAR(value, 0.0, SumBound(4));
      }
    }
  }
}

/// The transfer as the accumulator defines it: the horizon is constant over each swath and at least
/// as high as the plane in the middle of the swath. The cosine varies with the direction; the order
/// 0 uses the one in the middle.
std::vector<double> SlowTransfer(
  int bands, const std::vector<double>& slopes, const Gradient& gradient, SkyPart sky)
{
  const Vector normal = NormalOf(gradient.East, gradient.North);
  std::vector<double> sums(static_cast<std::size_t>(HarmonicCount(bands)), 0.0);
  const double width = 2.0 * Pi / static_cast<double>(slopes.size());
  for (std::size_t k = 0; k < slopes.size(); ++k)
  {
    const double azimuth = static_cast<double>(k) * width;
    const Vector ahead = DirectionOf(azimuth, 0.0);
    const double rise = gradient.East * ahead.X + gradient.North * ahead.Y;
    double low = std::max(std::atan(slopes[k]), std::atan(rise));
    low = sky == SkyPart::Upper ? std::max(low, 0.0) : low;
    const auto part = Project(
      bands, azimuth - 0.5 * width, azimuth + 0.5 * width, 150, 600, [&](double) { return low; },
      [&](const Vector& d) { return normal.X * d.X + normal.Y * d.Y + normal.Z * d.Z; });
    const auto middle = Project(
      bands, azimuth - 0.5 * width, azimuth + 0.5 * width, 150, 600, [&](double) { return low; },
      [&](const Vector& d)
      {
        const double across = std::hypot(d.X, d.Y);
        return (normal.X * ahead.X + normal.Y * ahead.Y) * across + normal.Z * d.Z;
      });
    for (int l = 0; l < bands; ++l)
    {
      for (int m = -l; m <= l; ++m)
      {
        const auto c = static_cast<std::size_t>(HarmonicIndex(l, m));
        sums[c] += m == 0 ? middle[c] : part[c];
      }
    }
  }
  return sums;
}

TEST(TransferAccumulator, EqualsBruteForce)
{
  constexpr double midpointBound = 4.0e-5; // 150 x 600 midpoints per swath
  shapes::Random random(8);
  for (const int n : { 5, 12 })
  {
    for (const SkyPart sky : { SkyPart::Upper, SkyPart::Sphere })
    {
      const std::vector<double> slopes = RandomSlopes(random, n);
      const Gradient gradient{ 3.0 * random() - 1.5, 3.0 * random() - 1.5 };
      const auto truth = SlowTransfer(5, slopes, gradient, sky);
      ForEachProcessorTarget(
        [&]()
        {
          const auto sum = SumPost(5, slopes, &gradient, sky);
          for (std::size_t c = 0; c < sum.size(); ++c)
          {
            EXPECT_NEAR(sum[c], truth[c], midpointBound) << c;
          }
        });
    }
  }
}

TEST(TransferAccumulator, UniformSkyIsTheSkyViewFactor)
{
  shapes::Random random(2);
  for (int post = 0; post < 20; ++post)
  {
    const std::vector<double> slopes = RandomSlopes(random, 24);
    const Gradient gradient{ 4.0 * random() - 2.0, 4.0 * random() - 2.0 };
    float factor = 0.0f;
    const auto east = static_cast<float>(gradient.East);
    const auto north = static_cast<float>(gradient.North);
    SkyBuffers buffers;
    buffers.SkyViewFactor.Values = &factor;
    SkyAccumulator sky(1, buffers, &east, &north);
    for (std::size_t k = 0; k < slopes.size(); ++k)
    {
      const auto slope = static_cast<float>(slopes[k]);
      sky.Begin(2.0 * Pi * static_cast<double>(k) / 24.0, 2.0 * Pi / 24.0);
      sky.Add(0, 0, 1, &slope);
    }
    sky.Finish(0, 1);
    // A uniform radiance of 1 has only the coefficient sqrt(4 pi).
    EXPECT_NEAR(SumPost(4, slopes, &gradient)[0] * std::sqrt(4.0 * Pi), Pi * factor, 1.0e-5);
  }
}

// White furnace test: uniform light without terrain.
TEST(TransferAccumulator, WhiteFurnaceGivesPiOnAnyNormal)
{
  shapes::Random random(6);
  for (int k = 0; k < 50; ++k)
  {
    const Gradient gradient{ 4.0 * random() - 2.0, 4.0 * random() - 2.0 };
    const Vector normal = NormalOf(gradient.East, gradient.North);
    for (const int n : { 3, 16, 32, 256 })
    {
      const std::vector<double> open(static_cast<std::size_t>(n), NoTerrainSlope);
      // By the triple product of SN08, which is exact for any number of azimuths.
      const auto sphere = SumPost(4, open, nullptr, SkyPart::Sphere);
      double zonal[4], cosine[16], transfer[16];
      for (int l = 0; l < 4; ++l)
      {
        zonal[l] = ClampedCosineZonal(l);
      }
      RotateZonal(4, zonal, normal.X, normal.Y, normal.Z, cosine);
      HarmonicProduct::ForBands(4).Product(cosine, sphere.data(), transfer);
      EXPECT_NEAR(transfer[0] * std::sqrt(4.0 * Pi), Pi, 1.0e-6) << n;
      // By integration: the horizon of the plane itself is a smooth function of the azimuth, and a
      // sum over a circle converges faster than any power of n. The steepest of these planes has a
      // slope of 70 degrees.
      if (n >= 16)
      {
        EXPECT_NEAR(SumPost(4, open, &gradient, SkyPart::Sphere)[0] * std::sqrt(4.0 * Pi), Pi,
          n == 16 ? 1.0e-3 : 1.0e-5);
      }
      // Above the horizontal plane alone, a tilted receiver loses the directions below it: a kink,
      // h^2 / 12.
      EXPECT_NEAR(SumPost(4, open, &gradient)[0] * std::sqrt(4.0 * Pi), HalfPi * (1.0 + normal.Z),
        10.0 / (n * n));
    }
  }
}

TEST(TransferAccumulator, SteepestPlanesSeeHalfTheSky)
{
  // Only the plane itself hides the sky. 36 azimuths represent the circle: pi^2 / 6 N^2, as in
  // TestSkyAccumulator.
  for (const double steep : { 1.0e4, 1.0e8, 1.0e12 })
  {
    const Gradient gradient{ steep, 0.0 };
    const auto sum = SumPost(
      4, std::vector<double>(36, NoTerrainSlope), &gradient, SkyPart::Upper, 2.0 * Pi, Pi / 36.0);
    EXPECT_NEAR(sum[0] * std::sqrt(4.0 * Pi), HalfPi, 5.0e-3) << steep;
    for (const double value : sum)
    {
      EXPECT_LT(std::abs(value), 1.0) << steep;
    }
  }
}

TEST(TransferAccumulator, MissingPostsStayMissing)
{
  const Gradient missing{ std::nan(""), std::nan("") };
  for (const double value : SumPost(4, std::vector<double>(8, 0.0), &missing))
  {
    EXPECT_TRUE(std::isnan(value));
  }
}

TEST(TransferAccumulator, LevelGroundIsTheClampedCosine)
{
  const Gradient level;
  for (const int n : { 3, 4, 5, 31, 256 })
  {
    const auto sum = SumPost(8, std::vector<double>(static_cast<std::size_t>(n), 0.0), &level);
    for (int l = 0; l < 8; ++l)
    {
      for (int m = -l; m <= l; ++m)
      {
        EXPECT_NEAR(sum[static_cast<std::size_t>(HarmonicIndex(l, m))],
          m == 0 ? ClampedCosineZonal(l) : 0.0, 2.0e-7);
      }
    }
  }
}

TEST(VisibilityAccumulator, SwathsAddUp)
{
  // A circle of 40 azimuths consists of two arcs of 13 and 27.
  shapes::Random random(12);
  const std::vector<double> slopes = RandomSlopes(random, 40);
  const Gradient gradient{ 0.3, -0.8 };
  const double width = 2.0 * Pi / 40.0;
  for (const Gradient* plane : { static_cast<const Gradient*>(nullptr), &gradient })
  {
    const auto whole = SumPost(4, slopes, plane);
    const auto first =
      SumPost(4, { slopes.begin(), slopes.begin() + 13 }, plane, SkyPart::Upper, 13.0 * width);
    const auto second = SumPost(
      4, { slopes.begin() + 13, slopes.end() }, plane, SkyPart::Upper, 27.0 * width, 13.0 * width);
    for (std::size_t c = 0; c < whole.size(); ++c)
    {
      EXPECT_NEAR(first[c] + second[c], whole[c], SumBound(4));
    }
  }
}

TEST(VisibilityAccumulator, FractionsOfADegreeKeepTheirDigits)
{
  const double width = 0.01 * RadiansPerDegree;
  const auto sum = SumPost(4, { 0.5, 0.2, 0.1 }, nullptr, SkyPart::Upper, 3.0 * width, 1.0);
  std::vector<double> truth(16, 0.0), wedge(16);
  for (int k = 0; k < 3; ++k)
  {
    const double slopes[3] = { 0.5, 0.2, 0.1 };
    StepWedge(4, 1.0 + k * width, width, std::atan(slopes[k]), wedge.data());
    for (std::size_t c = 0; c < 16; ++c)
    {
      truth[c] += wedge[c];
    }
  }
  for (std::size_t c = 0; c < 16; ++c)
  {
    EXPECT_NEAR(sum[c] / width, truth[c] / width, SumBound(4));
  }
}

/// The coefficients of a small field, added in runs of `run` posts.
std::vector<float> FieldSums(std::ptrdiff_t run, bool transfer, int azimuths)
{
  const std::ptrdiff_t columns = 301, rows = 3;
  shapes::Random random(9);
  std::vector<float> east, north;
  for (std::ptrdiff_t i = 0; i < columns * rows; ++i)
  {
    east.push_back(static_cast<float>(random() - 0.5));
    north.push_back(static_cast<float>(random() - 0.5));
  }
  std::vector<float> values(
    static_cast<std::size_t>(columns * rows * 16), std::numeric_limits<float>::quiet_NaN());
  VisibilityAccumulator sums({ columns, rows, 4, values.data(), SkyPart::Upper },
    transfer ? east.data() : nullptr, transfer ? north.data() : nullptr);
  for (int k = 0; k < azimuths; ++k)
  {
    sums.Begin(2.0 * Pi * k / azimuths, 2.0 * Pi / azimuths);
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
        sums.Add(row, column, static_cast<std::ptrdiff_t>(slopes.size()), slopes.data());
      }
    }
  }
  sums.Finish(0, 1);
  sums.Finish(1, rows);
  return values;
}

TEST(VisibilityAccumulator, RunsDoNotChangeABit)
{
  ForEachProcessorTarget(
    []()
    {
      for (const bool transfer : { false, true })
      {
        for (const int azimuths : { 1, 4, 7, 9 })
        {
          const std::vector<float> whole = FieldSums(301, transfer, azimuths);
          for (const float value : whole)
          {
            ASSERT_TRUE(std::isfinite(value));
          }
          for (const std::ptrdiff_t run : { 1, 3, 16, 17, 64, 300 })
          {
            EXPECT_EQ(FieldSums(run, transfer, azimuths), whole) << run;
          }
        }
      }
    });
}

TEST(VisibilityAccumulator, WithoutAzimuthsNothingIsVisible)
{
  for (const double value : SumPost(4, {}))
  {
    EXPECT_EQ(value, 0.0);
  }
}

TEST(VisibilityAccumulator, RefusesBands)
{
  float values[100];
  for (const int bands : { -1, 0, 9 })
  {
    EXPECT_THROW(
      VisibilityAccumulator({ 1, 1, bands, values, SkyPart::Upper }), std::invalid_argument);
  }
}

} // namespace
} // namespace testing
} // namespace skyline
