// SPDX-License-Identifier: BSD-3-Clause
// A height field with the maxima of its blocks of cells: what the rays to a lamp ask.
#ifndef skyline_LampTerrain_h
#define skyline_LampTerrain_h

#include "HeightField/HeightField.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <vector>

namespace skyline
{

/// Built once for a closed field, which must outlive it; a third of the field's floats.
class SKYLINECORE_EXPORT LampTerrain
{
public:
  explicit LampTerrain(const HeightField& field);

  const HeightField& Field() const { return *this->Heights; }

  /// Blocks of 2^level cells, level 1 .. Levels(); a cell is named by its south-west post.
  int Levels() const { return static_cast<int>(this->Blocks.size()); }

  /// The greatest height of the complete cells of the block that holds a cell; MissingHeight if
  /// there is none.
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
