// SPDX-License-Identifier: BSD-3-Clause
// Small light maps, and sums over their pixels.
#ifndef skyline_LightMapTesting_h
#define skyline_LightMapTesting_h

#include "Sky/LightMap.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace skyline
{
namespace testing
{

/// A map that owns its pixels, starting at the top.
struct OwnedMap
{
  OwnedMap(std::ptrdiff_t columns, std::ptrdiff_t rows)
    : Columns(columns)
    , Rows(rows)
    , Values(static_cast<std::size_t>(3 * columns * rows), 0.0f)
  {
  }
  LightMap View() const { return ViewTopDown(this->Values.data(), this->Columns, this->Rows); }
  float* Pixel(std::ptrdiff_t row, std::ptrdiff_t column)
  {
    return &this->Values[static_cast<std::size_t>(3 * (row * this->Columns + column))];
  }

  std::ptrdiff_t Columns, Rows;
  std::vector<float> Values;
};

/// Independent random radiances between 0 and 1.
inline OwnedMap RandomMap(std::ptrdiff_t columns, std::ptrdiff_t rows, unsigned seed)
{
  OwnedMap map(columns, rows);
  std::mt19937 engine(seed);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  std::generate(map.Values.begin(), map.Values.end(), [&] { return uniform(engine); });
  return map;
}

/// The integral of radiance over the sphere.
inline std::array<double, 3> Energy(const LightMap& map)
{
  std::array<double, 3> energy{};
  for (std::ptrdiff_t row = 0; row < map.Rows; ++row)
  {
    for (std::ptrdiff_t column = 0; column < map.Columns; ++column)
    {
      for (int c = 0; c < 3; ++c)
      {
        energy[c] += PixelSolidAngle(map, row) * map.Pixel(row, column)[c];
      }
    }
  }
  return energy;
}

/// The irradiance of a surface that faces `normal`, without terrain: the sum over all pixels of
/// radiance times solid angle times max(0, cosine at the centre of the pixel).
inline std::array<double, 3> BruteIrradiance(const LightMap& map, const LightMapDirection& normal)
{
  std::array<double, 3> irradiance{};
  for (std::ptrdiff_t row = 0; row < map.Rows; ++row)
  {
    for (std::ptrdiff_t column = 0; column < map.Columns; ++column)
    {
      const LightMapDirection d = PixelDirection(map, row, column);
      const double cosine = normal.X * d.X + normal.Y * d.Y + normal.Z * d.Z;
      for (int c = 0; cosine > 0.0 && c < 3; ++c)
      {
        irradiance[c] += cosine * PixelSolidAngle(map, row) * map.Pixel(row, column)[c];
      }
    }
  }
  return irradiance;
}

} // namespace testing
} // namespace skyline

#endif
