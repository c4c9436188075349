// SPDX-License-Identifier: BSD-3-Clause
#include "HarmonicLight.h"

#include "Constants.h"
#include "SphericalHarmonics.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace skyline
{

namespace
{

constexpr double LeastRadius = 0.01 * RadiansPerDegree;

} // namespace

HarmonicLight::HarmonicLight(int bands)
  : Bands(bands)
  , Coefficients(static_cast<std::size_t>(3 * HarmonicCount(bands)), 0.0)
{
}

void HarmonicLight::Add(const TurnedLightMap& light)
{
  const auto count = static_cast<std::size_t>(HarmonicCount(this->Bands));
  // What shines from below the horizon is never seen, so it is free: the mirror image of the upper
  // half leaves no edge at the horizon over which a short series would ring. A mirrored function
  // has twice the coefficients of the half for even l + m, and none for odd.
  std::vector<double> map(3 * count, 0.0);
  const LightMapProjection projection(light.Map.Columns, light.Map.Rows, this->Bands);
  const std::ptrdiff_t half = light.Map.Rows / 2, mirrored = light.Map.Rows - half;
  projection.AddRows(light.Map, 0, half, map.data());
  projection.AddRows(light.Map, 0, mirrored, map.data()); // a middle row counts once
  for (int l = 0; l < this->Bands; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        map[c * count + static_cast<std::size_t>(HarmonicIndex(l, m))] *=
          (l + m) % 2 == 0 ? 1.0 : 0.0;
      }
    }
  }
  std::vector<double> turned(count);
  for (std::size_t c = 0; c < 3; ++c)
  {
    RotateAboutVertical(this->Bands, light.Rotation, map.data() + c * count, turned.data());
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Coefficients[c * count + i] += light.Scale[c] * turned[i];
    }
  }
}

void HarmonicLight::Add(const SkyDisc& disc)
{
  const auto count = static_cast<std::size_t>(HarmonicCount(this->Bands));
  const double radius = std::max(disc.Radius, LeastRadius);
  const double reach = std::sin(radius);
  std::array<double, MaxHarmonicBands> zonal{};
  for (int l = 0; l < this->Bands; ++l)
  {
    zonal[static_cast<std::size_t>(l)] = CapZonal(l, std::cos(radius)) / (Pi * reach * reach);
  }
  std::vector<double> turned(count);
  const double level = std::cos(disc.Elevation);
  RotateZonal(this->Bands, zonal.data(), level * std::sin(disc.Azimuth),
    level * std::cos(disc.Azimuth), std::sin(disc.Elevation), turned.data());
  for (std::size_t c = 0; c < 3; ++c)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Coefficients[c * count + i] += disc.Irradiance[c] * turned[i];
    }
  }
}

void HarmonicLight::Light(
  const float* transfer, std::ptrdiff_t begin, std::ptrdiff_t end, float* rgb) const
{
  const auto count = static_cast<std::ptrdiff_t>(HarmonicCount(this->Bands));
  const std::vector<float> light(this->Coefficients.begin(), this->Coefficients.end());
  for (std::ptrdiff_t post = begin; post < end; ++post)
  {
    const float* values = transfer + post * count;
    float sums[3] = {};
    for (std::ptrdiff_t c = 0; c < 3; ++c)
    {
      const float* coefficients = light.data() + c * count;
      for (std::ptrdiff_t i = 0; i < count; ++i)
      {
        sums[c] += values[i] * coefficients[i];
      }
      rgb[3 * post + c] += sums[c] < 0.0f ? 0.0f : sums[c]; // the series rings; NaN passes
    }
  }
}

} // namespace skyline
