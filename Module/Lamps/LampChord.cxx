// SPDX-License-Identifier: BSD-3-Clause
#include "Lamps/LampChord.h"

#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skyline
{

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();

/// Rounding errors of sums and differences of light that may remain when a chord is completely
/// hidden.
constexpr double Nothing = 1.0e-12;

} // namespace

/// Int (Up sin e + Along cos e) cos e de
///   = Up (sin^2 e2 - sin^2 e1) / 2 + Along (e2 - e1 + (sin 2 e2 - sin 2 e1) / 2) / 2
///   = [Up sin 2m sin 2d + Along (2d + cos 2m sin 2d)] / 2,  m the middle, d half the length.
double FacingLight(const LampFacing& facing, double centre, double from, double to)
{
  if (!(from < to))
  {
    return 0.0;
  }
  const double twice = 2.0 * centre + from + to;
  const double length = to - from;
  const double sine = std::sin(length);
  return std::max(0.0,
    0.5 * (facing.Up * std::sin(twice) * sine + facing.Along * (length + std::cos(twice) * sine)));
}

bool LampChord::Set(
  double along, double up, double circle, double tangent, const LampFacing& facing)
{
  if (!(circle > 0.0))
  {
    return false;
  }
  // The directions of the tangents are that of the centre, rotated by half the angle of the disc to
  // either side. Multiplied by the distances of the centre and of the tangent points, they give
  // slopes and positions without angles.
  const double lowAlong = along * tangent + up * circle;
  const double lowUp = up * tangent - along * circle;
  const double highAlong = along * tangent - up * circle;
  const double highUp = up * tangent + along * circle;
  const bool hasLow = lowAlong > 0.0, hasHigh = highAlong > 0.0;
  if (!hasLow && !hasHigh)
  {
    return false; // a chord is below 180 degrees, so all of it lies behind the vertical
  }
  this->Facing = facing;
  this->Along = along;
  this->Up = up;
  this->Circle = circle;
  this->Tangent = tangent;
  this->HasAngles = false;
  const double square = along * along + up * up;
  this->LowSlope = hasLow ? lowUp / lowAlong : -Infinite;
  this->HighSlope = hasHigh ? highUp / highAlong : Infinite;

  this->Turn = std::max(0.0, along - circle);
  // If rounding leaves the disc both tangents although it touches the vertical, the slope is that
  // of the vertical.
  this->TurnSlope = !hasLow ? -Infinite
    : !hasHigh              ? Infinite
    : this->Turn > 0.0      ? up / this->Turn
                            : std::copysign(Infinite, up);
  this->TurnSlope = std::clamp(this->TurnSlope, this->LowSlope, this->HighSlope);
  const double toTangent = tangent / square;
  this->LowEnd = hasLow ? std::max(this->Turn, toTangent * lowAlong) : this->Turn;
  this->HighEnd = hasHigh ? std::max(this->Turn, toTangent * highAlong) : this->Turn;
  this->Last = std::max(this->LowEnd, this->HighEnd);

  // The part below the plane of the receiver counts as hidden from the start, so that walks need
  // not test it.
  this->Near = this->LowTop = this->HighTop = FacingSlope(facing);
  this->Gone = 0.0;
  this->Place = 0.0;
  this->Least = std::max(this->Near, this->LowSlope);
  return !this->Dark();
}

void LampChord::FindAngles()
{
  if (this->HasAngles)
  {
    return;
  }
  this->HasAngles = true;
  const double scale = 1.0 / std::sqrt(this->Along * this->Along + this->Up * this->Up);
  this->SinCentre = this->Up * scale;
  this->CosCentre = this->Along * scale;
  this->Centre = std::atan2(this->Up, this->Along);
  const double half = std::atan2(this->Circle, this->Tangent);
  this->First = this->LowSlope > -Infinite ? -half : -0.5 * Pi - this->Centre;
  this->Final = this->HighSlope < Infinite ? half : 0.5 * Pi - this->Centre;
}

double LampChord::Whole()
{
  this->FindAngles();
  const double own = FacingSlope(this->Facing);
  return this->Between(own, this->TurnSlope) +
    this->Between(std::max(own, this->TurnSlope), Infinite);
}

/// The elevation of a slope relative to that of the centre, clamped to the chord.
double LampChord::Offset(double slope) const
{
  if (slope <= this->LowSlope)
  {
    return this->First;
  }
  if (slope >= this->HighSlope)
  {
    return this->Final;
  }
  const double offset = std::atan2(
    slope * this->CosCentre - this->SinCentre, this->CosCentre + slope * this->SinCentre);
  return std::clamp(offset, this->First, this->Final);
}

double LampChord::Between(double low, double high) const
{
  return low < high ? FacingLight(this->Facing, this->Centre, this->Offset(low), this->Offset(high))
                    : 0.0;
}

/// The slope of the point of the circle at the distance s, on its low (side = -1) or high (side =
/// 1) half.
double LampChord::ArcSlope(double s, double side) const
{
  const double off = s - this->Along;
  const double rise = std::sqrt(std::max(0.0, (this->Circle - off) * (this->Circle + off)));
  return s > 0.0 ? (this->Up + side * rise) / s : -side * Infinite;
}

void LampChord::Raise()
{
  this->LowTop = std::max(this->LowTop, this->Near);
  this->HighTop = std::max(this->HighTop, this->Near);
  this->Least = std::max(this->Least, this->Near);
}

/// Terrain at the post itself is in front of the whole lamp.
void LampChord::Start(double slope)
{
  this->Near = std::max(this->Near, slope);
  this->Raise();
}

bool LampChord::Piece(double s0, double z0, double s1, double z1)
{
  if (s0 < this->Turn)
  {
    const bool across = s1 > this->Turn;
    const double s = across ? this->Turn : s1;
    const double z = across ? z0 + (z1 - z0) * (s - s0) / (s1 - s0) : z1;
    const double slope = s0 > 0.0 ? std::max(z / s, z0 / s0) : z / s;
    if (slope > this->Near)
    {
      this->Near = slope;
      this->Place = 0.5 * (s0 + s);
      this->Raise();
    }
    if (across)
    {
      this->Beyond(s, z, s1, z1);
    }
  }
  else
  {
    this->Beyond(s0, z0, s1, z1);
  }
  return !this->Dark() && s1 < this->Last;
}

void LampChord::Beyond(double s0, double z0, double s1, double z1)
{
  const double highest = std::max(s0 > 0.0 ? z0 / s0 : z1 / s1, z1 / s1);
  if (highest <= this->Least)
  {
    return;
  }
  // Where the piece intersects the circle, as fractions of its length.
  const double ds = s1 - s0, dz = z1 - z0, ps = s0 - this->Along, pz = z0 - this->Up;
  const double a = ds * ds + dz * dz, b = ds * ps + dz * pz;
  const double c = ps * ps + pz * pz - this->Circle * this->Circle;
  const double root = b * b - a * c;
  double cut[2] = { -1.0, -1.0 };
  if (root > 0.0)
  {
    const double q = -(b + std::copysign(std::sqrt(root), b));
    cut[0] = q / a;
    cut[1] = q != 0.0 ? c / q : cut[0];
    if (cut[0] > cut[1])
    {
      std::swap(cut[0], cut[1]);
    }
  }
  double begin = 0.0;
  for (const double part : { cut[0], cut[1], 1.0 })
  {
    if (part > begin && part <= 1.0)
    {
      this->HideHigh(s0 + begin * ds, z0 + begin * dz, s0 + part * ds, z0 + part * dz);
      const double s = s0 + part * ds;
      this->HideLow(s, (z0 + part * dz) / s);
      begin = part;
    }
  }
  if (s0 > 0.0)
  {
    this->HideLow(s0, z0 / s0);
  }
  if (s0 < this->LowEnd && s1 > this->LowEnd)
  {
    this->HideLow(this->LowEnd, (z0 + dz * (this->LowEnd - s0) / ds) / this->LowEnd);
  }
}

void LampChord::HideLow(double s, double slope)
{
  if (slope > this->LowTop && s <= this->LowEnd)
  {
    this->LowTop = std::max(this->LowTop, std::min(slope, this->ArcSlope(s, -1.0)));
  }
}

/// A piece that does not intersect the circle hides a part of the high arc if it lies above the
/// arc.
void LampChord::HideHigh(double s0, double z0, double s1, double z1)
{
  if (!(s0 < this->HighEnd))
  {
    return;
  }
  const double end = std::min(s1, this->HighEnd);
  const double zEnd = end < s1 ? z0 + (z1 - z0) * (end - s0) / (s1 - s0) : z1;
  const double middle = 0.5 * (s0 + end);
  if (0.5 * (z0 + zEnd) <= this->ArcSlope(middle, 1.0) * middle)
  {
    return;
  }
  const double slope = std::max(s0 > 0.0 ? z0 / s0 : zEnd / end, zEnd / end);
  const double low = std::max(std::max(this->HighTop, this->TurnSlope), this->ArcSlope(s0, 1.0));
  this->FindAngles();
  this->Gone += this->Between(low, slope);
  this->HighTop = std::max(this->HighTop, slope);
}

double LampChord::Lit()
{
  const double whole = this->Whole();
  const double clear = std::max(FacingSlope(this->Facing), this->LowSlope);
  if (this->Near <= clear && this->LowTop <= clear && this->Gone == 0.0)
  {
    return whole; // nothing is hidden, and no further angle is needed
  }
  const double lit = this->Between(this->LowTop, this->TurnSlope) +
    this->Between(std::max(this->Near, this->TurnSlope), Infinite) - this->Gone;
  return lit > Nothing * whole ? lit : 0.0;
}

} // namespace skyline
