// SPDX-License-Identifier: BSD-3-Clause
// Projections of the visible sky by brute force: sums of midpoints in azimuth and elevation, in
// double precision.
#ifndef skyline_WedgeTesting_h
#define skyline_WedgeTesting_h

#include "Harmonics/SphericalHarmonics.h"
#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace skyline
{
namespace testing
{

/// A unit vector, x east, y north, z up.
struct Vector
{
  double X, Y, Z;
};

inline Vector DirectionOf(double azimuth, double elevation)
{
  return { std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
    std::sin(elevation) };
}

/// The upward normal of a plane with the given gradient.
inline Vector NormalOf(double east, double north)
{
  const double up = 1.0 / std::sqrt(1.0 + east * east + north * north);
  return { -east * up, -north * up, up };
}

using Radiance = std::function<double(const Vector&)>;

/// Calls sample(direction, solid angle) for directions in the swath [from, to] of azimuths, above
/// the elevation horizon(azimuth). The directions are midpoints, with the given numbers in azimuth
/// and elevation.
template <class Horizon, class Sample>
void ForSky(double from, double to, int azimuths, int elevations, const Horizon& horizon,
  const Sample& sample)
{
  const double width = (to - from) / azimuths;
  for (int i = 0; i < azimuths; ++i)
  {
    const double azimuth = from + (i + 0.5) * width;
    const double low = horizon(azimuth);
    const double step = (0.5 * Pi - low) / elevations;
    for (int j = 0; j < elevations; ++j)
    {
      const double elevation = low + (j + 0.5) * step;
      sample(DirectionOf(azimuth, elevation), width * step * std::cos(elevation));
    }
  }
}

/// The coefficients of f over the sky above a horizon.
template <class Horizon, class Function>
std::vector<double> Project(int bands, double from, double to, int azimuths, int elevations,
  const Horizon& horizon, const Function& f)
{
  std::vector<double> sums(static_cast<std::size_t>(HarmonicCount(bands)), 0.0);
  std::vector<double> values(sums.size());
  ForSky(from, to, azimuths, elevations, horizon,
    [&](const Vector& d, double solid)
    {
      EvaluateHarmonics(bands, d.X, d.Y, d.Z, values.data());
      for (std::size_t k = 0; k < sums.size(); ++k)
      {
        sums[k] += f(d) * solid * values[k];
      }
    });
  return sums;
}

inline double Dot(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
  {
    sum += a[k] * b[k];
  }
  return sum;
}

} // namespace testing
} // namespace skyline

#endif
