// SPDX-License-Identifier: BSD-3-Clause
// Runs a prepared method over a part of the posts, in threads, and passes on the slopes in rows.
#ifndef skyline_SlopeSearch_h
#define skyline_SlopeSearch_h

#include "Horizon/HorizonMethod.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace skyline
{

/// The rows [RowBegin, RowEnd) and columns [ColumnBegin, ColumnEnd) of posts.
struct PostRegion
{
  std::ptrdiff_t RowBegin, RowEnd, ColumnBegin, ColumnEnd;
};

/// Receives the slopes of the posts (column .. column + count - 1, row) and may change them. It is
/// called from many threads, for disjoint posts.
using SlopeTaker = std::function<void(
  std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, float* slopes)>;

/// Finds the slopes of the region in the azimuth that the method is prepared for. The same region
/// gives the same bits with any number of threads.
void FindSlopes(const HorizonMethod& method, const PostRegion& region, const SlopeTaker& take);

/// Tells the method which posts of the field will be requested.
void AskFor(HorizonMethod& method, const PostRegion& region);

/// The same for parts of the field: rectangles that do not overlap, of up to SearchRows rows and
/// SearchColumns columns.
void FindParts(
  const HorizonMethod& method, const std::vector<PostRegion>& parts, const SlopeTaker& take);
constexpr std::ptrdiff_t SearchRows = 64, SearchColumns = 4 * SearchRows;

} // namespace skyline

#endif
