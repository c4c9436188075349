// SPDX-License-Identifier: BSD-3-Clause
// How much of the sun's disc stands above the horizon of each post.
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

/// Writes unit vectors to the sun (x east, y north, z up, on the grid's axes) of the posts
/// (column .. column + count - 1, row); called from many threads.
using SunDirections = std::function<void(
  std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, float* x, float* y, float* z)>;

/// The lit fraction of a disc over the horizon curve, linear in elevation between the azimuths: 0
/// to 1, exactly 0 or 1 where all or nothing is covered. Feed it rising azimuths, those of
/// SunAzimuths or closer ones (never more than a right angle apart), over every swath; the disc's
/// part outside of them is left out, and a post whose disc lies outside of all gets NaN. Widths are
/// ignored.
///
/// Sunlight, as that of the sky, comes from above the horizontal plane alone: a horizon below 0
/// counts as 0. What lies beyond the data is unknown, and without it a midnight sun would light
/// every post that looks down to the edge.
///
/// With radius 0 the sun is a point: lit or not at its own azimuth, or at the azimuth given first
/// if its own is outside of all.
///
/// Memory: one float a post beside the result, two if the sun differs from post to post.
class SKYLINECORE_EXPORT SunAccumulator : public Accumulator
{
public:
  /// The same sun over all posts.
  SunAccumulator(std::ptrdiff_t columns, std::ptrdiff_t rows, const SunDisc& sun,
    const PostBuffer& visibility, double limbDarkening = 0.0);

  /// A sun for each post, of one radius (radians, 0 up to pi/2).
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
  SunDirections Directions; ///< empty: Sun is everywhere
  PostBuffer Visibility;    ///< until Finish: light hidden (one sun) or lit (a sun for each post)
  double LimbDarkening;
  std::unique_ptr<float[]> Previous; ///< slopes of the azimuth before
  std::unique_ptr<float[]> Hidden;   ///< light hidden, if there is a sun for each post

  bool Started = false;          ///< an azimuth has begun
  bool First = true;             ///< the current azimuth is the first
  double Azimuth = 0.0;          ///< the current one
  double Before = 0.0;           ///< the one before
  double Interval = 0.0;         ///< from the azimuth before, radians
  double Sin0 = 0.0, Cos0 = 1.0; ///< sine and cosine of the azimuth before
  double Sin1 = 0.0, Cos1 = 1.0; ///< and of the current one
  DiscSlice Slice;               ///< of the one sun, in the interval
  float SliceLight = 0.0f;
  double PointPlace = -1.0; ///< of a sun of radius 0 in the interval, 0 to 1; below 0: outside
  float Whole = 0.0f;       ///< of the one sun so far, summed like its hidden light
};

} // namespace skyline

#endif
