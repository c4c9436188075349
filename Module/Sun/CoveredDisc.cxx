// SPDX-License-Identifier: BSD-3-Clause
// With  root = sqrt((1+k+d) (1+k-d) (1-k+d) (k-1+d)),  which is 4 times the area of the triangle of
// both centres and a point where the rims meet, the common area of two discs with the radii 1 and k
// at the distance d is
//   atan2(root, d^2 + 1 - k^2) + k^2 atan2(root, d^2 + k^2 - 1) - root / 2.
// The light of mu = sqrt(1 - r^2) is summed over rings. On the ring of radius r, half of the
// covered arc is phi = acos((r^2 + d^2 - k^2) / (2 r d)), or the whole ring is covered. The rings
// r = a + (b - a) sin^2(t / 2), evenly spaced in t, make the square roots at both ends smooth.
#include "Sun/CoveredDisc.h"

#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>

namespace skyline
{

namespace
{

constexpr int Rings = 48;

/// Integral of mu dA over the disc within a radius.
double BrightWithin(double radius)
{
  const double rest = (1.0 - radius) * (1.0 + radius);
  return 2.0 * Pi / 3.0 * (1.0 - rest * std::sqrt(rest));
}

double BrightCovered(double d, double k)
{
  const double first = std::abs(d - k), last = std::min(1.0, d + k);
  double sum = k > d ? BrightWithin(first) : 0.0;
  const double step = Pi / Rings;
  for (int ring = 0; ring < Rings; ++ring)
  {
    const double t = (ring + 0.5) * step;
    const double half = std::sin(0.5 * t);
    const double r = first + (last - first) * half * half;
    const double width = 0.5 * (last - first) * std::sin(t) * step;
    const double phi = std::acos(std::clamp((r * r + d * d - k * k) / (2.0 * r * d), -1.0, 1.0));
    sum += 2.0 * phi * r * std::sqrt((1.0 - r) * (1.0 + r)) * width;
  }
  return sum;
}

} // namespace

double CoveredShare(double distance, double cover, double limbDarkening)
{
  const double d = distance, k = cover, u = limbDarkening;
  if (d >= 1.0 + k || k <= 0.0)
  {
    return 0.0;
  }
  if (d <= k - 1.0)
  {
    return 1.0;
  }
  double even = Pi * k * k;
  if (d > 1.0 - k)
  {
    const double root = std::sqrt((1.0 + k + d) * (1.0 + k - d) * (1.0 - k + d) * (k - 1.0 + d));
    even = std::atan2(root, d * d + 1.0 - k * k) + k * k * std::atan2(root, d * d + k * k - 1.0) -
      0.5 * root;
  }
  const double bright = u == 0.0 ? 0.0 : d == 0.0 ? BrightWithin(k) : BrightCovered(d, k);
  return std::clamp(((1.0 - u) * even + u * bright) / (Pi * (1.0 - u / 3.0)), 0.0, 1.0);
}

double CoveredMagnitude(double distance, double cover)
{
  if (distance <= std::abs(1.0 - cover))
  {
    return cover;
  }
  return std::max(0.0, 0.5 * (1.0 + cover - distance));
}

} // namespace skyline
