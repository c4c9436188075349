// SPDX-License-Identifier: BSD-3-Clause
// Blends the rays that one azimuth needs on a distorted map.
#ifndef skyline_FanBlend_h
#define skyline_FanBlend_h

#include "Geo/GroundMetric.h"
#include "Geo/RayFan.h"
#include "SlopeSearch.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace skyline
{

class Accumulator;

/// A rectangle of posts, and the range of directions and lengths of a fan that it uses.
struct FanTile
{
  PostRegion Posts;
  std::size_t FirstDirection, LastDirection, FirstLength, LastLength;
};

/// Blends the searches of a fan: the slope of each post is that of the neighbouring rays, weighted
/// by their nearness and converted to the length that a step has at the post.
class FanBlend
{
public:
  explicit FanBlend(const GroundMetric& metric);

  /// Starts the next azimuth. The fan must outlive it.
  void Begin(const RayFan& fan);

  /// Finds the posts that need direction i with length j. Returns false if there are none.
  bool Asks(std::size_t direction, std::size_t length, PostRegion& posts);

  /// Finds the slopes of these posts with the method, which must be prepared, and adds them by
  /// weight.
  void Add(const HorizonMethod& method);

  /// Passes the slopes of the azimuth to the consumer.
  void End(Accumulator& consumer);

  /// Converts slopes of posts in a row to the length of a step at each post.
  static void Lengthen(const GroundMetric& metric, const RayFrame& frame, std::ptrdiff_t row,
    std::ptrdiff_t column, std::ptrdiff_t count, float* slopes);

  /// Floats per post that this class needs.
  static constexpr std::ptrdiff_t Floats = 2;

private:
  void Divide(const PostRegion& posts);

  const GroundMetric& Metric;
  const RayFan* Fan = nullptr;
  std::vector<FanTile> Tiles;
  std::size_t Direction = 0, Length = 0;
  std::vector<PostRegion> Asked;
  std::unique_ptr<float[]> Sums, Known; ///< of weighted slopes, and of weights with terrain
};

} // namespace skyline

#endif
