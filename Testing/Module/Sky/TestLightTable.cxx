// SPDX-License-Identifier: BSD-3-Clause
#include "Sky/LightTable.h"

#include "Reference/LightOracle.h"
#include "Reference/PublishedTable.h"

#include <gtest/gtest.h>

namespace skyline
{
namespace testing
{
namespace
{

// Coefficients are floats: an error of 6e-8 for each of up to six terms as large as the result.
constexpr double FloatBound = 1.0e-6;

// 2000 strips of azimuth: a strip that contains the edge of a pixel has an error of up to half of
// its part.
constexpr double StripBound = 1.0e-3;

// The value of the table for a plane with the slopes east and north above an elevation. The
// vertical component nz of the normal is left out.
Color Evaluate(const LightTable& table, double elevation, double east, double north)
{
  const double zenith = 0.5 * Pi - elevation;
  const auto line =
    std::min(static_cast<std::ptrdiff_t>(zenith * table.LinesPerRadian()), table.LineCount() - 1);
  const float* at = table.Lines() + line * LightTable::LineSize;
  const double square = std::sin(zenith) * std::sin(zenith);
  const double bow = zenith - std::sin(zenith) * std::cos(zenith);
  Color light{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    light[c] = (at[c] + at[4 + c] * square) - east * (at[8 + c] + at[12 + c] * bow) -
      north * (at[16 + c] + at[20 + c] * bow);
  }
  return light;
}

void ExpectNear(const Color& value, const Color& truth, double bound)
{
  const double size = 1e-30 + std::abs(truth[0]) + std::abs(truth[1]) + std::abs(truth[2]);
  for (std::size_t c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(value[c], truth[c], bound * size) << c;
  }
}

TEST(LightTable, EqualsTheSumOverPixels)
{
  shapes::Random random(3);
  for (const auto& size :
    { std::array<std::ptrdiff_t, 2>{ 64, 32 }, { 60, 31 }, { 8, 4 }, { 1, 2 } })
  {
    const OwnedMap map = NoisyMap(size[0], size[1], 5);
    for (int trial = 0; trial < 20; ++trial)
    {
      const double rotation = 7.0 * random() - 3.5;
      const double begin = 7.0 * random(), width = 0.02 + random();
      const SwathPiece piece{ begin, begin + width, 1.0, 1.0 };
      LightTable table;
      table.Build({ map.View(), rotation }, &piece, &piece + 1);
      const double east = 2.0 * random() - 1.0, north = 2.0 * random() - 1.0;
      for (const double elevation : { 0.0, 0.5 * Pi * random(), 0.5 * Pi * random() })
      {
        ExpectNear(Evaluate(table, elevation, east, north),
          StripLight(
            map, rotation, begin, begin + width, [&](double) { return elevation; }, east, north,
            2000),
          StripBound);
      }
    }
  }
}

TEST(LightTable, OnePixelInClosedForm)
{
  // A pixel of radiance 1, and a swath that covers all, half or none of it.
  OwnedMap map(36, 18);
  std::fill_n(map.At(20, 6), 3, 1.0f); // azimuths 20 to 30, elevations 20 to 30 degrees
  const double low = 20.0 * RadiansPerDegree, high = 30.0 * RadiansPerDegree;
  const double rise = 0.5 * (std::pow(std::sin(high), 2) - std::pow(std::sin(low), 2));
  for (const double end : { 40.0, 25.0, 20.0 })
  {
    const SwathPiece piece{ 10.0 * RadiansPerDegree, end * RadiansPerDegree, 1.0, 1.0 };
    LightTable table;
    table.Build({ map.View(), 0.0 }, &piece, &piece + 1);
    const double width = std::min(end, 30.0) * RadiansPerDegree - low;
    const double level = width * rise;
    ExpectNear(Evaluate(table, 0.0, 0.0, 0.0), { level, level, level }, FloatBound);
    EXPECT_EQ(Evaluate(table, high + 0.01, 0.0, 0.0)[0], 0.0);
    EXPECT_EQ(table.Dark(), end == 20.0);
  }
}

TEST(LightTable, WeightsAreLinear)
{
  // A triangular weight over equal pixels gives half of a constant one, and two halves of a
  // constant one the whole.
  const OwnedMap map = NoisyMap(40, 20, 9);
  const SwathPiece box{ 1.0, 1.5, 1.0, 1.0 };
  const SwathPiece halves[2] = { { 1.0, 1.2, 1.0, 1.0 }, { 1.2, 1.5, 1.0, 1.0 } };
  const SwathPiece slopes[2] = { { 1.0, 1.5, 0.0, 1.0 }, { 1.0, 1.5, 1.0, 0.0 } };
  LightTable one, two, both;
  one.Build({ map.View(), 0.3 }, &box, &box + 1);
  two.Build({ map.View(), 0.3 }, halves, halves + 2);
  both.Build({ map.View(), 0.3 }, slopes, slopes + 2);
  for (const double elevation : { 0.0, 0.4, 1.1 })
  {
    const Color truth = Evaluate(one, elevation, 0.3, -0.4);
    ExpectNear(Evaluate(two, elevation, 0.3, -0.4), truth, FloatBound);
    ExpectNear(Evaluate(both, elevation, 0.3, -0.4), truth, FloatBound);
  }
}

TEST(LightTable, TurnsWithoutResampling)
{
  // Turning the map, the swath and the plane by the same angle changes nothing.
  const OwnedMap map = NoisyMap(40, 20, 10);
  const double turn = 1.2345;
  const SwathPiece piece{ 0.7, 0.9, 1.0, 1.0 }, turned{ 0.7 + turn, 0.9 + turn, 1.0, 1.0 };
  LightTable before, after;
  before.Build({ map.View(), 0.0 }, &piece, &piece + 1);
  after.Build({ map.View(), turn }, &turned, &turned + 1);
  const double c = std::cos(turn), s = std::sin(turn);
  ExpectNear(Evaluate(after, 0.3, 0.5 * c + 0.2 * s, -0.5 * s + 0.2 * c),
    Evaluate(before, 0.3, 0.5, 0.2), FloatBound);
}

TEST(LightTable, IsWhatThePublishedTableTendsTo)
{
  // The swath is so narrow that the single direction of the paper's table causes no error, and the
  // map does not change with azimuth. With 511 x 4096 nodes the paper's table differs by its
  // interpolation error.
  constexpr double InterpolationBound = 2.0e-4;
  OwnedMap map(4, 64);
  for (std::ptrdiff_t row = 0; row < 64; ++row)
  {
    for (std::ptrdiff_t column = 0; column < 4; ++column)
    {
      std::fill_n(map.At(column, row), 3, static_cast<float>(1 + row % 5));
    }
  }
  const double azimuth = 0.8, width = 1.0e-3;
  const SwathPiece piece{ azimuth - 0.5 * width, azimuth + 0.5 * width, 1.0, 1.0 };
  LightTable table;
  table.Build({ map.View(), 0.0 }, &piece, &piece + 1);
  const PublishedTable published(
    [&](double zenith)
    {
      const auto row =
        std::min(static_cast<std::ptrdiff_t>(zenith / Pi * 64.0), std::ptrdiff_t{ 63 });
      return static_cast<double>(map.At(0, row)[0]);
    },
    width, 511, 4096);
  shapes::Random random(8);
  for (int trial = 0; trial < 50; ++trial)
  {
    const double east = 4.0 * random() - 2.0, north = 4.0 * random() - 2.0;
    const double horizon = 0.5 * Pi * random();
    const double rise = east * std::sin(azimuth) + north * std::cos(azimuth);
    // The projected normal is nz (-rise, 1): its angle from the zenith in the azimuth, and its
    // length. nz is left out on both sides.
    const double length = std::sqrt(1.0 + rise * rise), normal = std::atan(-rise);
    const double truth = length * published(normal, 0.5 * Pi - std::max(horizon, 0.0));
    const double lowest = std::max({ horizon, std::atan(rise), 0.0 });
    EXPECT_NEAR(
      Evaluate(table, lowest, east, north)[0], truth, InterpolationBound * width * 5.0 * length);
  }
}

TEST(LightTable, HoldsASunOfAHundredThousandMeans)
{
  // A horizon above the sun leaves nothing of its light, one below it leaves all of it, although
  // both are floats.
  OwnedMap map(1024, 512, 1.0f);
  std::fill_n(map.At(700, 100), 3, 1.0e5f);
  const double azimuth = 2.0 * Pi * 700.5 / 1024.0 - Pi;
  const SwathPiece piece{ azimuth - 0.02, azimuth + 0.02, 1.0, 1.0 };
  LightTable table;
  table.Build({ map.View(), 0.0 }, &piece, &piece + 1);
  const double top = 0.5 * Pi - Pi * 100.0 / 512.0, bottom = 0.5 * Pi - Pi * 101.0 / 512.0;
  const double pixel = 2.0 * Pi / 1024.0;
  for (const double elevation : { top + 1e-4, bottom - 1e-4, 0.5 * (top + bottom), 0.0 })
  {
    const double around = 0.5 * 0.04 * std::pow(std::cos(elevation), 2);
    const double from = std::clamp(elevation, bottom, top);
    const double sun =
      0.5 * pixel * 99999.0 * (std::pow(std::sin(top), 2) - std::pow(std::sin(from), 2));
    // The row of the sun is the difference of terms that are a hundred times larger.
    EXPECT_NEAR(Evaluate(table, elevation, 0.0, 0.0)[0], around + sun,
      elevation > top ? FloatBound * around : 1.0e-4 * (around + sun));
  }
}

} // namespace
} // namespace testing
} // namespace skyline
