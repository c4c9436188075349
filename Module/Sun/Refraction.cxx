// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/Refraction.h"

#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace skyline
{
namespace
{

// ISO 2533: sea level, gradient and top of the troposphere, gravity, gas constant of dry air.
constexpr double SeaPressure = 1013.25;    // hPa
constexpr double SeaTemperature = 288.15;  // K
constexpr double TemperatureFall = 0.0065; // K/m
constexpr double Tropopause = 11000.0;     // m
constexpr double LowestHeight = -5000.0;   // m
constexpr double Gravity = 9.80665;        // m/s^2
constexpr double GasConstant = 287.05287;  // J/(kg K)
constexpr double ZeroCelsius = 273.15;     // K

// Saemundsson: R' = 1.02 / tan(h + Bend / (h + Offset)), angles in degrees, R in minutes.
constexpr double Bend = 10.3;
constexpr double Offset = 5.11;

double Saemundsson(double elevation)
{
  const double argument = (elevation + Bend / (elevation + Offset)) * RadiansPerDegree;
  return 1.02 / 60.0 / std::tan(argument);
}

} // namespace

Air StandardAir(double height)
{
  if (!std::isfinite(height))
  {
    throw std::invalid_argument(
      "height " + std::to_string(height) + " is not a number; give the mean height in metres");
  }
  const double low = std::clamp(height, LowestHeight, Tropopause);
  const double temperature = SeaTemperature - TemperatureFall * low;
  double pressure =
    SeaPressure * std::pow(temperature / SeaTemperature, Gravity / (GasConstant * TemperatureFall));
  if (height > Tropopause)
  {
    pressure *= std::exp(-Gravity * (height - Tropopause) / (GasConstant * temperature));
  }
  Air air;
  air.PressureHPa = pressure;
  air.TemperatureC = temperature - ZeroCelsius;
  return air;
}

double Refraction(double elevation, const Air& air)
{
  if (!air.Refracts)
  {
    return 0.0;
  }
  // The formula has its maximum where h + Bend / (h + Offset) has its minimum.
  static const double peak = std::sqrt(Bend) - Offset;
  double lift = 0.0;
  if (elevation >= peak)
  {
    lift = std::max(Saemundsson(elevation), 0.0);
  }
  else
  {
    const double depth = (peak - elevation) / (peak + 90.0);
    lift = Saemundsson(peak) * (1.0 - depth * depth);
  }
  return lift * (air.PressureHPa / 1010.0) * (283.0 / (273.0 + air.TemperatureC));
}

} // namespace skyline
