// SPDX-License-Identifier: BSD-3-Clause
// Exact shadow heights: the height above a post below which a point lies in the shadow of the
// terrain.
#ifndef skyline_ShadowHeight_h
#define skyline_ShadowHeight_h

#include "Horizon/HorizonMethod.h"
#include "ShadowHeight/ShadowHeightTiles.h"
#include "Shared/Constants.h"
#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// The shadow height where no terrain lies towards the light.
constexpr float NoShadow = MissingHeight;

/// A limit: all shadow heights of terrain lie above it, all with a share of a missing post below.
constexpr float LeastShadowHeight = -1.0e14f;

/// Greatest elevation of a light in radians, 89.9 degrees. Higher lights cast their shadows as from
/// there. A wall of 573 m then darkens one metre of the ground.
constexpr double HighestShadowLight = 89.9 * RadiansPerDegree;

/// The fall of a light ray in metres per metre: the tangent of its elevation (radians), clamped to
/// 0 .. HighestShadowLight.
SKYLINECORE_EXPORT double ShadowSlope(double elevation);

/// Shadow heights of a directional light: the greatest  z - slope d - drop d^2  over all points
/// where a vertical plane towards the light crosses an edge of the triangulated surface, at
/// distance d > 0 and height z. A point above the post is in shadow if it lies below this height.
/// The post itself is in shadow if its horizon lies above the light. The height is not cut off at
/// the post: if it lies below the ground, it shows by how much the shadow misses the post.
///
/// Used like other horizon methods. Find writes shadow heights in metres above the base of the
/// field instead of slopes, and NoShadow where no terrain lies towards the light. Edges near the
/// receiver come first; tiles of posts further away are searched only if their highest post may
/// still shade a receiver of the block. The time is linear in the number of posts unless the light
/// is so low that most of the field lies above the rays (Documentation/shadow-height.md).
class SKYLINECORE_EXPORT ShadowHeightExact : public HorizonMethod
{
public:
  /// slope: the ShadowSlope of the light; drop as in HorizonSettings. The field must be closed and
  /// must outlive this object.
  ShadowHeightExact(const HeightField& field, double slope, double drop);

  void SetAzimuth(const Grid& grid, double azimuth) override;
  std::ptrdiff_t PrepareCount() const override { return 0; }
  void Prepare(std::ptrdiff_t, std::ptrdiff_t) override {}
  void Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
    std::ptrdiff_t laneEnd, float* heights, std::ptrdiff_t stride) const override;

private:
  const HeightField& Field;
  double Slope, CurvatureDrop;
  double FallPerLine = 0.0;
  ShadowHeightTiles RowTiles, ColumnTiles;
};

/// The input of the search for a range of receivers.
struct ShadowHeightTask
{
  const RayFrame& Frame; ///< its steps hold weights that sum to 1, and falls instead of drops
  const ShadowHeightTiles& Tiles;
  double FallPerLine, DropPerLine2; ///< metres
  bool Holes;
  std::ptrdiff_t LineBegin, LineEnd, LaneBegin, LaneEnd;
  float* Heights;
  std::ptrdiff_t Stride;
};

} // namespace skyline

#endif
