// SPDX-License-Identifier: BSD-3-Clause
#include "Sky/SkyModel.h"

#include "Shared/Constants.h"
#include "Sky/AirMass.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace skyline
{

namespace
{

/// Standard parameters a, b, c, d, e of types 1 to 15: CIE S 011/E:2003, table 1.
constexpr double CieTable[15][5] = {
  { 4.0, -0.70, 0.0, -1.0, 0.00 },
  { 4.0, -0.70, 2.0, -1.5, 0.15 },
  { 1.1, -0.80, 0.0, -1.0, 0.00 },
  { 1.1, -0.80, 2.0, -1.5, 0.15 },
  { 0.0, -1.00, 0.0, -1.0, 0.00 },
  { 0.0, -1.00, 2.0, -1.5, 0.15 },
  { 0.0, -1.00, 5.0, -2.5, 0.30 },
  { 0.0, -1.00, 10.0, -3.0, 0.45 },
  { -1.0, -0.55, 2.0, -1.5, 0.15 },
  { -1.0, -0.55, 5.0, -2.5, 0.30 },
  { -1.0, -0.55, 10.0, -3.0, 0.45 },
  { -1.0, -0.32, 10.0, -3.0, 0.45 },
  { -1.0, -0.32, 16.0, -3.0, 0.30 },
  { -1.0, -0.15, 16.0, -3.0, 0.30 },
  { -1.0, -0.15, 24.0, -2.8, 0.15 },
};

/// Lower limits of the bins of clearness: Perez et al. 1993 (from Perez et al. 1990, table 1).
constexpr double Clearness[8] = { 1.0, 1.065, 1.230, 1.500, 1.950, 2.800, 4.500, 6.200 };

/// x1 to x4 of a, b, c, d and e in each bin: Perez et al. 1993, table 1.
constexpr double PerezTable[8][5][4] = {
  { { 1.3525, -0.2576, -0.2690, -1.4366 }, { -0.7670, 0.0007, 1.2734, -0.1233 },
    { 2.8000, 0.6004, 1.2375, 1.0000 }, { 1.8734, 0.6297, 0.9738, 0.2809 },
    { 0.0356, -0.1246, -0.5718, 0.9938 } },
  { { -1.2219, -0.7730, 1.4148, 1.1016 }, { -0.2054, 0.0367, -3.9128, 0.9156 },
    { 6.9750, 0.1774, 6.4477, -0.1239 }, { -1.5798, -0.5081, -1.7812, 0.1080 },
    { 0.2624, 0.0672, -0.2190, -0.4285 } },
  { { -1.1000, -0.2515, 0.8952, 0.0156 }, { 0.2782, -0.1812, -4.5000, 1.1766 },
    { 24.7219, -13.0812, -37.7000, 34.8438 }, { -5.0000, 1.5218, 3.9229, -2.6204 },
    { -0.0156, 0.1597, 0.4199, -0.5562 } },
  { { -0.5484, -0.6654, -0.2672, 0.7117 }, { 0.7234, -0.6219, -5.6812, 2.6297 },
    { 33.3389, -18.3000, -62.2500, 52.0781 }, { -3.5000, 0.0016, 1.1477, 0.1062 },
    { 0.4659, -0.3296, -0.0876, -0.0329 } },
  { { -0.6000, -0.3566, -2.5000, 2.3250 }, { 0.2937, 0.0496, -5.6812, 1.8415 },
    { 21.0000, -4.7656, -21.5906, 7.2492 }, { -3.5000, -0.1554, 1.4062, 0.3988 },
    { 0.0032, 0.0766, -0.0656, -0.1294 } },
  { { -1.0156, -0.3670, 1.0078, 1.4051 }, { 0.2875, -0.5328, -3.8500, 3.3750 },
    { 14.0000, -0.9999, -7.1406, 7.5469 }, { -3.4000, -0.1078, -1.0750, 1.5702 },
    { -0.0672, 0.4016, 0.3017, -0.4844 } },
  { { -1.0000, 0.0211, 0.5025, -0.5119 }, { -0.3000, 0.1922, 0.7023, -1.6317 },
    { 19.0000, -5.0000, 1.2438, -1.9094 }, { -4.0000, 0.0250, 0.3844, 0.2656 },
    { 1.0468, -0.3788, -2.4517, 1.4656 } },
  { { -1.0500, 0.0289, 0.4260, 0.3590 }, { -0.3250, 0.1156, 0.7781, 0.0025 },
    { 31.0625, -14.5000, -46.1148, 55.3750 }, { -7.2312, 0.4050, 13.3500, 0.6234 },
    { 1.5000, -0.6426, 1.8564, 0.5636 } },
};

/// Smaller sines count as the horizon, where B / sine is undefined.
constexpr double LeastSine = 1.0e-9;

} // namespace

double SkyModel::Radiance(double sine, double cosToSun) const
{
  if (this->Traditional)
  {
    return 1.0 + 2.0 * sine;
  }
  const double gradation =
    this->A == 0.0 ? 1.0 : 1.0 + this->A * std::exp(this->B / std::max(sine, LeastSine));
  if (this->Zonal())
  {
    return std::max(0.0, gradation * this->Base);
  }
  const double angle = std::acos(std::clamp(cosToSun, -1.0, 1.0));
  const double indicatrix =
    this->Base + this->C * std::exp(this->D * angle) + this->E * cosToSun * cosToSun;
  return std::max(0.0, gradation * indicatrix);
}

SkyModel CieSky(int type)
{
  SkyModel sky;
  if (type == TraditionalOvercast)
  {
    sky.Traditional = true;
    return sky;
  }
  if (type < 1 || type > 15)
  {
    throw std::invalid_argument("no CIE sky has the number " + std::to_string(type) +
      "; give 1 to 15, or 16 for the traditional overcast sky");
  }
  const double* row = CieTable[type - 1];
  sky.A = row[0];
  sky.B = row[1];
  sky.C = row[2];
  sky.D = row[3];
  sky.E = row[4];
  sky.Base = 1.0 - sky.C * std::exp(0.5 * Pi * sky.D);
  return sky;
}

SkyModel PerezSky(double direct, double diffuse, double sunElevation)
{
  if (!(direct >= 0.0 && std::isfinite(direct) && diffuse > 0.0 && std::isfinite(diffuse)))
  {
    throw std::invalid_argument(
      "Perez's sky needs a direct irradiance of 0 or more and a diffuse one above 0, in W/m2");
  }
  if (!(sunElevation > 0.0 && sunElevation <= 0.5 * Pi))
  {
    throw std::invalid_argument("Perez's sky needs a sun above the horizon");
  }
  const double zenith = 0.5 * Pi - sunElevation;
  const double cubic = 1.041 * zenith * zenith * zenith;
  const double clearness = ((diffuse + direct) / diffuse + cubic) / (1.0 + cubic);
  // The brightness is limited to the range for which table 1 was fitted (Perez et al. 1990).
  const double brightness =
    std::clamp(AirMass(sunElevation * DegreesPerRadian) * diffuse / SolarConstant, 0.01, 0.6);
  const auto bin = static_cast<std::size_t>(
    std::upper_bound(std::begin(Clearness), std::end(Clearness), clearness) -
    std::begin(Clearness) - 1);
  const auto& table = PerezTable[bin];
  const auto plain = [&](std::size_t k)
  {
    const double* x = table[k];
    return x[0] + x[1] * zenith + brightness * (x[2] + x[3] * zenith);
  };
  SkyModel sky;
  sky.A = plain(0);
  // Outside the weather for which table 1 was fitted, B would rise above 0 and the radiance at the
  // horizon to infinity.
  sky.B = std::min(plain(1), 0.0);
  sky.C = plain(2);
  sky.D = plain(3);
  sky.E = plain(4);
  if (bin == 0)
  {
    // Equations of the overcast bin, printed below table 1.
    const double* c = table[2];
    const double* d = table[3];
    sky.C = std::exp(std::pow(brightness * (c[0] + c[1] * zenith), c[2])) - c[3];
    sky.D = -std::exp(brightness * (d[0] + d[1] * zenith)) + d[2] + brightness * d[3];
  }
  return sky;
}

void FillSky(const SkyModel& sky, double sunAzimuth, double sunElevation, const SkyScale& scale,
  int width, int height, float* rgb)
{
  // Two Gauss nodes in each direction.
  const double nodes[2] = { 0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0) };
  const double sunSine = std::sin(sunElevation), sunCosine = std::cos(sunElevation);
  double light = 0.0; // irradiance on open level ground
  std::fill_n(rgb, 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0f);
  const auto at = [&](double zenith, double azimuth)
  {
    const double sine = std::cos(zenith);
    return sky.Radiance(
      sine, sunSine * sine + sunCosine * std::sin(zenith) * std::cos(azimuth - sunAzimuth));
  };
  const double top = at(0.0, 0.0);
  for (int row = 0; row < height / 2; ++row)
  {
    const double begin = Pi * row / height, end = Pi * (row + 1) / height;
    const double weight = 0.5 * (std::pow(std::sin(end), 2) - std::pow(std::sin(begin), 2));
    for (int column = 0; column < width; ++column)
    {
      double sum = 0.0;
      for (const double u : nodes)
      {
        for (const double v : nodes)
        {
          sum += 0.25 * at(begin + u * (end - begin), 2.0 * Pi * (column + v) / width - Pi);
        }
      }
      light += weight * sum * 2.0 * Pi / width;
      float* pixel = rgb + 3 * (static_cast<std::size_t>(row) * width + column);
      pixel[0] = static_cast<float>(sum);
    }
  }
  const double unit = scale.ByIrradiance ? light : top;
  if (!(unit > 0.0))
  {
    throw std::invalid_argument(
      scale.ByIrradiance ? "the sky has no light" : "the sky is dark at the zenith");
  }
  const double factor = scale.Value / unit;
  const std::size_t lit = static_cast<std::size_t>(height / 2) * static_cast<std::size_t>(width);
  for (std::size_t i = 0; i < lit; ++i)
  {
    std::fill_n(rgb + 3 * i, 3, static_cast<float>(factor * rgb[3 * i]));
  }
}

} // namespace skyline
