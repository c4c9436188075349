// SPDX-License-Identifier: BSD-3-Clause
// A vertical half plane through a post, the circle of the lamp in this plane, and the terrain in
// front of it.
#ifndef skyline_LampChord_h
#define skyline_LampChord_h

#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// The plane of the receiver along one azimuth: n.d = Up sin e + Along cos e at the elevation e.
struct LampFacing
{
  double Up = 1.0;    ///< component of the unit normal
  double Along = 0.0; ///< component of the unit normal
};

/// Integral of max(0, n.d) cos e de over the elevations between centre + from and centre + to, all
/// within -pi/2 .. pi/2. Radians. It is computed from differences, so that it is accurate for the
/// smallest lamp.
double FacingLight(const LampFacing& facing, double centre, double from, double to);

/// The slope of the plane of the receiver along the azimuth.
inline double FacingSlope(const LampFacing& facing)
{
  return -facing.Along / facing.Up;
}

/// The circle of a lamp, in distances s from the post along the azimuth and heights z above the
/// post, and the part of it that pieces of terrain leave visible. This is the visitor of a
/// LampWalk.
///
/// The side of the circle that faces the post runs from the low tangent to the high one. The point
/// nearest to the vertical through the post (the turn) divides it into two arcs. Along each arc,
/// the distance s changes in one direction. Terrain at the distance s with the slope m hides the
/// rays with slopes up to m that pass s before they end on the circle. On the low arc, these are
/// the rays from its bottom up to its point at distance s; on the high arc, those between its point
/// at distance s and m. The visible part of the low arc therefore lies above one slope, and that of
/// the high arc is a sum of gaps.
class SKYLINECORE_EXPORT LampChord
{
public:
  /// along, up: centre of the circle; circle: its radius; tangent: length of the tangents from the
  /// post to the circle, above 0. Returns false if the circle lies outside the half plane or
  /// entirely below the plane of the receiver. No angle is computed here: that is done only when
  /// light is needed.
  bool Set(double along, double up, double circle, double tangent, const LampFacing& facing);

  /// Whether no part of the chord can be visible any more. NearPlace is the distance of the terrain
  /// that hides it.
  bool Dark() const { return this->Near >= this->HighSlope; }
  double NearPlace() const { return this->Place; }

  double Whole(); ///< light of the chord without terrain
  double Lit();   ///< light that the visited terrain leaves

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
  double Centre = 0.0, SinCentre = 0.0, CosCentre = 1.0; ///< elevation of the centre of the circle
  double First = 0.0, Final = 0.0;        ///< ends of the chord, radians from the centre
  double LowSlope = 0.0, HighSlope = 0.0; ///< the same ends as slopes
  double TurnSlope = 0.0;                 ///< slope at the turn, between the arcs
  double Turn = 0.0;                      ///< distance of the turn
  double LowEnd = 0.0, HighEnd = 0.0;     ///< distances of the tangent points; Turn if an arc is
                                          ///< absent
  double Last = 0.0;
  double Near = 0.0;    ///< slope of the terrain before the turn, which hides both arcs
  double Place = 0.0;   ///< distance of that terrain
  double LowTop = 0.0;  ///< slope below which the low arc is hidden
  double HighTop = 0.0; ///< slope below which the gaps of the high arc are already counted
  double Gone = 0.0;    ///< light of the high arc above Near that is hidden
  double Least = 0.0;
};

} // namespace skyline

#endif
