// SPDX-License-Identifier: BSD-3-Clause
// Runs a prepared method over a part of the posts, in threads, and hands its slopes on in rows.
#ifndef skyline_SlopeSearch_h
#define skyline_SlopeSearch_h

#include "GroundMetric.h"
#include "GroundPatches.h"
#include "HorizonMethod.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace skyline
{

class Accumulator;

/// Rows [RowBegin, RowEnd) and columns [ColumnBegin, ColumnEnd) of posts.
struct PostRegion
{
  std::ptrdiff_t RowBegin, RowEnd, ColumnBegin, ColumnEnd;
};

/// Takes the slopes of posts (column .. column + count - 1, row), which it may change; called from many
/// threads, for disjoint posts.
using SlopeTaker =
  std::function<void(std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, float* slopes)>;

/// The region's slopes in the azimuth that the method is prepared for. The same region gives the same
/// bits, whatever the number of threads.
void FindSlopes(const HorizonMethod& method, const PostRegion& region, const SlopeTaker& take);

/// Tells the method which posts of the field will be asked for.
void AskFor(HorizonMethod& method, const PostRegion& region);

/// Turns slopes found with the metric of a patch into those of each post's own, and blends patches.
class PatchBlend
{
public:
  PatchBlend(const GroundMetric& metric, const GroundPatches& patches);

  /// Forgets the azimuth before.
  void Begin();

  /// Finds and takes the slopes of the patch of a side of columns and one of rows; those that no other
  /// patch shares go to the consumer at once.
  void Add(const HorizonMethod& method, const PatchSide& columns, const PatchSide& rows,
    Accumulator& consumer);

  /// Hands the others on.
  void End(Accumulator& consumer);

  /// Floats a post that it needs.
  static std::ptrdiff_t Floats(const GroundPatches& patches) { return patches.Count() > 1 ? 2 : 0; }

private:
  bool Shared(std::ptrdiff_t row) const;

  const GroundMetric& Metric;
  const GroundPatches& Patches;
  std::ptrdiff_t Columns, Rows;
  std::unique_ptr<float[]> Sums, Known; ///< of slopes by weight, and of the weights with terrain
  std::vector<bool> SharedRows;
};

} // namespace skyline

#endif
