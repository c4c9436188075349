// SPDX-License-Identifier: BSD-3-Clause
// The grid of posts that all kernels use.
#ifndef skyline_Grid_h
#define skyline_Grid_h

#include <cstddef>

namespace skyline
{

/// A regular grid of posts. Rows are counted northward and columns eastward; row 0 is the southern
/// edge. The next row lies at (0, SpacingY) and the next column at (SpacingX, Shear), in metres.
struct Grid
{
  std::ptrdiff_t Columns = 0; ///< posts from west to east, at least 2
  std::ptrdiff_t Rows = 0;    ///< posts from south to north, at least 2
  double SpacingX = 1.0;      ///< metres between columns, above 0
  double SpacingY = 1.0;      ///< metres between rows, above 0
  double Shear = 0.0;         ///< metres by which each column lies further north than the one
                              ///< before
};

/// The surface between the posts.
enum class Surface
{
  Triangles, ///< each cell is split from its (i, j) to its (i + 1, j + 1) post
  Bilinear   ///< each cell is a bilinear patch; maxima inside it count
};

} // namespace skyline

#endif
