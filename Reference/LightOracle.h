// SPDX-License-Identifier: BSD-3-Clause
// Light maps for tests, and their light above a horizon by direct sums in double precision.
#ifndef skyline_LightOracle_h
#define skyline_LightOracle_h

#include "Reference/Oracle.h"
#include "Reference/Shapes.h"
#include "Sky/LightAccumulator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace skyline
{
namespace testing
{

/// A map that owns its pixels.
struct OwnedMap
{
  std::ptrdiff_t Columns = 0, Rows = 0;
  std::vector<float> Pixels;

  OwnedMap(std::ptrdiff_t columns, std::ptrdiff_t rows, float radiance = 0.0f)
    : Columns(columns)
    , Rows(rows)
    , Pixels(static_cast<std::size_t>(3 * columns * rows), radiance)
  {
  }
  float* At(std::ptrdiff_t column, std::ptrdiff_t row)
  {
    return this->Pixels.data() + 3 * (row * this->Columns + column);
  }
  LightMap View() const { return ViewTopDown(this->Pixels.data(), this->Columns, this->Rows); }
};

/// Random pixels, evenly distributed, with a different value for each colour.
inline OwnedMap NoisyMap(std::ptrdiff_t columns, std::ptrdiff_t rows, std::uint64_t seed)
{
  OwnedMap map(columns, rows);
  shapes::Random random(seed);
  for (float& value : map.Pixels)
  {
    value = static_cast<float>(random());
  }
  return map;
}

/// A smooth map with mean 1, and one pixel of 1e5 at an azimuth and an elevation (degrees).
inline OwnedMap SunnyMap(
  std::ptrdiff_t columns, std::ptrdiff_t rows, double azimuth, double elevation)
{
  OwnedMap map(columns, rows);
  for (std::ptrdiff_t row = 0; row < rows; ++row)
  {
    for (std::ptrdiff_t column = 0; column < columns; ++column)
    {
      const double a =
        2.0 * Pi * (static_cast<double>(column) + 0.5) / static_cast<double>(columns);
      const double z = Pi * (static_cast<double>(row) + 0.5) / static_cast<double>(rows);
      for (int c = 0; c < 3; ++c)
      {
        map.At(column, row)[c] = static_cast<float>(
          1.0 + 0.5 * std::sin(a + c) * std::sin(z) + 0.3 * std::cos((2.0 + c) * z));
      }
    }
  }
  const auto column =
    static_cast<std::ptrdiff_t>((azimuth + 180.0) / 360.0 * static_cast<double>(columns)) % columns;
  const auto row =
    static_cast<std::ptrdiff_t>((90.0 - elevation) / 180.0 * static_cast<double>(rows));
  std::fill_n(map.At(column, row), 3, 1.0e5f);
  return map;
}

using Color = std::array<double, 3>;

/// The light from the azimuths between begin and end (radians) on a plane with the slopes east and
/// north. Only directions above both horizon(azimuth) and floor(azimuth) count.
/// The azimuths are summed in `steps` strips; the rows are integrated in closed form. The vertical
/// component of the normal is left out.
inline Color StripLight(const OwnedMap& map, double rotation, double begin, double end,
  const std::function<double(double)>& lowest, double east, double north, int steps)
{
  const auto level = [](double e) { return 0.5 * std::sin(e) * std::sin(e); };
  const auto upright = [](double e) { return 0.5 * (e + std::sin(e) * std::cos(e)); };
  const double row = Pi / static_cast<double>(map.Rows);
  std::vector<double> levels, uprights; // at the upper edges of the rows
  for (std::ptrdiff_t r = 0; r <= map.Rows; ++r)
  {
    levels.push_back(level(0.5 * Pi - static_cast<double>(r) * row));
    uprights.push_back(upright(0.5 * Pi - static_cast<double>(r) * row));
  }
  Color sum{};
  for (int s = 0; s < steps; ++s)
  {
    const double azimuth = begin + (end - begin) * (s + 0.5) / steps;
    const double place = (azimuth - rotation + Pi) / (2.0 * Pi);
    const auto column = std::min(map.Columns - 1,
      static_cast<std::ptrdiff_t>((place - std::floor(place)) * static_cast<double>(map.Columns)));
    const double rise = east * std::sin(azimuth) + north * std::cos(azimuth);
    const double least = std::max(lowest(azimuth), 0.0);
    for (std::ptrdiff_t r = 0; r < map.Rows; ++r)
    {
      const double top = 0.5 * Pi - static_cast<double>(r) * row;
      if (least >= top)
      {
        break;
      }
      const auto head = static_cast<std::size_t>(r), foot = head + 1;
      const bool cut = least > top - row;
      const double weight = levels[head] - (cut ? level(least) : levels[foot]) -
        rise * (uprights[head] - (cut ? upright(least) : uprights[foot]));
      const float* pixel = map.Pixels.data() + 3 * (r * map.Columns + column);
      for (std::size_t c = 0; c < 3; ++c)
      {
        sum[c] += weight * static_cast<double>(pixel[c]) * (end - begin) / steps;
      }
    }
  }
  return sum;
}

/// Irradiance of a post from horizons (radians) in any azimuth: a dense sum over the whole map.
inline Color BruteLight(const OwnedMap& map, double rotation,
  const std::function<double(double)>& horizon, double east, double north, int steps)
{
  const auto lowest = [&](double azimuth)
  {
    return std::max(
      horizon(azimuth), std::atan(east * std::sin(azimuth) + north * std::cos(azimuth)));
  };
  Color light = StripLight(map, rotation, -Pi, Pi, lowest, east, north, steps);
  for (double& value : light)
  {
    value /= std::sqrt(1.0 + east * east + north * north);
  }
  return light;
}

/// Irradiance of one post as the accumulator computes it, from slopes in the azimuths that it
/// needs.
inline Color SumLight(const std::vector<TurnedLightMap>& maps, const std::vector<double>& azimuths,
  const LightAccumulator::Options& options, const std::function<double(double)>& horizon,
  double east, double north)
{
  float irradiance[3] = { -7.0f, -7.0f, -7.0f };
  const auto ge = static_cast<float>(east), gn = static_cast<float>(north);
  LightAccumulator light(1, 1, maps, azimuths, options, &ge, &gn, irradiance);
  for (const double azimuth : light.HorizonAzimuths())
  {
    const auto slope = static_cast<float>(std::tan(horizon(azimuth)));
    light.Begin(azimuth, 0.0);
    light.Add(0, 0, 1, &slope);
  }
  light.Finish(0, 1);
  return { irradiance[0], irradiance[1], irradiance[2] };
}

} // namespace testing
} // namespace skyline

#endif
