// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/HoursAfter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace skyline
{
namespace
{

std::string Later(const std::string& time, double hours)
{
  return ToText(HoursAfter(ParseUtcTime(time), hours));
}

TEST(HoursAfter, CrossesDaysMonthsAndYears)
{
  EXPECT_EQ(Later("2026-06-21T12:00Z", 2.0), "2026-06-21T14:00:00Z");
  EXPECT_EQ(Later("2026-06-21T12:00Z", 0.5125), "2026-06-21T12:30:45Z");
  EXPECT_EQ(Later("2026-12-31T23:30Z", 1.0), "2027-01-01T00:30:00Z");
  EXPECT_EQ(Later("2024-03-01T00:00Z", -24.0), "2024-02-29T00:00:00Z");
  EXPECT_EQ(Later("1901-01-01T00:00Z", -1.0), "1900-12-31T23:00:00Z");
}

TEST(HoursAfter, WithNoHoursIsTheMoment)
{
  const UtcTime leap = ParseUtcTime("2016-12-31T23:59:60.5Z");
  EXPECT_EQ(HoursAfter(leap, 0.0).Second, 60.5);
}

TEST(HoursAfter, RefusesWhatIsNoNumberOfHours)
{
  for (const double hours : { 1e9, -1e7, std::nan("") })
  {
    EXPECT_THROW(HoursAfter(UtcTime(), hours), std::invalid_argument);
  }
}

} // namespace
} // namespace skyline
