// SPDX-License-Identifier: BSD-3-Clause
#include "LaterTime.h"

#include "Sun/UtcTime.h"

#include <cmath>
#include <ctime>
#include <stdexcept>

namespace skyline
{

std::string LaterTime(const std::string& time, double hours)
{
  if (!(std::abs(hours) < 1e7)) // more than a thousand years, or not a number
  {
    throw std::invalid_argument(
      "the sun's time is moved by " + std::to_string(hours) + " hours; give less than 1e7");
  }
  if (hours == 0.0)
  {
    return time;
  }
  UtcTime moment = ParseUtcTime(time);
  std::tm clock{};
  clock.tm_year = moment.Year - 1900;
  clock.tm_mon = moment.Month - 1;
  clock.tm_mday = moment.Day;
  clock.tm_hour = moment.Hour;
  clock.tm_min = moment.Minute;
  const double seconds = moment.Second + 3600.0 * hours;
  const double whole = std::floor(seconds);
  const std::time_t later = timegm(&clock) + static_cast<std::time_t>(whole);
  gmtime_r(&later, &clock);
  moment.Year = clock.tm_year + 1900;
  moment.Month = clock.tm_mon + 1;
  moment.Day = clock.tm_mday;
  moment.Hour = clock.tm_hour;
  moment.Minute = clock.tm_min;
  moment.Second = clock.tm_sec + (seconds - whole);
  return ToText(moment);
}

} // namespace skyline
