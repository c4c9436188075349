// SPDX-License-Identifier: BSD-3-Clause
// Stores all horizons. This is the only accumulator that needs memory for each azimuth.
#ifndef skyline_StoreAccumulator_h
#define skyline_StoreAccumulator_h

#include "Horizon/Accumulator.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>

namespace skyline
{

/// Writes horizon elevations in degrees, with an error of at most 8e-6, and exactly -90 without
/// terrain. If components lie side by side, some hundred posts of a row share a block until Finish,
/// azimuth by azimuth, in the memory of their tuples. An azimuth then writes whole cache lines, and
/// no other memory is needed.
class SKYLINECORE_EXPORT StoreAccumulator : public Accumulator
{
public:
  /// The elevation of the k-th call of Begin at post (column, row) is written to values[(row *
  /// columns + column) * postStride + k * azimuthStride]. For components side by side, as in VTK:
  /// postStride = number of azimuths, all of which must be added, and azimuthStride = 1. For bands
  /// of a raster: postStride = 1, azimuthStride = columns * rows.
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
  std::ptrdiff_t Azimuth = -1; ///< index of the current azimuth
};

} // namespace skyline

#endif
