// SPDX-License-Identifier: BSD-3-Clause
// Points at the elevation e in the vertical plane of the azimuth offset a lie at an angle r from
// the centre of the disc (elevation s) if
//   sin e sin s + cos e cos s cos a = cos r,
// that is C cos(e - p) = cos r with
//   C^2 = 1 - cos^2 s sin^2 a,   tan p = sin s / (cos s cos a).
// All values are relative to the centre and use differences that do not cancel. With v = 1 - cos a:
//   tan(p - s) = sin s cos s v / (1 - cos^2 s v)
//   half chord = atan2(sqrt(sin^2 r - cos^2 s sin^2 a), cos r)
#include "Sun/SunDisc.h"

#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>

namespace skyline
{

namespace
{

/// Number of intervals into which the swath of a sun is divided.
constexpr int IntervalsPerSwath = 16;

/// Number of intervals of the full circle if the zenith or the nadir lies in the disc: 15 degrees
/// each.
constexpr int IntervalsPerCircle = 24;

/// Chords are integrated by three-point Gauss rules, each over at most this part of the disc, as an
/// angle t with azimuth = half swath * sin t, which makes the integrand smooth at the round ends of
/// the disc.
constexpr double LargestPiece = Pi / 8.0;

/// Below this angle (radians), five terms of the sine and cosine series have an error of 1e-17.
constexpr double SmallAngle = 0.05;

} // namespace

double HalfSwath(double elevation, double radius)
{
  const double reach = std::sin(radius);
  const double level = std::cos(elevation);
  return reach >= level ? (radius > 0.0 ? Pi : 0.0) : std::asin(reach / level);
}

DiscChord ChordOfDisc(const SunDisc& disc, double azimuthFromCentre)
{
  const double s = std::sin(disc.Elevation);
  const double c = std::cos(disc.Elevation);
  const double half = std::sin(0.5 * azimuthFromCentre);
  const double v = 2.0 * half * half;
  const double side = c * std::sin(azimuthFromCentre);
  const double reach = std::sin(disc.Radius);
  const double left = (reach - side) * (reach + side);
  DiscChord chord;
  if (left > 0.0)
  {
    chord.Middle = std::atan2(s * c * v, 1.0 - c * c * v);
    chord.Half = std::atan2(std::sqrt(left), std::cos(disc.Radius));
    chord.Low = std::max(chord.Middle - chord.Half, -0.5 * Pi - disc.Elevation);
    chord.High = std::min(chord.Middle + chord.Half, 0.5 * Pi - disc.Elevation);
    chord.High = std::max(chord.High, chord.Low);
  }
  return chord;
}

/// sin(elevation + angle) - sin(elevation): solid angle per azimuth between both elevations.
double DiscSlice::Rise(double angle) const
{
  if (std::abs(angle) < SmallAngle)
  {
    const double q = angle * angle;
    const double sine =
      angle * (1.0 - q / 6.0 * (1.0 - q / 20.0 * (1.0 - q / 42.0 * (1.0 - q / 72.0))));
    const double versine = 0.5 * q * (1.0 - q / 12.0 * (1.0 - q / 30.0 * (1.0 - q / 56.0)));
    return this->CosElevation * sine - this->SinElevation * versine;
  }
  const double half = std::sin(0.5 * angle);
  return this->CosElevation * std::sin(angle) - this->SinElevation * 2.0 * half * half;
}

/// Light per azimuth of the chord below an angle, except for a constant of the chord. With q
/// measured from the middle m of the chord, half its length d and mu = sqrt(d^2 - q^2) / r, cos e =
/// cos m - q sin m except for terms in q^2 / 2:
///   Int mu cos e dq = { cos m [q sqrt(d^2 - q^2) + d^2 asin(q / d)] / 2
///                       + sin m (d^2 - q^2)^(3/2) / 3 } / r
double DiscSlice::LightBelow(const DiscChord& chord, double angle) const
{
  const double even = this->Rise(angle);
  if (this->LimbDarkening == 0.0)
  {
    return even;
  }
  const double d = chord.Half;
  const double q = std::clamp(angle - chord.Middle, -d, d);
  const double rest = (d - q) * (d + q);
  const double root = std::sqrt(rest);
  const double cosine = std::cos(chord.Middle), sine = std::sin(chord.Middle);
  const double cosMiddle = this->CosElevation * cosine - this->SinElevation * sine;
  const double sinMiddle = this->SinElevation * cosine + this->CosElevation * sine;
  const double bright =
    0.5 * cosMiddle * (q * root + d * d * std::atan2(q, root)) + sinMiddle * rest * root / 3.0;
  return (1.0 - this->LimbDarkening) * even + this->LimbDarkening * bright / this->Radius;
}

void DiscSlice::Set(const SunDisc& disc, double from, double to, double limbDarkening)
{
  this->SinElevation = std::sin(disc.Elevation);
  this->CosElevation = std::cos(disc.Elevation);
  this->Radius = disc.Radius;
  this->LimbDarkening = limbDarkening;
  this->Samples.clear();
  this->Light = 0.0;

  const double swath = HalfSwath(disc.Elevation, disc.Radius);
  const bool circle = swath >= Pi;
  const double begin = circle ? from : std::max(from, -swath);
  const double end = circle ? to : std::min(to, swath);
  if (!(begin < end))
  {
    return;
  }
  // A disc around the zenith has no ends and is integrated directly over azimuth.
  const double first = circle ? begin : std::asin(begin / swath);
  const double last = circle ? end : std::asin(end / swath);
  const auto pieces = std::max(1.0, std::ceil((last - first) / LargestPiece - 1e-9));
  const double step = (last - first) / pieces;
  const double nodes[3] = { 0.5 - 0.5 * std::sqrt(0.6), 0.5, 0.5 + 0.5 * std::sqrt(0.6) };
  const double weights[3] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };
  for (int piece = 0; piece < static_cast<int>(pieces); ++piece)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double t = first + (piece + nodes[k]) * step;
      const double azimuth = circle ? t : swath * std::sin(t);
      Sample sample;
      sample.Chord = ChordOfDisc(disc, azimuth);
      sample.Place = (azimuth - from) / (to - from);
      sample.Weight = weights[k] * step * (circle ? 1.0 : swath * std::cos(t));
      sample.Light = sample.Weight *
        (this->LightBelow(sample.Chord, sample.Chord.High) -
          this->LightBelow(sample.Chord, sample.Chord.Low));
      if (sample.Light > 0.0)
      {
        this->Samples.push_back(sample);
        this->Light += sample.Light;
      }
    }
  }
}

double DiscSlice::Hidden(double first, double last) const
{
  double hidden = 0.0;
  for (const Sample& sample : this->Samples)
  {
    const DiscChord& chord = sample.Chord;
    const double horizon = first + sample.Place * (last - first);
    if (horizon >= chord.High)
    {
      hidden += sample.Light;
    }
    else if (horizon > chord.Low)
    {
      hidden +=
        sample.Weight * (this->LightBelow(chord, horizon) - this->LightBelow(chord, chord.Low));
    }
  }
  return hidden;
}

std::vector<double> SunAzimuths(
  double azimuthMin, double azimuthMax, double elevationMin, double elevationMax, double radius)
{
  const double low = std::abs(elevationMin), high = std::abs(elevationMax);
  const bool crossing = elevationMin < 0.0 && elevationMax > 0.0;
  const double widest = HalfSwath(std::max(low, high), radius);
  const double narrowest = HalfSwath(crossing ? 0.0 : std::min(low, high), radius);
  const bool single = azimuthMin == azimuthMax && elevationMin == elevationMax;
  if (azimuthMin == azimuthMax && radius == 0.0)
  {
    return { azimuthMin };
  }

  double begin = azimuthMin - widest;
  double end = azimuthMax + widest;
  double step = 2.0 * narrowest / IntervalsPerSwath;
  if (!single)
  {
    step = std::max(step, 2.0 * MeanSunRadius * RadiansPerDegree / IntervalsPerSwath);
  }
  if (widest >= Pi || end - begin >= 2.0 * Pi)
  {
    begin = 0.5 * (azimuthMin + azimuthMax) - Pi;
    end = begin + 2.0 * Pi;
  }
  step = std::min(step, 2.0 * Pi / IntervalsPerCircle);
  const auto intervals = std::max(1.0, std::ceil((end - begin) / step - 1e-9));
  std::vector<double> azimuths;
  for (int k = 0; k <= static_cast<int>(intervals); ++k)
  {
    azimuths.push_back(begin + (end - begin) * k / intervals);
  }
  return azimuths;
}

} // namespace skyline
