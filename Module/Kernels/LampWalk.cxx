// SPDX-License-Identifier: BSD-3-Clause
#include "LampWalk.h"

namespace skyline
{

/// The steepest that a cell with the receiver at its corner rises from it within the fan.
bool LampWalk::ClearStart(const Fan& fan, std::ptrdiff_t column, std::ptrdiff_t row) const
{
  const float* low = this->Plane->Line(row) + column;
  const float* high = this->Plane->Line(row + 1) + column;
  if (std::min(std::min(low[0], low[1]), std::min(high[0], high[1])) <= 0.5f * MissingHeight)
  {
    return true;
  }
  const double south = low[0], east = low[1], north = high[0], far = high[1];
  const double dx = this->Lattice.SpacingX, dy = this->Lattice.SpacingY;
  // A plane's slope over the fan is that along its middle, and the gradient times the fan's half
  // width more at most.
  const auto clear = [&](double gx, double gy, double more)
  {
    return gx * fan.Azimuth.East + gy * fan.Azimuth.North +
      std::sqrt(gx * gx + gy * gy) * fan.HalfWidth + more <=
      fan.Slope;
  };
  if (this->Shape == Surface::Triangles)
  {
    return clear((east - south) / dx, (far - east) / dy, 0.0) &&
      clear((far - north) / dx, (north - south) / dy, 0.0);
  }
  // A patch adds twist a b / s along the ray, s >= sqrt(2 a b dx dy), a and b up to 1.
  const bool atEast = fan.From.Column != column, atNorth = fan.From.Row != row;
  const double twist = far - east - north + south;
  return clear((atNorth ? far - north : east - south) / dx,
    (atEast ? far - east : north - south) / dy, std::abs(twist) / std::sqrt(2.0 * dx * dy));
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
  const double rise = highest - fan.From.Height - this->Sink * near2;
  const double ax = std::abs(x) + hx, ay = std::abs(y) + hy;
  const double place = rise > 0.0 ? std::sqrt(near2) : std::sqrt(ax * ax + ay * ay);
  if (rise <= fan.Slope * place && (near2 > 0.0 || rise <= 0.0))
  {
    return true;
  }
  if (level == 0)
  {
    return near2 == 0.0 && this->ClearStart(fan, column, row);
  }
  // The four quarters, those inside the data.
  const std::ptrdiff_t half = size / 2;
  const bool moreX = column + half < this->Lattice.Columns - 1;
  const bool moreY = row + half < this->Lattice.Rows - 1;
  return this->ClearBlock(fan, level - 1, column, row) &&
    (!moreX || this->ClearBlock(fan, level - 1, column + half, row)) &&
    (!moreY || this->ClearBlock(fan, level - 1, column, row + half)) &&
    (!moreX || !moreY || this->ClearBlock(fan, level - 1, column + half, row + half));
}

bool LampWalk::Clear(const LampReceiver& from, const LampAzimuth& azimuth, double halfWidth,
  double end, double slope) const
{
  const Fan fan{ from, azimuth, halfWidth, std::tan(halfWidth), end, slope };
  return this->ClearBlock(fan, this->Terrain->Levels(), 0, 0);
}

} // namespace skyline
