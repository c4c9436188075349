// SPDX-License-Identifier: BSD-3-Clause
#include "Lamps/LampTerrain.h"

#include <algorithm>

namespace skyline
{

namespace
{

/// The greatest height of the four posts of a cell; MissingHeight if one of them is missing.
float CellHighest(const PaddedPlane& plane, std::ptrdiff_t column, std::ptrdiff_t row)
{
  const float* south = plane.Line(row) + column;
  const float* north = plane.Line(row + 1) + column;
  const float lowest = std::min(std::min(south[0], south[1]), std::min(north[0], north[1]));
  const float highest = std::max(std::max(south[0], south[1]), std::max(north[0], north[1]));
  return lowest > 0.5f * MissingHeight ? highest : MissingHeight;
}

} // namespace

LampTerrain::LampTerrain(const HeightField& field)
  : Heights(&field)
{
  std::ptrdiff_t columns = field.Posts().Columns - 1;
  std::ptrdiff_t rows = field.Posts().Rows - 1;
  const PaddedPlane& plane = field.RowPlane();
  while (columns > 1 || rows > 1)
  {
    Level next{ (columns + 1) / 2, (rows + 1) / 2, {} };
    next.Values.resize(static_cast<std::size_t>(next.Columns * next.Rows));
    const Level* below = this->Blocks.empty() ? nullptr : &this->Blocks.back();
    for (std::ptrdiff_t j = 0; j < next.Rows; ++j)
    {
      for (std::ptrdiff_t i = 0; i < next.Columns; ++i)
      {
        float highest = MissingHeight;
        for (std::ptrdiff_t n = 2 * j; n < std::min(2 * j + 2, rows); ++n)
        {
          for (std::ptrdiff_t m = 2 * i; m < std::min(2 * i + 2, columns); ++m)
          {
            highest = std::max(highest,
              below ? below->Values[static_cast<std::size_t>(n * columns + m)]
                    : CellHighest(plane, m, n));
          }
        }
        next.Values[static_cast<std::size_t>(j * next.Columns + i)] = highest;
      }
    }
    columns = next.Columns;
    rows = next.Rows;
    this->Blocks.push_back(std::move(next));
  }
}

} // namespace skyline
