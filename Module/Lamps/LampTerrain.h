// SPDX-License-Identifier: BSD-3-Clause
// A height field with the greatest heights of blocks of cells, which the rays to a lamp use.
#ifndef skyline_LampTerrain_h
#define skyline_LampTerrain_h

#include "HeightField/HeightField.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <vector>

namespace skyline
{

/// Built once for a closed field, which must outlive it. Takes a third of the memory of the
/// heights.
class SKYLINECORE_EXPORT LampTerrain
{
public:
  explicit LampTerrain(const HeightField& field);

  const HeightField& Field() const { return *this->Heights; }

  /// Number of levels. Level 1 .. Levels() has blocks of 2^level cells. A cell has the indices of
  /// its south-west post.
  int Levels() const { return static_cast<int>(this->Blocks.size()); }

  /// The greatest height of the complete cells of the block that contains a cell; MissingHeight if
  /// there are none.
  float Highest(int level, std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    const Level& blocks = this->Blocks[static_cast<std::size_t>(level - 1)];
    return blocks
      .Values[static_cast<std::size_t>((row >> level) * blocks.Columns + (column >> level))];
  }

private:
  struct Level
  {
    std::ptrdiff_t Columns, Rows;
    std::vector<float> Values;
  };
  const HeightField* Heights;
  std::vector<Level> Blocks;
};

} // namespace skyline

#endif
