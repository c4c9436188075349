// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/LampPyramid.h"

#include "Horizon/HorizonPyramid.h"
#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace skyline
{

namespace
{

/// A sample has no height if its coverage by terrain is less than this value.
constexpr double LeastCoverage = 1.0e-6;

/// The taps of a position on an axis. Between the posts of the finest level the interpolation is
/// linear.
SplineTaps TapsOf(const HeightPyramid& pyramid, int level, double place, std::ptrdiff_t samples)
{
  if (level < pyramid.Levels() - 1)
  {
    return TapsAt(place, pyramid.Level(level).Scale, samples);
  }
  SplineTaps taps;
  const double low = std::clamp(std::floor(place), 0.0, static_cast<double>(samples - 1));
  const auto first = static_cast<std::ptrdiff_t>(low);
  taps.Weights = { static_cast<float>(1.0 - (place - low)), static_cast<float>(place - low), 0.0f,
    0.0f };
  taps.Samples = { first, std::min(first + 1, samples - 1), first, first };
  return taps;
}

/// The height of a level at a position in posts; false where there is no terrain.
bool HeightAt(const HeightPyramid& pyramid, int level, double column, double row, double& height)
{
  const PyramidLevel& samples = pyramid.Level(level);
  const SplineTaps across = TapsOf(pyramid, level, column, samples.Columns);
  const SplineTaps along = TapsOf(pyramid, level, row, samples.Rows);
  double sum = 0.0, coverage = 0.0;
  for (std::size_t j = 0; j < 4; ++j)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      const auto sample =
        static_cast<std::size_t>(along.Samples[j] * samples.Columns + across.Samples[i]);
      const double weight = along.Weights[j] * across.Weights[i];
      sum += weight * samples.Heights[sample];
      coverage += weight * (samples.Coverage.empty() ? 1.0 : samples.Coverage[sample]);
    }
  }
  height = sum / std::max(coverage, LeastCoverage);
  return coverage > LeastCoverage;
}

/// The uniform cubic B-spline with these control values at a parameter. The first and the last
/// value are repeated.
double SplineAt(const std::vector<double>& values, double parameter)
{
  const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
  const auto knot =
    std::clamp(static_cast<std::ptrdiff_t>(std::floor(parameter)), std::ptrdiff_t{ 0 }, last);
  const double t = parameter - static_cast<double>(knot), s = 1.0 - t;
  const double weights[4] = { s * s * s, 4.0 - 6.0 * t * t + 3.0 * t * t * t,
    4.0 - 6.0 * s * s + 3.0 * s * s * s, t * t * t };
  double sum = 0.0;
  for (std::ptrdiff_t k = 0; k < 4; ++k)
  {
    sum += weights[k] *
      values[static_cast<std::size_t>(std::clamp(knot + k - 1, std::ptrdiff_t{ 0 }, last))];
  }
  return sum / 6.0;
}

} // namespace

void FindLampHorizons(const HeightPyramid& pyramid, const PyramidSettings& settings,
  const Grid& grid, double drop, const Lamp& lamp, double azimuth, std::ptrdiff_t rowBegin,
  std::ptrdiff_t rowEnd, float* slopes)
{
  // In the order of distance.
  std::vector<PyramidReach> reaches = PyramidReaches(pyramid, settings, grid, azimuth);
  std::reverse(reaches.begin(), reaches.end());
  const double lastColumn = static_cast<double>(grid.Columns - 1);
  const double lastRow = static_cast<double>(grid.Rows - 1);
  std::vector<double> angles;
  for (std::ptrdiff_t row = rowBegin; row < rowEnd; ++row)
  {
    for (std::ptrdiff_t column = 0; column < grid.Columns; ++column)
    {
      const double x0 = static_cast<double>(column), y0 = static_cast<double>(row);
      const double distance = std::hypot(lamp.X - x0 * grid.SpacingX, lamp.Y - y0 * grid.SpacingY);
      angles.clear();
      int level = -1;
      double here = 0.0, there = 0.0;
      for (const PyramidReach& reach : reaches)
      {
        const double x = x0 + reach.East, y = y0 + reach.North;
        if (x < 0.0 || y < 0.0 || x > lastColumn || y > lastRow ||
          (reach.Level != level && !HeightAt(pyramid, reach.Level, x0, y0, here)) ||
          !HeightAt(pyramid, reach.Level, x, y, there))
        {
          break;
        }
        level = reach.Level;
        angles.push_back(std::atan((there - here) / reach.Distance - drop * reach.Distance));
        if (reach.Distance > distance)
        {
          break; // the one beyond the lamp
        }
      }
      float& slope = slopes[(row - rowBegin) * grid.Columns + column];
      if (angles.empty())
      {
        slope = NoTerrainSlope;
        continue;
      }
      const double end = std::clamp(
        settings.LevelStep * std::log2(std::max(distance, 1e-300) / reaches.front().Distance), 0.0,
        static_cast<double>(angles.size() - 1));
      double best = SplineAt(angles, end);
      for (int half = 0; 0.5 * half < end; ++half)
      {
        best = std::max(best, SplineAt(angles, 0.5 * half));
      }
      slope = static_cast<float>(std::tan(best));
    }
  }
}

} // namespace skyline
