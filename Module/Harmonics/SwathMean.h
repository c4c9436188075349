// SPDX-License-Identifier: BSD-3-Clause
// The azimuthal factors of spherical harmonics, averaged over the swath of one azimuth.
#ifndef skyline_SwathMean_h
#define skyline_SwathMean_h

#include "Shared/Constants.h"

#include <cmath>

namespace skyline
{

/// Means over a swath of the azimuthal factors of order m: cos(m p) and sin(m p), where the angle p
/// is counted from east to north, p = 90 degrees - azimuth.
struct SwathMean
{
  double Cosine, Sine;
};

/// The means over the swath with the centre `azimuth` (radians clockwise from north) and `width`
/// (radians).
inline SwathMean MeanOverSwath(int m, double azimuth, double width)
{
  const double angle = m * (0.5 * Pi - azimuth);
  const double half = 0.5 * m * width;
  const double part = std::abs(half) < 1.0e-9 ? 1.0 : std::sin(half) / half;
  return { part * std::cos(angle), part * std::sin(angle) };
}

} // namespace skyline

#endif
