// SPDX-License-Identifier: BSD-3-Clause
// Edge trust: how much of the horizon around a post is known from data.
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

/// The share of azimuths, 0 to 1, in which the data reach to a distance from the post or further:
/// the post nearest to the point at this distance is not missing, or terrain lies beyond it.
/// Missing posts in between do not count. With distance 0, the share of azimuths in which there is
/// any terrain.
///
/// Memory: two bytes per post beside the result.
class SKYLINECORE_EXPORT EdgeTrustAccumulator : public Accumulator
{
public:
  /// `distance`: metres, 0 or more. `rowSpacingX`, `rowSpacingY`: metres between columns and
  /// between rows, one value per row; null: the spacing of the field. The arguments must outlive
  /// the accumulator.
  EdgeTrustAccumulator(const HeightField& field, double distance, const PostBuffer& trust,
    const double* rowSpacingX = nullptr, const double* rowSpacingY = nullptr);

  void Begin(double azimuth, double width) override;
  void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes) override;
  void Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd) override;

private:
  /// The results of all posts in one azimuth, and the metres from a post to the point at the
  /// distance.
  struct View
  {
    std::vector<std::uint8_t> Posts; ///< flags of each post
    double East = 0.0, North = 0.0;
  };
  void Count(
    const View& view, std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count) const;

  bool LiesBeyond(
    const View& view, std::ptrdiff_t row, std::ptrdiff_t column, double right, double up) const;

  const HeightField& Field;
  double Distance;
  PostBuffer Trust; ///< before Finish: number of azimuths counted
  const double* RowSpacingX;
  const double* RowSpacingY;
  View Now, Before; ///< of the current azimuth and of the previous one
  int Azimuths = 0; ///< number of azimuths begun
};

} // namespace skyline

#endif
