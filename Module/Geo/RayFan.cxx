// SPDX-License-Identifier: BSD-3-Clause
#include "Geo/RayFan.h"

#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>

namespace skyline
{
namespace
{

/// Number of parts of the range of directions for which the largest widening is determined.
constexpr int Bins = 256;

/// The ray of a post, expressed in the metric of the centre.
struct OwnRay
{
  double Direction; ///< radians, on the ground at the centre
  double Length;    ///< logarithm of its length per line divided by that at the centre
  double Widening;  ///< change of the angle at the post per change of Direction
};

OwnRay RayOf(const PostMetric& metric, const PostMetric& reference, double azimuth)
{
  const double columns = std::sin(azimuth) / metric.X;
  const double rows = (std::cos(azimuth) - metric.Shear * columns) / metric.Y;
  const double length = LengthOf(reference, columns, rows); // 1 on the ground at the post itself
  OwnRay ray;
  ray.Direction = std::atan2(reference.X * columns, reference.Shear * columns + reference.Y * rows);
  ray.Length = -std::log(length);
  // A direction turns by the area of the cell divided by the squared length.
  ray.Widening = metric.X * metric.Y / (reference.X * reference.Y) * length * length;
  return ray;
}

/// The fractional position of a value among rising nodes.
float PlaceOf(const std::vector<double>& nodes, double value)
{
  const auto above = std::upper_bound(nodes.begin(), nodes.end(), value);
  if (above == nodes.begin())
  {
    return 0.0f;
  }
  if (above == nodes.end())
  {
    return static_cast<float>(nodes.size() - 1);
  }
  const auto index = static_cast<double>(above - nodes.begin() - 1);
  const double below = *(above - 1);
  return static_cast<float>(index + (value - below) / (*above - below));
}

/// Nodes from `least` to `greatest` whose distances are at most `step(from)`.
template <typename Step>
std::vector<double> Nodes(double least, double greatest, const Step& step)
{
  if (greatest - least <= step(least))
  {
    return { 0.5 * (least + greatest) };
  }
  std::vector<double> nodes{ least };
  while (nodes.back() < greatest)
  {
    nodes.push_back(nodes.back() + step(nodes.back()));
  }
  return nodes;
}

/// The largest widening of the posts that use a direction, for each part of the range of
/// directions. A part that no post uses gets the value of its neighbours.
class WideningByDirection
{
public:
  WideningByDirection(const std::vector<OwnRay>& rays, double least, double greatest)
    : Least(least)
    , Width(std::max(greatest - least, 1e-12) / Bins)
    , Values(Bins, 0.0)
  {
    for (const OwnRay& ray : rays)
    {
      double& here = this->Values[this->Bin(ray.Direction)];
      here = std::max(here, ray.Widening);
    }
    for (std::size_t i = 1; i < this->Values.size(); ++i)
    {
      this->Values[i] = this->Values[i] > 0.0 ? this->Values[i] : this->Values[i - 1];
    }
  }

  double Largest(double from, double to) const
  {
    return *std::max_element(this->Values.begin() + static_cast<std::ptrdiff_t>(this->Bin(from)),
      this->Values.begin() + static_cast<std::ptrdiff_t>(this->Bin(to)) + 1);
  }

private:
  std::size_t Bin(double direction) const
  {
    return static_cast<std::size_t>(
      std::clamp((direction - this->Least) / this->Width, 0.0, Bins - 1.0));
  }

  double Least, Width;
  std::vector<double> Values;
};

} // namespace

RayFan::RayFan(const GroundMetric& metric, double azimuth, bool onImage, bool curved)
  : Metric(metric)
  , Reference(metric.Centre())
{
  const auto ground = [&](const PostMetric& post)
  { return onImage ? metric.GroundAzimuth(post, azimuth) : azimuth; };
  const double middle = RayOf(this->Reference, this->Reference, ground(this->Reference)).Direction;
  std::vector<OwnRay> rays;
  metric.ForEachNode(
    [&](const PostMetric& node)
    {
      OwnRay ray = RayOf(node, this->Reference, ground(node));
      ray.Direction = middle + std::remainder(ray.Direction - middle, 2.0 * Pi);
      rays.push_back(ray);
    });
  const auto byDirection = [](const OwnRay& a, const OwnRay& b)
  { return a.Direction < b.Direction; };
  const auto byLength = [](const OwnRay& a, const OwnRay& b) { return a.Length < b.Length; };
  const auto [first, last] = std::minmax_element(rays.begin(), rays.end(), byDirection);
  const auto [shortest, longest] = std::minmax_element(rays.begin(), rays.end(), byLength);
  const double least = first->Direction, greatest = last->Direction;

  const WideningByDirection widening(rays, least, greatest);
  this->Directions = Nodes(least, greatest,
    [&](double from)
    {
      double step = FanAzimuthStep / widening.Largest(from, from);
      for (int i = 0; i < 3; ++i)
      {
        step = FanAzimuthStep / widening.Largest(from, from + step);
      }
      return step;
    });
  this->Lengths = curved
    ? Nodes(shortest->Length, longest->Length, [](double) { return FanLengthStep; })
    : std::vector<double>{ 0.0 };
  for (const OwnRay& ray : rays)
  {
    this->Direction.push_back(PlaceOf(this->Directions, ray.Direction));
    this->Length.push_back(PlaceOf(this->Lengths, ray.Length));
  }
}

PostMetric RayFan::MetricOf(std::size_t length) const
{
  const double scale = std::exp(this->Lengths[length]);
  return { scale * this->Reference.X, scale * this->Reference.Shear, scale * this->Reference.Y };
}

void RayFan::Places(std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count,
  float* directions, float* lengths) const
{
  this->Metric.Interpolate(this->Direction, row, column, count, directions);
  this->Metric.Interpolate(this->Length, row, column, count, lengths);
}

} // namespace skyline
