// SPDX-License-Identifier: BSD-3-Clause
// The fit c minimises Int (L - Sum c_k Y_k)^2 + ridge |c|^2 over the part of the sphere, so that
// (G + ridge) c = b, where G_jk = Int Y_j Y_k and b is the projection. As Y_lm is a factor of
// elevation times a factor of azimuth, G is such a product, too.
#include "Harmonics/LightFit.h"

#include "Harmonics/SwathMean.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace skyline
{

namespace
{

/// Integral over the swath of two azimuthal factors: cos(m p) for m >= 0, sin(-m p) for m < 0.
double AzimuthProduct(const Swath& swath, int a, int b)
{
  const SwathMean less = MeanOverSwath(std::abs(a) - std::abs(b), swath.Azimuth, swath.Width);
  const SwathMean more = MeanOverSwath(std::abs(a) + std::abs(b), swath.Azimuth, swath.Width);
  if (a >= 0 && b >= 0)
  {
    return 0.5 * swath.Width * (less.Cosine + more.Cosine);
  }
  if (a < 0 && b < 0)
  {
    return 0.5 * swath.Width * (less.Cosine - more.Cosine);
  }
  // sin A cos B = (sin(A + B) + sin(A - B)) / 2.
  return 0.5 * swath.Width * (more.Sine + (a < 0 ? less.Sine : -less.Sine));
}

/// The elevation factors of the harmonics, by band and order, with the azimuthal factor 1.
std::array<double, HarmonicCount(MaxHarmonicBands)> ElevationFactors(int bands, double elevation)
{
  // cos(m p) = 1 towards the east.
  std::array<double, HarmonicCount(MaxHarmonicBands)> values{};
  EvaluateHarmonics(bands, std::cos(elevation), 0.0, std::sin(elevation), values.data());
  for (int l = 0; l < bands; ++l)
  {
    for (int m = 1; m <= l; ++m)
    {
      values[static_cast<std::size_t>(HarmonicIndex(l, -m))] =
        values[static_cast<std::size_t>(HarmonicIndex(l, m))];
    }
  }
  return values;
}

/// The symmetric matrix G, row by row.
std::vector<double> Gram(const Swath& swath, int bands)
{
  // Simpson's rule, accurate to 1e-9 for functions that oscillate at most 16 times.
  constexpr int steps = 512;
  const auto count = static_cast<std::size_t>(HarmonicCount(bands));
  std::vector<double> gram(count * count, 0.0);
  for (int i = 0; i <= steps; ++i)
  {
    const double elevation = 0.5 * Pi * i / steps;
    const double weight = (i == 0 || i == steps ? 1.0
                              : i % 2 == 1      ? 4.0
                                                : 2.0) *
      0.5 * Pi / (3.0 * steps) * std::cos(elevation);
    const auto factors = ElevationFactors(bands, elevation);
    for (std::size_t j = 0; j < count; ++j)
    {
      for (std::size_t k = 0; k <= j; ++k)
      {
        gram[j * count + k] += weight * factors[j] * factors[k];
      }
    }
  }
  std::vector<int> orders;
  for (int l = 0; l < bands; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      orders.push_back(m);
    }
  }
  for (std::size_t j = 0; j < count; ++j)
  {
    for (std::size_t k = 0; k <= j; ++k)
    {
      gram[j * count + k] *= AzimuthProduct(swath, orders[j], orders[k]);
    }
  }
  return gram;
}

/// Solves a symmetric positive definite system, given by its lower triangle, with Cholesky's
/// method.
void Solve(std::vector<double>& matrix, std::vector<double>& vector)
{
  const std::size_t n = vector.size();
  for (std::size_t j = 0; j < n; ++j)
  {
    double* row = matrix.data() + j * n;
    for (std::size_t k = 0; k <= j; ++k)
    {
      const double* other = matrix.data() + k * n;
      double sum = row[k];
      for (std::size_t i = 0; i < k; ++i)
      {
        sum -= row[i] * other[i];
      }
      row[k] = j == k ? std::sqrt(sum) : sum / other[k];
    }
    for (std::size_t k = 0; k < j; ++k)
    {
      vector[j] -= row[k] * vector[k];
    }
    vector[j] /= row[j];
  }
  for (std::size_t j = n; j-- > 0;)
  {
    for (std::size_t k = j + 1; k < n; ++k)
    {
      vector[j] -= matrix[k * n + j] * vector[k];
    }
    vector[j] /= matrix[j * n + j];
  }
}

} // namespace

void FitLight(const Swath& swath, int bands, const double* projected, double* fitted, double ridge)
{
  const auto count = static_cast<std::size_t>(HarmonicCount(bands));
  std::vector<double> gram = Gram(swath, bands);
  for (std::size_t k = 0; k < count; ++k)
  {
    gram[k * count + k] += ridge * swath.Width / (2.0 * Pi); // the share of the hemisphere that the
                                                             // part covers
  }
  std::vector<double> solution(projected, projected + count);
  Solve(gram, solution);
  for (std::size_t k = 0; k < count; ++k)
  {
    fitted[k] = solution[k];
  }
}

} // namespace skyline
