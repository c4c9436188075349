// SPDX-License-Identifier: BSD-3-Clause
// The local time of a day, set by two sliders.
#ifndef skyline_SunClock_h
#define skyline_SunClock_h

#include <string>

namespace skyline
{

/// Whole hours that the nautical time zone of a longitude (degrees east) is ahead of UTC: one hour
/// per 15 degrees, whatever the borders.
int NauticalZone(double longitude);

/// A time as year, day of the year and minutes of the day, in a time zone of whole hours. The years
/// are 1901 to 2099, which the supported times contain in every time zone; steps stop at their
/// limits.
class SunClock
{
public:
  static constexpr int FirstYear = 1901;
  static constexpr int LastYear = 2099;
  static constexpr double MinutesOfDay = 1440.0;

  SunClock() = default;

  /// `time` is a text that ParseUtcTime can read. Throws its exceptions, and std::out_of_range for
  /// other years.
  SunClock(const std::string& time, int zone);

  SunClock(int year, int dayOfYear, double minutes, int zone);

  int GetYear() const { return this->Year; }
  int GetDayOfYear() const { return this->DayOfYear; } ///< 1 to DaysOfYear
  int DaysOfYear() const;
  double GetMinutes() const { return this->Minutes; } ///< 0 to below 1440, local
  int GetZone() const { return this->Zone; }          ///< hours ahead of UTC

  void SetDayOfYear(int day);      ///< clamped to the year
  void SetMinutes(double minutes); ///< of this day, clamped to 0 ... one second before midnight
  void AddMinutes(double minutes); ///< may lead to other days
  void AddDays(int days);
  void TurnMinutes(double minutes); ///< wraps around within this day

  /// The time with its time zone, for ParseUtcTime, to the second.
  std::string ToTime() const;

  std::string LocalDate() const;  ///< 2026-06-21
  std::string LocalClock() const; ///< 16:00
  std::string ZoneName() const;   ///< UTC-8
  std::string UtcText() const;    ///< 2026-06-22 00:00

private:
  void MonthAndDay(int& month, int& day) const;
  int Seconds() const;

  int Year = 2000;
  int DayOfYear = 1;
  double Minutes = 0.0;
  int Zone = 0;
};

} // namespace skyline

#endif
