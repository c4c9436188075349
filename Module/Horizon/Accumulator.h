// SPDX-License-Identifier: BSD-3-Clause
// What consumes horizons: fed azimuth by azimuth, so that no scene stores all of them.
#ifndef skyline_Accumulator_h
#define skyline_Accumulator_h

#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>

namespace skyline
{

/// A consumer of horizons. The driver calls Begin once for every azimuth (one thread), then Add for
/// every post once, in runs along a row of posts (many threads, disjoint runs), and after the last
/// azimuth Finish for every row once (many threads, disjoint rows).
class SKYLINECORE_EXPORT Accumulator
{
public:
  virtual ~Accumulator() = default;

  /// The next azimuth: radians clockwise from grid north, and the width of the swath it stands for
  /// in radians (2 pi / N for N azimuths around).
  virtual void Begin(double azimuth, double width) = 0;

  /// Slopes (tangents of the horizon elevation, NoTerrainSlope where no terrain lies) of the posts
  /// (column .. column + count - 1, row) in the current azimuth.
  virtual void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes) = 0;

  /// Turns the sums of the posts of rows [rowBegin, rowEnd) into results.
  virtual void Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd) = 0;
};

} // namespace skyline

#endif
