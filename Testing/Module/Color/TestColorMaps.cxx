// SPDX-License-Identifier: BSD-3-Clause
#include "Color/ColorMaps.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

constexpr float FloatTolerance = 1e-6f; // a few roundings of a float near 1
constexpr double RoundTolerance = 1e-12;

TEST(ColorMaps, EveryMapIsFoundByItsName)
{
  for (const skyline::ColorMap& map : skyline::ColorMaps())
  {
    EXPECT_EQ(skyline::FindColorMap(map.Name), &map);
    EXPECT_FALSE(map.Description.empty());
  }
  EXPECT_EQ(skyline::FindColorMap("rainbow"), nullptr);
  EXPECT_EQ(skyline::FindColorMap(""), nullptr);
  EXPECT_EQ(skyline::ColorMaps()[0].Name, "hypsometric");
}

// A map whose lightness only increases looks the same to people with any type of colour vision.
TEST(ColorMaps, LightnessRisesWithHeight)
{
  for (const skyline::ColorMap& map : skyline::ColorMaps())
  {
    float before = -1.0f;
    for (int i = 0; i <= 200; ++i)
    {
      const float luminance = skyline::Luminance(skyline::ColorAt(map, i / 200.0));
      EXPECT_GT(luminance, before) << map.Name << " at " << i / 200.0;
      before = luminance;
    }
  }
}

TEST(ColorMaps, EndsAndMiddleAreTheListedColours)
{
  const skyline::ColorMap& map = *skyline::FindColorMap("viridis");
  const auto expectCode = [&](double t, unsigned int code)
  {
    const skyline::Rgb color = skyline::ColorAt(map, t);
    EXPECT_EQ(skyline::SrgbByte(color[0]), code >> 16);
    EXPECT_EQ(skyline::SrgbByte(color[1]), (code >> 8) & 255u);
    EXPECT_EQ(skyline::SrgbByte(color[2]), code & 255u);
  };
  expectCode(0.0, 0x440154);
  expectCode(-3.0, 0x440154);
  expectCode(1.0, 0xfde725);
  expectCode(7.0, 0xfde725);
  expectCode(3.0 / 9.0, 0x31688e);
}

TEST(ColorMaps, AlbedoIsBetweenBlackAndWhite)
{
  for (const skyline::ColorMap& map : skyline::ColorMaps())
  {
    for (int i = 0; i <= 100; ++i)
    {
      for (float channel : skyline::ColorAt(map, i / 100.0))
      {
        EXPECT_GE(channel, 0.0f);
        EXPECT_LE(channel, 1.0f);
      }
    }
  }
}

TEST(ColorMaps, PlacesOfHeights)
{
  const skyline::ColorMap& land = *skyline::FindColorMap("hypsometric");
  EXPECT_NEAR(skyline::PlaceOnMap(land, 1500.0, 1000.0, 2000.0), 0.5, RoundTolerance);
  EXPECT_EQ(skyline::PlaceOnMap(land, 0.0, 1000.0, 2000.0), 0.0);
  EXPECT_EQ(skyline::PlaceOnMap(land, 9000.0, 1000.0, 2000.0), 1.0);
  // A flat field has one colour, which is defined.
  EXPECT_EQ(skyline::PlaceOnMap(land, 7.0, 7.0, 7.0), 0.5);

  const skyline::ColorMap& sea = *skyline::FindColorMap("ocean");
  EXPECT_NEAR(skyline::PlaceOnMap(sea, 0.0, -3000.0, 1000.0), 0.5, RoundTolerance);
  EXPECT_NEAR(skyline::PlaceOnMap(sea, -3000.0, -3000.0, 1000.0), 0.0, RoundTolerance);
  EXPECT_NEAR(skyline::PlaceOnMap(sea, 1000.0, -3000.0, 1000.0), 2.0 / 3.0, RoundTolerance);
}

TEST(ColorMaps, BlueBelowHeightZeroAndOnlyThere)
{
  const skyline::ColorMap& sea = *skyline::FindColorMap("ocean");
  for (const double reach : { 1e-3, 30.0, 9000.0 })
  {
    for (const double height : { 1.0, 0.5, 0.1, 1e-3, 1e-9, 1e-300 })
    {
      for (const double low : { -reach, 0.0 })
      {
        const auto color = [&](double z)
        { return skyline::ColorAt(sea, skyline::PlaceOnMap(sea, z, low, reach)); };
        const skyline::Rgb under = color(-height * reach);
        const skyline::Rgb over = color(height * reach);
        EXPECT_GT(under[2], 1.2f * under[0]) << height << " of " << reach;
        EXPECT_LT(over[2], over[0]) << height << " of " << reach;
      }
    }
    const skyline::Rgb coast = skyline::ColorAt(sea, skyline::PlaceOnMap(sea, 0.0, -reach, reach));
    EXPECT_LT(coast[2], coast[0]);
  }
}

TEST(ColorMaps, NeighbouringPlacesHaveNeighbouringColours)
{
  for (const skyline::ColorMap& map : skyline::ColorMaps())
  {
    for (int i = 0; i < 1000; ++i)
    {
      if (map.SeaCount > 0 && i == 499)
      {
        continue; // the coast
      }
      const skyline::Rgb a = skyline::ColorAt(map, i / 1000.0);
      const skyline::Rgb b = skyline::ColorAt(map, (i + 1) / 1000.0);
      for (std::size_t c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(a[c], b[c], 0.02f + FloatTolerance) << map.Name;
      }
    }
  }
}

} // namespace
