// SPDX-License-Identifier: BSD-3-Clause
// Fields with more than 2^31 posts: the search over rows with 46400 x 46400 posts, in 10 GB; over
// columns with 40000 x 40000 posts, in 14 GB; consumers with reserved memory that is only used
// where a post is written; and a whole filter with 40000 x 40000 posts, in 16 GB. The closed forms
// are those of level ground inside straight crests.
#include "Data/MemoryDemand.h"
#include "Horizon/StoreAccumulator.h"
#include "Reference/OracleTerrain.h"
#include "Sky/SkyAccumulator.h"

#include "vtkFloatArray.h"
#include "vtkHeightFieldHorizon.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <sys/mman.h>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

constexpr std::ptrdiff_t Side = 46400;
static_assert(Side * Side > (std::int64_t{ 1 } << 31), "the posts must exceed 32 bits");

// A slope is the quotient of two exact floats: an error of a few units in the last place.
constexpr double SlopeRounding = 4.0e-7;

// Degrees: the accuracy of StoreAccumulator, plus SlopeRounding as an angle.
constexpr double ElevationBound = 3.0e-5;

/// Reserved address space without memory. Pages are allocated when they are written.
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

// Returns why there is not enough memory (needed: gigabytes), or an empty string if there is.
std::string MemoryShortage(double needed)
{
  const double free = 1.0e-9 * FreeMemory();
  return free > needed
    ? std::string()
    : std::to_string(free) + " GB of memory are free, it takes " + std::to_string(needed);
}

// The last posts of a field of this size, for each azimuth, in consumers that store only their
// results: the value must be where 64-bit arithmetic puts it.
TEST(HugeFields, ConsumersReachTheLastPost)
{
  constexpr std::ptrdiff_t posts = Side * Side;
  constexpr int azimuths = 8;
  const Reserved bands(static_cast<std::size_t>(posts) * azimuths);
  const Reserved tuples(static_cast<std::size_t>(posts) * azimuths);
  const Reserved sky(static_cast<std::size_t>(posts) * 3);
  if (!bands.Given() || !tuples.Given() || !sky.Given())
  {
    GTEST_SKIP() << "no 170 GB of address space without memory";
  }
  StoreAccumulator stored(Side, bands.Values(), 1, posts);
  StoreAccumulator sideBySide(Side, tuples.Values(), azimuths);
  SkyBuffers buffers;
  buffers.VisibleSkyFraction = { sky.Values() + 2, 3 };
  SkyAccumulator fraction(Side, buffers, nullptr, nullptr);
  const std::vector<float> slopes(16, 1.0f); // 45 degrees all around
  for (int k = 0; k < azimuths; ++k)
  {
    for (Accumulator* consumer : { static_cast<Accumulator*>(&stored),
           static_cast<Accumulator*>(&sideBySide), static_cast<Accumulator*>(&fraction) })
    {
      consumer->Begin(2.0 * Pi * k / azimuths, 2.0 * Pi / azimuths);
      consumer->Add(Side - 1, Side - 16, 16, slopes.data());
    }
  }
  sideBySide.Finish(Side - 1, Side);
  fraction.Finish(Side - 1, Side);
  EXPECT_NEAR(bands.Values()[posts - 1], 45.0, 1e-5);
  EXPECT_NEAR(bands.Values()[azimuths * posts - 1], 45.0, 1e-5);
  for (int k = 1; k <= azimuths; ++k)
  {
    EXPECT_NEAR(tuples.Values()[azimuths * posts - k], 45.0, 1e-5);
  }
  EXPECT_NEAR(sky.Values()[3 * (posts - 1) + 2], 1.0 - std::sqrt(0.5), 1e-5);
}

// Level ground whose first and last rows and columns are crests with different heights.
constexpr double South = 500.0, North = 1000.0, West = 700.0, East = 300.0;

class HugeHorizons : public ::testing::Test
{
protected:
  void Search(HeightField& posts, double azimuth, const std::vector<std::ptrdiff_t>& lanes)
  {
    const Grid& grid = posts.Posts();
    const std::ptrdiff_t side = grid.Columns;
    const auto method = MakeHorizonMethod(posts, HorizonSettings());
    method->SetAzimuth(grid, azimuth * RadiansPerDegree);
    method->Prepare(0, method->PrepareCount());
    const RayFrame& frame = method->Frame();
    constexpr std::ptrdiff_t lines = 4, block = 32;
    std::vector<float> slopes(static_cast<std::size_t>(lines * block));
    for (const std::ptrdiff_t begin : { std::ptrdiff_t{ 1 }, side / 2, side - 1 - lines })
    {
      for (const std::ptrdiff_t lane : lanes)
      {
        method->Find(begin, begin + lines, lane, lane + block, slopes.data(), block);
        for (std::ptrdiff_t i = 0; i < lines * block; ++i)
        {
          // The crest in front is a straight edge across all lanes.
          const std::ptrdiff_t line = frame.ImageLine(begin + i / block);
          const bool onwards = azimuth < 135.0;
          const double crest = frame.Columns ? onwards ? East : West : onwards ? North : South;
          const auto ahead = static_cast<double>(onwards ? side - 1 - line : line);
          const double turned = (azimuth - std::round(azimuth / 90.0) * 90.0) * RadiansPerDegree;
          const double truth = crest / ahead * std::cos(turned);
          EXPECT_NEAR(slopes[static_cast<std::size_t>(i)], truth, SlopeRounding * truth)
            << azimuth << " degrees, line " << line << ", lane " << lane + i % block;
        }
      }
    }
  }

  static HeightField Field(std::ptrdiff_t side)
  {
    HeightField posts(Grid{ side, side, 1.0, 1.0 });
    posts.Fill(0, side, 0.0,
      [side](std::ptrdiff_t column, std::ptrdiff_t row)
      {
        return row == 0        ? South
          : row == side - 1    ? North
          : column == 0        ? West
          : column == side - 1 ? East
                               : 0.0;
      });
    posts.Close();
    return posts;
  }
};

TEST_F(HugeHorizons, OverRows)
{
  const std::string lacking = MemoryShortage(11.0); // heights 8.6, bounds 1.2
  if (!lacking.empty())
  {
    GTEST_SKIP() << lacking;
  }
  HeightField posts = Field(Side);
  this->Search(posts, 0.0, { 32, Side / 2, Side - 64 });
  this->Search(posts, 180.0, { 32, Side / 2, Side - 64 });
  this->Search(posts, 10.0, { Side / 2 }); // it meets the crest 8182 columns further east
}

TEST_F(HugeHorizons, OverColumns)
{
  // Heights are stored twice: a machine of 24 GB cannot hold more posts.
  constexpr std::ptrdiff_t side = 40000;
  const std::string lacking = MemoryShortage(14.5);
  if (!lacking.empty())
  {
    GTEST_SKIP() << lacking;
  }
  HeightField posts = Field(side);
  posts.Transpose();
  this->Search(posts, 90.0, { 32, side / 2, side - 64 });
  this->Search(posts, 260.0, { side / 2 });
}

// A filter over all posts of 40000 x 40000, whose results are 6.4e9 bytes.
TEST(HugeFilter, HorizonOfEveryPost)
{
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "an hour under the sanitizers: the preset huge runs it";
#endif
  const std::string lacking = MemoryShortage(15.8); // heights 1.6 and 6.4, bounds 0.9, results 6.4
  if (!lacking.empty())
  {
    GTEST_SKIP() << lacking;
  }
  constexpr vtkIdType side = 40000;
  constexpr unsigned char crest = 200;
  vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, 1);
  {
    vtkNew<vtkUnsignedCharArray> heights;
    heights->SetNumberOfTuples(side * side);
    heights->FillValue(0);
    std::fill_n(heights->GetPointer((side - 1) * side), side, crest);
    image->GetPointData()->SetScalars(heights);
  }
  vtkNew<vtkHeightFieldHorizon> filter;
  filter->SetInputData(image);
  filter->SetNumberOfAzimuths(1); // north
  filter->Update();
  auto* horizon =
    vtkFloatArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetArray("HorizonElevation"));
  ASSERT_NE(horizon, nullptr);
  ASSERT_EQ(horizon->GetNumberOfTuples(), side * side);
  for (vtkIdType row = 0; row < side; ++row)
  {
    const double truth = row == side - 1
      ? -90.0
      : std::atan(crest / static_cast<double>(side - 1 - row)) * DegreesPerRadian;
    const float* degrees = horizon->GetPointer(row * side);
    const auto [least, greatest] = std::minmax_element(degrees, degrees + side);
    ASSERT_NEAR(*least, truth, ElevationBound) << "row " << row;
    ASSERT_NEAR(*greatest, truth, ElevationBound) << "row " << row;
  }
}

} // namespace
} // namespace testing
} // namespace skyline
