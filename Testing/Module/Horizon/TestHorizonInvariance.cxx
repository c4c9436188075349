// SPDX-License-Identifier: BSD-3-Clause
// Changes that must not change a horizon: mirrors, swapped axes, an offset of all heights, the
// division into lines, a second run.
#include "Reference/OracleTerrain.h"

#include <gtest/gtest.h>

namespace skyline
{
namespace testing
{
namespace
{

const oracle::OracleField& Hills()
{
  static const oracle::OracleField field = shapes::Fractal(101, 83, 30.0, 1200.0, 21);
  return field;
}

std::vector<float> ExactSlopes(const oracle::OracleField& field, double azimuth)
{
  const HeightField posts = FieldOf(field);
  HorizonSettings settings;
  settings.Shape = field.Through;
  settings.CurvatureDrop = field.CurvatureDrop;
  return Slopes(*MakeHorizonMethod(posts, settings), GridOf(field), azimuth);
}

// A mirror changes the diagonals of the triangles; the bilinear surface has none.
TEST(HorizonInvariance, MirrorsOfTheBilinearSurface)
{
  oracle::OracleField field = Hills();
  field.Through = Surface::Bilinear;
  oracle::OracleField mirrored = field;
  for (std::ptrdiff_t j = 0; j < field.Rows; ++j)
  {
    for (std::ptrdiff_t i = 0; i < field.Columns; ++i)
    {
      mirrored.At(i, j) = field.At(field.Columns - 1 - i, j);
    }
  }
  for (const double azimuth : { 13.0, 45.0, 80.0, 155.0, 200.0, 290.0 })
  {
    const std::vector<float> a = ExactSlopes(field, azimuth);
    const std::vector<float> b = ExactSlopes(mirrored, -azimuth);
    for (std::ptrdiff_t j = 0; j < field.Rows; ++j)
    {
      for (std::ptrdiff_t i = 0; i < field.Columns; ++i)
      {
        const auto here = static_cast<std::size_t>(j * field.Columns + i);
        const auto there = static_cast<std::size_t>((j + 1) * field.Columns - 1 - i);
        ASSERT_NEAR(Elevation(a[here]), Elevation(b[there]), RoundingBound(field));
      }
    }
  }
}

// Swapped axes keep the diagonals: row i of one field is column i of the other, and the azimuth a
// becomes 90 - a.
TEST(HorizonInvariance, SwappedAxes)
{
  const oracle::OracleField& field = Hills();
  oracle::OracleField swapped(field.Rows, field.Columns, field.SpacingY, field.SpacingX);
  for (std::ptrdiff_t j = 0; j < field.Rows; ++j)
  {
    for (std::ptrdiff_t i = 0; i < field.Columns; ++i)
    {
      swapped.At(j, i) = field.At(i, j);
    }
  }
  for (const double azimuth : { 0.0, 20.0, 45.0, 70.0, 100.0, 190.0, 330.0 })
  {
    const std::vector<float> a = ExactSlopes(field, azimuth);
    const std::vector<float> b = ExactSlopes(swapped, 90.0 - azimuth);
    for (std::ptrdiff_t j = 0; j < field.Rows; ++j)
    {
      for (std::ptrdiff_t i = 0; i < field.Columns; ++i)
      {
        ASSERT_NEAR(Elevation(a[static_cast<std::size_t>(j * field.Columns + i)]),
          Elevation(b[static_cast<std::size_t>(i * field.Rows + j)]), RoundingBound(field));
      }
    }
  }
}

// 1e7 m in double precision: heights are stored relative to their middle, so only 2^-53 x 1e7 m = 1
// nm is lost.
TEST(HorizonInvariance, HeightShift)
{
  oracle::OracleField shifted = Hills();
  for (double& height : shifted.Heights)
  {
    height += 1.0e7;
  }
  for (const double azimuth : { 0.0, 33.0, 211.0 })
  {
    const std::vector<float> a = ExactSlopes(Hills(), azimuth);
    const std::vector<float> b = ExactSlopes(shifted, azimuth);
    for (std::size_t post = 0; post < a.size(); ++post)
    {
      ASSERT_NEAR(Elevation(a[post]), Elevation(b[post]), RoundingBound(Hills()));
    }
  }
}

// Millimetres on top of 1e7 m: a plane that rises by 1 mm per post keeps its slope.
TEST(HorizonInvariance, MillimetresOnTenThousandKilometres)
{
  oracle::OracleField field = shapes::Plane(50, 50, 1.0, 0.001, 0.0);
  for (double& height : field.Heights)
  {
    height += 1.0e7;
  }
  const std::vector<float> slopes = ExactSlopes(field, 90.0);
  // At 1e7 m doubles are 1.9 nm apart, which is 4e-6 of 1 mm per post.
  EXPECT_NEAR(slopes[25 * 50 + 20], 0.001, 5.0e-9);
}

TEST(HorizonInvariance, LinesMayBeDealtOutInTheSameChunksByAnyone)
{
  const HeightField posts = FieldOf(Hills());
  const auto once = MakeHorizonMethod(posts, HorizonSettings());
  const auto again = MakeHorizonMethod(posts, HorizonSettings());
  EXPECT_EQ(Slopes(*once, GridOf(Hills()), 61.0), Slopes(*again, GridOf(Hills()), 61.0));
  // Another size of the groups of lines may only change the rounding.
  const std::vector<float> whole = Slopes(*once, GridOf(Hills()), 61.0, 1000);
  const std::vector<float> single = Slopes(*once, GridOf(Hills()), 61.0, 1);
  for (std::size_t post = 0; post < whole.size(); ++post)
  {
    ASSERT_NEAR(Elevation(whole[post]), Elevation(single[post]), RoundingBound(Hills()));
  }
}

// A part of the lanes of a line can be requested, as it is for bands of rows.
TEST(HorizonInvariance, PartOfTheLanes)
{
  const HeightField posts = FieldOf(Hills());
  const auto method = MakeHorizonMethod(posts, HorizonSettings());
  for (const double azimuth : { 10.0, 80.0, 190.0, 350.0 })
  {
    const std::vector<float> all = Slopes(*method, GridOf(Hills()), azimuth);
    const RayFrame& frame = method->Frame();
    constexpr std::ptrdiff_t begin = 17;
    constexpr std::ptrdiff_t end = 60;
    constexpr std::ptrdiff_t stride = 64;
    std::vector<float> part(static_cast<std::size_t>(frame.Lines * stride));
    method->Find(0, frame.Lines, begin, end, part.data(), stride);
    for (std::ptrdiff_t line = 0; line < frame.Lines; ++line)
    {
      for (std::ptrdiff_t lane = begin; lane < end; ++lane)
      {
        const std::ptrdiff_t image = frame.ImageLine(line);
        const std::ptrdiff_t post =
          frame.Columns ? lane * Hills().Columns + image : image * Hills().Columns + lane;
        ASSERT_NEAR(Elevation(all[static_cast<std::size_t>(post)]),
          Elevation(part[static_cast<std::size_t>(line * stride + lane - begin)]),
          RoundingBound(Hills()));
      }
    }
  }
}

TEST(DirectionOfAzimuth, IsExactAtMultiplesOf45)
{
  const double half = std::sqrt(0.5);
  const std::vector<std::pair<double, double>> expected{ { 0, 1 }, { half, half }, { 1, 0 },
    { half, -half }, { 0, -1 }, { -half, -half }, { -1, 0 }, { -half, half } };
  for (int turn = -2; turn <= 2; ++turn)
  {
    for (int k = 0; k < 8; ++k)
    {
      const Direction direction = DirectionOfAzimuth((45.0 * k + 360.0 * turn) * RadiansPerDegree);
      EXPECT_EQ(direction.East, expected[static_cast<std::size_t>(k)].first);
      EXPECT_EQ(direction.North, expected[static_cast<std::size_t>(k)].second);
    }
  }
  EXPECT_THROW(DirectionOfAzimuth(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

} // namespace
} // namespace testing
} // namespace skyline
