// SPDX-License-Identifier: BSD-3-Clause
// The receiver's plane: gradients of the heights at the posts.
#ifndef skyline_Normals_h
#define skyline_Normals_h

#include "HeightField/Grid.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace skyline
{

/// Heights where they lie: post (column, row) is Values[column * ColumnStride + row * RowStride].
/// Calling it gives a height, so it stands wherever a callback does.
template <class Height>
struct PostView
{
  const Height* Values = nullptr;
  std::ptrdiff_t ColumnStride = 1; ///< elements from a column to the next
  std::ptrdiff_t RowStride = 0;    ///< elements from a row to the next northward

  Height operator()(std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    return this->Values[column * this->ColumnStride + row * this->RowStride];
  }
};

/// Rise per metre along one axis, from the height of a post and of its neighbours before and after;
/// a neighbour that is not finite is missing. Central difference, one-sided beside a missing
/// neighbour, 0 between two.
inline float AxisGradient(double before, double here, double after, double spacing)
{
  const bool hasBefore = std::isfinite(before);
  const bool hasAfter = std::isfinite(after);
  // The difference comes first, in double: millimetres on a height of 1e7 m keep their digits.
  const double rise = (hasAfter ? after : here) - (hasBefore ? before : here);
  const int steps = static_cast<int>(hasBefore) + static_cast<int>(hasAfter);
  return steps == 0 ? 0.0f : static_cast<float>(rise / (steps * spacing));
}

/// Gradients of the posts of rows [rowBegin, rowEnd): dz/dx to east[row * columns + column], dz/dy
/// likewise to north. The upward normal is (-dz/dx, -dz/dy, 1), not normalised. Central
/// differences, one-sided at the edge and beside missing posts, 0 where neither neighbour exists,
/// NaN at a missing post (NaN or infinite).
///
/// height(column, row): metres, of any arithmetic type; rows of posts beside the range are read
/// too. spacingX, spacingY: metres between columns and between rows, one of each a row from the
/// south; null: the grid's. Disjoint ranges may be filled by different threads.
template <class HeightAt>
void Gradients(const Grid& grid, const HeightAt& height, std::ptrdiff_t rowBegin,
  std::ptrdiff_t rowEnd, float* east, float* north, const double* spacingX = nullptr,
  const double* spacingY = nullptr)
{
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  const auto at = [&](std::ptrdiff_t column, std::ptrdiff_t row)
  { return static_cast<double>(height(column, row)); };
  for (std::ptrdiff_t row = rowBegin; row < rowEnd; ++row)
  {
    const double dx = spacingX ? spacingX[row] : grid.SpacingX;
    const double dy = spacingY ? spacingY[row] : grid.SpacingY;
    double before = missing;
    double here = at(0, row);
    for (std::ptrdiff_t column = 0; column < grid.Columns; ++column)
    {
      const double after = column + 1 < grid.Columns ? at(column + 1, row) : missing;
      const std::ptrdiff_t post = row * grid.Columns + column;
      if (std::isfinite(here))
      {
        const double south = row > 0 ? at(column, row - 1) : missing;
        const double beyond = row + 1 < grid.Rows ? at(column, row + 1) : missing;
        east[post] = AxisGradient(before, here, after, dx);
        north[post] = AxisGradient(south, here, beyond, dy);
      }
      else
      {
        east[post] = north[post] = std::numeric_limits<float>::quiet_NaN();
      }
      before = here;
      here = after;
    }
  }
}

} // namespace skyline

#endif
