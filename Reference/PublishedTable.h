// SPDX-License-Identifier: BSD-3-Clause
// The lighting table as published by Timonen & Westerholm (2010), section 6.2: two-dimensional,
// with bilinear interpolation. LightTable is compared with it.
#ifndef skyline_PublishedTable_h
#define skyline_PublishedTable_h

#include "Shared/Constants.h"
#include "Sky/LightMap.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace skyline
{
namespace testing
{

/// L_p of one azimuth: equation 7 without its factor 1 / pi, for angles of the normal from -90 to
/// 90 degrees and angles of the horizon from 0 to 180 degrees, both from the zenith.
class PublishedTable
{
public:
  /// radiance(zenith angle): the mean over the swath. normals: an odd number, so that (0, 0, 1) has
  /// its own node, as the paper requires.
  PublishedTable(
    const std::function<double(double)>& radiance, double width, int normals, int horizons)
    : Normals(normals)
    , Horizons(horizons)
    , Values(static_cast<std::size_t>(normals) * static_cast<std::size_t>(horizons))
  {
    constexpr int Steps = 8; // of the integral between two nodes of the horizon
    for (int n = 0; n < normals; ++n)
    {
      const double normal = Pi * n / (normals - 1) - 0.5 * Pi;
      double sum = 0.0;
      for (int h = 0; h < horizons; ++h)
      {
        this->At(n, h) = sum;
        for (int s = 0; s < Steps; ++s)
        {
          const double step = Pi / (horizons - 1) / Steps;
          const double zenith = Pi * h / (horizons - 1) + (s + 0.5) * step;
          const double facing = zenith < normal + 0.5 * Pi ? std::cos(zenith - normal) : 0.0;
          sum += radiance(zenith) * std::sin(zenith) * facing * step * width;
        }
      }
    }
  }

  /// The light of the swath for the angles of the projected normal and of the horizon, in radians
  /// from the zenith. Times the length of the projected normal, it is the irradiance.
  double operator()(double normal, double horizon) const
  {
    const double x = std::clamp((normal + 0.5 * Pi) / Pi, 0.0, 1.0) * (this->Normals - 1);
    const double y =
      std::clamp(std::min(horizon, normal + 0.5 * Pi) / Pi, 0.0, 1.0) * (this->Horizons - 1);
    const int i = std::min(static_cast<int>(x), this->Normals - 2);
    const int j = std::min(static_cast<int>(y), this->Horizons - 2);
    const double u = x - i, v = y - j;
    return (1.0 - u) * ((1.0 - v) * this->Get(i, j) + v * this->Get(i, j + 1)) +
      u * ((1.0 - v) * this->Get(i + 1, j) + v * this->Get(i + 1, j + 1));
  }

private:
  std::size_t Index(int n, int h) const
  {
    return static_cast<std::size_t>(n) * static_cast<std::size_t>(this->Horizons) +
      static_cast<std::size_t>(h);
  }
  double& At(int n, int h) { return this->Values[this->Index(n, h)]; }
  double Get(int n, int h) const { return this->Values[this->Index(n, h)]; }

  int Normals, Horizons;
  std::vector<double> Values;
};

} // namespace testing
} // namespace skyline

#endif
