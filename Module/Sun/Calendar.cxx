// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/Calendar.h"

#include <erfa.h>
#include <erfam.h>

#include <cmath>

namespace skyline
{

int DayNumber(const CalendarDate& date)
{
  double zero = 0.0, days = 0.0;
  (void)eraCal2jd(date.Year, date.Month, 1, &zero, &days);
  return static_cast<int>(std::lround(days)) + date.Day - 1;
}

CalendarDate DateOfDay(int number)
{
  CalendarDate date;
  double fraction = 0.0;
  (void)eraJd2cal(
    ERFA_DJM0, static_cast<double>(number), &date.Year, &date.Month, &date.Day, &fraction);
  return date;
}

int DaysInMonth(int year, int month)
{
  const CalendarDate next =
    month < 12 ? CalendarDate{ year, month + 1, 1 } : CalendarDate{ year + 1, 1, 1 };
  return DayNumber(next) - DayNumber({ year, month, 1 });
}

int DaysInYear(int year)
{
  return DayNumber({ year + 1, 1, 1 }) - DayNumber({ year, 1, 1 });
}

} // namespace skyline
