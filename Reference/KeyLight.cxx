// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/KeyLight.h"

#include "Harmonics/ElevationIntegral.h"
#include "Harmonics/LightFit.h"
#include "Harmonics/SwathMean.h"
#include "Shared/Constants.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace skyline
{

namespace
{

/// The transfer vector of a receiver with the given normal that sees the sky of the whole swath.
std::vector<double> OpenTransfer(const Swath& swath, int bands, const double normal[3])
{
  constexpr int parts = 256; // midpoints; the integrand has at most one kink
  const auto upward = ElevationIntegrals(bands, ElevationWeight::Upward);
  const auto forward = ElevationIntegrals(bands, ElevationWeight::Forward);
  std::vector<double> transfer(static_cast<std::size_t>(HarmonicCount(bands)), 0.0);
  for (const double azimuth : AzimuthsOf(swath, parts))
  {
    const double ahead = normal[0] * std::sin(azimuth) + normal[1] * std::cos(azimuth);
    const double low = std::max(0.0, std::atan2(-ahead, normal[2]));
    std::size_t index = 0;
    for (int m = 0; m < bands; ++m)
    {
      const SwathMean mean = MeanOverSwath(m, azimuth, swath.Width / parts);
      for (int l = m; l < bands; ++l, ++index)
      {
        const double value = swath.Width / parts *
          (normal[2] * (upward[index].Whole - upward[index].Lost(low)) +
            ahead * (forward[index].Whole - forward[index].Lost(low)));
        transfer[static_cast<std::size_t>(HarmonicIndex(l, m))] += value * mean.Cosine;
        if (m > 0)
        {
          transfer[static_cast<std::size_t>(HarmonicIndex(l, -m))] += value * mean.Sine;
        }
      }
    }
  }
  return transfer;
}

/// Returns true if the whole disc lies above the horizontal plane and in the swath.
bool IsWithin(const KeyLight& light, const Swath& swath)
{
  const Swath own = SwathOf(light);
  return light.Elevation >= light.Radius &&
    (swath.IsCircle() ||
      (swath.Holds(own.Azimuth) &&
        std::abs(std::remainder(own.Azimuth - swath.Azimuth, Circle)) + 0.5 * own.Width <=
          0.5 * swath.Width + 1.0e-12));
}

/// Projects the part of the disc that lies above the horizontal plane and in the swath, by
/// midpoints of rings of equal width and of spokes.
void ProjectPart(const KeyLight& light, const Swath& swath, int bands, double* coefficients)
{
  constexpr int rings = 64;
  constexpr int spokes = 256;
  const double se = std::sin(light.Elevation);
  const double ce = std::cos(light.Elevation);
  std::fill_n(coefficients, HarmonicCount(bands), 0.0);
  double values[HarmonicCount(MaxHarmonicBands)];
  for (int ring = 0; ring < rings; ++ring)
  {
    const double r = (ring + 0.5) * light.Radius / rings;
    const double weight = std::sin(r) * light.Radius / rings * Circle / spokes;
    for (int spoke = 0; spoke < spokes; ++spoke)
    {
      const double turn = Circle * (spoke + 0.5) / spokes;
      // Components ahead, to the right of and above the direction of the light.
      const double ahead = std::cos(r) * ce - std::sin(r) * std::cos(turn) * se;
      const double right = std::sin(r) * std::sin(turn);
      const double up = std::cos(r) * se + std::sin(r) * std::cos(turn) * ce;
      const double azimuth = light.Azimuth + std::atan2(right, ahead);
      if (up <= 0.0 || !swath.Holds(azimuth))
      {
        continue;
      }
      const double level = std::hypot(ahead, right);
      EvaluateHarmonics(bands, std::sin(azimuth) * level, std::cos(azimuth) * level, up, values);
      for (int k = 0; k < HarmonicCount(bands); ++k)
      {
        coefficients[k] += weight * values[k];
      }
    }
  }
}

} // namespace

Swath SwathOf(const KeyLight& light)
{
  const double sine = std::sin(light.Radius);
  const double cosine = std::cos(light.Elevation);
  if (light.Elevation + light.Radius >= 0.5 * Pi || sine >= cosine)
  {
    return { ModuloCircle(light.Azimuth), Circle };
  }
  return { ModuloCircle(light.Azimuth), std::max(LeastSwath, 2.0 * std::asin(sine / cosine)) };
}

double FacingIrradiance(const KeyLight& light)
{
  const double sine = std::sin(light.Radius);
  if (light.Elevation >= light.Radius)
  {
    return Pi * sine * sine;
  }
  // Rings around the centre of the light. On the ring of angle r, the part with the sine of
  // elevation sin e cos r + cos e sin r cos t > 0 lies above the horizontal plane.
  constexpr int rings = 20000;
  const double step = light.Radius / rings;
  double sum = 0.0;
  for (int ring = 0; ring < rings; ++ring)
  {
    const double r = (ring + 0.5) * step;
    const double across = std::cos(light.Elevation) * std::sin(r);
    const double limit = -std::sin(light.Elevation) * std::cos(r);
    const double visible =
      across <= 0.0 ? (limit < 0.0 ? Pi : 0.0) : std::acos(std::clamp(limit / across, -1.0, 1.0));
    sum += 2.0 * visible * std::cos(r) * std::sin(r) * step;
  }
  return sum;
}

void KeyLightHarmonics(
  const KeyLight& light, const Swath& swath, int bands, double* coefficients, KeyLightSeries series)
{
  const double cosine = std::cos(light.Elevation);
  const double toward[3] = { std::sin(light.Azimuth) * cosine, std::cos(light.Azimuth) * cosine,
    std::sin(light.Elevation) };
  if (series == KeyLightSeries::Projected || IsWithin(light, swath))
  {
    double zonal[MaxHarmonicBands];
    for (int l = 0; l < bands; ++l)
    {
      zonal[l] = CapZonal(l, std::cos(light.Radius));
    }
    RotateZonal(bands, zonal, toward[0], toward[1], toward[2], coefficients);
  }
  else
  {
    ProjectPart(light, swath, bands, coefficients);
  }
  if (series == KeyLightSeries::Fitted)
  {
    FitLight(swath, bands, coefficients, coefficients);
  }
  const std::vector<double> open = OpenTransfer(swath, bands, toward);
  double found = 0.0;
  for (std::size_t k = 0; k < open.size(); ++k)
  {
    found += open[k] * coefficients[k];
  }
  // If no part of the light lies in the swath, or the light has no size, all coefficients are 0.
  const double scale = found > 0.0 ? FacingIrradiance(light) / found : 0.0;
  for (std::size_t k = 0; k < open.size(); ++k)
  {
    coefficients[k] *= scale;
  }
}

} // namespace skyline
