// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/UtcTime.h"

#include "Sun/Calendar.h"

#include <erfa.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace skyline
{
namespace
{

constexpr int MinutesPerDay = 24 * 60;

/// Reads a text from left to right, independent of the locale, unlike strtod.
class Reader
{
public:
  explicit Reader(const std::string& text)
    : Text(text)
  {
  }

  bool AtEnd() const { return this->Position == this->Text.size(); }

  bool Accept(char wanted)
  {
    const bool found = !this->AtEnd() && this->Text[this->Position] == wanted;
    this->Position += found ? 1 : 0;
    return found;
  }

  void Expect(char wanted)
  {
    if (!this->Accept(wanted))
    {
      this->Refuse("is not a time");
    }
  }

  /// Reads exactly `digits` digits, whose number must lie within [low, high].
  int Number(int digits, int low, int high, const char* what)
  {
    int value = 0;
    for (int digit = 0; digit < digits; ++digit)
    {
      if (!this->DigitNext())
      {
        this->Refuse("is not a time");
      }
      value = 10 * value + (this->Text[this->Position++] - '0');
    }
    if (value < low || value > high)
    {
      this->Refuse("has the " + std::string(what) + " outside " + std::to_string(low) + " to " +
        std::to_string(high));
    }
    return value;
  }

  /// Reads the digits after a decimal mark as a number in [0, 1).
  double Fraction()
  {
    if (!this->DigitNext())
    {
      this->Refuse("is not a time");
    }
    double value = 0.0, unit = 1.0;
    while (this->DigitNext())
    {
      unit *= 0.1;
      value += unit * (this->Text[this->Position++] - '0');
    }
    // Many nines would round up to the next second, which may not exist.
    return std::min(value, 1.0 - 1e-12);
  }

  [[noreturn]] void Refuse(const std::string& reason) const
  {
    throw std::invalid_argument(
      "\"" + this->Text + "\" " + reason + "; write it like 2026-06-21T06:00Z");
  }

private:
  bool DigitNext() const
  {
    return !this->AtEnd() && this->Text[this->Position] >= '0' && this->Text[this->Position] <= '9';
  }

  const std::string& Text;
  std::size_t Position = 0;
};

/// Reads the time zone: minutes by which the written time is ahead of UTC.
int ReadZone(Reader& reader)
{
  if (reader.AtEnd())
  {
    return 0;
  }
  reader.Accept(' ');
  if (reader.Accept('Z'))
  {
    return 0;
  }
  if (reader.Accept('U'))
  {
    reader.Expect('T');
    reader.Expect('C');
    return 0;
  }
  const bool behind = reader.Accept('-');
  if (!behind)
  {
    reader.Expect('+');
  }
  int minutes = 60 * reader.Number(2, 0, 23, "zone hour");
  if (reader.Accept(':') || !reader.AtEnd())
  {
    minutes += reader.Number(2, 0, 59, "zone minute");
  }
  return behind ? -minutes : minutes;
}

/// Subtracts `minutes`, less than a day, from the time.
void Subtract(int minutes, UtcTime& time)
{
  int minute = 60 * time.Hour + time.Minute - minutes;
  const int days = minute < 0 ? -1 : minute / MinutesPerDay;
  minute -= days * MinutesPerDay;
  const CalendarDate date = DateOfDay(DayNumber({ time.Year, time.Month, time.Day + days }));
  time.Year = date.Year;
  time.Month = date.Month;
  time.Day = date.Day;
  time.Hour = minute / 60;
  time.Minute = minute % 60;
}

/// Returns true if the day of `time` ends with a leap second and `time` is in its last minute.
bool InLeapSecondMinute(const UtcTime& time)
{
  double day = 0.0, fraction = 0.0;
  const int status = eraDtf2d(
    "UTC", time.Year, time.Month, time.Day, time.Hour, time.Minute, time.Second, &day, &fraction);
  // 0 and 1 (a year in the far past or future) are valid; 2 and 3 mean that the day has already
  // ended.
  return time.Hour == 23 && time.Minute == 59 && (status == 0 || status == 1);
}

} // namespace

UtcTime ParseUtcTime(const std::string& text)
{
  Reader reader(text);
  UtcTime time;
  time.Year = reader.Number(4, 0, 9999, "year");
  reader.Expect('-');
  time.Month = reader.Number(2, 1, 12, "month");
  reader.Expect('-');
  time.Day = reader.Number(2, 1, DaysInMonth(time.Year, time.Month), "day");
  if (reader.AtEnd())
  {
    return time;
  }

  if (!reader.Accept(' ')) // the form of Python, pandas and GNU date
  {
    reader.Expect('T');
  }
  time.Hour = reader.Number(2, 0, 23, "hour");
  reader.Expect(':');
  time.Minute = reader.Number(2, 0, 59, "minute");
  if (reader.Accept(':'))
  {
    time.Second = reader.Number(2, 0, 60, "second");
    if (reader.Accept('.') || reader.Accept(','))
    {
      time.Second += reader.Fraction();
    }
  }
  Subtract(ReadZone(reader), time);
  if (!reader.AtEnd())
  {
    reader.Refuse("is not a time");
  }
  if (time.Second >= 60.0 && !InLeapSecondMinute(time))
  {
    reader.Refuse("has a second 60 where no leap second is known");
  }
  return time;
}

bool NamesZone(const std::string& text)
{
  constexpr std::size_t date = 10; // characters of the date, whose hyphens do not begin a zone
  return text.size() > date && text.find_first_of("ZU+-", date) != std::string::npos;
}

std::string ToText(const UtcTime& time)
{
  // A small amount is added so that 30.1 does not become 30.099.
  constexpr double hair = 1e-6;
  const double last = time.Second < 60.0 ? 59999.0 : 60999.0;
  const double second = time.Second >= 0.0 ? time.Second : 0.0; // 0 for NaN too
  const int milliseconds = static_cast<int>(std::min(std::floor(1000.0 * second + hair), last));
  char text[96];
  std::snprintf(text, sizeof text, "%04d-%02d-%02dT%02d:%02d:%02d", time.Year, time.Month, time.Day,
    time.Hour, time.Minute, milliseconds / 1000);
  std::string result = text;
  if (milliseconds % 1000 != 0)
  {
    std::snprintf(text, sizeof text, ".%03d", milliseconds % 1000);
    result += text;
  }
  return result + "Z";
}

} // namespace skyline
