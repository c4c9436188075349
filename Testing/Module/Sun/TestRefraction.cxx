// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/Refraction.h"

#include "Shared/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace skyline;

namespace
{

/// Bennett's formula, from apparent to true elevation (Meeus, equation 16.3), in degrees. It and
/// Saemundsson's formula were fitted separately and agree to 0.1 arcminutes.
double Bennett(double apparent)
{
  return 1.0 / 60.0 / std::tan((apparent + 7.31 / (apparent + 4.4)) * RadiansPerDegree);
}
constexpr double BennettTolerance = 0.1 / 60.0;

/// The tables of ISO 2533 have six digits.
constexpr double TableTolerance = 2e-6;

} // namespace

TEST(Refraction, MeeusExample16)
{
  // The lower limb of the setting sun: apparent elevation 30', at 1010 hPa and 10 C. The true
  // elevation is 1.75' and the refraction 28.75' by Bennett's formula. Skyline starts from the true
  // elevation.
  EXPECT_NEAR(Refraction(1.75 / 60.0, Air()) * 60.0, 28.75, 0.1);
}

TEST(Refraction, InvertsBennettAboveTheHorizon)
{
  for (double apparent = 0.0; apparent <= 90.0; apparent += 0.25)
  {
    const double truth = apparent - Bennett(apparent);
    EXPECT_NEAR(Refraction(truth, Air()), Bennett(apparent), BennettTolerance) << apparent;
  }
}

TEST(Refraction, ScalesWithTheAir)
{
  Air air;
  air.PressureHPa = 820.0;
  air.TemperatureC = 11.0;
  const double scale = 820.0 / 1010.0 * 283.0 / 284.0;
  EXPECT_DOUBLE_EQ(Refraction(20.0, air), Refraction(20.0, Air()) * scale);
  air.Refracts = false;
  EXPECT_EQ(Refraction(0.0, air), 0.0);
  EXPECT_EQ(Refraction(-60.0, air), 0.0);
}

TEST(Refraction, ValueAndSlopeAreContinuousAndTheSkyKeepsItsOrder)
{
  // The densest possible air, which has the steepest refraction.
  Air air;
  air.PressureHPa = 1085.0;
  air.TemperatureC = -60.0;
  const double step = 0.01;
  const double steepest = 0.30;   // degrees per degree; found near -0.9 degrees
  const double bend = 0.35 * 1.5; // change of the slope per degree; 0.35 at the peak in normal air
  double previousSlope = 0.0;
  for (double elevation = -90.0; elevation < 90.0; elevation += step)
  {
    const double here = Refraction(elevation, air);
    const double slope = (Refraction(elevation + step, air) - here) / step;
    ASSERT_GE(here, 0.0) << elevation;
    ASSERT_LT(std::abs(slope), steepest) << elevation;
    if (elevation > -90.0)
    {
      ASSERT_LT(std::abs(slope - previousSlope), bend * step) << elevation;
    }
    previousSlope = slope;
  }
  EXPECT_NEAR(Refraction(-90.0, air), 0.0, 1e-12);
  EXPECT_EQ(Refraction(90.0, air), 0.0);
}

TEST(StandardAir, AgreesWithTheTablesOfIso2533)
{
  struct
  {
    double Height, Pressure, Kelvin;
  } const table[] = { { 0.0, 1013.25, 288.15 }, { 1000.0, 898.746, 281.65 },
    { 5000.0, 540.199, 255.65 }, { 11000.0, 226.321, 216.65 }, { 20000.0, 54.7489, 216.65 },
    { -1000.0, 1139.29, 294.65 }, { -5000.0, 1776.87, 320.65 } };
  // Geopotential heights, as in the formula. Their difference from geometric heights is not
  // significant.
  for (const auto& row : table)
  {
    const Air air = StandardAir(row.Height);
    EXPECT_NEAR(air.PressureHPa / row.Pressure, 1.0, 2 * TableTolerance) << row.Height;
    EXPECT_NEAR(air.TemperatureC, row.Kelvin - 273.15, 1e-9) << row.Height;
    EXPECT_TRUE(air.Refracts);
  }
}

TEST(StandardAir, ExtremeHeightsStayAir)
{
  EXPECT_EQ(StandardAir(-1e7).PressureHPa, StandardAir(-5000.0).PressureHPa);
  EXPECT_NEAR(StandardAir(1e7).PressureHPa, 0.0, 1e-12);
  EXPECT_NEAR(
    StandardAir(11000.0 - 1e-6).PressureHPa, StandardAir(11000.0 + 1e-6).PressureHPa, 1e-6);
  EXPECT_THROW(StandardAir(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(StandardAir(std::numeric_limits<double>::infinity()), std::invalid_argument);
}
