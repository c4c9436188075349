// SPDX-License-Identifier: BSD-3-Clause
#include "Horizon/StoreAccumulator.h"

#include "Shared/Constants.h"
#include "Testing/Module/ProcessorTargets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

/// Degrees: the accuracy of StoreAccumulator, 1.4e-7 rad.
constexpr double ElevationBound = 8.0e-6;

std::vector<float> Degrees(const std::vector<float>& slopes)
{
  std::vector<float> degrees(slopes.size());
  StoreAccumulator store(static_cast<std::ptrdiff_t>(slopes.size()), degrees.data(), 1);
  store.Begin(0.0, 1.0);
  store.Add(0, 0, static_cast<std::ptrdiff_t>(slopes.size()), slopes.data());
  store.Finish(0, 1);
  return degrees;
}

TEST(StoreAccumulator, EndsAreExact)
{
  ForEachProcessorTarget(
    []()
    {
      const float infinite = std::numeric_limits<float>::infinity();
      const std::vector<float> slopes{ NoTerrainSlope, -infinite, -1.0f, 0.0f, 1.0f, infinite };
      EXPECT_EQ(
        Degrees(slopes), (std::vector<float>{ -90.0f, -90.0f, -45.0f, 0.0f, 45.0f, 90.0f }));
    });
}

TEST(StoreAccumulator, ArcTangentOfEveryMagnitude)
{
  ForEachProcessorTarget(
    []()
    {
      std::vector<float> slopes;
      for (std::uint64_t bits = 0; bits < 1ull << 32; bits += 40009)
      {
        const auto word = static_cast<std::uint32_t>(bits);
        float slope = 0.0f;
        std::memcpy(&slope, &word, sizeof(slope));
        if (std::abs(slope) <= 1.0e18f)
        {
          slopes.push_back(slope);
        }
      }
      const std::vector<float> degrees = Degrees(slopes);
      double worst = 0.0;
      for (std::size_t i = 0; i < slopes.size(); ++i)
      {
        const double truth = std::atan(static_cast<double>(slopes[i])) * DegreesPerRadian;
        worst = std::max(worst, std::abs(degrees[i] - truth));
        EXPECT_EQ(std::signbit(degrees[i]), std::signbit(slopes[i]));
      }
      EXPECT_LE(worst, ElevationBound);
    });
}

// Rows that are shorter than a block of posts, or consist of two blocks and a remainder, added in
// runs across their borders.
class StoreLayouts : public ::testing::TestWithParam<std::tuple<std::ptrdiff_t, std::ptrdiff_t>>
{
};

TEST_P(StoreLayouts, HoldTheSame)
{
  const std::ptrdiff_t rows = 2;
  const auto [columns, azimuths] = GetParam();
  std::vector<float> components(static_cast<std::size_t>(columns * rows * azimuths)),
    bands(components.size());
  StoreAccumulator sideBySide(columns, components.data(), azimuths);
  StoreAccumulator apart(columns, bands.data(), 1, columns * rows);
  for (std::ptrdiff_t k = 0; k < azimuths; ++k)
  {
    sideBySide.Begin(0.1 * static_cast<double>(k), 0.1);
    apart.Begin(0.1 * static_cast<double>(k), 0.1);
    for (std::ptrdiff_t row = 0; row < rows; ++row)
    {
      std::vector<float> slopes;
      for (std::ptrdiff_t i = 0; i < columns; ++i)
      {
        slopes.push_back(static_cast<float>(i - 9) * 0.3f + static_cast<float>(k + 10 * row));
      }
      // In one run, and in three runs.
      apart.Add(row, 0, columns, slopes.data());
      sideBySide.Add(row, 0, 1, slopes.data());
      sideBySide.Add(row, 1, columns - 2, slopes.data() + 1);
      sideBySide.Add(row, columns - 1, 1, slopes.data() + columns - 1);
    }
  }
  for (std::ptrdiff_t row = 0; row < rows; ++row)
  {
    sideBySide.Finish(row, row + 1);
    apart.Finish(row, row + 1);
  }
  for (std::ptrdiff_t post = 0; post < columns * rows; ++post)
  {
    for (std::ptrdiff_t k = 0; k < azimuths; ++k)
    {
      EXPECT_EQ(components[static_cast<std::size_t>(post * azimuths + k)],
        bands[static_cast<std::size_t>(k * columns * rows + post)]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ColumnsAndAzimuths, StoreLayouts,
  ::testing::Combine(::testing::Values(2, 19, 528, 529, 1100), ::testing::Values(1, 2, 16, 37)));

} // namespace
} // namespace testing
} // namespace skyline
