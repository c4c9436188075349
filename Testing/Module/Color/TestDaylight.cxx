// SPDX-License-Identifier: BSD-3-Clause
#include "Color/Daylight.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

constexpr double Pi = 3.14159265358979;
constexpr double Tolerance = 1e-5; // floats, a dozen operations

// Kasten and Young (1989), table II: 1 at the zenith, about 38 at the horizon.
TEST(Daylight, AirMass)
{
  EXPECT_NEAR(skyline::AirMass(90.0), 1.0, 5e-4);
  EXPECT_NEAR(skyline::AirMass(30.0), 1.9943, 5e-4);
  EXPECT_NEAR(skyline::AirMass(10.0), 5.586, 5e-3);
  EXPECT_NEAR(skyline::AirMass(0.0), 37.92, 0.02);
  EXPECT_EQ(skyline::AirMass(-5.0), skyline::AirMass(0.0));
}

// The exposure is set for level open ground, whose irradiance is near pi in each light.
TEST(Daylight, LevelGroundHasIrradiancePi)
{
  for (bool air : { true, false })
  {
    for (double elevation : { -20.0, -0.5, 0.0, 1.0, 5.0, 20.0, 45.0, 70.0, 90.0 })
    {
      const skyline::Daylight light = skyline::ClearDaylight(elevation, air);
      const double height = std::max(0.0, std::sin(elevation * Pi / 180.0));
      skyline::Rgb ground;
      for (std::size_t c = 0; c < 3; ++c)
      {
        EXPECT_TRUE(std::isfinite(light.SunIrradiance[c]) && light.SunIrradiance[c] >= 0.0f);
        EXPECT_TRUE(std::isfinite(light.SkyRadiance[c]) && light.SkyRadiance[c] > 0.0f);
        ground[c] = static_cast<float>(light.SunIrradiance[c] * height + Pi * light.SkyRadiance[c]);
      }
      // The quarter of the colour cast that is kept changes luminance by a few percent.
      EXPECT_NEAR(skyline::Luminance(ground), Pi, 0.05 * Pi) << elevation;
    }
  }
}

TEST(Daylight, SunIsWarmSkyIsBlueAndLowSunWarmer)
{
  const skyline::Daylight noon = skyline::ClearDaylight(60.0);
  const skyline::Daylight evening = skyline::ClearDaylight(8.0);
  EXPECT_GT(noon.SunIrradiance[0], noon.SunIrradiance[2]);
  EXPECT_LT(noon.SkyRadiance[0], noon.SkyRadiance[2]);
  EXPECT_GT(evening.SunIrradiance[0] / evening.SunIrradiance[2],
    noon.SunIrradiance[0] / noon.SunIrradiance[2]);
}

TEST(Daylight, NoAirNoColour)
{
  const skyline::Daylight moon = skyline::ClearDaylight(30.0, false);
  for (std::size_t c = 1; c < 3; ++c)
  {
    EXPECT_NEAR(moon.SunIrradiance[c], moon.SunIrradiance[0], Tolerance);
    EXPECT_NEAR(moon.SkyRadiance[c], moon.SkyRadiance[0], Tolerance);
  }
}

TEST(Daylight, NoSunUnderTheHorizon)
{
  const skyline::Daylight night = skyline::ClearDaylight(-6.0);
  for (float channel : night.SunIrradiance)
  {
    EXPECT_EQ(channel, 0.0f);
  }
}

} // namespace
