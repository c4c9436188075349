// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/SunAccumulator.h"

#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skyline
{

namespace
{

/// Number of posts that are tested together: usually all of them are lit, or all are in shadow.
constexpr std::ptrdiff_t Block = 16;

/// Azimuths that differ by less, in radians, count as equal.
constexpr double SameAzimuth = 1e-9;

/// The slope of a horizon as the sun sees it: at least 0, that of the horizontal plane.
float SunSlope(float slope)
{
  return slope > 0.0f ? slope : 0.0f;
}

/// The elevation, in radians, of a slope above a direction whose elevation has the given sine and
/// cosine. The difference is taken before the arc tangent to keep its digits.
double Above(float slope, double sine, double cosine)
{
  const double t = slope;
  return std::atan2(t * cosine - sine, cosine + t * sine);
}

/// The slope of an elevation, infinite at and beyond the zenith and the nadir.
float SlopeOf(double elevation)
{
  const double infinite = std::numeric_limits<double>::infinity();
  return static_cast<float>(elevation >= 0.5 * Pi ? infinite
      : elevation <= -0.5 * Pi                    ? -infinite
                                                  : std::tan(elevation));
}

/// Light of a flat disc between its centre and the line at s (-1 to 1, in radii), as a share of the
/// light of the whole disc. u: limb darkening. The chord at s has the light 2 sqrt(1 - s^2) for a
/// uniform disc and pi/2 (1 - s^2) for mu.
double StripLight(double s, double u)
{
  const double even = std::asin(s) + s * std::sqrt((1.0 - s) * (1.0 + s));
  const double bright = 0.5 * Pi * (s - s * s * s / 3.0);
  return ((1.0 - u) * even + u * bright) / (Pi * (1.0 - u / 3.0));
}

/// 1 if a point sun is lit, 0 if not. horizon: its elevation in radians above the sun.
float PointLit(double horizon)
{
  return horizon < 0.0 ? 1.0f : 0.0f;
}

} // namespace

SunAccumulator::SunAccumulator(std::ptrdiff_t columns, std::ptrdiff_t rows, const SunDisc& sun,
  const PostBuffer& visibility, double limbDarkening)
  : Columns(columns)
  , Sun(sun)
  , Visibility(visibility)
  , LimbDarkening(limbDarkening)
  , Previous(new float[static_cast<std::size_t>(columns * rows)])
{
}

SunAccumulator::SunAccumulator(std::ptrdiff_t columns, std::ptrdiff_t rows,
  const SunDirections& directions, double radius, const PostBuffer& visibility,
  double limbDarkening)
  : SunAccumulator(columns, rows, SunDisc{ 0.0, 0.0, radius }, visibility, limbDarkening)
{
  this->Directions = directions;
  this->Hidden.reset(new float[static_cast<std::size_t>(columns * rows)]);
}

void SunAccumulator::Begin(double azimuth, double)
{
  const double turn = 2.0 * Pi;
  this->First = !this->Started;
  this->Started = true;
  this->Before = this->First ? azimuth : this->Azimuth;
  this->Azimuth = azimuth;
  const double step = azimuth - this->Before;
  this->Interval = step - turn * std::floor(step / turn);
  this->Sin0 = std::sin(this->Before);
  this->Cos0 = std::cos(this->Before);
  this->Sin1 = std::sin(this->Azimuth);
  this->Cos1 = std::cos(this->Azimuth);

  const double middle = this->Before + 0.5 * this->Interval - this->Sun.Azimuth;
  const double from = std::remainder(middle, turn) - 0.5 * this->Interval;
  const double to = from + this->Interval;
  this->PointPlace = -1.0;
  if (this->First || (from <= SameAzimuth && to >= -SameAzimuth))
  {
    this->PointPlace = this->Interval > 0.0 ? std::clamp(-from / this->Interval, 0.0, 1.0) : 1.0;
  }
  if (!this->First && !this->Directions)
  {
    this->Slice.Set(this->Sun, from, to, this->LimbDarkening);
    this->SliceLight = static_cast<float>(this->Slice.Whole());
    this->Whole += this->SliceLight;
  }
}

void SunAccumulator::Add(
  std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes)
{
  const std::ptrdiff_t post = row * this->Columns + column;
  float* before = this->Previous.get() + post;
  if (this->First)
  {
    for (std::ptrdiff_t i = 0; i < count; ++i)
    {
      before[i] = SunSlope(slopes[i]);
      this->Result(post + i) = 0.0f;
    }
    if (this->Hidden)
    {
      std::fill_n(this->Hidden.get() + post, count, 0.0f);
    }
    if (this->Sun.Radius > 0.0)
    {
      return;
    }
  }
  if (this->Directions)
  {
    this->AddEach(row, column, count, slopes);
  }
  else if (this->Sun.Radius > 0.0)
  {
    this->AddSame(post, count, slopes);
  }
  else
  {
    this->AddSamePoint(post, count, slopes);
  }
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    before[i] = SunSlope(slopes[i]);
  }
}

void SunAccumulator::AddSame(std::ptrdiff_t post, std::ptrdiff_t count, const float* slopes)
{
  if (this->SliceLight <= 0.0f)
  {
    return;
  }
  const double sine = std::sin(this->Sun.Elevation);
  const double cosine = std::cos(this->Sun.Elevation);
  // Only horizons between the lowest and the highest point of the disc need the exact computation.
  // The limits are moved outwards to the next floats, because they are rounded.
  const float infinite = std::numeric_limits<float>::infinity();
  const float lowest = std::nextafter(SlopeOf(this->Sun.Elevation - this->Sun.Radius), -infinite);
  const float highest = std::nextafter(SlopeOf(this->Sun.Elevation + this->Sun.Radius), infinite);
  const float light = this->SliceLight;
  const float* before = this->Previous.get() + post;
  for (std::ptrdiff_t begin = 0; begin < count; begin += Block)
  {
    const std::ptrdiff_t size = std::min(Block, count - begin);
    float last[Block], hidden[Block];
    int cut = 0, covered = 0;
    // Without branches, so that the compiler vectorises a whole block.
    const auto look = [&](std::ptrdiff_t end)
    {
      for (std::ptrdiff_t i = 0; i < end; ++i)
      {
        const float first = before[begin + i], next = SunSlope(slopes[begin + i]);
        const int above = static_cast<int>(first >= highest) & static_cast<int>(next >= highest);
        const int below = static_cast<int>(first <= lowest) & static_cast<int>(next <= lowest);
        last[i] = next;
        hidden[i] = above ? light : 0.0f;
        covered |= above;
        cut |= 1 ^ (above | below);
      }
    };
    if (size == Block)
    {
      look(Block);
    }
    else
    {
      look(size);
    }
    if (!(cut | covered))
    {
      continue;
    }
    for (std::ptrdiff_t i = 0; i < size; ++i)
    {
      const float first = before[begin + i], next = last[i];
      if (cut && !(first >= highest && next >= highest) && !(first <= lowest && next <= lowest))
      {
        hidden[i] = static_cast<float>(
          this->Slice.Hidden(Above(first, sine, cosine), Above(next, sine, cosine)));
      }
      this->Result(post + begin + i) += hidden[i];
    }
  }
}

void SunAccumulator::AddSamePoint(std::ptrdiff_t post, std::ptrdiff_t count, const float* slopes)
{
  if (this->PointPlace < 0.0)
  {
    return;
  }
  const double sine = std::sin(this->Sun.Elevation);
  const double cosine = std::cos(this->Sun.Elevation);
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    const double first = Above(this->Previous[static_cast<std::size_t>(post + i)], sine, cosine);
    const double last = Above(SunSlope(slopes[i]), sine, cosine);
    this->Result(post + i) = PointLit(first + this->PointPlace * (last - first));
  }
}

void SunAccumulator::AddEach(
  std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes)
{
  constexpr std::ptrdiff_t Piece = 256;
  float x[Piece], y[Piece], z[Piece], outside[Piece];
  const auto reach = static_cast<float>(std::sin(this->Sun.Radius));
  const auto sin0 = static_cast<float>(this->Sin0), cos0 = static_cast<float>(this->Cos0);
  const auto sin1 = static_cast<float>(this->Sin1), cos1 = static_cast<float>(this->Cos1);
  DiscSlice slice;
  for (std::ptrdiff_t begin = 0; begin < count; begin += Piece)
  {
    const std::ptrdiff_t size = std::min(Piece, count - begin);
    this->Directions(row, column + begin, size, x, y, z);
    // For most azimuths, most discs lie elsewhere. Relative to the azimuth of the sun, an end of
    // the interval has the sine `side` and the cosine `ahead`, both times the cosine of the
    // elevation of the sun.
    for (std::ptrdiff_t i = 0; i < size; ++i)
    {
      const float side0 = sin0 * y[i] - cos0 * x[i], ahead0 = sin0 * x[i] + cos0 * y[i];
      const float side1 = sin1 * y[i] - cos1 * x[i], ahead1 = sin1 * x[i] + cos1 * y[i];
      const float past = std::max(side0, -side1) - reach;
      const float behind = -std::max(ahead0, ahead1);
      const float overhead = reach * reach - (x[i] * x[i] + y[i] * y[i]);
      outside[i] = std::min(std::max(past, behind), -overhead);
    }
    for (std::ptrdiff_t i = 0; i < size; ++i)
    {
      if (outside[i] <= 0.0f || this->First)
      {
        const std::ptrdiff_t post = row * this->Columns + column + begin + i;
        this->AddOne(post, SunSlope(slopes[begin + i]), { x[i], y[i], z[i] }, slice);
      }
    }
  }
}

void SunAccumulator::AddOne(
  std::ptrdiff_t post, float last, const std::array<double, 3>& sun, DiscSlice& slice)
{
  const double x = sun[0], y = sun[1], sine = sun[2];
  const double cosine = std::sqrt(x * x + y * y);
  const double side0 = this->Sin0 * y - this->Cos0 * x, ahead0 = this->Sin0 * x + this->Cos0 * y;
  const double side1 = this->Sin1 * y - this->Cos1 * x, ahead1 = this->Sin1 * x + this->Cos1 * y;
  const float first = this->Previous[static_cast<std::size_t>(post)];
  if (this->Sun.Radius == 0.0)
  {
    const double place = this->Interval > 0.0
      ? std::clamp(-std::atan2(side0, ahead0) / this->Interval, 0.0, 1.0)
      : 1.0;
    const double low = Above(first, sine, cosine), high = Above(last, sine, cosine);
    this->Result(post) = PointLit(low + place * (high - low));
    return;
  }

  float& lit = this->Result(post);
  float& hidden = this->Hidden[static_cast<std::size_t>(post)];
  const double reach = std::sin(this->Sun.Radius);
  // The horizon is above the disc if rise >= tan(radius) run, where rise and run are the components
  // of the direction to the horizon across and along the direction to the sun.
  const double rise0 = first * cosine - sine, run0 = cosine + first * sine;
  const double rise1 = last * cosine - sine, run1 = cosine + last * sine;
  const double tangent = std::tan(this->Sun.Radius);
  const bool plain = run0 > 0.0 && run1 > 0.0 && reach < cosine;
  const bool covered = plain && rise0 >= tangent * run0 && rise1 >= tangent * run1;
  const bool clear = plain && rise0 <= -tangent * run0 && rise1 <= -tangent * run1;
  if (covered || clear)
  {
    const double begin = ahead0 < 0.0 ? -1.0 : std::clamp(side0 / reach, -1.0, 1.0);
    const double end = ahead1 < 0.0 ? 1.0 : std::clamp(side1 / reach, -1.0, 1.0);
    const double share =
      StripLight(end, this->LimbDarkening) - StripLight(begin, this->LimbDarkening);
    (covered ? hidden : lit) += static_cast<float>(std::max(share, 0.0));
    return;
  }
  const double half = std::sin(0.5 * this->Sun.Radius);
  // All light of the disc.
  const double disc = 4.0 * Pi * half * half * (1.0 - this->LimbDarkening / 3.0);
  const double from = std::atan2(side0, ahead0);
  slice.Set({ 0.0, std::atan2(sine, cosine), this->Sun.Radius }, from, from + this->Interval,
    this->LimbDarkening);
  const double light =
    slice.Whole() > 0.0 ? slice.Hidden(Above(first, sine, cosine), Above(last, sine, cosine)) : 0.0;
  hidden += static_cast<float>(light / disc);
  lit += static_cast<float>((slice.Whole() - light) / disc);
}

void SunAccumulator::Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd)
{
  if (this->Sun.Radius == 0.0)
  {
    return;
  }
  for (std::ptrdiff_t post = rowBegin * this->Columns; post < rowEnd * this->Columns; ++post)
  {
    float& result = this->Result(post);
    const float hidden = this->Hidden ? this->Hidden[static_cast<std::size_t>(post)] : result;
    const float lit = this->Hidden ? result : this->Whole - hidden;
    // 0 / 0, and so NaN, if no azimuth met the disc. Clamped, because light may be counted twice or
    // not at all due to rounding.
    result =
      hidden <= 0.0f && lit > 0.0f ? 1.0f : std::max(lit, 0.0f) / (std::max(lit, 0.0f) + hidden);
  }
}

} // namespace skyline
