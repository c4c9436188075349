// SPDX-License-Identifier: BSD-3-Clause
#include "EmbreeHorizon.h"

#include "Measure.h"
#include "Reference/Shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#ifdef SKYLINE_EMBREE
#include "EmbreeCaster.h"
#endif

namespace skyline
{
namespace benchmark
{

#ifndef SKYLINE_EMBREE

std::string EmbreeVersion()
{
  return "not built in";
}

Result MeasureEmbree(const Scene&, const ReferenceHorizons&, double, int)
{
  throw std::runtime_error("not built in");
}

#else

namespace
{

// Runs of adjacent existing posts, at random places.
std::vector<std::ptrdiff_t> RunsOfPosts(const oracle::OracleField& field, std::size_t count)
{
  constexpr std::ptrdiff_t length = 64;
  shapes::Random random(7);
  std::vector<std::ptrdiff_t> posts;
  while (posts.size() < count)
  {
    const std::ptrdiff_t first = random.Below(field.Columns * field.Rows);
    const std::ptrdiff_t end =
      std::min((first / field.Columns + 1) * field.Columns, first + length);
    for (std::ptrdiff_t post = first; post < end; ++post)
    {
      if (std::isfinite(field.Heights[static_cast<std::size_t>(post)]))
      {
        posts.push_back(post);
      }
    }
  }
  return posts;
}

} // namespace

std::string EmbreeVersion()
{
  return RTC_VERSION_STRING;
}

Result MeasureEmbree(
  const Scene& scene, const ReferenceHorizons& truth, double accuracy, int repeats)
{
  const PeakMemory memory;
  const double start = ProcessCpu();
  const EmbreeCaster caster(scene.Field);
  Result result;
  result.BuildSeconds = ProcessCpu() - start;
  const auto posts = static_cast<double>(scene.Field.Heights.size());
  result.FloatsPerPost = memory.FloatsPerPost(posts);

  std::vector<oracle::Direction> directions;
  for (const double azimuth : truth.Azimuths)
  {
    directions.push_back(oracle::DirectionOfAzimuth(azimuth));
  }
  const std::vector<std::ptrdiff_t> runs = RunsOfPosts(scene.Field, truth.Posts.size());
  RepeatTimer timer;
  volatile double last = 0.0; // prevents the compiler from removing the computation
  while (timer.Next(repeats, std::numeric_limits<double>::infinity()))
  {
    timer.Search(
      [&]
      {
        for (const std::ptrdiff_t post : runs)
        {
          double horizon = 0.0;
          for (const oracle::Direction& direction : directions)
          {
            horizon = caster.Horizon(post, direction, horizon, accuracy);
          }
          last = horizon;
        }
      });
  }
  timer.Report(result, static_cast<double>(runs.size() * directions.size()));

  result.PrepareNs = NotMeasured;

  ErrorSum errors;
  for (std::size_t post = 0; post < truth.Posts.size(); ++post)
  {
    double horizon = 0.0;
    for (std::size_t azimuth = 0; azimuth < directions.size(); ++azimuth)
    {
      horizon = caster.Horizon(truth.Posts[post], directions[azimuth], horizon, accuracy);
      errors.Add(horizon, truth.Elevation(azimuth, post));
    }
  }
  result.Error = errors.Get();
  result.Ran = true;
  return result;
}

#endif

} // namespace benchmark
} // namespace skyline
