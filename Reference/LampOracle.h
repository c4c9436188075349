// SPDX-License-Identifier: BSD-3-Clause
// The light of a lamp, by testing rays against triangles in double precision. For tests only.
#ifndef skyline_LampOracle_h
#define skyline_LampOracle_h

#include "Reference/Oracle.h"
#include "Reference/Shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace skyline
{
namespace oracle
{

struct Vector3
{
  double X, Y, Z;
};

inline Vector3 operator+(const Vector3& a, const Vector3& b)
{
  return { a.X + b.X, a.Y + b.Y, a.Z + b.Z };
}
inline Vector3 operator*(double k, const Vector3& a)
{
  return { k * a.X, k * a.Y, k * a.Z };
}
inline Vector3 operator-(const Vector3& a, const Vector3& b)
{
  return a + -1.0 * b;
}
inline double Dot(const Vector3& a, const Vector3& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}
inline Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}
inline Vector3 Unit(const Vector3& a)
{
  return (1.0 / std::sqrt(Dot(a, a))) * a;
}

/// The position of a post: metres east and north of post (0, 0), and height.
inline Vector3 PlaceOf(const OracleField& field, std::ptrdiff_t column, std::ptrdiff_t row)
{
  return { static_cast<double>(column) * field.SpacingX, static_cast<double>(row) * field.SpacingY,
    field.At(column, row) };
}

/// Whether a ray from o in the direction d meets the triangle a, b, c at a parameter in (0, end].
inline bool MeetsTriangle(const Vector3& o, const Vector3& d, const Vector3& a, const Vector3& b,
  const Vector3& c, double end)
{
  const Vector3 u = b - a, v = c - a, p = Cross(d, v);
  const double det = Dot(u, p);
  if (det == 0.0)
  {
    return false;
  }
  const Vector3 s = o - a, q = Cross(s, u);
  const double i = Dot(s, p) / det, j = Dot(d, q) / det, t = Dot(v, q) / det;
  constexpr double slack = 1e-12; // no ray passes between two triangles
  return i >= -slack && j >= -slack && i + j <= 1.0 + slack && t > 1e-9 * end && t <= end;
}

/// Whether terrain (triangles, without curvature) blocks the ray from a post along a unit vector within
/// `end` metres. A ray that starts downwards into the surface is blocked at once.
inline bool Stopped(
  const OracleField& field, std::ptrdiff_t column, std::ptrdiff_t row, const Vector3& d, double end)
{
  const Vector3 o = PlaceOf(field, column, row);
  for (std::ptrdiff_t dj = -1; dj <= 0; ++dj)
  {
    for (std::ptrdiff_t di = -1; di <= 0; ++di)
    {
      const double a = d.X / field.SpacingX, b = d.Y / field.SpacingY;
      if (!field.HasCell(column + di, row + dj) || (di == 0 ? a < 0.0 : a > 0.0) ||
        (dj == 0 ? b < 0.0 : b > 0.0))
      {
        continue;
      }
      // The heights of the triangle at the post grow by ex per column and by ey per row.
      const double sw = field.At(column + di, row + dj), se = field.At(column + di + 1, row + dj);
      const double nw = field.At(column + di, row + dj + 1);
      const double ne = field.At(column + di + 1, row + dj + 1);
      // A post on the diagonal belongs to both triangles, the post (1, 0) of a cell to the
      // south-eastern one.
      const bool southEast = di == dj ? a > b : di == -1;
      const double ex = southEast ? se - sw : ne - nw, ey = southEast ? ne - se : nw - sw;
      if (a * ex + b * ey > d.Z)
      {
        return true;
      }
    }
  }
  // All rows of cells, and in each row all cells that the ray crosses on the map.
  for (std::ptrdiff_t j = 0; j + 1 < field.Rows; ++j)
  {
    const double south = static_cast<double>(j) * field.SpacingY - o.Y;
    const double north = south + field.SpacingY;
    double from = 0.0, to = end;
    if (d.Y != 0.0)
    {
      from = std::max(from, std::min(south / d.Y, north / d.Y));
      to = std::min(to, std::max(south / d.Y, north / d.Y));
    }
    else if (south > 0.0 || north < 0.0)
    {
      continue;
    }
    if (from > to)
    {
      continue;
    }
    const double x0 = (o.X + from * d.X) / field.SpacingX;
    const double x1 = (o.X + to * d.X) / field.SpacingX;
    const double lowest = o.Z + std::min(from * d.Z, to * d.Z);
    const auto first = static_cast<std::ptrdiff_t>(std::floor(std::min(x0, x1) - 1e-9));
    const auto last = static_cast<std::ptrdiff_t>(std::floor(std::max(x0, x1) + 1e-9));
    for (std::ptrdiff_t i = first; i <= last; ++i)
    {
      if (!field.HasCell(i, j))
      {
        continue;
      }
      const Vector3 sw = PlaceOf(field, i, j), se = PlaceOf(field, i + 1, j);
      const Vector3 nw = PlaceOf(field, i, j + 1), ne = PlaceOf(field, i + 1, j + 1);
      if (std::max(std::max(sw.Z, se.Z), std::max(nw.Z, ne.Z)) >= lowest &&
        (MeetsTriangle(o, d, sw, se, ne, end) || MeetsTriangle(o, d, sw, ne, nw, end)))
      {
        return true;
      }
    }
  }
  return false;
}

struct Ball
{
  Vector3 Centre;
  double Radius;
};

/// The irradiance of a post (unit normal n) from a ball of unit radiance, by side x side rays, one
/// into each cell of an even grid over the disc of the ball. The post must lie outside the ball.
inline double BallIrradiance(const OracleField& field, std::ptrdiff_t column, std::ptrdiff_t row,
  const Vector3& n, const Ball& ball, int side, bool shadowed = true, std::uint64_t seed = 1)
{
  shapes::Random random(seed);
  const Vector3 to = ball.Centre - PlaceOf(field, column, row);
  const double distance = std::sqrt(Dot(to, to));
  const Vector3 w = (1.0 / distance) * to;
  const Vector3 u =
    Unit(Cross(std::abs(w.X) < 0.5 ? Vector3{ 1.0, 0.0, 0.0 } : Vector3{ 0.0, 1.0, 0.0 }, w));
  const Vector3 v = Cross(w, u);
  const double sine = ball.Radius / distance;
  // 1 - cos of the angular radius, without cancellation.
  const double depth = sine * sine / (1.0 + std::sqrt(1.0 - sine * sine));
  double sum = 0.0;
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      const double versine = depth * (i + random()) / side;
      const double turn = 2.0 * Pi * (j + random()) / side;
      const double s = std::sqrt(versine * (2.0 - versine)), c = 1.0 - versine;
      const Vector3 d = c * w + s * std::cos(turn) * u + s * std::sin(turn) * v;
      const double cosine = Dot(n, d);
      if (cosine <= 0.0)
      {
        continue;
      }
      const double hit = distance * c -
        std::sqrt(std::max(0.0, ball.Radius * ball.Radius - distance * distance * s * s));
      if (!shadowed || !Stopped(field, column, row, d, hit))
      {
        sum += cosine;
      }
    }
  }
  return 2.0 * Pi * depth * sum / (static_cast<double>(side) * side);
}

} // namespace oracle
} // namespace skyline

#endif
