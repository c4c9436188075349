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

/// A rectangle of posts, and which directions and lengths of a fan it uses.
struct FanTile
{
  PostRegion Posts;
  std::size_t FirstDirection, LastDirection, FirstLength, LastLength;
};

/// Blends the searches of a fan: at every post those of the neighbouring rays, each in proportion to its
/// nearness, with slopes brought to the post's own length.
class FanBlend
{
public:
  explicit FanBlend(const GroundMetric& metric);

  /// The next azimuth. The fan must outlive it.
  void Begin(const RayFan& fan);

  /// The posts that need direction i with length j; false if there are none.
  bool Asks(std::size_t direction, std::size_t length, PostRegion& posts);

  /// Finds their slopes with the method, which is prepared for them, and takes its part.
  void Add(const HorizonMethod& method);

  /// Hands the azimuth's slopes on.
  void End(Accumulator& consumer);

  /// Brings slopes of posts of a row to their own length.
  static void Lengthen(const GroundMetric& metric, const RayFrame& frame, std::ptrdiff_t row,
    std::ptrdiff_t column, std::ptrdiff_t count, float* slopes);

  /// Floats a post that it needs.
  static constexpr std::ptrdiff_t Floats = 2;

private:
  void Divide(const PostRegion& posts);

  const GroundMetric& Metric;
  const RayFan* Fan = nullptr;
  std::vector<FanTile> Tiles;
  std::size_t Direction = 0, Length = 0;
  std::vector<PostRegion> Asked;
  std::unique_ptr<float[]> Sums, Known; ///< of slopes by weight, and of the weights with terrain
};

} // namespace skyline

#endif
