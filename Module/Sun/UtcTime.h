// SPDX-License-Identifier: BSD-3-Clause
// A moment in coordinated universal time, and its form as text.
#ifndef skyline_UtcTime_h
#define skyline_UtcTime_h

#include "SkylineCoreModule.h" // for the export macro

#include <string>

namespace skyline
{

/// A moment in UTC, in the Gregorian calendar. Seconds may reach 61 in the last minute of a day
/// that ends with a leap second.
struct UtcTime
{
  int Year = 2000;     ///< astronomical: year 0 precedes year 1
  int Month = 1;       ///< 1 to 12
  int Day = 1;         ///< 1 to 31
  int Hour = 0;        ///< 0 to 23
  int Minute = 0;      ///< 0 to 59
  double Second = 0.0; ///< from 0 to below 60; below 61 in a leap second
};

/// Reads the extended form of ISO 8601, and the forms that Python, pandas and GNU date print:
/// `2026-06-21`, `2026-06-21T06:00Z`, `2026-06-21 06:00:00+00:00`,
/// `2026-06-21T08:00:30.250000000 +0200`. A date without a time is its first moment. Without a
/// zone, the time is UTC. Zones are Z, UTC, +hh:mm, +hhmm and +hh, or the same with a minus. Second
/// 60 is accepted where the table of ERFA has a leap second. Throws std::invalid_argument, which
/// names the text and a valid form, for all other texts.
SKYLINECORE_EXPORT UtcTime ParseUtcTime(const std::string& text);

/// Returns true if a text that ParseUtcTime can read states its time zone.
SKYLINECORE_EXPORT bool NamesZone(const std::string& text);

/// The moment as text that ParseUtcTime reads, truncated (not rounded) to milliseconds.
SKYLINECORE_EXPORT std::string ToText(const UtcTime& time);

} // namespace skyline

#endif
