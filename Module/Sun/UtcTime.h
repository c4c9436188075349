// SPDX-License-Identifier: BSD-3-Clause
// A moment in coordinated universal time, and how people write it.
#ifndef skyline_UtcTime_h
#define skyline_UtcTime_h

#include "SkylineCoreModule.h" // for the export macro

#include <string>

namespace skyline
{

/// A moment in UTC, Gregorian calendar. Seconds reach up to 61 in the last minute of a day that
/// ends with a leap second.
struct UtcTime
{
  int Year = 2000;     ///< astronomical count
  int Month = 1;       ///< 1 to 12
  int Day = 1;         ///< 1 to 31
  int Hour = 0;        ///< 0 to 23
  int Minute = 0;      ///< 0 to 59
  double Second = 0.0; ///< 0 up to, not including, 60; 61 in a leap second
};

/// Reads ISO 8601's extended form, and what Python, pandas and GNU date print: `2026-06-21`,
/// `2026-06-21T06:00Z`, `2026-06-21 06:00:00+00:00`, `2026-06-21T08:00:30.250000000 +0200`. A date alone
/// means its first moment. Without a zone the time is UTC. Zones are Z, UTC, +hh:mm, +hhmm and +hh, or
/// with a minus. Second 60 is read where ERFA's table has a leap second. Throws std::invalid_argument,
/// naming the text and a form that works, for everything else.
SKYLINECORE_EXPORT UtcTime ParseUtcTime(const std::string& text);

/// Whether a text that ParseUtcTime reads says in which zone its clock is.
SKYLINECORE_EXPORT bool NamesZone(const std::string& text);

/// The moment as text that ParseUtcTime reads, cut (not rounded) to milliseconds.
SKYLINECORE_EXPORT std::string ToText(const UtcTime& time);

} // namespace skyline

#endif
