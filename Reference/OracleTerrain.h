// SPDX-License-Identifier: BSD-3-Clause
// Computes the horizons of a method on a field of the oracle.
#ifndef skyline_OracleTerrain_h
#define skyline_OracleTerrain_h

#include "Horizon/HorizonMethod.h"
#include "Reference/Oracle.h"
#include "Reference/Shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace skyline
{
namespace testing
{

inline Grid GridOf(const oracle::OracleField& field)
{
  return Grid{ field.Columns, field.Rows, field.SpacingX, field.SpacingY };
}

/// The mean of the lowest and the highest post.
inline double BaseOf(const oracle::OracleField& field)
{
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double height : field.Heights)
  {
    if (std::isfinite(height))
    {
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
  return low + 0.5 * (high - low);
}

inline HeightField FieldOf(const oracle::OracleField& field)
{
  HeightField result(GridOf(field));
  result.Fill(0, field.Rows, BaseOf(field),
    [&](std::ptrdiff_t column, std::ptrdiff_t row)
    { return field.Heights[static_cast<std::size_t>(row * field.Columns + column)]; });
  result.Close();
  result.Transpose();
  return result;
}

/// Slopes of all posts in one azimuth (degrees), row by row, found in groups of `chunk` lines.
inline std::vector<float> Slopes(
  HorizonMethod& method, const Grid& grid, double azimuth, std::ptrdiff_t chunk = 64)
{
  method.SetAzimuth(grid, azimuth * RadiansPerDegree);
  method.Prepare(0, method.PrepareCount());
  const RayFrame& frame = method.Frame();
  const std::ptrdiff_t stride = (frame.Lanes + 31) / 32 * 32;
  std::vector<float> lines(static_cast<std::size_t>(frame.Lines * stride));
  for (std::ptrdiff_t line = 0; line < frame.Lines; line += chunk)
  {
    method.Find(line, std::min(line + chunk, frame.Lines), 0, frame.Lanes,
      lines.data() + line * stride, stride);
  }
  std::vector<float> slopes(static_cast<std::size_t>(grid.Columns * grid.Rows));
  for (std::ptrdiff_t line = 0; line < frame.Lines; ++line)
  {
    for (std::ptrdiff_t lane = 0; lane < frame.Lanes; ++lane)
    {
      const std::ptrdiff_t image = frame.ImageLine(line);
      const std::ptrdiff_t post =
        frame.Columns ? lane * grid.Columns + image : image * grid.Columns + lane;
      slopes[static_cast<std::size_t>(post)] =
        lines[static_cast<std::size_t>(line * stride + lane)];
    }
  }
  return slopes;
}

/// Elevation in degrees; -90 for NoTerrainSlope.
inline double Elevation(float slope)
{
  return slope == NoTerrainSlope ? -90.0 : std::atan(static_cast<double>(slope)) * DegreesPerRadian;
}

/// The error in degrees that heights in floats allow: the heights of receiver and edge are rounded
/// to 2^-24 of the relief, relative to its middle. Their difference and its weights are each
/// rounded once more, over at least one step. The slope itself is a float too.
inline double RoundingBound(const oracle::OracleField& field)
{
  const double base = BaseOf(field);
  double largest = 0.0;
  for (const double height : field.Heights)
  {
    largest = std::isfinite(height) ? std::max(largest, std::abs(height - base)) : largest;
  }
  constexpr double unit = 5.96e-8; // 2^-24
  const double step = std::min(field.SpacingX, field.SpacingY);
  return (4.0 * unit * largest / step + 4.0 * unit) * DegreesPerRadian + 1.0e-5;
}

} // namespace testing
} // namespace skyline

#endif
