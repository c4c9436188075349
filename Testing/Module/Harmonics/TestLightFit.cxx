// SPDX-License-Identifier: BSD-3-Clause
#include "Harmonics/LightFit.h"

#include "WedgeTesting.h"

#include <gtest/gtest.h>

#include <cmath>

namespace skyline
{
namespace testing
{
namespace
{

std::vector<double> ProjectedOver(
  const Swath& swath, int bands, const std::function<double(const Vector&)>& light)
{
  return Project(
    bands, swath.Azimuth - 0.5 * swath.Width, swath.Azimuth + 0.5 * swath.Width, 256, 1000,
    [](double) { return 0.0; }, light);
}

double SeriesAt(const std::vector<double>& coefficients, int bands, const Vector& d)
{
  std::vector<double> values(coefficients.size());
  EvaluateHarmonics(bands, d.X, d.Y, d.Z, values.data());
  return Dot(coefficients, values);
}

/// The root mean square difference from the light over the swath.
double Error(const Swath& swath, int bands, const std::vector<double>& coefficients,
  const std::function<double(const Vector&)>& light)
{
  double squares = 0.0, area = 0.0;
  ForSky(
    swath.Azimuth - 0.5 * swath.Width, swath.Azimuth + 0.5 * swath.Width, 64, 200,
    [](double) { return 0.0; },
    [&](const Vector& d, double solid)
    {
      squares += solid * std::pow(SeriesAt(coefficients, bands, d) - light(d), 2.0);
      area += solid;
    });
  return std::sqrt(squares / area);
}

TEST(LightFit, FindsALightOfItsOwnBands)
{
  // The overcast sky of Moon & Spencer has two bands, so the fit reproduces it, except for the
  // ridge.
  const auto overcast = [](const Vector& d) { return (1.0 + 2.0 * d.Z) / 3.0; };
  for (const Swath& swath : { Swath{}, Swath{ 1.0, 0.4 } })
  {
    for (const int bands : { 2, 4, 6 })
    {
      auto light = ProjectedOver(swath, bands, overcast);
      FitLight(swath, bands, light.data(), light.data());
      EXPECT_LT(Error(swath, bands, light, overcast), 2.0e-3) << bands;
    }
  }
}

TEST(LightFit, IsTheClosestSeries)
{
  // All other series fit worse: the coefficients of the fit are changed slightly, in both
  // directions.
  const Swath swath{ 2.0, 1.5 };
  const auto sky = [](const Vector& d) { return std::exp(3.0 * (d.X - d.Z)); };
  std::vector<double> fit = ProjectedOver(swath, 3, sky);
  FitLight(swath, 3, fit.data(), fit.data(), 1.0e-9);
  const double least = Error(swath, 3, fit, sky);
  for (double& coefficient : fit)
  {
    const double kept = coefficient;
    for (const double step : { -0.05, 0.05 })
    {
      coefficient = kept + step;
      EXPECT_GT(Error(swath, 3, fit, sky), least);
    }
    coefficient = kept;
  }
}

TEST(LightFit, WithoutAnyPartLeftOutIsNearTheProjection)
{
  // With more bands, the ridge keeps the coefficients of a smooth sky small.
  const auto sky = [](const Vector& d) { return 1.0 + 0.5 * d.X * d.Z; };
  for (const int bands : { 4, 8 })
  {
    std::vector<double> fit = ProjectedOver(Swath(), bands, sky);
    FitLight(Swath(), bands, fit.data(), fit.data());
    for (const double coefficient : fit)
    {
      EXPECT_LT(std::abs(coefficient), 5.0);
    }
  }
}

} // namespace
} // namespace testing
} // namespace skyline
