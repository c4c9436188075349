// SPDX-License-Identifier: BSD-3-Clause
// 40000 x 40000 posts, where posts times components pass 2^31: the whole search of an azimuth, in 8 GB,
// and the consumers, over memory that is reserved but touched only where a post is written.
#include "HorizonTesting.h"
#include "SkyAccumulator.h"
#include "StoreAccumulator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <sys/mman.h>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

constexpr std::ptrdiff_t Side = 40000;

/// Address space without memory behind it; pages come as they are written.
class Reserved
{
public:
  explicit Reserved(std::size_t floats)
    : Bytes(floats * sizeof(float))
    , Start(mmap(
        nullptr, Bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0))
  {
  }
  ~Reserved()
  {
    if (this->Given())
    {
      munmap(this->Start, this->Bytes);
    }
  }
  Reserved(const Reserved&) = delete;
  Reserved& operator=(const Reserved&) = delete;

  bool Given() const { return this->Start != MAP_FAILED; }
  float* Values() const { return static_cast<float*>(this->Start); }

private:
  std::size_t Bytes;
  void* Start;
};

double GigabytesFree()
{
  std::ifstream file("/proc/meminfo");
  std::string word;
  while (file >> word)
  {
    if (word == "MemAvailable:")
    {
      double kilobytes = 0.0;
      file >> kilobytes;
      return kilobytes * 1024.0e-9;
    }
  }
  return 0.0;
}

// The last posts of a field of that size, azimuth by azimuth, in consumers that keep nothing a post but
// their results: the value lies where 64-bit arithmetic puts it.
TEST(HugeFields, ConsumersReachTheLastPost)
{
  constexpr std::ptrdiff_t posts = Side * Side;
  constexpr int azimuths = 8;
  const Reserved bands(static_cast<std::size_t>(posts) * azimuths);
  const Reserved sky(static_cast<std::size_t>(posts) * 3);
  if (!bands.Given() || !sky.Given())
  {
    GTEST_SKIP() << "no 70 GB of address space without memory";
  }
  StoreAccumulator stored(Side, Side, bands.Values(), 1, posts);
  SkyBuffers buffers;
  buffers.VisibleSkyFraction = { sky.Values() + 2, 3 };
  SkyAccumulator fraction(Side, buffers, nullptr, nullptr);
  const std::vector<float> slopes(16, 1.0f); // 45 degrees all around
  for (int k = 0; k < azimuths; ++k)
  {
    for (Accumulator* consumer :
      { static_cast<Accumulator*>(&stored), static_cast<Accumulator*>(&fraction) })
    {
      consumer->Begin(2.0 * Pi * k / azimuths, 2.0 * Pi / azimuths);
      consumer->Add(Side - 1, Side - 16, 16, slopes.data());
    }
  }
  fraction.Finish(Side - 1, Side);
  EXPECT_NEAR(bands.Values()[posts - 1], 45.0, 1e-5);
  EXPECT_NEAR(bands.Values()[azimuths * posts - 1], 45.0, 1e-5);
  EXPECT_NEAR(sky.Values()[3 * (posts - 1) + 2], 1.0 - std::sqrt(0.5), 1e-5);
}

// A plane, whose horizon is known, over the rows of the whole field.
TEST(HugeFields, HorizonsOfTheLastLines)
{
  constexpr double needed = 10.0; // GB: heights 6.4, bounds 0.8, and what the program is
  if (GigabytesFree() < needed)
  {
    GTEST_SKIP() << GigabytesFree() << " GB of memory are free, it takes " << needed;
  }
  const Grid grid{ Side, Side, 1.0, 1.0 };
  constexpr double rise = 0.01; // towards the north
  HeightField posts(grid);
  posts.Fill(0, Side, 0.5 * rise * static_cast<double>(Side),
    [&](std::ptrdiff_t, std::ptrdiff_t row) { return rise * static_cast<double>(row); });
  posts.Close();
  const auto method = MakeHorizonMethod(posts, HorizonSettings());
  constexpr std::ptrdiff_t lines = 64;
  std::vector<float> slopes(static_cast<std::size_t>(lines * (Side + 32)));
  // The rays go north: the last lines are the first rows, which see the whole field.
  for (const double azimuth : { 0.0, 10.0, 180.0 })
  {
    method->SetAzimuth(grid, azimuth);
    ASSERT_FALSE(method->Frame().Columns);
    method->Prepare(0, method->PrepareCount());
    for (const std::ptrdiff_t begin : { std::ptrdiff_t{ 0 }, Side - lines })
    {
      method->Find(begin, begin + lines, 0, Side, slopes.data(), Side + 32);
      const std::ptrdiff_t line = begin == 0 ? 1 : lines - 2;
      const double truth = rise * std::cos(azimuth * RadiansPerDegree);
      // Heights of 200 m in floats of 1.5e-5 m, over a step: twice that.
      EXPECT_NEAR(slopes[static_cast<std::size_t>(line * (Side + 32) + Side / 2)], truth, 4e-5)
        << azimuth << " from line " << begin;
    }
  }
}

} // namespace
} // namespace testing
} // namespace skyline
