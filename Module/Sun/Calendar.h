// SPDX-License-Identifier: BSD-3-Clause
// Dates of the Gregorian calendar, by ERFA.
#ifndef skyline_Calendar_h
#define skyline_Calendar_h

#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// Month 1 to 12, day from 1. Years count astronomically: 0 is the one before 1.
struct CalendarDate
{
  int Year = 2000, Month = 1, Day = 1;
};

/// Days from the date to the next one differ by 1: the modified Julian date. Years from -4799 on; a day
/// beyond its month counts on into the next.
SKYLINECORE_EXPORT int DayNumber(const CalendarDate& date);

/// The date with a DayNumber.
SKYLINECORE_EXPORT CalendarDate DateOfDay(int number);

int DaysInMonth(int year, int month);
SKYLINECORE_EXPORT int DaysInYear(int year);

} // namespace skyline

#endif
