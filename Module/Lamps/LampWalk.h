// SPDX-License-Identifier: BSD-3-Clause
// The profile of the terrain along a ray of a post, from near to far, without blocks that cannot
// matter.
#ifndef skyline_LampWalk_h
#define skyline_LampWalk_h

#include "HeightField/Grid.h"
#include "Lamps/LampTerrain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace skyline
{

/// A post that receives light.
struct LampReceiver
{
  std::ptrdiff_t Column, Row;
  double Height; ///< metres above the base of the field
};

/// A horizontal unit vector.
struct LampAzimuth
{
  double East, North;
};

/// Visits the cells of the vertical half plane of an azimuth, starting at a receiver. A visitor has
///   double End()        metres after which terrain does not matter
///   double Fine()       metres after which bilinear cells are passed in short pieces
///   double Threshold()  only terrain with a greater slope matters
///   void Start(slope)   called before the first piece, with the slope of the surface at the
///                       receiver
///   bool Piece(s0, z0, s1, z1)   a straight piece of terrain between the distances s0 < s1, with
///                       heights above the receiver, less the drop of the body; returns false to
///                       end the walk
class LampWalk
{
public:
  LampWalk(const LampTerrain& terrain, const Grid& grid, Surface shape, double drop)
    : Terrain(&terrain)
    , Plane(&terrain.Field().RowPlane())
    , Lattice(grid)
    , Shape(shape)
    , CurvatureDrop(drop)
  {
  }

  template <class Visitor>
  void operator()(const LampReceiver& from, const LampAzimuth& azimuth, Visitor& visitor) const;

  /// Shows the visitor only the cell at a distance above 0, if all of it lies before Fine(). This
  /// tests terrain that probably hides the lamp.
  template <class Visitor>
  void Look(
    const LampReceiver& from, const LampAzimuth& azimuth, double distance, Visitor& visitor) const;

  /// Returns true if certainly no terrain has a slope above `slope` (metres of height, less the
  /// drop of the body, per metre of distance from the receiver) within half a swath of an azimuth
  /// (given by its sine, below 1) and within `end` metres.
  bool Clear(const LampReceiver& from, const LampAzimuth& azimuth, double sinSwath, double end,
    double slope) const;

private:
  struct Ray
  {
    double U, V; ///< columns and rows per metre
  };
  struct Fan
  {
    LampReceiver From;
    LampAzimuth Azimuth;
    double Turn, Spread, End, Slope; ///< Turn and Spread: chord and tangent of half the swath
  };
  bool ClearBlock(const Fan& fan, int level, std::ptrdiff_t column, std::ptrdiff_t row) const;
  bool ClearCell(const Fan& fan, std::ptrdiff_t column, std::ptrdiff_t row, double x, double y,
    double drop) const;
  bool ClearStart(const Fan& fan, std::ptrdiff_t column, std::ptrdiff_t row) const;
  struct Cell
  {
    double South, East, North, Far; ///< heights of the posts (0,0), (1,0), (0,1), (1,1)
    double X, Y;                    ///< the south-west post relative to the receiver, in posts
  };
  template <class Visitor>
  bool Triangles(const Cell& cell, const Ray& ray, double in, double out, Visitor& visitor) const;
  template <class Visitor>
  bool Bilinear(const Cell& cell, const Ray& ray, double in, double out, Visitor& visitor) const;

  const LampTerrain* Terrain;
  const PaddedPlane* Plane;
  Grid Lattice;
  Surface Shape;
  double CurvatureDrop;
};

template <class Visitor>
void LampWalk::Look(
  const LampReceiver& from, const LampAzimuth& azimuth, double distance, Visitor& visitor) const
{
  const Ray ray{ azimuth.East / this->Lattice.SpacingX, azimuth.North / this->Lattice.SpacingY };
  const auto i = from.Column + static_cast<std::ptrdiff_t>(std::floor(ray.U * distance));
  const auto j = from.Row + static_cast<std::ptrdiff_t>(std::floor(ray.V * distance));
  if (i < 0 || j < 0 || i + 1 >= this->Lattice.Columns || j + 1 >= this->Lattice.Rows)
  {
    return;
  }
  const float* low = this->Plane->Line(j) + i;
  const float* high = this->Plane->Line(j + 1) + i;
  if (std::min(std::min(low[0], low[1]), std::min(high[0], high[1])) <= 0.5f * MissingHeight)
  {
    return;
  }
  const Cell cell{ low[0] - from.Height, low[1] - from.Height, high[0] - from.Height,
    high[1] - from.Height, static_cast<double>(i - from.Column),
    static_cast<double>(j - from.Row) };
  double in = 0.0, out = std::numeric_limits<double>::infinity();
  const auto clip = [&](double speed, double begin)
  {
    if (speed != 0.0)
    {
      const double a = begin / speed, b = (begin + 1.0) / speed;
      in = std::max(in, std::min(a, b));
      out = std::min(out, std::max(a, b));
    }
  };
  clip(ray.U, cell.X);
  clip(ray.V, cell.Y);
  if (in > 0.0 && in < out && out <= visitor.Fine())
  {
    this->Shape == Surface::Triangles ? this->Triangles(cell, ray, in, out, visitor)
                                      : this->Bilinear(cell, ray, in, out, visitor);
  }
}

template <class Visitor>
bool LampWalk::Triangles(
  const Cell& cell, const Ray& ray, double in, double out, Visitor& visitor) const
{
  // South-east of the diagonal z = South + a (East - South) + b (Far - East); north-west of it z =
  // South + a (Far - North) + b (North - South); a and b in cells.
  const double ex = cell.East - cell.South, ey = cell.Far - cell.East;
  const double nx = cell.Far - cell.North, ny = cell.North - cell.South;
  const auto height = [&](double s, bool east)
  {
    const double a = ray.U * s - cell.X, b = ray.V * s - cell.Y;
    return cell.South + (east ? a * ex + b * ey : a * nx + b * ny) - this->CurvatureDrop * s * s;
  };
  const double middle = 0.5 * (in + out);
  const double drift = ray.U - ray.V;
  const double offset = cell.X - cell.Y;
  const double cross = drift != 0.0 ? offset / drift : -1.0;
  const bool split = cross > in && cross < out;
  const bool eastFirst = drift * (split ? 0.5 * (in + cross) : middle) > offset;
  const double firstEnd = split ? cross : out;
  const double zIn = in > 0.0 ? height(in, eastFirst) : 0.0;
  const double zMid = height(firstEnd, eastFirst);
  if (in == 0.0)
  {
    visitor.Start(zMid / firstEnd);
  }
  return visitor.Piece(in, zIn, firstEnd, zMid) &&
    (!split || visitor.Piece(cross, zMid, out, height(out, !eastFirst)));
}

template <class Visitor>
bool LampWalk::Bilinear(
  const Cell& cell, const Ray& ray, double in, double out, Visitor& visitor) const
{
  // Along the ray,  z = a + b s + c s^2.
  const double east = cell.East - cell.South, north = cell.North - cell.South;
  const double twist = cell.Far - cell.South - east - north;
  const double a = cell.South - east * cell.X - north * cell.Y + twist * cell.X * cell.Y;
  const double b = east * ray.U + north * ray.V - twist * (cell.X * ray.V + cell.Y * ray.U);
  const double c = twist * ray.U * ray.V - this->CurvatureDrop;
  const auto height = [&](double s) { return (in > 0.0 ? a : 0.0) + s * (b + s * c); };
  if (in == 0.0)
  {
    visitor.Start(b);
  }
  // Split where the slope a / s + b + c s is greatest inside, and into short pieces where a lamp
  // may stand.
  const double peak = a < 0.0 && c < 0.0 && in > 0.0 ? std::sqrt(a / c) : 0.0;
  constexpr int pieces = 8; // a chord over an eighth leaves 1/256 of the bend of the patch
  const int count = out > visitor.Fine() ? pieces : 1;
  double s0 = in, z0 = height(in);
  for (int k = 1; k <= count; ++k)
  {
    const double s1 = k < count ? in + (out - in) * k / count : out;
    if (peak > s0 && peak < s1)
    {
      const double z = height(peak);
      if (!visitor.Piece(s0, z0, peak, z))
      {
        return false;
      }
      s0 = peak;
      z0 = z;
    }
    const double z1 = height(s1);
    if (s1 > s0 && !visitor.Piece(s0, z0, s1, z1))
    {
      return false;
    }
    s0 = s1;
    z0 = z1;
  }
  return true;
}

template <class Visitor>
void LampWalk::operator()(
  const LampReceiver& from, const LampAzimuth& azimuth, Visitor& visitor) const
{
  constexpr double never = std::numeric_limits<double>::infinity();
  const std::ptrdiff_t columns = this->Lattice.Columns - 1, rows = this->Lattice.Rows - 1; // cells
  const Ray ray{ azimuth.East / this->Lattice.SpacingX, azimuth.North / this->Lattice.SpacingY };
  const double perColumn = ray.U != 0.0 ? 1.0 / ray.U : 0.0;
  const double perRow = ray.V != 0.0 ? 1.0 / ray.V : 0.0;
  const double end = visitor.End();
  // A ray along a line of posts uses the cells on one side that lie inside the data.
  std::ptrdiff_t i =
    ray.U < 0.0 || (ray.U == 0.0 && from.Column == columns) ? from.Column - 1 : from.Column;
  std::ptrdiff_t j = ray.V < 0.0 || (ray.V == 0.0 && from.Row == rows) ? from.Row - 1 : from.Row;
  int level = 0;
  double s = 0.0;
  while (s < end && i >= 0 && j >= 0 && i < columns && j < rows)
  {
    const std::ptrdiff_t west = (i >> level) << level, south = (j >> level) << level;
    const std::ptrdiff_t size = std::ptrdiff_t{ 1 } << level;
    const std::ptrdiff_t lineX = ray.U > 0.0 ? west + size : west;
    const std::ptrdiff_t lineY = ray.V > 0.0 ? south + size : south;
    const double outX = ray.U != 0.0 ? static_cast<double>(lineX - from.Column) * perColumn : never;
    const double outY = ray.V != 0.0 ? static_cast<double>(lineY - from.Row) * perRow : never;
    const double out = std::min(outX, outY);

    Cell cell{};
    double highest = 0.0;
    bool complete = true;
    if (level > 0)
    {
      highest = this->Terrain->Highest(level, i, j);
      complete = highest > 0.5 * MissingHeight;
    }
    else
    {
      const float* low = this->Plane->Line(j) + i;
      const float* high = this->Plane->Line(j + 1) + i;
      cell = { low[0] - from.Height, low[1] - from.Height, high[0] - from.Height,
        high[1] - from.Height, static_cast<double>(i - from.Column),
        static_cast<double>(j - from.Row) };
      complete =
        std::min(std::min(low[0], low[1]), std::min(high[0], high[1])) > 0.5f * MissingHeight;
      highest = std::max(std::max(low[0], low[1]), std::max(high[0], high[1]));
    }
    const double rise = highest - from.Height - this->CurvatureDrop * s * s;
    const bool matters =
      complete && (s == 0.0 || rise > visitor.Threshold() * (rise > 0.0 ? s : out));
    if (matters && level > 0)
    {
      --level;
      continue;
    }
    if (matters && out > s &&
      !(this->Shape == Surface::Triangles ? this->Triangles(cell, ray, s, out, visitor)
                                          : this->Bilinear(cell, ray, s, out, visitor)))
    {
      return;
    }
    if (outX <= outY)
    {
      i = ray.U > 0.0 ? lineX : lineX - 1;
    }
    else
    {
      i = std::clamp(
        from.Column + static_cast<std::ptrdiff_t>(std::floor(ray.U * out)), west, west + size - 1);
    }
    if (outY <= outX)
    {
      j = ray.V > 0.0 ? lineY : lineY - 1;
    }
    else
    {
      j = std::clamp(
        from.Row + static_cast<std::ptrdiff_t>(std::floor(ray.V * out)), south, south + size - 1);
    }
    s = out;
    level = std::min(level + (matters ? 0 : 1), this->Terrain->Levels());
  }
}

} // namespace skyline

#endif
