// SPDX-License-Identifier: BSD-3-Clause
// Adds objects on the ground to the height field, so that they cast shadows, too.
#ifndef skyline_ShadowHeightCap_h
#define skyline_ShadowHeightCap_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace skyline
{

/// A corner: column and row in posts (fractions allowed, any values), height in metres.
using CapCorner = std::array<double, 3>;

/// Raises the posts under a triangle, edges included, to the height of the triangle where that is
/// higher (Lee & Kim, figure 8). heights: columns * rows, row by row; missing posts (NaN) stay
/// missing. A vertical triangle covers no post.
inline void CapTriangle(const std::array<CapCorner, 3>& corners, std::ptrdiff_t columns,
  std::ptrdiff_t rows, double* heights)
{
  const CapCorner &a = corners[0], &b = corners[1], &c = corners[2];
  const double area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  if (!(std::abs(area) > 0.0) || !std::isfinite(area))
  {
    return;
  }
  // A tolerance, so that posts on an edge shared by two triangles are not lost.
  constexpr double hair = -1e-9;
  const auto first = [](double least)
  { return static_cast<std::ptrdiff_t>(std::ceil(std::max(least + hair, 0.0))); };
  const auto last = [](double greatest, std::ptrdiff_t count)
  {
    const double end = std::min(greatest - hair, static_cast<double>(count - 1));
    return end < 0.0 ? std::ptrdiff_t{ -1 } : static_cast<std::ptrdiff_t>(end);
  };
  const double leastColumn = std::min({ a[0], b[0], c[0] });
  const double leastRow = std::min({ a[1], b[1], c[1] });
  if (leastColumn > static_cast<double>(columns) || leastRow > static_cast<double>(rows))
  {
    return;
  }
  const std::ptrdiff_t columnEnd = last(std::max({ a[0], b[0], c[0] }), columns);
  const std::ptrdiff_t rowEnd = last(std::max({ a[1], b[1], c[1] }), rows);
  const double perArea = 1.0 / area;
  for (std::ptrdiff_t row = first(leastRow); row <= rowEnd; ++row)
  {
    const double y = static_cast<double>(row) - a[1];
    for (std::ptrdiff_t column = first(leastColumn); column <= columnEnd; ++column)
    {
      const double x = static_cast<double>(column) - a[0];
      const double v = (x * (c[1] - a[1]) - (c[0] - a[0]) * y) * perArea;
      const double w = ((b[0] - a[0]) * y - x * (b[1] - a[1])) * perArea;
      if (v >= hair && w >= hair && v + w <= 1.0 - hair)
      {
        double& height = heights[row * columns + column];
        const double top = a[2] + v * (b[2] - a[2]) + w * (c[2] - a[2]);
        height = top > height ? top : height; // NaN stays NaN
      }
    }
  }
}

} // namespace skyline

#endif
