// SPDX-License-Identifier: BSD-3-Clause
// The posts as the horizon kernels read them: float, padded, in both orders.
#ifndef skyline_HeightField_h
#define skyline_HeightField_h

#include "HeightField/Grid.h"
#include "Shared/Constants.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace skyline
{

/// Heights line by line with a margin of missing posts around, so that a kernel may read a whole
/// vector across the edge of the data and one line beyond its ends.
class PaddedPlane
{
public:
  static constexpr std::ptrdiff_t Margin =
    48; ///< lanes before and after a line: a block of 32 and its reach

  PaddedPlane() = default;
  PaddedPlane(std::ptrdiff_t lines, std::ptrdiff_t lanes)
    : Lines(lines)
    , Lanes(lanes)
    , Stride(((lanes + 2 * Margin + 15) / 16 | 1) * 16) // odd: lines spread over the cache's sets
    , Values(static_cast<std::size_t>((lines + 2) * Stride), MissingHeight)
  {
  }

  float* Line(std::ptrdiff_t line)
  {
    return this->Values.data() + (line + 1) * this->Stride + Margin;
  }
  const float* Line(std::ptrdiff_t line) const
  {
    return this->Values.data() + (line + 1) * this->Stride + Margin;
  }

  std::ptrdiff_t Lines = 0;  ///< lines of posts
  std::ptrdiff_t Lanes = 0;  ///< posts in a line
  std::ptrdiff_t Stride = 0; ///< floats from a line to the next

private:
  std::vector<float> Values;
};

/// Where a plane has missing posts: a byte for every run of lanes of a line, not 0 if one is missing.
struct MissingMap
{
  static constexpr std::ptrdiff_t RunLanes = 32;

  std::ptrdiff_t Lines = 0; ///< of posts; 0 if none of the field is missing
  std::ptrdiff_t Runs = 0;  ///< in a line
  std::vector<std::uint8_t> Missing;

  const std::uint8_t* Line(std::ptrdiff_t line) const
  {
    return this->Missing.data() + line * this->Runs;
  }
};

/// The surface's posts. Heights are metres above Base(), which keeps the differences of heights of
/// 1e7 m exact to the float's 24 bits of the relief, not of the height.
class SKYLINECORE_EXPORT HeightField
{
public:
  /// columns, rows: at least 2 each; spacings by HeightLimits.h; else std::invalid_argument.
  HeightField(const Grid& grid);

  /// Copies rows [rowBegin, rowEnd) of posts less `base`; height(column, row) is a double, NaN or
  /// infinite where missing, else within GreatestHeight. Disjoint ranges may be filled at once.
  template <typename Height>
  void Fill(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd, double base, const Height& height)
  {
    for (std::ptrdiff_t row = rowBegin; row < rowEnd; ++row)
    {
      float* line = this->Rows.Line(row);
      for (std::ptrdiff_t column = 0; column < this->Lattice.Columns; ++column)
      {
        const double value = height(column, row);
        line[column] = std::isfinite(value) ? static_cast<float>(value - base) : MissingHeight;
      }
    }
  }

  /// Finds the missing posts after the last Fill: call once, before any of the members below.
  void Close();

  /// Builds the transposed copy that azimuths near east and west read; does nothing the second time.
  void Transpose();

  const Grid& Posts() const { return this->Lattice; }
  bool HasMissing() const { return this->Missing; }
  bool AllMissing() const { return !this->Any; }
  float LargestHeight() const { return this->Largest; } ///< greatest |height - base|, metres

  /// Posts that occlude, lines = rows of the image, and lines = columns.
  const PaddedPlane& RowPlane() const { return this->Rows; }
  const PaddedPlane& ColumnPlane() const { return this->Columns; }

  /// Of the row plane, or after Transpose of the column plane; lonely posts count as missing.
  const MissingMap& MissingPosts(bool columns) const
  {
    return columns ? this->MissingInColumns : this->MissingInRows;
  }

  /// The heights of the receivers of a line (a row, or a column if `columns`): the plane's own line,
  /// or `buffer` (as many floats as the line has posts) if the line holds posts that receive but,
  /// outside every complete cell, do not occlude. Missing posts stay at MissingHeight.
  const float* Receivers(bool columns, std::ptrdiff_t line, std::vector<float>& buffer) const;

private:
  bool CellComplete(std::ptrdiff_t column, std::ptrdiff_t row) const;

  struct LonelyPost // outside every complete cell: it carries no surface
  {
    std::ptrdiff_t Line, Lane;
    float Height;
  };

  Grid Lattice;
  PaddedPlane Rows, Columns;
  std::vector<LonelyPost> LonelyInRows, LonelyInColumns; // sorted by line
  MissingMap MissingInRows, MissingInColumns;
  float Largest = 0.0f;
  bool Missing = false;
  bool Any = false; ///< some post has a height
};

} // namespace skyline

#endif
