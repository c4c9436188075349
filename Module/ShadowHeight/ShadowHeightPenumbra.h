// SPDX-License-Identifier: BSD-3-Clause
// How much of the sun's disc stands free at any height over a place, from its shadow heights.
#ifndef skyline_ShadowHeightPenumbra_h
#define skyline_ShadowHeightPenumbra_h

#include "ShadowHeight/ShadowHeight.h"
#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>

namespace skyline
{

/// The lit part of a light at height z over a place with shadow height `shadow`, metres, as published
/// (Lee & Kim, section 3.2): all below shadow - depth is dark, all above the shadow lit, linear
/// between. With depth 0 (or less) a point is lit from the shadow height upwards.
inline double LitByPenumbraDepth(double shadow, double z, double depth)
{
  if (!(depth > 0.0))
  {
    return z >= shadow ? 1.0 : 0.0;
  }
  return 1.0 - std::min(std::max((shadow - z) / depth, 0.0), 1.0);
}

/// The part of a disc above a level line `t` radii above its centre: the chord model.
inline double LitAboveChord(double t)
{
  const double s = std::min(std::max(t, -1.0), 1.0);
  return (std::acos(s) - s * std::sqrt((1.0 - s) * (1.0 + s))) / Pi;
}

/// The penumbra of a disc between the shadow heights of its two limbs.
///
/// An edge at distance d and height h shades up to h - d tan(e) against light of elevation e. The
/// heights of both limbs give d and h, and with them the elevation of the edge seen from any height
/// between: exact where one edge shades the whole disc and is level across it. The disc counts above
/// the horizontal plane alone, as in SunAccumulator.
class ShadowHeightPenumbra
{
public:
  /// Radians; radius 0: a point.
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

  /// ShadowSlope of the upper and of the lower limb: shadow heights are wanted for both.
  double UpperSlope() const { return this->Steep; }
  double LowerSlope() const { return this->Level; }

  /// Whether any of the disc stands above the horizontal plane.
  bool Risen() const { return this->Elevation + this->Radius > 0.0; }

  /// The lit part at height z, 0 to 1; upper, lower: shadow heights of the limbs, upper <= lower, in
  /// the metres of z.
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
  double Open; // lit where no terrain shades
};

} // namespace skyline

#endif
