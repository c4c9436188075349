// SPDX-License-Identifier: BSD-3-Clause
// One vertical half plane through a post, the lamp's circle in it, and the terrain in front of it.
#ifndef skyline_LampChord_h
#define skyline_LampChord_h

#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// The receiver's plane along one azimuth: n.d = Up sin e + Along cos e at the elevation e.
struct LampFacing
{
  double Up = 1.0;    ///< of the unit normal
  double Along = 0.0; ///< of the unit normal
};

/// Integral of max(0, n.d) cos e de over elevations between centre + from and centre + to, all
/// within -pi/2 .. pi/2. Radians; written in differences, which the smallest lamp keeps.
double FacingLight(const LampFacing& facing, double centre, double from, double to);

/// The slope under which the receiver looks into its own plane.
inline double FacingSlope(const LampFacing& facing)
{
  return -facing.Along / facing.Up;
}

/// A lamp's circle, distances s from the post along the azimuth and heights z above it, and what
/// pieces of terrain leave visible of it: the visitor of a LampWalk.
///
/// The side of the circle that faces the post runs from the low tangent to the high one. Its point
/// nearest to the post's vertical (the turn) parts it in two arcs, on each of which the distance s
/// changes one way. Terrain at the distance s and the slope m hides the rays up to m that pass s
/// before they end on the circle: on the low arc those from the bottom up to the arc's point over s,
/// on the high arc those between the arc's point over s and m. So what stays visible of the low arc
/// is all above one slope, and of the high arc a sum of gaps.
class SKYLINECORE_EXPORT LampChord
{
public:
  /// along, up: the circle's centre; circle: its radius; tangent: length of the tangents from the
  /// post to it, above 0. False if the half plane sees nothing of it, or the receiver's plane hides
  /// all. Costs no angle: those are found when light is asked for.
  bool Set(double along, double up, double circle, double tangent, const LampFacing& facing);

  /// Whether nothing of the chord can be visible any more, and the distance of the terrain that did it.
  bool Dark() const { return this->Near >= this->HighSlope; }
  double NearPlace() const { return this->Place; }

  double Whole(); ///< light of the chord without terrain
  double Lit();   ///< light that the terrain of the walk lets through

  double End() const { return this->Last; }
  double Fine() const { return this->Turn; }
  double Threshold() const { return this->Least; }
  void Start(double slope);
  bool Piece(double s0, double z0, double s1, double z1);

private:
  void FindAngles();
  double Offset(double slope) const;
  double Between(double low, double high) const;
  double ArcSlope(double s, double side) const;
  void Raise();
  void Beyond(double s0, double z0, double s1, double z1);
  void HideLow(double s, double slope);
  void HideHigh(double s0, double z0, double s1, double z1);

  LampFacing Facing;
  double Along = 0.0, Up = 0.0, Circle = 0.0;
  double Tangent = 0.0;
  bool HasAngles = false;
  double Centre = 0.0, SinCentre = 0.0, CosCentre = 1.0; ///< elevation of the circle's centre
  double First = 0.0, Final = 0.0;        ///< ends of the chord, radians from the centre
  double LowSlope = 0.0, HighSlope = 0.0; ///< the same as slopes
  double TurnSlope = 0.0;                 ///< between the arcs
  double Turn = 0.0;                      ///< distance of the turn
  double LowEnd = 0.0, HighEnd = 0.0;     ///< distances of the tangent points; arcs without: Turn
  double Last = 0.0;
  double Near = 0.0;    ///< slope of the terrain before the turn: hides both arcs
  double Place = 0.0;   ///< distance of that terrain
  double LowTop = 0.0;  ///< slope below which the low arc is hidden
  double HighTop = 0.0; ///< slope below which the gaps of the high arc are counted
  double Gone = 0.0;    ///< light hidden of the high arc above Near
  double Least = 0.0;
};

} // namespace skyline

#endif
