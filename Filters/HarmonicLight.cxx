// SPDX-License-Identifier: BSD-3-Clause
#include "HarmonicLight.h"

#include "Harmonics/LightFit.h"
#include "Harmonics/SphericalHarmonics.h"
#include "Shared/Constants.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace skyline
{

namespace
{

constexpr double LeastRadius = 0.01 * RadiansPerDegree;

/// Turns the projection over the upper hemisphere into the series that is closest there. The mean
/// is left out of the fit and added afterwards, so that a uniform sky stays uniform to rounding.
void FitSky(int bands, std::vector<double>& coefficients)
{
  const double mean = coefficients[0] / HemisphereZonal(0);
  for (int l = 0; l < bands; ++l)
  {
    coefficients[static_cast<std::size_t>(HarmonicIndex(l, 0))] -= mean * HemisphereZonal(l);
  }
  FitLight(Swath(), bands, coefficients.data(), coefficients.data());
  coefficients[0] += mean * std::sqrt(4.0 * Pi);
}

} // namespace

HarmonicLight::HarmonicLight(int bands)
  : Bands(bands)
  , Coefficients(static_cast<std::size_t>(3 * HarmonicCount(bands)), 0.0)
{
}

void HarmonicLight::Add(const TurnedLightMap& light)
{
  const auto count = static_cast<std::size_t>(HarmonicCount(this->Bands));
  // Light from below the horizon is never seen, so the series may have any values there. Only the
  // upper half of the map is fitted; thus there is no edge at the horizon at which the series would
  // oscillate.
  std::vector<double> upper(3 * count, 0.0);
  const std::ptrdiff_t columns = light.Map.Columns, rows = light.Map.Rows;
  if (rows % 2 == 0)
  {
    LightMapProjection(columns, rows, this->Bands).AddRows(light.Map, 0, rows / 2, upper.data());
  }
  else
  {
    std::vector<float> twice; // each row twice, so that the horizon lies between rows
    for (std::ptrdiff_t row = 0; row < 2 * rows; ++row)
    {
      const float* pixels = light.Map.Pixel(row / 2, 0);
      twice.insert(twice.end(), pixels, pixels + 3 * columns);
    }
    LightMapProjection(columns, 2 * rows, this->Bands)
      .AddRows(ViewTopDown(twice.data(), columns, 2 * rows), 0, rows, upper.data());
  }
  std::vector<double> turned(count);
  for (std::size_t c = 0; c < 3; ++c)
  {
    RotateAboutVertical(this->Bands, light.Rotation, upper.data() + c * count, turned.data());
    FitSky(this->Bands, turned);
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
      rgb[3 * post + c] += sums[c] < 0.0f ? 0.0f : sums[c]; // oscillation may go below 0; NaN stays
    }
  }
}

} // namespace skyline
