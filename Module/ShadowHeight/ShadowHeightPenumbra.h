// SPDX-License-Identifier: BSD-3-Clause
// Computes from shadow heights how much of the disc of the sun is visible at any height above a
// post.
#ifndef skyline_ShadowHeightPenumbra_h
#define skyline_ShadowHeightPenumbra_h

#include "ShadowHeight/ShadowHeight.h"
#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>

namespace skyline
{

/// The lit share of a light at height z above a post with the shadow height `shadow` (metres), as
/// published (Lee & Kim, section 3.2): 0 below shadow - depth, 1 above shadow, and linear in
/// between. With a depth of 0 or less, a point is lit from the shadow height upwards.
inline double LitByPenumbraDepth(double shadow, double z, double depth)
{
  if (!(depth > 0.0))
  {
    return z >= shadow ? 1.0 : 0.0;
  }
  return 1.0 - std::min(std::max((shadow - z) / depth, 0.0), 1.0);
}

/// The share of a disc above a level line, `t` radii above the centre of the disc: the chord model.
inline double LitAboveChord(double t)
{
  const double s = std::min(std::max(t, -1.0), 1.0);
  return (std::acos(s) - s * std::sqrt((1.0 - s) * (1.0 + s))) / Pi;
}

/// The penumbra of a disc between the shadow heights of its two limbs.
///
/// An edge at distance d and height h casts a shadow up to h - d tan(e) for light of elevation e.
/// The shadow heights of both limbs give d and h, and thus the elevation of the edge seen from any
/// height in between. This is exact if one edge shades the whole disc and is level across it. Only
/// the part of the disc above the horizontal plane counts, as in SunAccumulator.
class ShadowHeightPenumbra
{
public:
  /// elevation and angular radius of the disc in radians; radius 0: a point.
  ShadowHeightPenumbra(double elevation, double radius)
    : Elevation(elevation)
    , Radius(radius)
    , Steep(ShadowSlope(elevation + radius))
    , Level(ShadowSlope(elevation - radius))
    , Open(radius > 0.0     ? LitAboveChord(-elevation / radius)
          : elevation > 0.0 ? 1.0
                            : 0.0)
  {
  }

  /// ShadowSlope of the upper and the lower limb. The shadow heights of both are needed.
  double UpperSlope() const { return this->Steep; }
  double LowerSlope() const { return this->Level; }

  /// Returns true if a part of the disc lies above the horizontal plane.
  bool Risen() const { return this->Elevation + this->Radius > 0.0; }

  /// The lit share at height z, 0 to 1. upper, lower: shadow heights of the two limbs, upper <=
  /// lower, with the same zero as z, in metres.
  double Lit(double upper, double lower, double z) const
  {
    if (z >= lower)
    {
      return this->Open;
    }
    if (!(z > upper) || !(this->Radius > 0.0) || !this->Risen())
    {
      return 0.0;
    }
    const double part = (z - upper) / (lower - upper);
    const double edge = std::atan(this->Steep + part * (this->Level - this->Steep));
    return LitAboveChord((edge - this->Elevation) / this->Radius);
  }

private:
  double Elevation, Radius;
  double Steep, Level;
  double Open; // lit share without terrain
};

} // namespace skyline

#endif
