// SPDX-License-Identifier: BSD-3-Clause
#include "Horizon/RayFrame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace skyline
{

namespace
{

// With 36 binary digits after the point, the product with any line number below 2^16 is exact in
// double. Then floor(slant * (a + b)) and floor(slant * a) + floor(slant * b) differ by 0 or 1,
// never because of rounding. The ray is off by at most 2^16 / 2^37 = 5e-7 of a lane.
constexpr double SlantUnit = 1.0 / 68719476736.0; // 2^-36

struct Weights
{
  float Near, Far, Drop;
};

// Weights for a crossing at the fraction `t` of the way from line D - 1 to line D.
Weights Between(double t, double lineBefore, double dropPerLine2)
{
  const double distance = lineBefore + t;
  if (!(distance > 0.0))
  {
    return { 0.0f, 0.0f, -MissingHeight }; // the receiver itself
  }
  return { static_cast<float>((1.0 - t) / distance), static_cast<float>(t / distance),
    static_cast<float>(dropPerLine2 * distance) };
}

// An azimuth in degrees. Simple fractions of a degree, which radians round, are restored.
double MeantDegrees(double azimuth)
{
  constexpr double parts = 201600.0; // 2^7 3^2 5^2 7: divides 360 degrees into 2^10, 3600 and
                                     // similar numbers of parts
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  const double degrees = azimuth * DegreesPerRadian;
  const double simple = std::nearbyint(degrees * parts) / parts;
  return std::abs(simple - degrees) <= rounding * std::abs(degrees) ? simple : degrees;
}

} // namespace

Direction DirectionOfAzimuth(double azimuth)
{
  if (!std::isfinite(azimuth))
  {
    throw std::invalid_argument("azimuth " + std::to_string(azimuth) + ": give finite radians");
  }
  // First reduced to the nearest quarter turn, a whole number of degrees, so that sine and cosine
  // are exact for 0 and 45 degrees.
  const double reduced = std::remainder(MeantDegrees(azimuth), 360.0);
  const double quarter = std::nearbyint(reduced / 90.0);
  const double rest = (reduced - 90.0 * quarter) * RadiansPerDegree;
  double s = std::sin(rest);
  double c = std::cos(rest);
  if (std::abs(reduced - 90.0 * quarter) == 45.0)
  {
    c = std::sqrt(0.5);
    s = std::copysign(c, rest);
  }
  switch ((static_cast<int>(quarter) % 4 + 4) % 4)
  {
    case 0:
      return { s, c };
    case 1:
      return { c, -s };
    case 2:
      return { -s, -c };
    default:
      return { -c, s };
  }
}

PostsPerMetre RayOfAzimuth(const Grid& grid, double azimuth)
{
  const Direction direction = DirectionOfAzimuth(azimuth);
  const double columns = direction.East / grid.SpacingX;
  return { columns, (direction.North - grid.Shear * columns) / grid.SpacingY };
}

bool RayFrame::TakesColumns(const Grid& grid, double azimuth)
{
  const PostsPerMetre ray = RayOfAzimuth(grid, azimuth);
  return std::abs(ray.Columns) > std::abs(ray.Rows);
}

RayFrame::RayFrame(const HeightField& field, const Grid& grid, double azimuth, double drop)
{
  const PostsPerMetre ray = RayOfAzimuth(grid, azimuth);
  double along = ray.Rows;     // lines per metre
  double across = ray.Columns; // lanes per metre
  this->Columns = TakesColumns(grid, azimuth);
  if (this->Columns)
  {
    std::swap(along, across);
  }
  const PaddedPlane& plane = this->Columns ? field.ColumnPlane() : field.RowPlane();
  this->Lines = plane.Lines;
  this->Lanes = plane.Lanes;
  this->Reversed = along < 0.0;
  this->Heights = plane.Line(this->Reversed ? this->Lines - 1 : 0);
  this->LineStride = this->Reversed ? -plane.Stride : plane.Stride;
  this->StepLength = 1.0 / std::abs(along);
  this->Slant = std::nearbyint(std::abs(across / along) / SlantUnit) * SlantUnit;
  this->Drift = across < 0.0 && this->Slant > 0.0 ? -1 : 1;
  this->Against = this->Reversed != (this->Drift < 0);
  const double dropPerLine2 = drop * this->StepLength * this->StepLength;
  this->DropPerLine2 = static_cast<float>(dropPerLine2);

  this->FillSteps(dropPerLine2);
}

void RayFrame::FillSteps(double dropPerLine2)
{
  this->Steps.resize(static_cast<std::size_t>(this->Lines));
  this->Sides.resize(this->Steps.size());
  this->Places.resize(this->Steps.size());
  double whole = 0.0;
  double part = 0.0;
  for (std::ptrdiff_t d = 1; d < this->Lines; ++d)
  {
    const double line = static_cast<double>(d);
    const double wholeBefore = whole;
    const double partBefore = part;
    whole = std::floor(this->Slant * line);
    part = this->Slant * line - whole;

    RayStep& step = this->Steps[static_cast<std::size_t>(d)];
    SideStep& side = this->Sides[static_cast<std::size_t>(d)];
    step.Lane = this->Drift * static_cast<std::int32_t>(whole);
    step.Next = whole > wholeBefore ? 1 : 0;
    step.RowTrail = static_cast<float>((1.0 - part) / line);
    step.RowLead = static_cast<float>(part / line);
    step.RowDrop = static_cast<float>(dropPerLine2 * line);

    const double before = line - 1.0;
    double middle = 0.0;
    if (step.Next != 0)
    {
      middle = (1.0 - partBefore) / this->Slant;
      const Weights left = Between((1.0 - partBefore) / (1.0 + this->Slant), before, dropPerLine2);
      const Weights right = Between((2.0 - partBefore) / (1.0 + this->Slant), before, dropPerLine2);
      side.LeftNear = left.Near;
      side.LeftFar = left.Far;
      side.LeftDrop = left.Drop;
      side.RightNear = right.Near;
      side.RightFar = right.Far;
      side.RightDrop = right.Drop;
    }
    else if (this->Against)
    {
      middle = (1.0 - partBefore) / (1.0 + this->Slant);
    }
    else
    {
      middle = partBefore / (1.0 - this->Slant);
    }
    const Weights mid = Between(middle, before, dropPerLine2);
    step.MidNear = mid.Near;
    step.MidFar = mid.Far;
    step.MidDrop = mid.Drop;
    this->Places[static_cast<std::size_t>(d)] = { part, before + middle };
  }
}

std::ptrdiff_t RayFrame::LastStep(std::ptrdiff_t lane, std::ptrdiff_t width) const
{
  const std::ptrdiff_t reach =
    std::min(this->Drift > 0 ? this->Lanes - 1 - lane : lane + width - 1, this->Lanes - 1);
  const double steps = static_cast<double>(reach + 1) / std::max(this->Slant, SlantUnit);
  if (steps >= static_cast<double>(this->Lines))
  {
    return this->Lines - 1;
  }
  return static_cast<std::ptrdiff_t>(std::ceil(steps)); // the step in which the ray leaves the data
                                                        // at the latest
}

} // namespace skyline
