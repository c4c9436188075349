// SPDX-License-Identifier: BSD-3-Clause
// Keeps every horizon: the one consumer that needs memory for each azimuth.
#ifndef skyline_StoreAccumulator_h
#define skyline_StoreAccumulator_h

#include "Horizon/Accumulator.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>

namespace skyline
{

/// Writes horizon elevations in degrees, greatest error 8e-6; -90 exactly where no terrain lies.
/// Components side by side: until Finish, some hundred posts of a row share a block, azimuth by
/// azimuth, where their tuples will lie. An azimuth then writes whole lines of the cache, and nothing
/// is stored beside the result.
class SKYLINECORE_EXPORT StoreAccumulator : public Accumulator
{
public:
  /// The k-th Begin's elevation of post (column, row) goes to
  /// values[(row * columns + column) * postStride + k * azimuthStride]. VTK's components side by
  /// side: postStride = number of azimuths, all of which must come, azimuthStride = 1. Bands of a
  /// raster: postStride = 1, azimuthStride = columns * rows.
  StoreAccumulator(std::ptrdiff_t columns, float* values, std::ptrdiff_t postStride,
    std::ptrdiff_t azimuthStride = 1);

  void Begin(double azimuth, double width) override;
  void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes) override;
  void Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd) override;

private:
  std::ptrdiff_t Columns;
  float* Values;
  std::ptrdiff_t PostStride;
  std::ptrdiff_t AzimuthStride;
  std::ptrdiff_t Azimuth = -1; ///< index of the current one
};

} // namespace skyline

#endif
