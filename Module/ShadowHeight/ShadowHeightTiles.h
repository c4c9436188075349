// SPDX-License-Identifier: BSD-3-Clause
// The greatest heights of square tiles of a plane in two sizes. Rays above them cannot meet the
// terrain.
#ifndef skyline_ShadowHeightTiles_h
#define skyline_ShadowHeightTiles_h

#include "HeightField/HeightField.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace skyline
{

/// Greatest heights of square tiles, including the lines before and after each tile, whose edges
/// reach into it.
class ShadowHeightTiles
{
public:
  static constexpr std::ptrdiff_t Fine = 16;    ///< posts along the side of a tile
  static constexpr std::ptrdiff_t Coarse = 128; ///< posts along the side of a large tile; a
                                                ///< multiple of Fine

  /// Computes the heights; later calls do nothing.
  void Build(const PaddedPlane& plane);

  /// Greatest height of the fine tiles in tile row `row` that contain lanes first .. last;
  /// MissingHeight for lanes outside the data.
  float FineTop(std::ptrdiff_t row, std::ptrdiff_t first, std::ptrdiff_t last) const
  {
    return Top(this->FineTiles, this->FinePerRow, row, first, last, Fine);
  }
  float CoarseTop(std::ptrdiff_t row, std::ptrdiff_t first, std::ptrdiff_t last) const
  {
    return Top(this->CoarseTiles, this->CoarsePerRow, row, first, last, Coarse);
  }
  float Highest() const { return this->Whole; } ///< of all posts

private:
  static float Top(const std::vector<float>& tiles, std::ptrdiff_t perRow, std::ptrdiff_t row,
    std::ptrdiff_t first, std::ptrdiff_t last, std::ptrdiff_t size)
  {
    const std::ptrdiff_t begin = std::max<std::ptrdiff_t>(first, 0) / size;
    const std::ptrdiff_t end = std::min((last + size) / size, perRow);
    const float* line = tiles.data() + row * perRow;
    float top = MissingHeight;
    for (std::ptrdiff_t tile = begin; tile < end; ++tile)
    {
      top = std::max(top, line[tile]);
    }
    return top;
  }

  std::ptrdiff_t FinePerRow = 0, CoarsePerRow = 0;
  std::vector<float> FineTiles, CoarseTiles;
  float Whole = MissingHeight;
};

} // namespace skyline

#endif
