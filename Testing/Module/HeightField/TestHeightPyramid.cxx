// SPDX-License-Identifier: BSD-3-Clause
#include "HeightField/HeightPyramid.h"

#include "Reference/OracleTerrain.h"
#include "SlowPyramid.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace skyline
{
namespace testing
{
namespace
{

HeightPyramid PyramidOf(const oracle::OracleField& field, double step)
{
  HeightPyramid pyramid(FieldOf(field), step);
  pyramid.Expand(0, pyramid.RowCount());
  return pyramid;
}

TEST(HeightPyramid, HasTheLevelsOfTheTable)
{
  // SN08, table 1 with k = 4, and figure 10 with n = 512.
  EXPECT_EQ(PyramidLevels(256, 4.0), 33);
  EXPECT_EQ(PyramidLevels(512, 4.0), 37);
  EXPECT_EQ(PyramidLevels(1024, 4.0), 41);
  EXPECT_EQ(PyramidLevels(512, 1.0), 10);
  EXPECT_EQ(PyramidLevels(512, 2.0), 19);
  EXPECT_EQ(PyramidLevels(512, 8.0), 73);
  // Other sizes and steps: ceil(1.5 log2 160) + 1.
  EXPECT_EQ(PyramidLevels(160, 1.5), 12);
  EXPECT_EQ(PyramidLevels(2, 1.0), 2);
}

TEST(HeightPyramid, ShrinksByTheStep)
{
  const HeightPyramid pyramid = PyramidOf(shapes::Fractal(53, 31, 10.0, 100.0), 3.0);
  ASSERT_EQ(pyramid.Levels(), PyramidLevels(53, 3.0));
  double scale = 1.0;
  for (int i = pyramid.Levels() - 1; i >= 0; --i, scale *= std::cbrt(2.0))
  {
    const PyramidLevel& level = pyramid.Level(i);
    EXPECT_NEAR(level.Scale, scale, 1e-12 * scale);
    EXPECT_EQ(level.Columns, static_cast<std::ptrdiff_t>(std::ceil(53.0 / scale - 1e-9)));
    EXPECT_EQ(level.Rows, static_cast<std::ptrdiff_t>(std::ceil(31.0 / scale - 1e-9)));
  }
  EXPECT_EQ(pyramid.Level(0).Columns, 1);
}

TEST(HeightPyramid, TakesTheMemoryOfAFewCopies)
{
  // The rows of all levels together are 1 / (1 - 2^(-1/4)) = 6.3 times those of the field, not 41
  // times.
  const HeightPyramid pyramid = PyramidOf(shapes::Plane(1024, 1024, 1.0, 0.1, 0.0), 4.0);
  EXPECT_LT(pyramid.RowCount(), 6.4 * 1024);
}

TEST(HeightPyramid, TapsAreTheSpline)
{
  for (const double place : { 0.0, 0.3, 7.25, 19.0 })
  {
    const SplineTaps taps = TapsAt(place, 1.7, 12);
    const double at = (place + 0.5) / 1.7 - 0.5;
    double sum = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
    {
      const double sample = std::floor(at) - 1.0 + static_cast<double>(k);
      EXPECT_NEAR(taps.Weights[k], Bump(at - sample), 1e-7);
      EXPECT_EQ(taps.Samples[k], static_cast<std::ptrdiff_t>(std::clamp(sample, 0.0, 11.0)));
      sum += taps.Weights[k];
    }
    EXPECT_NEAR(sum, 1.0, 1e-6);
  }
}

TEST(HeightPyramid, KeepsALevelPlaneLevel)
{
  const HeightPyramid pyramid = PyramidOf(shapes::Plane(40, 30, 1.0, 0.0, 0.0), 4.0);
  for (int i = 0; i < pyramid.Levels(); ++i)
  {
    for (const float height : pyramid.Level(i).Heights)
    {
      EXPECT_EQ(height, 0.0f);
    }
  }
}

TEST(HeightPyramid, MissingPostsWeighNothing)
{
  oracle::OracleField field = shapes::Plane(64, 48, 1.0, 0.0, 0.0);
  for (double& height : field.Heights)
  {
    height = 700.0;
  }
  field.At(0, 0) = 500.0; // makes the base differ from the height of the plain
  shapes::RemoveIslands(field, 20, 6, 2);
  field.At(0, 0) = 700.0;
  const HeightPyramid pyramid = PyramidOf(field, 2.5);
  ASSERT_TRUE(pyramid.HasMissing());
  const float height = pyramid.Level(0).Heights[0] / pyramid.Level(0).Coverage[0];
  for (int i = 0; i < pyramid.Levels(); ++i)
  {
    const PyramidLevel& level = pyramid.Level(i);
    for (std::size_t sample = 0; sample < level.Heights.size(); ++sample)
    {
      EXPECT_NEAR(level.Heights[sample], height * level.Coverage[sample], 1e-3);
    }
  }
}

TEST(HeightPyramid, RefusesSteps)
{
  const HeightField field = FieldOf(shapes::Plane(8, 8, 1.0, 0.0, 0.0));
  for (const double step : { 0.0, -1.0, 0.5, 17.0, std::nan("") })
  {
    EXPECT_THROW(HeightPyramid(field, step), std::invalid_argument) << step;
  }
}

} // namespace
} // namespace testing
} // namespace skyline
