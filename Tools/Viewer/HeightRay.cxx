// SPDX-License-Identifier: BSD-3-Clause
#include "HeightRay.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

constexpr double SamplesPerPost = 2.0;
constexpr double MostSamples = 100000.0;
constexpr int Halvings = 8;

// Narrows the part [first, last] of the way to where a coordinate is within [low, high].
void Narrow(double from, double to, double low, double high, double& first, double& last)
{
  const double step = to - from;
  if (step == 0.0)
  {
    if (from < low || from > high)
    {
      last = -1.0;
    }
    return;
  }
  const double a = (low - from) / step;
  const double b = (high - from) / step;
  first = std::max(first, std::min(a, b));
  last = std::min(last, std::max(a, b));
}

skyline::ScenePoint Between(
  const skyline::ScenePoint& from, const skyline::ScenePoint& to, double part)
{
  skyline::ScenePoint point{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    point[k] = from[k] + part * (to[k] - from[k]);
  }
  return point;
}

} // namespace

namespace skyline
{

double GroundAt(vtkImageData* terrain, double exaggeration, double x, double y)
{
  const double* origin = terrain->GetOrigin();
  const double* spacing = terrain->GetSpacing();
  const int* size = terrain->GetDimensions();
  const double column = (x - origin[0]) / spacing[0];
  const double row = (y - origin[1]) / spacing[1];
  if (!(column >= 0.0 && column <= size[0] - 1 && row >= 0.0 && row <= size[1] - 1))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const int i = std::min(static_cast<int>(column), size[0] - 2);
  const int j = std::min(static_cast<int>(row), size[1] - 2);
  const double u = column - i;
  const double v = row - j;
  vtkDataArray* heights = terrain->GetPointData()->GetArray("Elevation");
  const vtkIdType post = static_cast<vtkIdType>(j) * size[0] + i;
  const double south =
    (1.0 - u) * heights->GetComponent(post, 0) + u * heights->GetComponent(post + 1, 0);
  const double north = (1.0 - u) * heights->GetComponent(post + size[0], 0) +
    u * heights->GetComponent(post + size[0] + 1, 0);
  return exaggeration * ((1.0 - v) * south + v * north);
}

double GroundOrZero(vtkImageData* terrain, double exaggeration, double x, double y)
{
  const double height = GroundAt(terrain, exaggeration, x, y);
  return std::isfinite(height) ? height : 0.0;
}

bool FindGround(vtkImageData* terrain, double exaggeration, const ScenePoint& from,
  const ScenePoint& to, ScenePoint& found)
{
  const double* bounds = terrain->GetBounds();
  double first = 0.0;
  double last = 1.0;
  Narrow(from[0], to[0], bounds[0], bounds[1], first, last);
  Narrow(from[1], to[1], bounds[2], bounds[3], first, last);
  const double* heights = terrain->GetPointData()->GetArray("Elevation")->GetFiniteRange();
  Narrow(
    from[2], to[2], exaggeration * heights[0] - 1.0, exaggeration * heights[1] + 1.0, first, last);
  if (!(first <= last))
  {
    return false;
  }
  const double* spacing = terrain->GetSpacing();
  const double posts =
    (last - first) * std::hypot((to[0] - from[0]) / spacing[0], (to[1] - from[1]) / spacing[1]);
  const int samples =
    2 + static_cast<int>(std::min(SamplesPerPost * posts, MostSamples)); // NaN is excluded above
  const auto depth = [&](double part)
  {
    const ScenePoint point = Between(from, to, part);
    return GroundAt(terrain, exaggeration, point[0], point[1]) - point[2]; // above 0: below ground
  };
  double above = first;
  for (int k = 0; k <= samples; ++k)
  {
    double part = first + (last - first) * k / samples;
    if (depth(part) >= 0.0)
    {
      for (int turn = 0; turn < Halvings; ++turn)
      {
        const double middle = 0.5 * (above + part);
        (depth(middle) >= 0.0 ? part : above) = middle;
      }
      found = Between(from, to, part);
      found[2] = GroundAt(terrain, exaggeration, found[0], found[1]);
      return true;
    }
    above = part;
  }
  return false;
}

} // namespace skyline
