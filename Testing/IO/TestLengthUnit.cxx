// SPDX-License-Identifier: BSD-3-Clause
#include "LengthUnit.h"

#include <gtest/gtest.h>

using skyline::ReadUnitName;
using skyline::UnitName;

namespace
{

double Metres(const char* name)
{
  double metres = -1.0;
  EXPECT_EQ(ReadUnitName(name, metres), UnitName::Length) << name;
  return metres;
}

} // namespace

TEST(LengthUnit, Metres)
{
  for (const char* name : { "m", "M", "metre", "Metres", "meter", "meters", " m ", "[m]",
         "metres above mean sea level", "m (NAVD88)" })
  {
    EXPECT_EQ(Metres(name), 1.0) << name;
  }
  EXPECT_EQ(Metres("gpm"), 1.0);
  EXPECT_EQ(Metres("[gpm]"), 1.0);
  EXPECT_EQ(Metres("geopotential meters"), 1.0);
  EXPECT_EQ(Metres("gpdam"), 10.0);
  EXPECT_EQ(Metres("yard"), 0.9144);
  EXPECT_EQ(Metres("dm"), 0.1);
  EXPECT_EQ(Metres("centimeters"), 0.01);
  EXPECT_EQ(Metres("km"), 1000.0);
}

// The two feet differ by 2e-6, which is 18 mm for the height of Mount Everest, but they must not be
// confused.
TEST(LengthUnit, FeetAreTwo)
{
  for (const char* name : { "ft", "foot", "Feet", "international foot", "international_feet" })
  {
    EXPECT_EQ(Metres(name), 0.3048) << name;
  }
  for (const char* name : { "us-ft", "US survey foot", "U.S. Survey Feet", "ftUS", "foot_us",
         "Foot (US survey)", "survey feet" })
  {
    EXPECT_EQ(Metres(name), 1200.0 / 3937.0) << name;
  }
}

TEST(LengthUnit, Others)
{
  double metres = 5.0;
  for (const char* name : { "", " ", "unknown", "None", "other" })
  {
    EXPECT_EQ(ReadUnitName(name, metres), UnitName::Absent) << name;
  }
  for (const char* name : { "degC", "m2", "m/s", "%", "1", "\xc2\xb0", "parsec", "10m" })
  {
    EXPECT_EQ(ReadUnitName(name, metres), UnitName::Unknown) << name;
  }
  EXPECT_EQ(metres, 5.0);
}

TEST(LengthUnit, ProductsAndPowersAreNoLengths)
{
  for (const char* name : { "m s-1", "m/s", "m / s", "m s^-1", "m**2 s**-2", "m2 s-2", "m^2" })
  {
    double metres = -1.0;
    EXPECT_EQ(ReadUnitName(name, metres), UnitName::Unknown) << name;
  }
}
