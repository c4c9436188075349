// SPDX-License-Identifier: BSD-3-Clause
// Consumers of horizons. They receive the horizons azimuth by azimuth, so that these need not be
// stored.
#ifndef skyline_Accumulator_h
#define skyline_Accumulator_h

#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>

namespace skyline
{

/// A consumer of horizons. For each azimuth, the driver calls Begin once (in one thread) and then
/// Add once for each post, in runs along a row of posts (many threads, disjoint runs). After the
/// last azimuth it calls Finish once for each row (many threads, disjoint rows).
class SKYLINECORE_EXPORT Accumulator
{
public:
  virtual ~Accumulator() = default;

  /// Starts the next azimuth: radians clockwise from grid north, and the width in radians of the
  /// swath that it stands for (2 pi / N for N azimuths around the circle).
  virtual void Begin(double azimuth, double width) = 0;

  /// Adds the slopes (tangents of the horizon elevation, NoTerrainSlope without terrain) of the
  /// posts (column .. column + count - 1, row) in the current azimuth.
  virtual void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes) = 0;

  /// Converts the sums of the posts of rows [rowBegin, rowEnd) to results.
  virtual void Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd) = 0;
};

} // namespace skyline

#endif
