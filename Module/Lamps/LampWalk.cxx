// SPDX-License-Identifier: BSD-3-Clause
#include "Lamps/LampWalk.h"

namespace skyline
{

/// Returns true if a cell with the receiver at a corner certainly does not rise above the slope of
/// the fan.
bool LampWalk::ClearStart(const Fan& fan, std::ptrdiff_t column, std::ptrdiff_t row) const
{
  const float* low = this->Plane->Line(row) + column;
  const float* high = this->Plane->Line(row + 1) + column;
  if (std::min(std::min(low[0], low[1]), std::min(high[0], high[1])) <= 0.5f * MissingHeight)
  {
    return true;
  }
  // The quadrant of directions over the cell, and the part of it over each triangle, may lie
  // outside the fan. No direction of the fan is further than Turn from its middle.
  const bool atEast = fan.From.Column != column, atNorth = fan.From.Row != row;
  if ((atEast ? -fan.Azimuth.East : fan.Azimuth.East) < -fan.Turn ||
    (atNorth ? -fan.Azimuth.North : fan.Azimuth.North) < -fan.Turn)
  {
    return true;
  }
  const double south = low[0], east = low[1], north = high[0], far = high[1];
  const double dx = this->Lattice.SpacingX, dy = this->Lattice.SpacingY;
  // Within the fan, the slope of a plane is at most its slope along the middle, plus the gradient
  // times the change of direction.
  const auto clear = [&](double gx, double gy, double more)
  {
    return gx * fan.Azimuth.East + gy * fan.Azimuth.North +
      std::sqrt(gx * gx + gy * gy) * fan.Turn + more <=
      fan.Slope;
  };
  if (this->Shape == Surface::Triangles)
  {
    const double side = fan.Azimuth.East * dy - fan.Azimuth.North * dx; // above 0: south-east
    const double reach = fan.Turn * std::sqrt(dx * dx + dy * dy);
    const bool diagonal = atEast == atNorth; // both triangles meet at the post
    const bool southEast = diagonal ? side >= -reach : atEast;
    const bool northWest = diagonal ? side <= reach : atNorth;
    return (!southEast || clear((east - south) / dx, (far - east) / dy, 0.0)) &&
      (!northWest || clear((far - north) / dx, (north - south) / dy, 0.0));
  }
  // A patch adds twist a b / s along the ray, where s >= sqrt(2 a b dx dy) and a and b are at most
  // 1.
  const double twist = far - east - north + south;
  return clear((atNorth ? far - north : east - south) / dx,
    (atEast ? far - east : north - south) / dy, std::abs(twist) / std::sqrt(2.0 * dx * dy));
}

/// The height minus the line of sight, linear or bilinear in the cell, is greatest at a corner. For
/// slopes above 0, the distance is at least its component along the direction to the middle of the
/// cell (x, y), which is linear. For slopes below 0, minus slope times distance is convex.
bool LampWalk::ClearCell(
  const Fan& fan, std::ptrdiff_t column, std::ptrdiff_t row, double x, double y, double drop) const
{
  const double scale = 1.0 / std::sqrt(x * x + y * y);
  const double hx = 0.5 * this->Lattice.SpacingX, hy = 0.5 * this->Lattice.SpacingY;
  for (std::ptrdiff_t n = 0; n < 2; ++n)
  {
    const float* line = this->Plane->Line(row + n) + column;
    const double v = n == 0 ? y - hy : y + hy;
    for (std::ptrdiff_t m = 0; m < 2; ++m)
    {
      const double u = m == 0 ? x - hx : x + hx;
      const double place = fan.Slope > 0.0 ? (u * x + v * y) * scale : std::sqrt(u * u + v * v);
      if (line[m] - fan.From.Height - drop > fan.Slope * place)
      {
        return false;
      }
    }
  }
  return true;
}

bool LampWalk::ClearBlock(
  const Fan& fan, int level, std::ptrdiff_t column, std::ptrdiff_t row) const
{
  const std::ptrdiff_t size = std::ptrdiff_t{ 1 } << level;
  const double hx = 0.5 * static_cast<double>(size) * this->Lattice.SpacingX;
  const double hy = 0.5 * static_cast<double>(size) * this->Lattice.SpacingY;
  const double x = static_cast<double>(column - fan.From.Column) * this->Lattice.SpacingX + hx;
  const double y = static_cast<double>(row - fan.From.Row) * this->Lattice.SpacingY + hy;
  const double east = fan.Azimuth.East, north = fan.Azimuth.North;
  const double along = x * east + y * north, across = std::abs(x * north - y * east);
  const double reach = std::abs(east) * hx + std::abs(north) * hy;
  const double width = std::abs(north) * hx + std::abs(east) * hy;
  if (along + reach <= 0.0 || across - width > fan.Spread * (along + reach))
  {
    return true;
  }
  const double dx = std::max(std::abs(x) - hx, 0.0), dy = std::max(std::abs(y) - hy, 0.0);
  const double near2 = dx * dx + dy * dy;
  if (near2 >= fan.End * fan.End)
  {
    return true;
  }
  double highest = 0.0;
  if (level > 0)
  {
    highest = this->Terrain->Highest(level, column, row);
  }
  else
  {
    const float* low = this->Plane->Line(row) + column;
    const float* high = this->Plane->Line(row + 1) + column;
    highest = std::min(std::min(low[0], low[1]), std::min(high[0], high[1])) > 0.5f * MissingHeight
      ? std::max(std::max(low[0], low[1]), std::max(high[0], high[1]))
      : MissingHeight;
  }
  const double rise = highest - fan.From.Height - this->CurvatureDrop * near2;
  const double ax = std::abs(x) + hx, ay = std::abs(y) + hy;
  const double place = rise > 0.0 ? std::sqrt(near2) : std::sqrt(ax * ax + ay * ay);
  if (rise <= fan.Slope * place && (near2 > 0.0 || rise <= 0.0))
  {
    return true;
  }
  if (level == 0)
  {
    return near2 > 0.0 ? this->ClearCell(fan, column, row, x, y, this->CurvatureDrop * near2)
                       : this->ClearStart(fan, column, row);
  }
  // The four quarters that lie inside the data.
  const std::ptrdiff_t half = size / 2;
  const bool moreX = column + half < this->Lattice.Columns - 1;
  const bool moreY = row + half < this->Lattice.Rows - 1;
  return this->ClearBlock(fan, level - 1, column, row) &&
    (!moreX || this->ClearBlock(fan, level - 1, column + half, row)) &&
    (!moreY || this->ClearBlock(fan, level - 1, column, row + half)) &&
    (!moreX || !moreY || this->ClearBlock(fan, level - 1, column + half, row + half));
}

bool LampWalk::Clear(const LampReceiver& from, const LampAzimuth& azimuth, double sinSwath,
  double end, double slope) const
{
  // The chord 2 sin(w / 2) of the half swath w bounds how much a slope can grow towards the rim.
  const double cosine = std::sqrt((1.0 - sinSwath) * (1.0 + sinSwath));
  const Fan fan{ from, azimuth, sinSwath / std::sqrt(0.5 * (1.0 + cosine)), sinSwath / cosine, end,
    slope };
  return this->ClearBlock(fan, this->Terrain->Levels(), 0, 0);
}

} // namespace skyline
