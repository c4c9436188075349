// SPDX-License-Identifier: BSD-3-Clause
// Shadow heights by the oracle, and the differences that the rounding of floats allows.
#ifndef skyline_ShadowTesting_h
#define skyline_ShadowTesting_h

#include "Reference/OracleTerrain.h"
#include "ShadowHeight/ShadowHeight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skyline
{
namespace testing
{

/// The final interval is 2^-40 of the first one.
constexpr int Halvings = 40;

/// The height at which the horizon of a point above the post (column, row) has the slope of the
/// light, by bisection; this is the definition. -infinity if there is no terrain in that direction.
/// The field is restored afterwards.
inline double ShadowHeightOf(oracle::OracleField& field, std::ptrdiff_t column, std::ptrdiff_t row,
  double azimuth, double slope)
{
  const oracle::Direction direction = oracle::DirectionOfAzimuth(azimuth);
  const double own = field.At(column, row);
  const auto shaded = [&](double height)
  {
    field.At(column, row) = height;
    return oracle::HorizonSlope(field, column, row, direction) > slope;
  };
  if (oracle::HorizonSlope(field, column, row, direction) == oracle::NoTerrain)
  {
    return -std::numeric_limits<double>::infinity();
  }
  double size = 1.0;
  while (shaded(own + size) || !shaded(own - size))
  {
    size *= 4.0;
  }
  double low = own - size, high = own + size;
  for (int halving = 0; halving < Halvings; ++halving)
  {
    const double middle = low + 0.5 * (high - low);
    (shaded(middle) ? low : high) = middle;
  }
  field.At(column, row) = own;
  return high;
}

/// The sum  w a + (1 - w) b - fall  in floats is rounded to 2^-24 of its terms: the heights
/// relative to the middle of the relief, and a fall that is at most the relief plus the depth of
/// the shadow. At most six roundings, plus the final interval of the bisection for a level field.
inline double HeightBound(const oracle::OracleField& field, double shadow)
{
  const double base = BaseOf(field);
  double largest = 0.0;
  for (const double height : field.Heights)
  {
    largest = std::isfinite(height) ? std::max(largest, std::abs(height - base)) : largest;
  }
  constexpr double unit = 5.96e-8;
  return 6.0 * unit * (largest + std::abs(shadow - base)) + 1e-11;
}

} // namespace testing
} // namespace skyline

#endif
