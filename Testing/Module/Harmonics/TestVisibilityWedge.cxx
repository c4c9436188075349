// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/VisibilityWedge.h"

#include "Reference/Shapes.h"
#include "WedgeTesting.h"

#include <gtest/gtest.h>

#include <cmath>

namespace skyline
{
namespace testing
{
namespace
{

constexpr double HalfPi = 0.5 * Pi;

/// Midpoint sums of 400 x 400 values of a function with at most 8 oscillations.
constexpr double MidpointBound = 2.0e-5;

std::vector<double> Step(int bands, double azimuth, double width, double horizon)
{
  std::vector<double> wedge(static_cast<std::size_t>(HarmonicCount(bands)));
  StepWedge(bands, azimuth, width, horizon, wedge.data());
  return wedge;
}

std::vector<double> Linear(int bands, double azimuth, double width, double from, double to)
{
  std::vector<double> wedge(static_cast<std::size_t>(HarmonicCount(bands)));
  LinearWedge(bands, azimuth, width, from, to, wedge.data());
  return wedge;
}

void ExpectClose(const std::vector<double>& a, const std::vector<double>& b, double bound)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    EXPECT_NEAR(a[k], b[k], bound) << "coefficient " << k;
  }
}

TEST(VisibilityWedge, EqualsBruteForce)
{
  const auto one = [](const Vector&) { return 1.0; };
  for (const double width : { 0.01, 0.4, 2.0, 2.0 * Pi })
  {
    for (const double azimuth : { 0.0, 1.0, 4.0 })
    {
      ExpectClose(Step(8, azimuth, width, 0.3),
        Project(
          8, azimuth - 0.5 * width, azimuth + 0.5 * width, 400, 400, [](double) { return 0.3; },
          one),
        MidpointBound * width);
      ExpectClose(Linear(8, azimuth, width, 0.1, 1.2),
        Project(
          8, azimuth, azimuth + width, 400, 400,
          [&](double a) { return 0.1 + 1.1 * (a - azimuth) / width; }, one),
        4.0 * MidpointBound * width);
    }
  }
}

TEST(VisibilityWedge, LevelLinearIsStep)
{
  for (const double width : { 1.0e-3, 0.2, 3.0, 2.0 * Pi })
  {
    ExpectClose(Linear(8, 0.7, width, 0.4, 0.4), Step(8, 0.7 + 0.5 * width, width, 0.4), 1.0e-12);
  }
}

TEST(VisibilityWedge, QuadratureErrsAsStated)
{
  // Four wedges with a quarter of the width use at least four times as many panels.
  for (const double width : { 0.1, 0.49, 1.0, 2.0 * Pi })
  {
    const double from = 0.0, to = HalfPi;
    std::vector<double> parts(64, 0.0);
    for (int k = 0; k < 16; ++k)
    {
      const auto part = Linear(8, 0.3 + k * width / 16.0, width / 16.0,
        from + (to - from) * k / 16.0, from + (to - from) * (k + 1) / 16.0);
      for (std::size_t c = 0; c < parts.size(); ++c)
      {
        parts[c] += part[c];
      }
    }
    ExpectClose(Linear(8, 0.3, width, from, to), parts, 1.0e-12);
  }
}

TEST(VisibilityWedge, NothingIsLeftUnderTheZenith)
{
  for (const double value : Step(8, 1.0, 2.0, HalfPi))
  {
    EXPECT_NEAR(value, 0.0, 1.0e-12);
  }
}

// The sums agree to 1e-12 in double precision; 1e-6 would be sufficient.
TEST(VisibilityWedge, FlatHorizonsSumToTheHemisphere)
{
  for (int n = 3; n <= 256; ++n)
  {
    std::vector<double> step(64, 0.0), linear(64, 0.0);
    for (int k = 0; k < n; ++k)
    {
      const double width = 2.0 * Pi / n;
      const auto a = Step(8, k * width, width, 0.0);
      const auto b = Linear(8, k * width, width, 0.0, 0.0);
      for (std::size_t c = 0; c < 64; ++c)
      {
        step[c] += a[c];
        linear[c] += b[c];
      }
    }
    for (int l = 0; l < 8; ++l)
    {
      for (int m = -l; m <= l; ++m)
      {
        const auto c = static_cast<std::size_t>(HarmonicIndex(l, m));
        EXPECT_NEAR(step[c], m == 0 ? HemisphereZonal(l) : 0.0, 1.0e-11) << n;
        EXPECT_NEAR(linear[c], m == 0 ? HemisphereZonal(l) : 0.0, 1.0e-11) << n;
      }
    }
  }
}

TEST(VisibilityWedge, BelowTheHorizontalGoesOnToTheNadir)
{
  // The full circle above the nadir is the sphere: sqrt(4 pi) in the first function alone.
  const auto sphere = Step(8, 0.0, 2.0 * Pi, -HalfPi);
  EXPECT_NEAR(sphere[0], std::sqrt(4.0 * Pi), 1.0e-12);
  for (std::size_t c = 1; c < sphere.size(); ++c)
  {
    EXPECT_NEAR(sphere[c], 0.0, 1.0e-11);
  }
}

// Bilinear interpolation with steps of 90 / 255 degrees: step^2 / 8 times the second derivatives of
// the integrals, which are below 6, in two directions.
constexpr double TableBound = 2.0 * 6.0 / 8.0 * (HalfPi / 255.0) * (HalfPi / 255.0);

TEST(WedgeTable, EqualsItsWedges)
{
  WedgeTables tables;
  const double width = 2.0 * Pi / 16.0;
  const auto table = tables.Get(4, width);
  shapes::Random random(4);
  double worst = 0.0;
  for (int k = 0; k < 2000; ++k)
  {
    const double azimuth = 6.0 * random(), from = HalfPi * random(), to = HalfPi * random();
    std::vector<double> sums(16, 0.0);
    table->AddInterior(azimuth, from, to, sums.data());
    const auto exact = Linear(4, azimuth, width, from, to);
    for (std::size_t c = 0; c < 16; ++c)
    {
      worst = std::max(worst, std::abs(sums[c] - exact[c]));
    }
  }
  RecordProperty("worst", std::to_string(worst / width));
  EXPECT_LT(worst, TableBound * width);
  EXPECT_EQ(tables.Get(4, width), table);
  EXPECT_EQ(tables.Made(), 1u);
}

TEST(WedgeTable, BoundariesComeDownFromTheZenithAndGoUpToIt)
{
  const double width = 0.3;
  const WedgeTable table(3, width);
  for (const double horizon : { 0.0, 0.2, 1.0, HalfPi })
  {
    std::vector<double> start(9, 0.0), end(9, 0.0);
    table.AddStart(2.0, horizon, start.data());
    table.AddEnd(2.0, horizon, end.data());
    ExpectClose(start, Linear(3, 2.0 - 0.5 * width, 0.5 * width, HalfPi, horizon), 1.0e-5);
    ExpectClose(end, Linear(3, 2.0, 0.5 * width, horizon, HalfPi), 1.0e-5);
  }
}

} // namespace
} // namespace testing
} // namespace skyline
