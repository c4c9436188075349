// SPDX-License-Identifier: BSD-3-Clause
#include "GpuWedgeWeights.h"

#include "Harmonics/ElevationIntegral.h"
#include "Harmonics/SphericalHarmonics.h"
#include "Harmonics/VisibilityAccumulator.h"

#include <cmath>
#include <cstddef>

namespace skyline
{

std::vector<float> WedgeTexels(int bands, const std::vector<double>& azimuths, double width)
{
  std::vector<float> texels(static_cast<std::size_t>(4 * (2 + 6 * bands)), 0.0f);
  for (std::size_t k = 0; k < azimuths.size(); ++k)
  {
    const double azimuth = azimuths[k];
    texels[k] = static_cast<float>(std::sin(azimuth));
    texels[4 + k] = static_cast<float>(std::cos(azimuth));
    const WedgeWeights<double> weights = WeightsOfSwath(bands, azimuth, width);
    for (int m = 0; m < bands; ++m)
    {
      const double of[6] = { weights.Cosine[m], weights.Sine[m], weights.CosineEast[m],
        weights.SineEast[m], weights.CosineNorth[m], weights.SineNorth[m] };
      for (int j = 0; j < 6; ++j)
      {
        texels[static_cast<std::size_t>(4 * (2 + 6 * m + j)) + k] = static_cast<float>(of[j]);
      }
    }
  }
  return texels;
}

std::array<std::vector<double>, 3> WholeSums(
  int bands, const std::vector<double>& azimuths, double width, bool transfer)
{
  const auto count = static_cast<std::size_t>(HarmonicCount(bands));
  std::array<std::vector<double>, 3> wholes;
  wholes.fill(std::vector<double>(count, 0.0));
  const auto visible = ElevationIntegrals(bands, ElevationWeight::One);
  const auto upward = ElevationIntegrals(bands, ElevationWeight::Upward);
  const auto forward = ElevationIntegrals(bands, ElevationWeight::Forward);
  for (const double azimuth : azimuths)
  {
    const WedgeWeights<double> weights = WeightsOfSwath(bands, azimuth, width);
    std::size_t index = 0;
    for (int m = 0; m < bands; ++m)
    {
      for (int l = m; l < bands; ++l, ++index)
      {
        const auto plus = static_cast<std::size_t>(HarmonicIndex(l, m));
        const auto minus = static_cast<std::size_t>(HarmonicIndex(l, -m));
        const double up = (transfer ? upward : visible)[index].Whole;
        const double ahead = transfer ? forward[index].Whole : 0.0;
        wholes[0][plus] += up * weights.Cosine[m];
        wholes[1][plus] -= ahead * weights.CosineEast[m];
        wholes[2][plus] -= ahead * weights.CosineNorth[m];
        if (m > 0)
        {
          wholes[0][minus] += up * weights.Sine[m];
          wholes[1][minus] -= ahead * weights.SineEast[m];
          wholes[2][minus] -= ahead * weights.SineNorth[m];
        }
      }
    }
  }
  return wholes;
}

} // namespace skyline
