// SPDX-License-Identifier: BSD-3-Clause
// Gauss-Legendre quadrature, computed at compile time.
#ifndef skyline_GaussRule_h
#define skyline_GaussRule_h

#include "Shared/Constants.h"

namespace skyline
{

/// The rule of N nodes (even) on [-1, 1], exact for polynomials of degree 2 N - 1. Only the nodes
/// above 0 are stored, in descending order; each has a mirror image with the same weight.
template <int N>
struct GaussRule
{
  static_assert(N > 0 && N % 2 == 0, "the middle node of an odd rule has no mirror image");
  static constexpr int Half = N / 2;
  double Node[Half] = {};
  double Weight[Half] = {};

  constexpr GaussRule()
  {
    for (int node = 0; node < Half; ++node)
    {
      // Newton's method from cos(pi (node + 3/4) / (N + 1/2)), the cosine by its series.
      const double t = Pi * (node + 0.75) / (N + 0.5), q = t * t;
      double z = 1.0 - q / 2.0 * (1.0 - q / 12.0 * (1.0 - q / 30.0 * (1.0 - q / 56.0)));
      double slope = 1.0;
      for (int step = 0; step < 6; ++step)
      {
        double before = 1.0, value = z;
        for (int l = 1; l < N; ++l)
        {
          const double next = ((2.0 * l + 1.0) * z * value - l * before) / (l + 1.0);
          before = value;
          value = next;
        }
        slope = N * (z * value - before) / (z * z - 1.0);
        z -= value / slope;
      }
      this->Node[node] = z;
      this->Weight[node] = 2.0 / ((1.0 - z) * (1.0 + z) * slope * slope);
    }
  }
};

} // namespace skyline

#endif
