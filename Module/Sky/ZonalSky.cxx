// SPDX-License-Identifier: BSD-3-Clause
#include "Sky/ZonalSky.h"

#include "Shared/Constants.h"
#include "Sky/SkyModel.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace skyline
{

namespace
{

/// Steps of Simpson's rule between two nodes of the table.
constexpr int StepsPerNode = 8;

} // namespace

bool ZonalSky::Knows(int cieType)
{
  return cieType == 1 || cieType == 3 || cieType == 5 || cieType == TraditionalOvercast;
}

double ZonalSky::Radiance(int cieType, double sine)
{
  if (!Knows(cieType))
  {
    throw std::invalid_argument("CIE sky " + std::to_string(cieType) +
      " is not the same in all azimuths; give 1, 3, 5 or 16");
  }
  const SkyModel sky = CieSky(cieType);
  return sky.Radiance(sine, 0.0) / sky.Radiance(1.0, 0.0);
}

ZonalSky::ZonalSky(int cieType)
{
  // With s = sin e: L sin e cos e de = L s ds and L cos e cos e de = L sqrt(1 - s^2) ds.
  const auto level = [&](double s) { return Radiance(cieType, s) * s; };
  const auto upright = [&](double s)
  { return Radiance(cieType, s) * std::sqrt(std::max(0.0, 1.0 - s * s)); };
  std::array<double, Nodes> levels{};
  std::array<double, Nodes> uprights{};
  const double step = 1.0 / ((Nodes - 1) * StepsPerNode);
  for (int node = Nodes - 2; node >= 0; --node)
  {
    const auto i = static_cast<std::size_t>(node);
    levels[i] = levels[i + 1];
    uprights[i] = uprights[i + 1];
    for (int k = 0; k < StepsPerNode; ++k)
    {
      const double a = (node * StepsPerNode + k) * step;
      const auto simpson = [&](const auto& f)
      { return step / 6.0 * (f(a) + 4.0 * f(a + 0.5 * step) + f(a + step)); };
      levels[i] += simpson(level);
      uprights[i] += simpson(upright);
    }
  }
  const double open = 2.0 * Pi * levels[0];
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    this->Table[i] = { static_cast<float>(levels[i] / open),
      static_cast<float>(uprights[i] / open) };
  }
}

ZonalSkyAccumulator::ZonalSkyAccumulator(
  const ZonalSky& sky, std::ptrdiff_t columns, const float* east, const float* north, float* share)
  : Sky(sky)
  , Columns(columns)
  , East(east)
  , North(north)
  , Share(share)
{
}

void ZonalSkyAccumulator::Begin(double azimuth, double width)
{
  this->First = this->Width == 0.0f;
  this->SinAzimuth = static_cast<float>(std::sin(azimuth));
  this->CosAzimuth = static_cast<float>(std::cos(azimuth));
  this->Width = static_cast<float>(width);
}

void ZonalSkyAccumulator::Add(
  std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes)
{
  const std::ptrdiff_t begin = row * this->Columns + column;
  const float* east = this->East + begin;
  const float* north = this->North + begin;
  float* share = this->Share + begin;
  constexpr float steepest = -NoTerrainSlope;
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    const float rise = east[i] * this->SinAzimuth + north[i] * this->CosAzimuth;
    // In this order, a rise of NaN affects the product in Light but not the table index.
    const float slope = std::min(std::max(std::max(0.0f, slopes[i]), rise), steepest);
    const float sine = slope / std::sqrt(1.0f + slope * slope);
    const float light = this->Width * this->Sky.Light(sine, rise);
    share[i] = this->First ? light : share[i] + light;
  }
}

void ZonalSkyAccumulator::Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd)
{
  for (std::ptrdiff_t post = rowBegin * this->Columns; post < rowEnd * this->Columns; ++post)
  {
    const float east = this->East[post];
    const float north = this->North[post];
    const float share = this->Share[post] / std::sqrt(1.0f + east * east + north * north);
    this->Share[post] = share < 0.0f ? 0.0f : share; // rounding where hardly any sky remains
  }
}

} // namespace skyline
