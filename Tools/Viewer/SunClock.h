// SPDX-License-Identifier: BSD-3-Clause
// Local time of a day, as two sliders set it.
#ifndef skyline_SunClock_h
#define skyline_SunClock_h

#include <string>

namespace skyline
{

/// Whole hours that the nautical time zone of a longitude (degrees east) is ahead of UTC: 15 degrees
/// an hour, no politics.
int NauticalZone(double longitude);

/// A moment as year, day of the year and minutes of the day, in a zone of whole hours. Years 1901 to
/// 2099, which all times that Skyline knows contain in every zone; steps beyond stop there.
class SunClock
{
public:
  static constexpr int FirstYear = 1901;
  static constexpr int LastYear = 2099;
  static constexpr double MinutesOfDay = 1440.0;

  SunClock() = default;

  /// Time given as text that ParseUtcTime reads; throws what that throws, and
  /// std::out_of_range beyond the years above.
  SunClock(const std::string& time, int zone);

  SunClock(int year, int dayOfYear, double minutes, int zone);

  int GetYear() const { return this->Year; }
  int GetDayOfYear() const { return this->DayOfYear; } ///< 1 to DaysOfYear
  int DaysOfYear() const;
  double GetMinutes() const { return this->Minutes; } ///< 0 up to 1440, local
  int GetZone() const { return this->Zone; }          ///< hours ahead of UTC

  void SetDayOfYear(int day);      ///< clamped
  void SetMinutes(double minutes); ///< of this day, clamped to 0 up to a second before midnight
  void AddMinutes(double minutes); ///< into other days
  void AddDays(int days);
  void TurnMinutes(double minutes); ///< round the clock, within this day

  /// The moment with its zone, for ParseUtcTime, to the second.
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
