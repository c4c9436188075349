// SPDX-License-Identifier: BSD-3-Clause
#include "Reconstruction.h"

#include "Horizon/HorizonPyramid.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace skyline
{
namespace gallery
{

namespace
{

/// The four samples of an axis that are read at a position (in posts). Linear interpolation uses
/// two of them.
SplineTaps TapsOf(double place, double scale, std::ptrdiff_t samples, Across across)
{
  if (across == Across::Spline && scale > 1.0)
  {
    return TapsAt(place, scale, samples);
  }
  const double x = (place + 0.5) / scale - 0.5;
  const double first = std::floor(x);
  SplineTaps taps;
  const auto near = static_cast<std::ptrdiff_t>(first);
  taps.Weights = { { static_cast<float>(1.0 - (x - first)), static_cast<float>(x - first) } };
  taps.Samples = { { std::clamp<std::ptrdiff_t>(near, 0, samples - 1),
    std::clamp<std::ptrdiff_t>(near + 1, 0, samples - 1) } };
  return taps;
}

double HeightAt(const PyramidLevel& level, double column, double row, Across across)
{
  const SplineTaps x = TapsOf(column, level.Scale, level.Columns, across);
  const SplineTaps y = TapsOf(row, level.Scale, level.Rows, across);
  double height = 0.0;
  for (std::size_t j = 0; j < 4; ++j)
  {
    const float* line = level.Heights.data() + y.Samples[j] * level.Columns;
    for (std::size_t i = 0; i < 4; ++i)
    {
      height += static_cast<double>(y.Weights[j]) * static_cast<double>(x.Weights[i]) *
        static_cast<double>(line[x.Samples[i]]);
    }
  }
  return height;
}

double Greatest(const std::vector<double>& angles, Along along)
{
  if (along == Along::Linear)
  {
    return *std::max_element(angles.begin(), angles.end());
  }
  const auto last = static_cast<std::ptrdiff_t>(angles.size()) - 1;
  const auto at = [&](std::ptrdiff_t i)
  { return angles[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))]; };
  double best = 0.0;
  for (std::ptrdiff_t i = 0; i <= last; ++i)
  {
    best = std::max({ best, (at(i - 1) + 4.0 * at(i) + at(i + 1)) / 6.0,
      (at(i - 1) + 23.0 * at(i) + 23.0 * at(i + 1) + at(i + 2)) / 48.0 });
  }
  return best;
}

} // namespace

HorizonsAt ReconstructedHorizons(
  const Scene& scene, double levelStep, double levelOffset, Along along, Across across)
{
  const auto pyramid = std::make_shared<HeightPyramid>(scene.Field, levelStep);
  PyramidSettings settings;
  settings.LevelStep = levelStep;
  settings.LevelOffset = levelOffset;
  return [=, &scene](double azimuth)
  {
    const auto reaches = PyramidReaches(*pyramid, settings, scene.Posts, azimuth);
    std::vector<float> horizons;
    std::vector<double> angles(reaches.size());
    for (std::ptrdiff_t row = 0; row < scene.Posts.Rows; ++row)
    {
      for (std::ptrdiff_t column = 0; column < scene.Posts.Columns; ++column)
      {
        for (std::size_t i = 0; i < reaches.size(); ++i)
        {
          const PyramidReach& reach = reaches[i];
          const PyramidLevel& level = pyramid->Level(reach.Level);
          const double x = static_cast<double>(column) + reach.East;
          const double y = static_cast<double>(row) + reach.North;
          const bool inside = x >= 0.0 && y >= 0.0 &&
            x <= static_cast<double>(scene.Posts.Columns - 1) &&
            y <= static_cast<double>(scene.Posts.Rows - 1);
          angles[i] = !inside ? 0.0
                              : std::max(0.0,
                                  std::atan((HeightAt(level, x, y, across) -
                                              HeightAt(level, static_cast<double>(column),
                                                static_cast<double>(row), across)) /
                                    reach.Distance));
        }
        horizons.push_back(static_cast<float>(Greatest(angles, along)));
      }
    }
    return horizons;
  };
}

} // namespace gallery
} // namespace skyline
