// SPDX-License-Identifier: BSD-3-Clause
#include "HeightField/Normals.h"

#include "Reference/Oracle.h"
#include "Reference/Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

constexpr double Missing = std::numeric_limits<double>::quiet_NaN();

struct Pair
{
  std::vector<float> East, North;
};

template <class HeightAt>
Pair All(const Grid& grid, const HeightAt& height, const double* spacingX = nullptr,
  const double* spacingY = nullptr)
{
  const auto posts = static_cast<std::size_t>(grid.Columns * grid.Rows);
  Pair gradients{ std::vector<float>(posts), std::vector<float>(posts) };
  // Two ranges of rows, as two threads would compute them.
  Gradients(grid, height, 0, grid.Rows / 2, gradients.East.data(), gradients.North.data(), spacingX,
    spacingY);
  Gradients(grid, height, grid.Rows / 2, grid.Rows, gradients.East.data(), gradients.North.data(),
    spacingX, spacingY);
  return gradients;
}

TEST(Normals, PlaneHasOneGradientUpToTheEdge)
{
  // The heights are exact in binary, and so are the quotients.
  const Grid grid{ 6, 5, 2.0, 0.5 };
  const Pair gradients =
    All(grid, [](std::ptrdiff_t column, std::ptrdiff_t row) { return 3 * column - 2 * row; });
  for (std::size_t post = 0; post < gradients.East.size(); ++post)
  {
    EXPECT_EQ(gradients.East[post], 1.5f);
    EXPECT_EQ(gradients.North[post], -4.0f);
  }
}

TEST(Normals, AgreesWithTheOracleBesideMissingPosts)
{
  oracle::OracleField field = shapes::Fractal(23, 19, 7.0, 100.0, 4);
  shapes::RemoveIslands(field, 6, 2, 8);
  const Grid grid{ 23, 19, 7.0, 7.0 };
  const Pair gradients = All(grid, PostView<double>{ field.Heights.data(), 1, 23 });
  for (std::ptrdiff_t row = 0; row < 19; ++row)
  {
    for (std::ptrdiff_t column = 0; column < 23; ++column)
    {
      const std::size_t post = field.Index(column, row);
      if (!field.HasPost(column, row))
      {
        EXPECT_TRUE(std::isnan(gradients.East[post]));
        EXPECT_TRUE(std::isnan(gradients.North[post]));
        continue;
      }
      double east = 0.0, north = 0.0;
      oracle::Gradient(field, column, row, east, north);
      EXPECT_FLOAT_EQ(gradients.East[post], static_cast<float>(east));
      EXPECT_FLOAT_EQ(gradients.North[post], static_cast<float>(north));
    }
  }
}

TEST(Normals, IsolatedPostIsLevel)
{
  const Grid grid{ 3, 3, 1.0, 1.0 };
  const Pair gradients = All(grid,
    [](std::ptrdiff_t column, std::ptrdiff_t row) {
      return column == 1 && row == 1 ? 5.0 : column == 0 ? Missing : -1.0 / 0.0;
    });
  EXPECT_EQ(gradients.East[4], 0.0f);
  EXPECT_EQ(gradients.North[4], 0.0f);
  EXPECT_TRUE(std::isnan(gradients.East[5])); // infinite heights count as missing
}

TEST(Normals, MillimetresOnTenThousandKilometres)
{
  // Steps of 2^-10 m, which doubles near 1e7 m represent exactly.
  const Grid grid{ 5, 4, 1.0, 1.0 };
  const Pair gradients = All(grid,
    [](std::ptrdiff_t column, std::ptrdiff_t row)
    { return 1.0e7 + static_cast<double>(column - 3 * row) / 1024.0; });
  for (std::size_t post = 0; post < gradients.East.size(); ++post)
  {
    EXPECT_EQ(gradients.East[post], 1.0f / 1024.0f);
    EXPECT_EQ(gradients.North[post], -3.0f / 1024.0f);
  }
}

TEST(Normals, EachRowMayHaveItsSpacing)
{
  const Grid grid{ 3, 3, 9.0, 9.0 };
  const double spacingX[3] = { 1.0, 2.0, 4.0 };
  const double spacingY[3] = { 8.0, 16.0, 32.0 };
  const std::int16_t heights[9] = { 0, 1, 2, 4, 5, 6, 8, 9, 10 };
  const Pair gradients = All(grid, PostView<std::int16_t>{ heights, 1, 3 }, spacingX, spacingY);
  for (std::size_t row = 0; row < 3; ++row)
  {
    EXPECT_EQ(gradients.East[3 * row + 1], static_cast<float>(1.0 / spacingX[row]));
    EXPECT_EQ(gradients.North[3 * row + 1], static_cast<float>(4.0 / spacingY[row]));
  }
}

TEST(Normals, ViewsMayBeStridedAndFlipped)
{
  // North-up rows with two values per post, of which the second is the height.
  const float values[8] = { 0, 7, 0, 9, 0, 1, 0, 2 };
  const PostView<float> view{ values + 5, 2, -4 };
  const Pair gradients = All(Grid{ 2, 2, 1.0, 1.0 }, view);
  EXPECT_EQ(gradients.East[0], 1.0f);
  EXPECT_EQ(gradients.East[2], 2.0f);
  EXPECT_EQ(gradients.North[0], 6.0f);
  EXPECT_EQ(gradients.North[1], 7.0f);
}

} // namespace
} // namespace testing
} // namespace skyline
