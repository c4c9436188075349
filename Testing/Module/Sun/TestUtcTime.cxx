// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/UtcTime.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

using namespace skyline;

namespace
{

/// Decimal fractions are not exact in binary, so the last digit can differ.
constexpr double SecondTolerance = 1e-9;

std::string Reason(const std::string& text)
{
  try
  {
    ParseUtcTime(text);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

} // namespace

TEST(UtcTime, ReadsEveryPart)
{
  const UtcTime time = ParseUtcTime("2026-06-21T06:07:08.25Z");
  EXPECT_EQ(time.Year, 2026);
  EXPECT_EQ(time.Month, 6);
  EXPECT_EQ(time.Day, 21);
  EXPECT_EQ(time.Hour, 6);
  EXPECT_EQ(time.Minute, 7);
  EXPECT_NEAR(time.Second, 8.25, SecondTolerance);
}

TEST(UtcTime, MissingPartsAreZeroAndMissingZoneIsUtc)
{
  EXPECT_EQ(ToText(ParseUtcTime("2026-06-21")), "2026-06-21T00:00:00Z");
  EXPECT_EQ(ToText(ParseUtcTime("2026-06-21T06:00")), "2026-06-21T06:00:00Z");
  EXPECT_EQ(ToText(ParseUtcTime("2026-06-21T06:00Z")), "2026-06-21T06:00:00Z");
}

// The output of str(datetime), str(pandas.Timestamp), strftime("%z"), numpy.datetime64 and GNU
// date.
TEST(UtcTime, ReadsWhatPythonAndPandasPrint)
{
  for (const char* text : { "2026-06-21 06:00:00+00:00", "2026-06-21 06:00:00", "2026-06-21 06:00Z",
         "2026-06-21 06:00:00.000000+00:00", "2026-06-21T06:00:00.000000000",
         "2026-06-21T08:00:00+0200", "2026-06-21 08:00:00 +0200", "2026-06-21 04:30-0130",
         "2026-06-21 06:00:00 UTC", "2026-06-21 06:00:00UTC", "2026-06-21 08:00:00+02" })
  {
    EXPECT_EQ(ToText(ParseUtcTime(text)), "2026-06-21T06:00:00Z") << text;
  }
  EXPECT_EQ(
    ToText(ParseUtcTime("2026-06-21 06:00:30.123456789+00:00")), "2026-06-21T06:00:30.123Z");
}

TEST(UtcTime, SaysWhetherAZoneIsNamed)
{
  for (const char* text : { "2026-06-21T06:00Z", "2026-06-21T08:00+02", "2026-06-21 04:00-02:00",
         "2026-06-21 06:00:00 UTC" })
  {
    EXPECT_TRUE(NamesZone(text)) << text;
  }
  for (const char* text : { "2026-06-21", "2026-06-21T06:00", "2026-06-21 06:00:00.25" })
  {
    EXPECT_FALSE(NamesZone(text)) << text;
  }
}

TEST(UtcTime, FractionsOfSeconds)
{
  EXPECT_EQ(ToText(ParseUtcTime("2026-06-21T06:00:30.1Z")), "2026-06-21T06:00:30.100Z");
  EXPECT_EQ(ToText(ParseUtcTime("2026-06-21T06:00:30,5Z")), "2026-06-21T06:00:30.500Z");
  // The seconds are not rounded up to 60.
  const std::string nines = "2026-06-21T06:00:59." + std::string(400, '9') + "Z";
  EXPECT_LT(ParseUtcTime(nines).Second, 60.0);
  EXPECT_EQ(ToText(ParseUtcTime(nines)), "2026-06-21T06:00:59.999Z");
}

TEST(UtcTime, OffsetsCrossDaysMonthsAndYears)
{
  EXPECT_EQ(ToText(ParseUtcTime("2026-06-21T08:00+02:00")), "2026-06-21T06:00:00Z");
  EXPECT_EQ(ToText(ParseUtcTime("2026-06-21T08:00+02")), "2026-06-21T06:00:00Z");
  EXPECT_EQ(ToText(ParseUtcTime("2026-06-21T06:00-00:30")), "2026-06-21T06:30:00Z");
  EXPECT_EQ(ToText(ParseUtcTime("2026-01-01T01:00+02:00")), "2025-12-31T23:00:00Z");
  EXPECT_EQ(ToText(ParseUtcTime("2025-12-31T23:00-02:00")), "2026-01-01T01:00:00Z");
  EXPECT_EQ(ToText(ParseUtcTime("2024-03-01T00:30+05:45")), "2024-02-29T18:45:00Z");
  EXPECT_EQ(ToText(ParseUtcTime("2023-02-28T20:00-06:00")), "2023-03-01T02:00:00Z");
}

TEST(UtcTime, LeapSecondsOnlyWhereThereWereSome)
{
  EXPECT_EQ(ToText(ParseUtcTime("2016-12-31T23:59:60Z")), "2016-12-31T23:59:60Z");
  EXPECT_EQ(ToText(ParseUtcTime("2016-12-31T23:59:60.75Z")), "2016-12-31T23:59:60.750Z");
  EXPECT_EQ(ToText(ParseUtcTime("2017-01-01T01:59:60+02:00")), "2016-12-31T23:59:60Z");
  for (const char* text : { "2017-12-31T23:59:60Z", "2016-12-31T22:59:60Z", "2016-12-31T23:59:61Z",
         "2016-12-31T23:59:60+02:00", "2026-06-21T06:00:60Z" })
  {
    EXPECT_NE(Reason(text), "") << text;
  }
}

TEST(UtcTime, RefusesEverythingElseByName)
{
  for (const char* text : { "", "now", "2026", "2026-06", "2026-6-21", "26-06-21", "2026-13-01",
         "2026-00-01", "2026-02-29", "1900-02-29", "2026-06-31", "2026-06-21T", "2026-06-21Z",
         "2026-06-21T06", "2026-06-21T6:00Z", "2026-06-21T24:00Z", "2026-06-21T06:60Z",
         "2026-06-21T06:00:", "2026-06-21T06:00:00.", "2026-06-21T06:00:00.Z", "2026-06-21  06:00Z",
         "2026-06-21T06:00+020", "2026-06-21T06:00 U", "2026-06-21t06:00z", "2026-06-21T06:00ZZ",
         "2026-06-21T06:00+", "2026-06-21T06:00+2:00", "2026-06-21T06:00+24:00",
         "2026-06-21T06:00+02:60", "2026-06-21T06:00+02:", " 2026-06-21", "2026-06-21 ",
         "20260621T060000Z", "2026-06-21T06:00:-1Z", "-2026-06-21", "+2026-06-21",
         "2026-06-21T06:00:00e1Z", "2026-06-21T06:00 CEST" })
  {
    const std::string reason = Reason(text);
    EXPECT_NE(reason.find(std::string("\"") + text + "\""), std::string::npos) << text;
    EXPECT_NE(reason.find("2026-06-21T06:00Z"), std::string::npos) << text;
    EXPECT_EQ(reason.find('\n'), std::string::npos) << text;
  }
  EXPECT_NE(Reason("2023-02-29").find("day outside 1 to 28"), std::string::npos);
}
