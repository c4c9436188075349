// SPDX-License-Identifier: BSD-3-Clause
// Keeps every horizon: the one consumer that needs memory for each azimuth.
#ifndef skyline_StoreAccumulator_h
#define skyline_StoreAccumulator_h

#include "Accumulator.h"

#include <cstddef>
#include <vector>

namespace skyline
{

/// Writes horizon elevations in degrees, greatest error 8e-6; -90 exactly where no terrain lies.
/// Components side by side are gathered for 16 azimuths, in 15 floats a post, and written together:
/// a post's tuple is then fetched into the cache once a batch, not once an azimuth.
class StoreAccumulator : public Accumulator
{
public:
  /// The k-th Begin's elevation of post (column, row) goes to
  /// values[(row * columns + column) * postStride + k * azimuthStride]. VTK's components side by
  /// side: postStride = number of azimuths, azimuthStride = 1. Bands of a raster: postStride = 1,
  /// azimuthStride = columns * rows.
  StoreAccumulator(std::ptrdiff_t columns, std::ptrdiff_t rows, float* values,
    std::ptrdiff_t postStride, std::ptrdiff_t azimuthStride = 1);

  void Begin(double azimuth, double width) override;
  void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes) override;
  void Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd) override;

private:
  void WriteBatch(std::ptrdiff_t post, std::ptrdiff_t count, std::ptrdiff_t gathered);

  std::ptrdiff_t Columns;
  std::ptrdiff_t Posts;
  float* Values;
  std::ptrdiff_t PostStride;
  std::ptrdiff_t AzimuthStride;
  std::ptrdiff_t Batch;        ///< azimuths that are written together
  std::ptrdiff_t Azimuth = -1; ///< index of the current one
  std::vector<float> Gathered; ///< planes of the batch so far; none where posts lie side by side
};

} // namespace skyline

#endif
