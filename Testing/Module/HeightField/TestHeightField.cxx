// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/OracleTerrain.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace skyline
{
namespace testing
{
namespace
{

TEST(HeightField, RefusesWhatCarriesNoSurface)
{
  EXPECT_THROW(HeightField(Grid{ 1, 5, 1.0, 1.0 }), std::invalid_argument);
  EXPECT_THROW(HeightField(Grid{ 5, 1, 1.0, 1.0 }), std::invalid_argument);
  EXPECT_THROW(HeightField(Grid{ 5, 5, 0.0, 1.0 }), std::invalid_argument);
  EXPECT_THROW(HeightField(Grid{ 5, 5, 1.0, -1.0 }), std::invalid_argument);
  EXPECT_THROW(HeightField(Grid{ 5, 5, std::numeric_limits<double>::quiet_NaN(), 1.0 }),
    std::invalid_argument);
}

// A post that has only missing neighbours is a receiver, but not an occluder.
TEST(HeightField, IsolatedPostsReceiveOnly)
{
  oracle::OracleField field = shapes::Plane(9, 9, 1.0, 0.0, 0.0);
  for (std::ptrdiff_t j = 3; j < 6; ++j)
  {
    for (std::ptrdiff_t i = 3; i < 6; ++i)
    {
      field.At(i, j) = std::numeric_limits<double>::quiet_NaN();
    }
  }
  field.At(4, 4) = 5.0;
  const HeightField posts = FieldOf(field);
  EXPECT_TRUE(posts.HasMissing());
  const auto method = MakeHorizonMethod(posts, HorizonSettings());
  const std::vector<float> east = Slopes(*method, GridOf(field), 90.0);
  EXPECT_FLOAT_EQ(east[4 * 9 + 2], 0.0f);         // sees the plain beyond the hole
  EXPECT_FLOAT_EQ(east[4 * 9 + 4], -5.0f / 4.0f); // the horizon is the farthest post of the plain
}

TEST(HeightField, InfiniteIsMissing)
{
  oracle::OracleField field = shapes::Plane(6, 6, 1.0, 0.0, 0.0);
  field.At(3, 3) = std::numeric_limits<double>::infinity();
  field.At(1, 1) = -std::numeric_limits<double>::infinity();
  const HeightField posts = FieldOf(field);
  EXPECT_TRUE(posts.HasMissing());
  EXPECT_EQ(posts.LargestHeight(), 0.0f);
}

} // namespace
} // namespace testing
} // namespace skyline
