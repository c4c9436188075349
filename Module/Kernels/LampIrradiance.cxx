// SPDX-License-Identifier: BSD-3-Clause
#include "LampIrradiance.h"

#include "Constants.h"
#include "LampChord.h"
#include "LampWalk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace skyline
{

namespace
{

/// Bisections of the interval between two planes: a step of the shadow falls within 2^-6 of it.
constexpr int DeepestSplit = 6;

/// Planes for a lamp that stands over or around the post, per plane of a lamp that does not.
constexpr int AroundFactor = 2;

/// Half swath (radians) beyond which nobody asks whether the whole fan is clear.
constexpr double WidestFan = 1.5;

/// What a plane gives, per unit of the variable that the planes are spaced evenly in.
struct PlaneLight
{
  double Whole = 0.0, Lit = 0.0;
};

/// Where the surface is at the post, in an azimuth: light that starts at the post meets no more.
struct StartSlope
{
  double Slope = -std::numeric_limits<double>::infinity();
  double End() const { return std::numeric_limits<double>::min(); }
  double Fine() const { return std::numeric_limits<double>::infinity(); }
  double Threshold() const { return 0.0; }
  void Start(double slope) { this->Slope = slope; }
  bool Piece(double, double, double, double) const { return false; }
};

/// One lamp over one post: the sum over vertical planes.
class LampView
{
public:
  LampView(const LampWalk& walk, const LampSettings& settings, LampWork& work)
    : Walk(walk)
    , Settings(settings)
    , Work(work)
  {
  }

  /// The part, 0 to 1, of its unshadowed irradiance that a post gets. up, east, north: the unit
  /// normal; x, y, z: from the post to the lamp.
  double LitPart(const LampReceiver& post, double x, double y, double z, double radius, double up,
    double east, double north);

private:
  PlaneLight At(double t);
  PlaneLight Outside(const LampAzimuth& azimuth, double cosine, double sine);
  PlaneLight Inside(const LampAzimuth& azimuth, double cosine, double sine);
  void Sum(double t0, const PlaneLight& p0, double t1, const PlaneLight& p1, int depth);

  const LampWalk& Walk;
  const LampSettings& Settings;
  LampWork& Work;

  LampReceiver Post{};
  double NormalUp = 1.0, NormalEast = 0.0, NormalNorth = 0.0;
  LampAzimuth Centre{ 0.0, 1.0 }; ///< azimuth of the lamp's centre
  double Level = 0.0, Rise = 0.0; ///< horizontal distance and height of the centre
  double Radius = 0.0;
  double Power = 0.0;     ///< distance^2 - radius^2: below 0 inside
  double HalfSwath = 0.0; ///< radians; 0: the lamp is seen in every azimuth
  double Allowed = 0.0;   ///< error of an interval
  double HiddenBefore = std::numeric_limits<double>::infinity(); ///< metres before the centre
  PlaneLight Total;
};

PlaneLight LampView::Outside(const LampAzimuth& azimuth, double cosine, double sine)
{
  const LampFacing facing{ this->NormalUp,
    azimuth.East * this->NormalEast + azimuth.North * this->NormalNorth };
  const double side = this->Level * sine;
  const double circle = std::sqrt(std::max(0.0, (this->Radius - side) * (this->Radius + side)));
  LampChord chord;
  if (!chord.Set(this->Level * cosine, this->Rise, circle, std::sqrt(this->Power), facing))
  {
    return {};
  }
  ++this->Work.Planes;
  // What hid the plane before mostly hides this one.
  const double guess = this->Level - this->HiddenBefore;
  if (guess > 0.0)
  {
    this->Walk.Look(this->Post, azimuth, guess, chord);
  }
  if (!chord.Dark())
  {
    this->Walk(this->Post, azimuth, chord);
  }
  if (chord.Dark())
  {
    this->HiddenBefore = this->Level - chord.NearPlace();
    return { chord.Whole(), 0.0 };
  }
  return { chord.Whole(), chord.Lit() };
}

/// Light from everywhere but the disc opposite to the centre.
PlaneLight LampView::Inside(const LampAzimuth& azimuth, double cosine, double sine)
{
  const LampFacing facing{ this->NormalUp,
    azimuth.East * this->NormalEast + azimuth.North * this->NormalNorth };
  const double side = this->Level * sine;
  const double distance2 = this->Power + this->Radius * this->Radius;
  const double left = distance2 - side * side;
  double darkLow = 0.5 * Pi, darkHigh = 0.5 * Pi;
  if (left > 0.0)
  {
    // Both in units of the radius: half the dark disc's chord, as ChordOfDisc finds it.
    const double half = std::atan2(std::sqrt(left), std::sqrt(-this->Power));
    const double middle = std::atan2(-this->Rise, -this->Level * cosine);
    darkLow = std::clamp(middle - half, -0.5 * Pi, 0.5 * Pi);
    darkHigh = std::clamp(middle + half, -0.5 * Pi, 0.5 * Pi);
  }
  StartSlope start;
  this->Walk(this->Post, azimuth, start);
  const auto above = [&](double low)
  {
    return FacingLight(facing, 0.0, low, std::max(low, darkLow)) +
      FacingLight(facing, 0.0, std::max(low, darkHigh), 0.5 * Pi);
  };
  const double own = std::atan(FacingSlope(facing));
  return { above(own), above(std::max(own, std::atan(start.Slope))) };
}

/// Planes are spaced evenly in t: the azimuth from the centre is half swath x sin t, which makes the
/// round ends of the disc smooth, or t itself for a lamp all around.
PlaneLight LampView::At(double t)
{
  const double angle = this->HalfSwath > 0.0 ? this->HalfSwath * std::sin(t) : t;
  const double weight = this->HalfSwath > 0.0 ? this->HalfSwath * std::cos(t) : 1.0;
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const LampAzimuth azimuth{ this->Centre.East * cosine + this->Centre.North * sine,
    this->Centre.North * cosine - this->Centre.East * sine };
  const PlaneLight light =
    this->Power > 0.0 ? this->Outside(azimuth, cosine, sine) : this->Inside(azimuth, cosine, sine);
  return { weight * light.Whole, weight * light.Lit };
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
  const PlaneLight p = this->At(middle);
  // The trapezium's error, from that with half its width: a third of their difference remains.
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
  this->HalfSwath =
    this->Power > 0.0 && radius < this->Level ? std::asin(radius / this->Level) : 0.0;
  this->Total = {};
  if (this->HalfSwath > 0.0)
  {
    // The lowest tangent lies in the plane of the centre.
    const double tangent = std::sqrt(this->Power);
    const double along = this->Level * tangent + z * radius;
    const double end = std::min(tangent, this->Level + radius);
    if (along > 0.0 && this->HalfSwath < WidestFan &&
      this->Walk.Clear(
        post, this->Centre, this->HalfSwath, end, (z * tangent - this->Level * radius) / along))
    {
      return 1.0;
    }
  }

  const bool around = this->HalfSwath == 0.0;
  const int intervals = std::max(2, this->Settings.Azimuths) * (around ? AroundFactor : 1);
  const double begin = around ? -Pi : -0.5 * Pi;
  const double step = -2.0 * begin / intervals;
  const double cosine = (up * z + east * x + north * y) / std::max(distance, 1e-300);
  this->Allowed = this->Settings.Tolerance / intervals *
    DiscIrradiance(DiscOfLamp(radius, distance), distance > 0.0 ? cosine : 1.0);

  // At the ends of a swath the disc has no width; all around, the last plane is the first.
  const PlaneLight first = around ? this->At(begin) : PlaneLight{};
  PlaneLight before = first;
  for (int k = 1; k <= intervals; ++k)
  {
    const double t = begin + k * step;
    const PlaneLight next = k < intervals ? this->At(t) : first;
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
  const LampWalk walk(terrain, grid, settings.Shape, settings.Sink);
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
      const double z = lamp.Z - heights[column] - settings.Sink * level2;
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
