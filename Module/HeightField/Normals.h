// SPDX-License-Identifier: BSD-3-Clause
// The tilted surface at the posts: gradients of the heights.
#ifndef skyline_Normals_h
#define skyline_Normals_h

#include "HeightField/Grid.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace skyline
{

/// Heights in an array: post (column, row) is Values[column * ColumnStride + row * RowStride]. It
/// can be called like a function that returns a height.
template <class Height>
struct PostView
{
  const Height* Values = nullptr;
  std::ptrdiff_t ColumnStride = 1; ///< elements from a column to the next
  std::ptrdiff_t RowStride = 0;    ///< elements from a row to the next one to the north

  Height operator()(std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    return this->Values[column * this->ColumnStride + row * this->RowStride];
  }
};

/// Rise per metre along one axis, from the height of a post and those of its neighbours before and
/// after. A neighbour that is not finite is missing. Central difference; one-sided beside a missing
/// neighbour; 0 between two missing ones.
inline float AxisGradient(double before, double here, double after, double spacing)
{
  const bool hasBefore = std::isfinite(before);
  const bool hasAfter = std::isfinite(after);
  // The difference is taken first, in double, so that millimetres are kept at heights of 1e7 m.
  const double rise = (hasAfter ? after : here) - (hasBefore ? before : here);
  const int steps = static_cast<int>(hasBefore) + static_cast<int>(hasAfter);
  return steps == 0 ? 0.0f : static_cast<float>(rise / (steps * spacing));
}

/// Computes the gradients of the posts of rows [rowBegin, rowEnd): dz/dx goes to
/// east[row * columns + column] and dz/dy to north likewise. The upward normal is
/// (-dz/dx, -dz/dy, 1), not normalised. Gradients are central differences, one-sided at the edge
/// and beside missing posts, 0 if both neighbours are missing, and NaN at a missing post (NaN or
/// infinite).
///
/// height(column, row): metres, of any arithmetic type; the rows beside the range are read too.
/// spacingX, spacingY: metres between columns and between rows, one value of each per row from the
/// south; null: the spacing of the grid. Different threads may process disjoint ranges.
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
