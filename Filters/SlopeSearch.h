// SPDX-License-Identifier: BSD-3-Clause
// Runs a prepared method over a part of the posts, in threads, and hands its slopes on in rows.
#ifndef skyline_SlopeSearch_h
#define skyline_SlopeSearch_h

#include "Horizon/HorizonMethod.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace skyline
{

/// Rows [RowBegin, RowEnd) and columns [ColumnBegin, ColumnEnd) of posts.
struct PostRegion
{
  std::ptrdiff_t RowBegin, RowEnd, ColumnBegin, ColumnEnd;
};

/// Takes the slopes of posts (column .. column + count - 1, row), which it may change; called from many
/// threads, for disjoint posts.
using SlopeTaker = std::function<void(
  std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, float* slopes)>;

/// The region's slopes in the azimuth that the method is prepared for. The same region gives the same
/// bits, whatever the number of threads.
void FindSlopes(const HorizonMethod& method, const PostRegion& region, const SlopeTaker& take);

/// Tells the method which posts of the field will be asked for.
void AskFor(HorizonMethod& method, const PostRegion& region);

/// The same for parts of the field, which are any rectangles of up to SearchRows rows and SearchColumns
/// columns that do not overlap.
void FindParts(
  const HorizonMethod& method, const std::vector<PostRegion>& parts, const SlopeTaker& take);
constexpr std::ptrdiff_t SearchRows = 64, SearchColumns = 4 * SearchRows;

} // namespace skyline

#endif
