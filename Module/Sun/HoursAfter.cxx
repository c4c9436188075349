// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/HoursAfter.h"

#include <cmath>
#include <ctime>
#include <stdexcept>
#include <string>

namespace skyline
{

UtcTime HoursAfter(const UtcTime& time, double hours)
{
  if (!(std::abs(hours) < 1e7)) // a thousand years, and no number at all
  {
    throw std::invalid_argument(
      "the sun's time is moved by " + std::to_string(hours) + " hours; give less than 1e7");
  }
  if (hours == 0.0)
  {
    return time;
  }
  std::tm clock{};
  clock.tm_year = time.Year - 1900;
  clock.tm_mon = time.Month - 1;
  clock.tm_mday = time.Day;
  clock.tm_hour = time.Hour;
  clock.tm_min = time.Minute;
  const double seconds = time.Second + 3600.0 * hours;
  const double whole = std::floor(seconds);
  const std::time_t later = timegm(&clock) + static_cast<std::time_t>(whole);
  gmtime_r(&later, &clock);
  UtcTime moment;
  moment.Year = clock.tm_year + 1900;
  moment.Month = clock.tm_mon + 1;
  moment.Day = clock.tm_mday;
  moment.Hour = clock.tm_hour;
  moment.Minute = clock.tm_min;
  moment.Second = clock.tm_sec + (seconds - whole);
  return moment;
}

} // namespace skyline
