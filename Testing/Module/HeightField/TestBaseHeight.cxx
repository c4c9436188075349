// SPDX-License-Identifier: BSD-3-Clause
// The height that is subtracted before heights become floats: the middle of the range for terrain,
// near most posts for other data.
#include "HeightField/BaseHeight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace skyline
{
namespace
{

constexpr std::ptrdiff_t Count = 1 << 20;

double Hill(std::ptrdiff_t i)
{
  return 1000.0 + 300.0 * std::sin(0.001 * static_cast<double>(i));
}

TEST(BaseHeight, IsHalfwayForTerrain)
{
  EXPECT_EQ(BaseHeight(Count, 700.0, 1300.0, Hill), 1000.0);
  EXPECT_EQ(BaseHeight(Count, 1e7, 1e7 + 0.002, Hill), 1e7 + 0.001);
  EXPECT_EQ(BaseHeight(Count, -4000.0, 5900.0, Hill), 950.0);
}

// Up to 40 % of the posts have one other value: for any value, the base lies within the hills.
TEST(BaseHeight, StaysWithMostPosts)
{
  for (const double fill : { -99999.0, -1e10, 1e20, 9.97e36, -1.7e308 })
  {
    for (const double share : { 0.0, 0.01, 0.4 })
    {
      const auto height = [&](std::ptrdiff_t i)
      { return static_cast<double>(i) < share * Count + 1.0 ? fill : Hill(i); };
      const double base = BaseHeight(Count, std::min(fill, 700.0), std::max(fill, 1300.0), height);
      EXPECT_GE(base, 700.0) << fill << " " << share;
      EXPECT_LE(base, 1300.0) << fill << " " << share;
    }
  }
}

// Values that cannot be heights are ignored, however many there are.
TEST(BaseHeight, LeavesOutWhatIsNoGround)
{
  const auto height = [](std::ptrdiff_t i) { return i % 10 > 0 ? 1e20 : Hill(i); };
  const double base = BaseHeight(Count, 700.0, 1e20, height);
  EXPECT_GE(base, 700.0);
  EXPECT_LE(base, 1300.0);
  const auto missing = [](std::ptrdiff_t i)
  { return i % 3 > 0 ? std::numeric_limits<double>::quiet_NaN() : Hill(i); };
  EXPECT_NEAR(BaseHeight(Count, 700.0, 1e20, missing), 1000.0, 300.0);
  const auto nothing = [](std::ptrdiff_t) { return 1e20; };
  EXPECT_TRUE(std::isfinite(BaseHeight(Count, 1e20, 1e20, nothing)));
}

} // namespace
} // namespace skyline
