// SPDX-License-Identifier: BSD-3-Clause
// How users write skies.
#include "Sky/SkyDescription.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace skyline
{
namespace
{

std::string Refusal(const std::string& text, bool takesNone = false)
{
  try
  {
    ParseSky(text, takesNone);
  }
  catch (const std::invalid_argument& reason)
  {
    return reason.what();
  }
  return "";
}

TEST(SkyDescription, ReadsTheSkiesByFormula)
{
  EXPECT_EQ(ParseSky("uniform").Kind, SkyKind::Uniform);
  EXPECT_EQ(ParseSky("none", true).Kind, SkyKind::None);
  for (const int zonal : { 1, 3, 5, 16 })
  {
    const SkyDescription sky = ParseSky("cie:" + std::to_string(zonal));
    EXPECT_EQ(sky.Kind, SkyKind::Zonal);
    EXPECT_EQ(sky.CieType, zonal);
    EXPECT_TRUE(sky.SameAllAround());
    EXPECT_FALSE(sky.Measured());
  }
  const SkyDescription clear = ParseSky("cie:12");
  EXPECT_EQ(clear.Kind, SkyKind::Formula);
  EXPECT_EQ(clear.CieType, 12);
  EXPECT_EQ(clear.Text, "cie:12");
  EXPECT_FALSE(clear.SameAllAround());
  const SkyDescription perez = ParseSky("perez:700,120.5");
  EXPECT_EQ(perez.Kind, SkyKind::Perez);
  EXPECT_EQ(perez.DirectIrradiance, 700.0);
  EXPECT_EQ(perez.DiffuseIrradiance, 120.5);
  EXPECT_TRUE(perez.Measured());
}

TEST(SkyDescription, ReadsTheNamesOfFiles)
{
  for (const std::string file : { "sky.hdr", "folder/sky", "./uniform" })
  {
    const SkyDescription sky = ParseSky(file);
    EXPECT_EQ(sky.Kind, SkyKind::Map);
    EXPECT_EQ(sky.Text, file);
    EXPECT_TRUE(sky.Measured());
  }
}

TEST(SkyDescription, RefusesWithTextAndCure)
{
  for (const std::string text : { "cie:0", "cie:17", "cie:2.5", "cie:x", "cie:" })
  {
    EXPECT_EQ(Refusal(text), "no sky is named " + text + "; give cie:1 to cie:16");
  }
  for (const std::string text : { "perez:", "perez:1", "perez:1,0", "perez:-1,1", "perez:1,2,3" })
  {
    EXPECT_EQ(
      Refusal(text), text + " is not a sky; give perez:DIRECT,DIFFUSE in W/m2, diffuse above 0");
  }
  EXPECT_EQ(Refusal("unifrom"), "no sky and no file is named unifrom; did you mean uniform?");
  EXPECT_NE(Refusal("none").find("give uniform, cie:1"), std::string::npos);
  EXPECT_NE(
    Refusal("no_such_sky_at_all", true).find("give uniform, none, cie:1"), std::string::npos);
  EXPECT_NE(Refusal("").find("no sky"), std::string::npos);
}

} // namespace
} // namespace skyline
