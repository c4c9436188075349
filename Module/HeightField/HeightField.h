// SPDX-License-Identifier: BSD-3-Clause
// The posts as the kernels read them: as padded floats, by rows and by columns.
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

/// Heights line by line with a margin of missing posts, so that a kernel may read whole vectors
/// beyond the edge of the data and one line beyond the first and last lines.
class PaddedPlane
{
public:
  static constexpr std::ptrdiff_t Margin =
    48; ///< lanes before and after a line: a block of 32 and its reach

  PaddedPlane() = default;
  PaddedPlane(std::ptrdiff_t lines, std::ptrdiff_t lanes)
    : Lines(lines)
    , Lanes(lanes)
    , Stride(((lanes + 2 * Margin + 15) / 16 | 1) * 16) // odd: uses all sets of the cache
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
  std::ptrdiff_t Lanes = 0;  ///< posts per line
  std::ptrdiff_t Stride = 0; ///< floats from a line to the next

private:
  std::vector<float> Values;
};

/// Marks where a plane has missing posts: one byte for each run of lanes of a line, not 0 if a post
/// of the run is missing.
struct MissingMap
{
  static constexpr std::ptrdiff_t RunLanes = 32;

  std::ptrdiff_t Lines = 0; ///< lines of posts; 0 if no post of the field is missing
  std::ptrdiff_t Runs = 0;  ///< runs per line
  std::vector<std::uint8_t> Missing;

  const std::uint8_t* Line(std::ptrdiff_t line) const
  {
    return this->Missing.data() + line * this->Runs;
  }
};

/// The posts of the surface. Heights are stored as metres above a base height, so that the 24 bits
/// of a float resolve the relief and not the height: with heights of 1e7 m, differences are still
/// exact.
class SKYLINECORE_EXPORT HeightField
{
public:
  /// grid: at least 2 columns and 2 rows, and spacings within the limits of HeightLimits.h; throws
  /// std::invalid_argument otherwise.
  HeightField(const Grid& grid);

  /// Copies the posts of rows [rowBegin, rowEnd), less `base`. height(column, row) returns a
  /// double: NaN or infinite for a missing post, otherwise within GreatestHeight. Disjoint ranges
  /// may be filled in parallel.
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

  /// Finds the missing posts. Call it once, after the last Fill and before any of the functions
  /// below.
  void Close();

  /// Makes the transposed copy that azimuths near east and west need; later calls do nothing.
  void Transpose();

  const Grid& Posts() const { return this->Lattice; }
  bool HasMissing() const { return this->Missing; }
  bool AllMissing() const { return !this->Any; }
  float LargestHeight() const { return this->Largest; } ///< greatest |height - base|, metres

  /// The posts that occlude; lines are rows of the image (RowPlane) or columns (ColumnPlane).
  const PaddedPlane& RowPlane() const { return this->Rows; }
  const PaddedPlane& ColumnPlane() const { return this->Columns; }

  /// The missing posts of the row plane or, after Transpose, of the column plane. Posts outside
  /// every complete cell count as missing.
  const MissingMap& MissingPosts(bool columns) const
  {
    return columns ? this->MissingInColumns : this->MissingInRows;
  }

  /// The heights of the receivers of a line (a row, or a column if `columns`). This is the line of
  /// the plane itself, or `buffer` (one float per post of the line) if the line has posts that
  /// receive but do not occlude, because they lie outside every complete cell. Missing posts have
  /// MissingHeight.
  const float* Receivers(bool columns, std::ptrdiff_t line, std::vector<float>& buffer) const;

private:
  bool CellComplete(std::ptrdiff_t column, std::ptrdiff_t row) const;

  struct IsolatedPost // outside every complete cell, and therefore without surface
  {
    std::ptrdiff_t Line, Lane;
    float Height;
  };

  Grid Lattice;
  PaddedPlane Rows, Columns;
  std::vector<IsolatedPost> IsolatedInRows, IsolatedInColumns; // sorted by line
  MissingMap MissingInRows, MissingInColumns;
  float Largest = 0.0f;
  bool Missing = false;
  bool Any = false; ///< true if some post has a height
};

} // namespace skyline

#endif
