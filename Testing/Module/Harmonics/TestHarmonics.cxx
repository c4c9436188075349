// SPDX-License-Identifier: BSD-3-Clause
#include "Harmonics/SphericalHarmonics.h"

#include "HarmonicTesting.h"
#include "SphereQuadrature.h"
#include "Testing/Module/NumberTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

/// Values in floats: 24 bits, up to 8 steps of recurrence and values up to 3.
constexpr double FloatBound = 3.0e-6;

constexpr int Count = HarmonicCount(MaxHarmonicBands);

struct Direction
{
  double X, Y, Z;
};

std::vector<Direction> Directions()
{
  std::vector<Direction> directions{ { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 },
    { 0, 0, 1 }, { 0, 0, -1 } };
  const std::vector<double> random = RandomVector(60, 7);
  for (std::size_t i = 0; i < random.size(); i += 3)
  {
    const double length = std::hypot(random[i], random[i + 1], random[i + 2]);
    directions.push_back({ random[i] / length, random[i + 1] / length, random[i + 2] / length });
  }
  return directions;
}

double Sum(const std::vector<double>& coefficients, const Direction& d)
{
  double values[Count];
  EvaluateHarmonics(MaxHarmonicBands, d.X, d.Y, d.Z, values);
  double sum = 0.0;
  for (int i = 0; i < Count; ++i)
  {
    sum += coefficients[i] * values[i];
  }
  return sum;
}

double Legendre(int l, double x)
{
  double before = 1.0, value = x;
  for (int k = 1; k < l; ++k)
  {
    const double next = ((2.0 * k + 1.0) * x * value - k * before) / (k + 1.0);
    before = value;
    value = next;
  }
  return l == 0 ? 1.0 : value;
}

TEST(Harmonics, ValuesOfTheReference)
{
  const std::vector<TableRow> rows = ReadTable("harmonics/sh_basis_values_order4.csv");
  ASSERT_EQ(rows.size(), 11u);
  for (const TableRow& row : rows)
  {
    double values[25];
    EvaluateHarmonics(5, Number(row, "x"), Number(row, "y"), Number(row, "z"), values);
    float floats[25];
    EvaluateHarmonics(5, static_cast<float>(Number(row, "x")), static_cast<float>(Number(row, "y")),
      static_cast<float>(Number(row, "z")), floats);
    for (int l = 0; l < 5; ++l)
    {
      for (int m = -l; m <= l; ++m)
      {
        const double expected = Number(row, "Y_" + std::to_string(l) + "_" + std::to_string(m));
        EXPECT_NEAR(values[HarmonicIndex(l, m)], expected, AlgebraBound) << l << " " << m;
        EXPECT_NEAR(floats[HarmonicIndex(l, m)], expected, FloatBound) << l << " " << m;
      }
    }
  }
}

TEST(Harmonics, Orthonormal)
{
  std::vector<double> products(Count * Count, 0.0);
  VisitSphere(MaxHarmonicBands, -1.0,
    [&](double x, double y, double z, double weight)
    {
      double values[Count];
      EvaluateHarmonics(MaxHarmonicBands, x, y, z, values);
      for (int i = 0; i < Count; ++i)
      {
        for (int j = 0; j < Count; ++j)
        {
          products[i * Count + j] += weight * values[i] * values[j];
        }
      }
    });
  for (int i = 0; i < Count; ++i)
  {
    for (int j = 0; j < Count; ++j)
    {
      EXPECT_NEAR(products[i * Count + j], i == j ? 1.0 : 0.0, AlgebraBound) << i << " " << j;
    }
  }
}

// The sum over m of Y_lm(a) Y_lm(b) is (2 l + 1) / (4 pi) P_l(a . b), which does not change under
// rotations.
TEST(Harmonics, AdditionTheorem)
{
  for (const Direction& a : Directions())
  {
    for (const Direction& b : Directions())
    {
      double first[Count], second[Count];
      EvaluateHarmonics(MaxHarmonicBands, a.X, a.Y, a.Z, first);
      EvaluateHarmonics(MaxHarmonicBands, b.X, b.Y, b.Z, second);
      const double dot = a.X * b.X + a.Y * b.Y + a.Z * b.Z;
      for (int l = 0; l < MaxHarmonicBands; ++l)
      {
        double sum = 0.0;
        for (int m = -l; m <= l; ++m)
        {
          sum += first[HarmonicIndex(l, m)] * second[HarmonicIndex(l, m)];
        }
        EXPECT_NEAR(sum, (2.0 * l + 1.0) / (4.0 * Pi) * Legendre(l, dot), AlgebraBound) << l;
      }
    }
  }
}

TEST(Harmonics, FewerBandsAreAPrefix)
{
  for (const Direction& d : Directions())
  {
    double all[Count];
    EvaluateHarmonics(MaxHarmonicBands, d.X, d.Y, d.Z, all);
    float single[Count];
    EvaluateHarmonics(MaxHarmonicBands, static_cast<float>(d.X), static_cast<float>(d.Y),
      static_cast<float>(d.Z), single);
    for (int bands = 1; bands <= MaxHarmonicBands; ++bands)
    {
      std::vector<double> some(HarmonicCount(bands) + 1, 99.0);
      EvaluateHarmonics(bands, d.X, d.Y, d.Z, some.data());
      EXPECT_TRUE(std::equal(some.begin(), some.end() - 1, all)) << bands;
      EXPECT_EQ(some.back(), 99.0) << "wrote beyond " << bands << " bands";
    }
    for (int i = 0; i < Count; ++i)
    {
      EXPECT_NEAR(single[i], all[i], FloatBound) << i;
    }
  }
}

TEST(Harmonics, RotationAboutTheVerticalMovesTheFunction)
{
  const std::vector<double> function = RandomVector(Count, 3);
  for (const double angle : { 0.0, 0.3, 0.5 * Pi, -2.0, 7.0 })
  {
    std::vector<double> turned(Count);
    RotateAboutVertical(MaxHarmonicBands, angle, function.data(), turned.data());
    for (const Direction& d : Directions())
    {
      // Clockwise seen from above: north (y) turns to east (x).
      const Direction moved{ d.X * std::cos(angle) + d.Y * std::sin(angle),
        -d.X * std::sin(angle) + d.Y * std::cos(angle), d.Z };
      EXPECT_NEAR(Sum(turned, moved), Sum(function, d), 10.0 * AlgebraBound) << angle;
    }
    std::vector<double> inPlace = function;
    RotateAboutVertical(MaxHarmonicBands, angle, inPlace.data(), inPlace.data());
    EXPECT_EQ(inPlace, turned);
    const std::vector<float> floats(function.begin(), function.end());
    std::vector<float> turnedFloats(Count);
    RotateAboutVertical(MaxHarmonicBands, angle, floats.data(), turnedFloats.data());
    for (int i = 0; i < Count; ++i)
    {
      EXPECT_NEAR(turnedFloats[i], turned[i], FloatBound);
    }
  }
}

TEST(Harmonics, QuarterTurnTakesNorthToEast)
{
  double north[4], east[4], turned[4];
  EvaluateHarmonics(2, 0.0, 1.0, 0.0, north);
  EvaluateHarmonics(2, 1.0, 0.0, 0.0, east);
  RotateAboutVertical(2, 0.5 * Pi, north, turned);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(turned[i], east[i], AlgebraBound);
  }
}

TEST(Harmonics, RotatedZonalDependsOnTheAngleToItsAxis)
{
  const std::vector<double> zonal = RandomVector(MaxHarmonicBands, 5);
  const std::vector<float> zonalFloats(zonal.begin(), zonal.end());
  for (const Direction& axis : Directions())
  {
    std::vector<double> rotated(Count);
    RotateZonal(MaxHarmonicBands, zonal.data(), axis.X, axis.Y, axis.Z, rotated.data());
    for (const Direction& d : Directions())
    {
      const double dot = axis.X * d.X + axis.Y * d.Y + axis.Z * d.Z;
      double expected = 0.0;
      for (int l = 0; l < MaxHarmonicBands; ++l)
      {
        expected += zonal[l] * std::sqrt((2.0 * l + 1.0) / (4.0 * Pi)) * Legendre(l, dot);
      }
      EXPECT_NEAR(Sum(rotated, d), expected, 10.0 * AlgebraBound);
    }
    float rotatedFloats[Count];
    RotateZonal(MaxHarmonicBands, zonalFloats.data(), static_cast<float>(axis.X),
      static_cast<float>(axis.Y), static_cast<float>(axis.Z), rotatedFloats);
    for (int i = 0; i < Count; ++i)
    {
      EXPECT_NEAR(rotatedFloats[i], rotated[i], FloatBound);
    }
  }
}

TEST(Harmonics, ClampedCosineOfTheReference)
{
  const std::vector<TableRow> rows = ReadTable("harmonics/sh_clamped_cosine_zonal.csv");
  ASSERT_EQ(rows.size(), 11u);
  for (const TableRow& row : rows)
  {
    const int l = std::stoi(row.at("l"));
    EXPECT_NEAR(
      ClampedCosineZonal(l), Number(row, "zh_coefficient c_l0 of max(cos,0)"), AlgebraBound);
    EXPECT_NEAR(std::sqrt(4.0 * Pi / (2.0 * l + 1.0)) * ClampedCosineZonal(l) / Pi,
      Number(row, "A_l/pi"), AlgebraBound);
  }
}

TEST(Harmonics, ZonalsAgainstQuadrature)
{
  constexpr int bands = 24; // more than the tables have: the closed forms hold for all bands
  for (const double bottom : { -1.0, -0.999, -0.4, 0.0, 0.3, 0.9, 0.99999 })
  {
    for (int l = 0; l < bands; ++l)
    {
      double cap = 0.0, cosine = 0.0;
      for (int k = 0; k < bands; ++k)
      {
        const auto [node, weight] = GaussNode(bands, k);
        const double z = bottom + 0.5 * (1.0 - bottom) * (node + 1.0);
        const double part =
          Pi * (1.0 - bottom) * weight * std::sqrt((2.0 * l + 1.0) / (4.0 * Pi)) * Legendre(l, z);
        cap += part;
        cosine += part * z;
      }
      EXPECT_NEAR(CapZonal(l, bottom), cap, AlgebraBound) << l << " " << bottom;
      if (bottom == 0.0)
      {
        EXPECT_NEAR(HemisphereZonal(l), cap, AlgebraBound) << l;
        EXPECT_NEAR(ClampedCosineZonal(l), cosine, AlgebraBound) << l;
      }
    }
  }
}

TEST(Harmonics, CapsAddUpAndEnd)
{
  for (int l = 0; l < 40; ++l)
  {
    EXPECT_EQ(CapZonal(l, 1.0), 0.0) << "nothing";
    EXPECT_NEAR(CapZonal(l, -1.0), l == 0 ? std::sqrt(4.0 * Pi) : 0.0, AlgebraBound) << "all";
    // The rest of the sphere is a cap around the nadir, where odd bands have the other sign.
    const double sphere = l == 0 ? std::sqrt(4.0 * Pi) : 0.0;
    EXPECT_NEAR(
      CapZonal(l, 0.3) + (l % 2 == 0 ? 1.0 : -1.0) * CapZonal(l, -0.3), sphere, AlgebraBound);
    // A cap of 1e-4 radians acts like its solid angle at the zenith, except for l (l + 1) radius^2
    // / 8.
    const double radius = 1.0e-4, solid = 2.0 * Pi * (1.0 - std::cos(radius));
    const double small = CapZonal(l, std::cos(radius)) / solid;
    EXPECT_NEAR(small / std::sqrt((2.0 * l + 1.0) / (4.0 * Pi)), 1.0,
      l * (l + 1.0) * radius * radius / 8.0 * 1.01 + AlgebraBound);
  }
}

} // namespace
} // namespace testing
} // namespace skyline
