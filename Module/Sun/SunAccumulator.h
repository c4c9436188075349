// SPDX-License-Identifier: BSD-3-Clause
// Sun visibility: the share of the disc of the sun above the horizon of each post.
#ifndef skyline_SunAccumulator_h
#define skyline_SunAccumulator_h

#include "Horizon/Accumulator.h"
#include "Horizon/PostBuffer.h"
#include "SkylineCoreModule.h" // for the export macro
#include "Sun/SunDisc.h"

#include <array>
#include <functional>
#include <memory>

namespace skyline
{

/// Writes unit vectors to the sun (x east, y north, z up, on the axes of the grid) for the posts
/// (column .. column + count - 1, row). Called from many threads.
using SunDirections = std::function<void(
  std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, float* x, float* y, float* z)>;

/// The visible share of the disc of the sun, 0 to 1, exactly 0 or 1 if all or nothing is hidden.
/// The horizon is linear in elevation between azimuths. Azimuths must be added in rising order:
/// those of SunAzimuths or closer ones (at most a right angle apart), over all swaths of the sun.
/// Parts of the disc outside these azimuths are left out; a post whose disc lies entirely outside
/// gets NaN. The widths passed to Begin are ignored.
///
/// Like the light of the sky, sunlight comes only from above the horizontal plane: a horizon below
/// 0 counts as 0. Terrain beyond the data is unknown; otherwise a midnight sun would light all
/// posts that look down to the edge of the data.
///
/// With radius 0 the sun is a point, which is visible or hidden at its own azimuth, or at the first
/// azimuth if its own lies outside all of them.
///
/// Memory: one float per post beside the result, or two if the sun differs from post to post.
class SKYLINECORE_EXPORT SunAccumulator : public Accumulator
{
public:
  /// The same sun at all posts.
  SunAccumulator(std::ptrdiff_t columns, std::ptrdiff_t rows, const SunDisc& sun,
    const PostBuffer& visibility, double limbDarkening = 0.0);

  /// A sun for each post, all with one radius (radians, 0 to pi/2).
  SunAccumulator(std::ptrdiff_t columns, std::ptrdiff_t rows, const SunDirections& directions,
    double radius, const PostBuffer& visibility, double limbDarkening = 0.0);

  void Begin(double azimuth, double width) override;
  void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes) override;
  void Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd) override;

private:
  void AddSame(std::ptrdiff_t post, std::ptrdiff_t count, const float* slopes);
  void AddSamePoint(std::ptrdiff_t post, std::ptrdiff_t count, const float* slopes);
  void AddEach(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes);
  void AddOne(std::ptrdiff_t post, float last, const std::array<double, 3>& sun, DiscSlice& slice);
  float& Result(std::ptrdiff_t post)
  {
    return this->Visibility.Values[post * this->Visibility.Stride];
  }

  std::ptrdiff_t Columns;
  SunDisc Sun;
  SunDirections Directions; ///< empty: Sun is used at all posts
  PostBuffer Visibility;    ///< before Finish: hidden light (one sun) or visible light (a sun for
                            ///< each post)
  double LimbDarkening;
  std::unique_ptr<float[]> Previous; ///< slopes in the previous azimuth
  std::unique_ptr<float[]> Hidden;   ///< hidden light, if there is a sun for each post

  bool Started = false;          ///< an azimuth has begun
  bool First = true;             ///< the current azimuth is the first
  double Azimuth = 0.0;          ///< the current azimuth
  double Before = 0.0;           ///< the previous azimuth
  double Interval = 0.0;         ///< width from the previous azimuth, radians
  double Sin0 = 0.0, Cos0 = 1.0; ///< sine and cosine of the previous azimuth
  double Sin1 = 0.0, Cos1 = 1.0; ///< sine and cosine of the current azimuth
  DiscSlice Slice;               ///< part of the disc in the interval, for one sun
  float SliceLight = 0.0f;
  double PointPlace = -1.0; ///< position of a sun of radius 0 in the interval, 0 to 1; below 0:
                            ///< outside
  float Whole = 0.0f;       ///< light of the one sun so far, summed in the same way as its hidden
                            ///< light
};

} // namespace skyline

#endif
