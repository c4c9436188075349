// SPDX-License-Identifier: BSD-3-Clause
// Dates of the Gregorian calendar, computed by ERFA.
#ifndef skyline_Calendar_h
#define skyline_Calendar_h

#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// A date: months 1 to 12, days from 1. Years are astronomical: year 0 precedes year 1.
struct CalendarDate
{
  int Year = 2000, Month = 1, Day = 1;
};

/// The number of a day (the modified Julian date), which grows by 1 from day to day. Years from
/// -4799 on. A day beyond the end of its month counts as a day of the next month.
SKYLINECORE_EXPORT int DayNumber(const CalendarDate& date);

/// The date of a DayNumber.
SKYLINECORE_EXPORT CalendarDate DateOfDay(int number);

int DaysInMonth(int year, int month);
SKYLINECORE_EXPORT int DaysInYear(int year);

} // namespace skyline

#endif
