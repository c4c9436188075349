// SPDX-License-Identifier: BSD-3-Clause
#include "KernelMethods.h"

#include "Measure.h"
#include "Reference/OracleTerrain.h"

#include <algorithm>

namespace skyline
{
namespace benchmark
{

namespace
{

constexpr std::ptrdiff_t ChunkLines = 64; // number of lines that the filters give to a thread

// Runs a method in one azimuth. Each chunk of lines uses the same buffer of slopes, as in a filter
// with an accumulator.
class Driver
{
public:
  explicit Driver(HorizonMethod& method)
    : Method(method)
  {
  }

  /// azimuth: degrees.
  void Prepare(const Grid& grid, double azimuth)
  {
    this->Method.SetAzimuth(grid, azimuth * RadiansPerDegree);
    this->Method.Prepare(0, this->Method.PrepareCount());
  }

  /// Calls take(line, slopes of the line) for each line.
  template <typename Take>
  void Search(const Take& take)
  {
    const RayFrame& frame = this->Method.Frame();
    const std::ptrdiff_t stride = (frame.Lanes + 31) / 32 * 32;
    this->Slopes.resize(static_cast<std::size_t>(ChunkLines * stride));
    for (std::ptrdiff_t begin = 0; begin < frame.Lines; begin += ChunkLines)
    {
      const std::ptrdiff_t end = std::min(begin + ChunkLines, frame.Lines);
      this->Method.Find(begin, end, 0, frame.Lanes, this->Slopes.data(), stride);
      for (std::ptrdiff_t line = begin; line < end; ++line)
      {
        take(line, this->Slopes.data() + (line - begin) * stride);
      }
    }
  }

private:
  HorizonMethod& Method;
  std::vector<float> Slopes;
};

// Elevations at the posts of the reference in one azimuth, in the order of the reference.
std::vector<double> Sample(
  Driver& driver, const RayFrame& frame, const Grid& grid, const std::vector<std::ptrdiff_t>& posts)
{
  struct Wanted
  {
    std::size_t Index;
    std::ptrdiff_t Lane;
  };
  std::vector<std::vector<Wanted>> wanted(static_cast<std::size_t>(frame.Lines));
  for (std::size_t i = 0; i < posts.size(); ++i)
  {
    const std::ptrdiff_t column = posts[i] % grid.Columns;
    const std::ptrdiff_t row = posts[i] / grid.Columns;
    const std::ptrdiff_t line = frame.ImageLine(frame.Columns ? column : row);
    wanted[static_cast<std::size_t>(line)].push_back({ i, frame.Columns ? row : column });
  }
  std::vector<double> elevations(posts.size());
  driver.Search(
    [&](std::ptrdiff_t line, const float* slopes)
    {
      for (const Wanted& post : wanted[static_cast<std::size_t>(line)])
      {
        elevations[post.Index] = testing::Elevation(slopes[post.Lane]);
      }
    });
  return elevations;
}

} // namespace

std::vector<std::size_t> ThinnedAzimuths(std::size_t count, std::size_t thin)
{
  std::vector<std::size_t> indices;
  for (std::size_t k = 0; k * thin < count; ++k)
  {
    indices.push_back(std::min(k * thin + k % thin, count - 1));
  }
  return indices;
}

Result MeasureKernel(const Scene& scene, const ReferenceHorizons& truth, const MakeMethod& make,
  int repeats, std::size_t thin, double seconds)
{
  const Grid grid = testing::GridOf(scene.Field);
  const auto posts = static_cast<double>(grid.Columns * grid.Rows);
  const PeakMemory memory;
  const HeightField field = testing::FieldOf(scene.Field);
  const std::unique_ptr<HorizonMethod> method = make(field);
  Driver driver(*method);
  const std::vector<std::size_t> azimuths = ThinnedAzimuths(truth.Azimuths.size(), thin);

  RepeatTimer timer;
  while (timer.Next(repeats, seconds))
  {
    for (const std::size_t azimuth : azimuths)
    {
      timer.Prepare([&] { driver.Prepare(grid, truth.Azimuths[azimuth]); });
      timer.Search([&] { driver.Search([](std::ptrdiff_t, const float*) {}); });
    }
  }
  Result result;
  result.FloatsPerPost = memory.FloatsPerPost(posts);
  timer.Report(result, posts * static_cast<double>(azimuths.size()));

  ErrorSum errors;
  for (const std::size_t azimuth : azimuths)
  {
    driver.Prepare(grid, truth.Azimuths[azimuth]);
    const std::vector<double> found = Sample(driver, method->Frame(), grid, truth.Posts);
    for (std::size_t post = 0; post < found.size(); ++post)
    {
      errors.Add(found[post], truth.Elevation(azimuth, post));
    }
  }
  result.Error = errors.Get();
  result.Ran = true;
  return result;
}

} // namespace benchmark
} // namespace skyline
