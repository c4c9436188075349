// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceLight.h"

#include "Harmonics/HarmonicProduct.h"
#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>

namespace skyline
{

namespace
{

// The factor of each shape in Visibility.glsl: the norm of the harmonic function times the
// coefficient of the cosine.
std::array<double, CosineShapes> CosineFactors()
{
  const double linear = std::sqrt(3.0 / (4.0 * Pi));
  const double square = std::sqrt(15.0 / (4.0 * Pi));
  const double zonal = std::sqrt(5.0 / (16.0 * Pi));
  std::array<double, CosineShapes> factors{ { std::sqrt(1.0 / (4.0 * Pi)), linear, linear, linear,
    square, square, zonal, square, 0.5 * square } };
  for (std::size_t j = 0; j < CosineShapes; ++j)
  {
    const int l = j == 0 ? 0 : j < 4 ? 1 : 2;
    factors[j] *= std::sqrt(4.0 * Pi / (2.0 * l + 1.0)) * ClampedCosineZonal(l);
  }
  return factors;
}

} // namespace

std::vector<float> PackTransferLight(const SurfaceLight& light)
{
  std::vector<float> packed;
  for (std::size_t c = 0; c < 3; ++c)
  {
    for (const LightColor& coefficient : light)
    {
      packed.push_back(static_cast<float>(coefficient[c]));
    }
  }
  return packed;
}

std::vector<float> PackVisibilityLight(const SurfaceLight& light)
{
  const HarmonicProduct& harmonics = HarmonicProduct::ForBands(DefaultHarmonicBands);
  const std::array<double, CosineShapes> factors = CosineFactors();
  std::vector<float> packed;
  for (std::size_t j = 0; j < CosineShapes; ++j)
  {
    std::array<double, LightCoefficients> function{};
    function[j] = factors[j];
    for (std::size_t c = 0; c < 3; ++c)
    {
      std::array<double, LightCoefficients> channel{};
      std::transform(light.begin(), light.end(), channel.begin(),
        [c](const LightColor& coefficient) { return coefficient[c]; });
      std::array<double, LightCoefficients> product{};
      harmonics.Product(function.data(), channel.data(), product.data());
      packed.insert(packed.end(), product.begin(), product.end());
    }
  }
  return packed;
}

std::array<LightColor, CosineShapes> OpenSky(const SurfaceLight& light)
{
  const std::array<double, CosineShapes> factors = CosineFactors();
  std::array<LightColor, CosineShapes> sky{};
  for (std::size_t j = 0; j < CosineShapes; ++j)
  {
    std::transform(light[j].begin(), light[j].end(), sky[j].begin(),
      [&](double coefficient) { return factors[j] * coefficient; });
  }
  return sky;
}

} // namespace skyline
