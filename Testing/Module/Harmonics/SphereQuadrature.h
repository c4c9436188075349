// SPDX-License-Identifier: BSD-3-Clause
// A quadrature rule that is exact for polynomials on the sphere, for the tests of harmonics.
#ifndef skyline_SphereQuadrature_h
#define skyline_SphereQuadrature_h

#include "Shared/Constants.h"

#include <cmath>
#include <utility>

namespace skyline
{
namespace testing
{

/// Node k of the n-point Gauss-Legendre rule on [-1, 1] and its weight, by Newton's method.
inline std::pair<double, double> GaussNode(int n, int k)
{
  double x = std::cos(Pi * (k + 0.75) / (n + 0.5)), slope = 1.0;
  for (int step = 0; step < 50; ++step)
  {
    double before = 1.0, value = x;
    for (int l = 1; l < n; ++l)
    {
      const double next = ((2.0 * l + 1.0) * x * value - l * before) / (l + 1.0);
      before = value;
      value = next;
    }
    slope = n * (x * value - before) / (x * x - 1.0);
    x -= value / slope;
  }
  return { x, 2.0 / ((1.0 - x * x) * slope * slope) };
}

/// Calls visit(x, y, z, weight) for the points of a rule that is exact for functions whose degree
/// in z is below 2 n and whose azimuthal frequency is below 2 n. z runs from `bottom` to 1.
template <typename Visit>
void VisitSphere(int n, double bottom, const Visit& visit)
{
  for (int k = 0; k < n; ++k)
  {
    const auto [node, weight] = GaussNode(n, k);
    const double z = bottom + 0.5 * (1.0 - bottom) * (node + 1.0);
    const double level = std::sqrt((1.0 - z) * (1.0 + z));
    for (int j = 0; j < 2 * n; ++j)
    {
      const double azimuth = Pi * (j + 0.5) / n;
      visit(level * std::sin(azimuth), level * std::cos(azimuth), z,
        0.5 * (1.0 - bottom) * weight * Pi / n);
    }
  }
}

} // namespace testing
} // namespace skyline

#endif
