// SPDX-License-Identifier: BSD-3-Clause
#include "Lamps/LampIrradiance.h"

#include "Lamps/LampChord.h"
#include "Lamps/LampWalk.h"
#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace skyline
{

namespace
{

/// Largest number of bisections of the interval between two planes: a shadow edge is found within
/// 2^-6 of it.
constexpr int DeepestSplit = 6;

/// Factor on the number of planes for a lamp that stands above or around the post.
constexpr int AroundFactor = 2;

/// Sine of the half swath beyond which the test whether the whole fan is clear is skipped.
constexpr double WidestFan = 0.99;

/// Light of a plane, per unit of the variable in which the planes are evenly spaced.
struct PlaneLight
{
  double Whole = 0.0, Lit = 0.0;
};

/// Visitor that finds the slope of the surface at the post in an azimuth, and ends the walk there.
struct StartSlope
{
  double Slope = -std::numeric_limits<double>::infinity();
  double End() const { return std::numeric_limits<double>::min(); }
  double Fine() const { return std::numeric_limits<double>::infinity(); }
  double Threshold() const { return 0.0; }
  void Start(double slope) { this->Slope = slope; }
  bool Piece(double, double, double, double) const { return false; }
};

/// The initial planes: intervals of t from `begin` to -begin. An end without light is left out.
struct LampNodes
{
  LampNodes(int intervals, double begin)
    : Intervals(static_cast<std::size_t>(intervals))
    , Begin(begin)
  {
    for (int k = begin > -Pi ? 1 : 0; k < intervals; ++k)
    {
      const double t = begin - 2.0 * begin * k / intervals;
      this->Cosine.push_back(std::cos(t));
      this->Sine.push_back(std::sin(t));
    }
  }
  std::size_t Intervals;
  double Begin;
  std::vector<double> Cosine, Sine;
};

/// One lamp at one post: the sum over vertical planes.
class LampView
{
public:
  LampView(const LampWalk& walk, const LampSettings& settings, LampWork& work)
    : Walk(walk)
    , Settings(settings)
    , Work(work)
    , Across(std::max(2, settings.Azimuths), -0.5 * Pi)
    , Around(std::max(2, settings.Azimuths) * AroundFactor, -Pi)
  {
  }

  /// The share, 0 to 1, of the unshadowed irradiance that a post receives. up, east, north: the
  /// unit normal; x, y, z: from the post to the lamp.
  double LitPart(const LampReceiver& post, double x, double y, double z, double radius, double up,
    double east, double north);

private:
  /// A plane. `Weight`: change of the azimuth per unit of the variable in which planes are evenly
  /// spaced.
  struct Plane
  {
    LampAzimuth Azimuth;
    double Cosine, Sine; ///< of the azimuth relative to that of the centre
    double Circle;       ///< radius of the circle in which the plane cuts the lamp
    double Weight;
  };
  Plane PlaneAt(double cosine, double sine) const;
  LampFacing FacingAt(const LampAzimuth& azimuth) const;
  bool Walked(const Plane& plane, LampChord& chord);
  bool AllDark(const LampNodes& nodes);
  PlaneLight At(double cosine, double sine);
  PlaneLight Inside(const Plane& plane) const;
  void Sum(double t0, const PlaneLight& p0, double t1, const PlaneLight& p1, int depth);

  const LampWalk& Walk;
  const LampSettings& Settings;
  LampWork& Work;

  LampNodes Across, Around; ///< planes through a lamp beside the post, and above it

  LampReceiver Post{};
  double NormalUp = 1.0, NormalEast = 0.0, NormalNorth = 0.0;
  LampAzimuth Centre{ 0.0, 1.0 }; ///< azimuth of the lamp's centre
  double Level = 0.0, Rise = 0.0; ///< horizontal distance and height of the centre
  double Radius = 0.0;
  double Power = 0.0;    ///< distance^2 - radius^2; below 0 inside the lamp
  double Tangent = 0.0;  ///< its square root: length of the tangents
  double SinSwath = 0.0; ///< sine of half the swath; 0: the lamp is seen in all azimuths
  double Allowed = 0.0;  ///< largest error of an interval
  double HiddenBefore = std::numeric_limits<double>::infinity(); ///< metres before the centre of
                                                                 ///< the lamp
  PlaneLight Total;
};

/// Planes are evenly spaced in t. The distance of the centre from a plane is radius x sin t, which
/// makes the integrand smooth at the round ends of the disc, and the radius of the circle is radius
/// x cos t. For a lamp around the post, t is the azimuth. cosine, sine: of t.
LampView::Plane LampView::PlaneAt(double cosine, double sine) const
{
  Plane plane{ {}, cosine, sine, this->Radius * cosine, 1.0 };
  if (this->SinSwath > 0.0)
  {
    plane.Sine = this->SinSwath * sine;
    plane.Cosine = std::sqrt((1.0 - plane.Sine) * (1.0 + plane.Sine));
    plane.Weight = plane.Cosine > 0.0 ? this->SinSwath * cosine / plane.Cosine : 1.0;
  }
  else
  {
    const double side = this->Level * sine;
    plane.Circle = std::sqrt(std::max(0.0, (this->Radius - side) * (this->Radius + side)));
  }
  plane.Azimuth = { this->Centre.East * plane.Cosine + this->Centre.North * plane.Sine,
    this->Centre.North * plane.Cosine - this->Centre.East * plane.Sine };
  return plane;
}

LampFacing LampView::FacingAt(const LampAzimuth& azimuth) const
{
  return { this->NormalUp, azimuth.East * this->NormalEast + azimuth.North * this->NormalNorth };
}

/// Compares the terrain in a plane with the lamp. Returns false if the plane shows no part of the
/// lamp anyway.
bool LampView::Walked(const Plane& plane, LampChord& chord)
{
  if (!chord.Set(this->Level * plane.Cosine, this->Rise, plane.Circle, this->Tangent,
        this->FacingAt(plane.Azimuth)))
  {
    return false;
  }
  ++this->Work.Planes;
  // The terrain that hid the previous plane usually hides this one, too.
  const double guess = this->Level - this->HiddenBefore;
  if (guess > 0.0)
  {
    this->Walk.Look(this->Post, plane.Azimuth, guess, chord);
  }
  if (!chord.Dark())
  {
    this->Walk(this->Post, plane.Azimuth, chord);
  }
  if (chord.Dark())
  {
    this->HiddenBefore = this->Level - chord.NearPlace();
  }
  return true;
}

/// Whether all planes are dark. This finds most of the shadowed posts without computing angles.
bool LampView::AllDark(const LampNodes& nodes)
{
  LampChord chord;
  for (std::size_t k = 0; k < nodes.Cosine.size(); ++k)
  {
    if (this->Walked(this->PlaneAt(nodes.Cosine[k], nodes.Sine[k]), chord) && !chord.Dark())
    {
      return false;
    }
  }
  return true;
}

/// Light from all directions except the disc opposite to the centre.
PlaneLight LampView::Inside(const Plane& plane) const
{
  const LampFacing facing = this->FacingAt(plane.Azimuth);
  const double side = this->Level * plane.Sine;
  const double distance2 = this->Power + this->Radius * this->Radius;
  const double left = distance2 - side * side;
  double darkLow = 0.5 * Pi, darkHigh = 0.5 * Pi;
  if (left > 0.0)
  {
    // Both in units of the radius: half the chord of the dark disc, as ChordOfDisc computes it.
    const double half = std::atan2(std::sqrt(left), std::sqrt(-this->Power));
    const double middle = std::atan2(-this->Rise, -this->Level * plane.Cosine);
    darkLow = std::clamp(middle - half, -0.5 * Pi, 0.5 * Pi);
    darkHigh = std::clamp(middle + half, -0.5 * Pi, 0.5 * Pi);
  }
  StartSlope start;
  this->Walk(this->Post, plane.Azimuth, start);
  const auto above = [&](double low)
  {
    return FacingLight(facing, 0.0, low, std::max(low, darkLow)) +
      FacingLight(facing, 0.0, std::max(low, darkHigh), 0.5 * Pi);
  };
  const double own = std::atan(FacingSlope(facing));
  return { above(own), above(std::max(own, std::atan(start.Slope))) };
}

PlaneLight LampView::At(double cosine, double sine)
{
  const Plane plane = this->PlaneAt(cosine, sine);
  if (!(this->Power > 0.0))
  {
    const PlaneLight light = this->Inside(plane);
    return { plane.Weight * light.Whole, plane.Weight * light.Lit };
  }
  LampChord chord;
  if (!this->Walked(plane, chord))
  {
    return {};
  }
  return { plane.Weight * chord.Whole(), chord.Dark() ? 0.0 : plane.Weight * chord.Lit() };
}

void LampView::Sum(double t0, const PlaneLight& p0, double t1, const PlaneLight& p1, int depth)
{
  const double width = t1 - t0;
  const bool clear = p0.Lit >= p0.Whole && p1.Lit >= p1.Whole;
  const bool dark = p0.Lit <= 0.0 && p1.Lit <= 0.0;
  if (clear || dark || depth == 0)
  {
    this->Total.Whole += 0.5 * width * (p0.Whole + p1.Whole);
    this->Total.Lit += 0.5 * width * (p0.Lit + p1.Lit);
    return;
  }
  const double middle = 0.5 * (t0 + t1);
  const PlaneLight p = this->At(std::cos(middle), std::sin(middle));
  // The error of the trapezium rule: a third of its difference from the rule with half the width.
  if (std::abs(p0.Lit - 2.0 * p.Lit + p1.Lit) * 0.25 * width <= this->Allowed)
  {
    this->Total.Whole += 0.25 * width * (p0.Whole + 2.0 * p.Whole + p1.Whole);
    this->Total.Lit += 0.25 * width * (p0.Lit + 2.0 * p.Lit + p1.Lit);
    return;
  }
  this->Sum(t0, p0, middle, p, depth - 1);
  this->Sum(middle, p, t1, p1, depth - 1);
}

double LampView::LitPart(const LampReceiver& post, double x, double y, double z, double radius,
  double up, double east, double north)
{
  this->Post = post;
  this->NormalUp = up;
  this->NormalEast = east;
  this->NormalNorth = north;
  this->Level = std::hypot(x, y);
  this->Rise = z;
  this->Radius = radius;
  this->Centre =
    this->Level > 0.0 ? LampAzimuth{ x / this->Level, y / this->Level } : LampAzimuth{ 0.0, 1.0 };
  const double distance = std::hypot(this->Level, z);
  this->Power = (distance - radius) * (distance + radius);
  this->Tangent = std::sqrt(std::max(0.0, this->Power));
  this->SinSwath = this->Power > 0.0 && radius < this->Level ? radius / this->Level : 0.0;
  this->Total = {};
  const bool around = this->SinSwath == 0.0;
  const LampNodes& nodes = around ? this->Around : this->Across;
  if (!around && this->SinSwath < WidestFan)
  {
    // The lowest tangent lies in the plane of the centre.
    const double along = this->Level * this->Tangent + z * radius;
    const double end = std::min(this->Tangent, this->Level + radius);
    // What lies under the plane of the receiver is not visible either. The slope of that plane is
    // least at the rim of the fan, half a swath (at most 1.42 times its sine) from the middle.
    const double gradient = std::hypot(east, north) / up;
    const double own = FacingSlope(this->FacingAt(this->Centre)) - 1.42 * this->SinSwath * gradient;
    const double slope = std::max(own, (z * this->Tangent - this->Level * radius) / along);
    if (along > 0.0 && this->Walk.Clear(post, this->Centre, this->SinSwath, end, slope))
    {
      return 1.0;
    }
  }
  if (this->Power > 0.0 && this->AllDark(nodes))
  {
    return 0.0;
  }

  const double step = (around ? 2.0 * Pi : Pi) / static_cast<double>(nodes.Intervals);
  const double cosine = (up * z + east * x + north * y) / std::max(distance, 1e-300);
  this->Allowed = this->Settings.Tolerance / static_cast<double>(nodes.Intervals) *
    DiscIrradiance(DiscOfLamp(radius, distance), distance > 0.0 ? cosine : 1.0);
  // At the ends of a swath the disc has no width. For a lamp around the post, the last plane is the
  // first one.
  const PlaneLight first = around ? this->At(nodes.Cosine[0], nodes.Sine[0]) : PlaneLight{};
  PlaneLight before = first;
  for (std::size_t k = 1; k <= nodes.Intervals; ++k)
  {
    const std::size_t node = around ? k : k - 1;
    const PlaneLight next =
      k < nodes.Intervals ? this->At(nodes.Cosine[node], nodes.Sine[node]) : first;
    const double t = nodes.Begin + static_cast<double>(k) * step;
    this->Sum(t - step, before, t, next, DeepestSplit);
    before = next;
  }
  return this->Total.Whole > 0.0 ? std::clamp(this->Total.Lit / this->Total.Whole, 0.0, 1.0) : 1.0;
}

} // namespace

void AddLampIrradiance(const LampTerrain& terrain, const Grid& grid, const float* east,
  const float* north, const Lamp& lamp, const LampSettings& settings, std::ptrdiff_t rowBegin,
  std::ptrdiff_t rowEnd, float* rgb, LampWork& work)
{
  CheckLamp(lamp);
  const LampWalk walk(terrain, grid, settings.Shape, settings.CurvatureDrop);
  LampView view(walk, settings, work);
  std::vector<float> buffer;
  for (std::ptrdiff_t row = rowBegin; row < rowEnd; ++row)
  {
    const float* heights = terrain.Field().Receivers(false, row, buffer);
    const double y = lamp.Y - static_cast<double>(row) * grid.SpacingY;
    for (std::ptrdiff_t column = 0; column < grid.Columns; ++column)
    {
      const std::ptrdiff_t post = row * grid.Columns + column;
      float* result = rgb + 3 * post;
      if (heights[column] <= 0.5f * MissingHeight)
      {
        std::fill_n(result, 3, std::numeric_limits<float>::quiet_NaN());
        continue;
      }
      const double x = lamp.X - static_cast<double>(column) * grid.SpacingX;
      const double level2 = x * x + y * y;
      const double z = lamp.Z - heights[column] - settings.CurvatureDrop * level2;
      const double distance = std::sqrt(level2 + z * z);
      const LampDisc disc = DiscOfLamp(lamp.Radius, distance);
      const double reach = Pi * disc.Sine * disc.Sine;
      if (!(reach > 0.0 || disc.Cosine < 0.0) || (disc.Cosine > 0.0 && reach < settings.Least))
      {
        continue;
      }
      const double slopeEast = east ? static_cast<double>(east[post]) : 0.0;
      const double slopeNorth = north ? static_cast<double>(north[post]) : 0.0;
      const double up = 1.0 / std::sqrt(1.0 + slopeEast * slopeEast + slopeNorth * slopeNorth);
      const double normalEast = -slopeEast * up, normalNorth = -slopeNorth * up;
      const double cosine =
        distance > 0.0 ? (z * up + x * normalEast + y * normalNorth) / distance : 1.0;
      const double whole = DiscIrradiance(disc, cosine);
      if (!(whole > 0.0))
      {
        continue;
      }
      ++work.Posts;
      const LampReceiver receiver{ column, row, static_cast<double>(heights[column]) };
      const double lit =
        whole * view.LitPart(receiver, x, y, z, lamp.Radius, up, normalEast, normalNorth);
      for (int band = 0; band < 3; ++band)
      {
        result[band] += static_cast<float>(lit * lamp.Radiance[static_cast<std::size_t>(band)]);
      }
    }
  }
}

void AddLampIrradiance(const LampTerrain& terrain, const Grid& grid, const float* east,
  const float* north, const Lamp& lamp, const LampSettings& settings, std::ptrdiff_t rowBegin,
  std::ptrdiff_t rowEnd, float* rgb)
{
  LampWork work;
  AddLampIrradiance(terrain, grid, east, north, lamp, settings, rowBegin, rowEnd, rgb, work);
}

} // namespace skyline
