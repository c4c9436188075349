// SPDX-License-Identifier: BSD-3-Clause
// Snyder & Nowrouzezahrai (2008), SN08, section 4, by the simplest loops in double precision.
#ifndef skyline_SlowPyramid_h
#define skyline_SlowPyramid_h

#include "Horizon/HorizonMethod.h"
#include "Reference/Oracle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace skyline
{
namespace testing
{

/// The basis function of the cubic B-spline around 0.
inline double Bump(double x)
{
  const double a = std::abs(x);
  return a < 1.0 ? (4.0 - 6.0 * a * a + 3.0 * a * a * a) / 6.0
    : a < 2.0    ? (2.0 - a) * (2.0 - a) * (2.0 - a) / 6.0
                 : 0.0;
}

/// A plane of values, and for each value the part that is known.
struct SlowPlane
{
  std::ptrdiff_t Columns = 0, Rows = 0;
  std::vector<double> Values, Known;

  double Value(std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    return this->Values[this->Index(column, row)];
  }
  double Part(std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    return this->Known[this->Index(column, row)];
  }
  std::size_t Index(std::ptrdiff_t column, std::ptrdiff_t row) const // repeats the edge
  {
    return static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(row, 0, this->Rows - 1) * this->Columns +
      std::clamp<std::ptrdiff_t>(column, 0, this->Columns - 1));
  }
};

/// The bilinear value at (x, y), or that of the bicubic B-spline if `bump` is true.
inline void SampleAt(
  const SlowPlane& plane, double x, double y, bool bump, double& value, double& known)
{
  value = known = 0.0;
  const auto i = static_cast<std::ptrdiff_t>(std::floor(x));
  const auto j = static_cast<std::ptrdiff_t>(std::floor(y));
  for (std::ptrdiff_t r = j - 1; r <= j + 2; ++r)
  {
    for (std::ptrdiff_t c = i - 1; c <= i + 2; ++c)
    {
      const double dx = x - static_cast<double>(c), dy = y - static_cast<double>(r);
      const double weight = bump
        ? Bump(dx) * Bump(dy)
        : std::max(0.0, 1.0 - std::abs(dx)) * std::max(0.0, 1.0 - std::abs(dy));
      value += weight * plane.Value(c, r);
      known += weight * plane.Part(c, r);
    }
  }
}

/// All levels of the pyramid, each at the full resolution of the field, the coarsest one first.
inline std::vector<SlowPlane> FullLevels(const oracle::OracleField& field, double step)
{
  SlowPlane finest{ field.Columns, field.Rows, {}, {} };
  for (std::ptrdiff_t row = 0; row < field.Rows; ++row)
  {
    for (std::ptrdiff_t column = 0; column < field.Columns; ++column)
    {
      const bool there = field.PostOccludes(column, row);
      finest.Values.push_back(there ? field.At(column, row) : 0.0);
      finest.Known.push_back(there ? 1.0 : 0.0);
    }
  }
  const double posts = static_cast<double>(std::max(field.Columns, field.Rows));
  const int levels = static_cast<int>(std::ceil(step * std::log2(posts) - 1e-9)) + 1;
  std::vector<SlowPlane> full(static_cast<std::size_t>(levels));
  full.back() = finest;
  SlowPlane level = finest;
  const double ratio = std::pow(2.0, 1.0 / step);
  double scale = 1.0;
  for (int i = levels - 2; i >= 0; --i)
  {
    scale *= ratio;
    const auto size = [&](std::ptrdiff_t n)
    { return static_cast<std::ptrdiff_t>(std::ceil(static_cast<double>(n) / scale - 1e-9)); };
    SlowPlane coarse{ size(field.Columns), size(field.Rows), {}, {} };
    for (std::ptrdiff_t row = 0; row < coarse.Rows; ++row)
    {
      for (std::ptrdiff_t column = 0; column < coarse.Columns; ++column)
      {
        double value = 0.0, known = 0.0;
        SampleAt(level, (static_cast<double>(column) + 0.5) * ratio - 0.5,
          (static_cast<double>(row) + 0.5) * ratio - 0.5, false, value, known);
        coarse.Values.push_back(value);
        coarse.Known.push_back(known);
      }
    }
    level = coarse;
    SlowPlane& out = full[static_cast<std::size_t>(i)];
    out = SlowPlane{ field.Columns, field.Rows, {}, {} };
    for (std::ptrdiff_t row = 0; row < field.Rows; ++row)
    {
      for (std::ptrdiff_t column = 0; column < field.Columns; ++column)
      {
        double value = 0.0, known = 0.0;
        SampleAt(level, (static_cast<double>(column) + 0.5) / scale - 0.5,
          (static_cast<double>(row) + 0.5) / scale - 0.5, true, value, known);
        out.Values.push_back(value);
        out.Known.push_back(known);
      }
    }
  }
  return full;
}

/// The horizon of a post in radians, from the blocking angles of all levels.
inline double SlowHorizon(const oracle::OracleField& field, const std::vector<SlowPlane>& full,
  const PyramidSettings& settings, std::ptrdiff_t column, std::ptrdiff_t row, double azimuth)
{
  const auto levels = static_cast<std::ptrdiff_t>(full.size());
  const oracle::Direction toward = oracle::DirectionOfAzimuth(azimuth);
  const double metres =
    1.0 / std::hypot(toward.East / field.SpacingX, toward.North / field.SpacingY);
  std::vector<double> angles;
  for (std::ptrdiff_t i = 0; i < levels; ++i)
  {
    const double distance = settings.Distance * metres *
      std::pow(2.0, static_cast<double>(levels - 1 - i) / settings.LevelStep);
    const double sharper =
      std::ceil(static_cast<double>(i) + settings.LevelStep * settings.LevelOffset - 1e-9);
    const SlowPlane& plane =
      full[static_cast<std::size_t>(std::min(sharper, static_cast<double>(levels - 1)))];
    const double x = static_cast<double>(column) + distance * toward.East / field.SpacingX;
    const double y = static_cast<double>(row) + distance * toward.North / field.SpacingY;
    double angle = 0.0;
    const double edge = 1e-9;
    if (x > -edge && y > -edge && x < static_cast<double>(field.Columns - 1) + edge &&
      y < static_cast<double>(field.Rows - 1) + edge)
    {
      double there = 0.0, known = 0.0;
      SampleAt(plane, x, y, false, there, known);
      if (known >= 0.5 && plane.Part(column, row) >= 1e-6)
      {
        const double here = plane.Value(column, row) / plane.Part(column, row);
        const double slope = (there / known - here) / distance - field.CurvatureDrop * distance;
        angle = std::max(0.0, std::atan(slope));
      }
    }
    angles.push_back(angle);
  }
  if (!settings.Spline)
  {
    return *std::max_element(angles.begin(), angles.end());
  }
  double best = 0.0;
  for (std::ptrdiff_t half = 0; half <= 2 * (levels - 1); ++half)
  {
    const double t = 0.5 * static_cast<double>(half);
    double value = 0.0;
    for (std::ptrdiff_t k = -2; k <= levels + 1; ++k)
    {
      const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(k, 0, levels - 1));
      value += Bump(t - static_cast<double>(k)) * angles[i];
    }
    best = std::max(best, value);
  }
  return best;
}

} // namespace testing
} // namespace skyline

#endif
