// SPDX-License-Identifier: BSD-3-Clause
// How much of the horizon around a post is known from data.
#ifndef skyline_EdgeTrustAccumulator_h
#define skyline_EdgeTrustAccumulator_h

#include "HeightField/HeightField.h"
#include "Horizon/Accumulator.h"
#include "Horizon/PostBuffer.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstdint>
#include <vector>

namespace skyline
{

/// The share of the azimuths, 0 to 1, in which the data reach at least a distance from the post: the
/// post nearest to the point at that distance is one of the surface's, or terrain lies beyond it. Holes
/// in between do not count. With distance 0: the azimuths in which any terrain lies.
///
/// Memory: two bytes a post beside the result.
class SKYLINECORE_EXPORT EdgeTrustAccumulator : public Accumulator
{
public:
  /// `distance`: metres, 0 or more. `rowSpacingX`, `rowSpacingY`: metres between columns and rows, one
  /// a row; null: the field's own. The field and they must outlive the accumulator.
  EdgeTrustAccumulator(const HeightField& field, double distance, const PostBuffer& trust,
    const double* rowSpacingX = nullptr, const double* rowSpacingY = nullptr);

  void Begin(double azimuth, double width) override;
  void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes) override;
  void Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd) override;

private:
  /// What an azimuth says of all posts, and metres from a post to the point at the distance.
  struct View
  {
    std::vector<std::uint8_t> Posts; ///< bits
    double East = 0.0, North = 0.0;
  };
  void Count(
    const View& view, std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count) const;

  bool LiesBeyond(
    const View& view, std::ptrdiff_t row, std::ptrdiff_t column, double right, double up) const;

  const HeightField& Field;
  double Distance;
  PostBuffer Trust; ///< until Finish: azimuths counted
  const double* RowSpacingX;
  const double* RowSpacingY;
  View Now, Before; ///< of this azimuth and the one before
  int Azimuths = 0; ///< begun
};

} // namespace skyline

#endif
