// SPDX-License-Identifier: BSD-3-Clause
#include "Geo/RowBands.h"

#include "Geo/GroundMetric.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace skyline
{
namespace
{

/// The spacing of a band is the middle of its least and greatest spacing. A band therefore grows
/// while half their difference stays within the tolerance.
struct Range
{
  double Least, Greatest;
  Range With(double value) const
  {
    return { std::min(this->Least, value), std::max(this->Greatest, value) };
  }
  double Middle() const { return 0.5 * (this->Least + this->Greatest); }
  bool Within(double relative) const
  {
    return this->Greatest - this->Middle() <= relative * this->Middle();
  }
};

} // namespace

std::vector<RowBand> RowBands(const GroundMetric& metric, double tolerance)
{
  if (!(tolerance >= 0.0))
  {
    throw std::invalid_argument("band tolerance " + std::to_string(tolerance) +
      " is negative; give a relative difference like 0.0025");
  }
  const std::ptrdiff_t rows = metric.Rows();
  if (!metric.ByRows())
  {
    const PostMetric centre = metric.Centre();
    return { { 0, rows, centre.X, centre.Y } };
  }
  const double* spacingX = metric.RowSpacingX();
  const double* spacingY = metric.RowSpacingY();
  std::vector<RowBand> bands;
  for (std::ptrdiff_t begin = 0; begin < rows;)
  {
    const double firstX = spacingX[begin];
    const double firstY = spacingY[begin];
    Range x{ firstX, firstX }, y{ firstY, firstY };
    std::ptrdiff_t end = begin + 1;
    for (; end < rows; ++end)
    {
      const Range widerX = x.With(spacingX[end]);
      const Range widerY = y.With(spacingY[end]);
      if (!widerX.Within(tolerance) || !widerY.Within(tolerance))
      {
        break;
      }
      x = widerX;
      y = widerY;
    }
    bands.push_back({ begin, end, x.Middle(), y.Middle() });
    begin = end;
  }
  return bands;
}

} // namespace skyline
