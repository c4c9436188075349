// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/HoursAfter.h"

#include "Sun/Calendar.h"

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace skyline
{

namespace
{

constexpr std::int64_t SecondsPerDay = 86400;

} // namespace

UtcTime HoursAfter(const UtcTime& time, double hours)
{
  if (!(std::abs(hours) < 1e7)) // more than a thousand years, or NaN
  {
    throw std::invalid_argument(
      "the sun's time is moved by " + std::to_string(hours) + " hours; give less than 1e7");
  }
  if (hours == 0.0)
  {
    return time;
  }
  const double seconds = time.Second + 3600.0 * hours;
  const double whole = std::floor(seconds);
  const std::int64_t clock = 3600 * time.Hour + 60 * time.Minute + static_cast<std::int64_t>(whole);
  const std::int64_t left = (clock % SecondsPerDay + SecondsPerDay) % SecondsPerDay;
  const auto days = static_cast<int>((clock - left) / SecondsPerDay);
  const CalendarDate date = DateOfDay(DayNumber({ time.Year, time.Month, time.Day + days }));
  UtcTime moment;
  moment.Year = date.Year;
  moment.Month = date.Month;
  moment.Day = date.Day;
  moment.Hour = static_cast<int>(left / 3600);
  moment.Minute = static_cast<int>(left / 60 % 60);
  moment.Second = static_cast<double>(left % 60) + (seconds - whole);
  return moment;
}

} // namespace skyline
