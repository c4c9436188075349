// SPDX-License-Identifier: BSD-3-Clause
// The lattice of posts under every kernel.
#ifndef skyline_Grid_h
#define skyline_Grid_h

#include <cstddef>

namespace skyline
{

/// A regular lattice of posts. Rows run north, columns run east; row 0 is the south edge. The next row
/// lies at (0, SpacingY), the next column at (SpacingX, Shear), metres.
struct Grid
{
  std::ptrdiff_t Columns = 0; ///< posts from west to east, at least 2
  std::ptrdiff_t Rows = 0;    ///< posts from south to north, at least 2
  double SpacingX = 1.0;      ///< metres between columns, above 0
  double SpacingY = 1.0;      ///< metres between rows, above 0
  double Shear = 0.0;         ///< metres by which a column lies further north than the one before
};

/// The surface through the posts.
enum class Surface
{
  Triangles, ///< each cell split from its (i, j) to its (i + 1, j + 1) post
  Bilinear   ///< each cell a bilinear patch, maxima inside it counted
};

} // namespace skyline

#endif
