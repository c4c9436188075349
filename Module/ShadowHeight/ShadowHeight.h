// SPDX-License-Identifier: BSD-3-Clause
// The height below which a point above a post lies in the shadow of the terrain, exactly.
#ifndef skyline_ShadowHeight_h
#define skyline_ShadowHeight_h

#include "Horizon/HorizonMethod.h"
#include "ShadowHeight/ShadowHeightTiles.h"
#include "Shared/Constants.h"
#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// What stands for a shadow height where no terrain lies towards the light.
constexpr float NoShadow = MissingHeight;

/// Every shadow height of terrain lies above, every one with a share of a missing post below.
constexpr float LeastShadowHeight = -1.0e14f;

/// Lights that stand higher, radians, cast their shadows as from here: 89.9 degrees. A wall of 573 m
/// then darkens one metre of the ground.
constexpr double HighestShadowLight = 89.9 * RadiansPerDegree;

/// The fall of a ray of light in metres a metre: the tangent of its elevation (radians), which counts
/// as 0 below the horizontal plane and as HighestShadowLight above that.
SKYLINECORE_EXPORT double ShadowSlope(double elevation);

/// Shadow heights of a directional light: the greatest  z - slope d - sink d^2  over all crossings, at
/// distance d > 0 and height z, of a vertical plane towards the light with the edges of the
/// triangulated surface. A point above the post is in shadow if it lies below; the post itself is if
/// its horizon stands above the light. Never cut off at the post's own height, so that it may lie
/// below the ground: how much the shadow misses by.
///
/// Driven as a method of horizons is; Find gives shadow heights, metres above the field's base, in
/// place of slopes, and NoShadow where no terrain lies towards the light. Edges near the receiver come
/// first; further tiles of posts are looked at only while their highest post could still shade a
/// receiver of the block. The time is linear in posts unless the light stands so low that most of the
/// field lies above the rays (Documentation/shadow-height.md).
class SKYLINECORE_EXPORT ShadowHeightExact : public HorizonMethod
{
public:
  /// The light's ShadowSlope; sink as in HorizonSettings. The field is closed and outlives this.
  ShadowHeightExact(const HeightField& field, double slope, double sink);

  void SetAzimuth(const Grid& grid, double azimuth) override;
  std::ptrdiff_t PrepareCount() const override { return 0; }
  void Prepare(std::ptrdiff_t, std::ptrdiff_t) override {}
  void Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
    std::ptrdiff_t laneEnd, float* heights, std::ptrdiff_t stride) const override;

private:
  const HeightField& Field;
  double Slope, Sink;
  double FallPerLine = 0.0;
  ShadowHeightTiles RowTiles, ColumnTiles;
};

/// What the search of a range of receivers reads.
struct ShadowHeightTask
{
  const RayFrame& Frame; ///< its steps hold weights that sum to 1, and falls in place of sinks
  const ShadowHeightTiles& Tiles;
  double FallPerLine, SinkPerLine2; ///< metres
  bool Holes;
  std::ptrdiff_t LineBegin, LineEnd, LaneBegin, LaneEnd;
  float* Heights;
  std::ptrdiff_t Stride;
};

} // namespace skyline

#endif
