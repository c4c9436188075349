// SPDX-License-Identifier: BSD-3-Clause
#include "SunClock.h"

#include "Sun/Calendar.h"
#include "Sun/UtcTime.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace
{

constexpr double DegreesPerHour = 15.0;
constexpr double LastMinute = skyline::SunClock::MinutesOfDay - 1.0 / 60.0;

template <typename... Numbers>
std::string Format(const char* format, Numbers... numbers)
{
  char text[64];
  std::snprintf(text, sizeof(text), format, numbers...);
  return text;
}

} // namespace

namespace skyline
{

int NauticalZone(double longitude)
{
  return static_cast<int>(std::lround(std::remainder(longitude, 360.0) / DegreesPerHour));
}

SunClock::SunClock(const std::string& time, int zone)
{
  const UtcTime utc = ParseUtcTime(time);
  if (utc.Year < FirstYear || utc.Year > LastYear)
  {
    throw std::out_of_range("the year is " + std::to_string(utc.Year) +
      "; in the window, give a time in the years " + std::to_string(FirstYear) + " to " +
      std::to_string(LastYear));
  }
  this->Year = utc.Year;
  this->DayOfYear = DayNumber({ utc.Year, utc.Month, utc.Day }) - DayNumber({ utc.Year, 1, 1 }) + 1;
  this->Zone = zone;
  this->AddMinutes(60.0 * (utc.Hour + zone) + utc.Minute + std::min(utc.Second, 59.0) / 60.0);
}

SunClock::SunClock(int year, int dayOfYear, double minutes, int zone)
  : Year(std::clamp(year, FirstYear, LastYear))
  , Zone(zone)
{
  this->SetDayOfYear(dayOfYear);
  this->SetMinutes(minutes);
}

int SunClock::DaysOfYear() const
{
  return DaysInYear(this->Year);
}

void SunClock::SetDayOfYear(int day)
{
  this->DayOfYear = std::clamp(day, 1, this->DaysOfYear());
}

void SunClock::SetMinutes(double minutes)
{
  this->Minutes = std::clamp(minutes, 0.0, LastMinute);
}

void SunClock::AddMinutes(double minutes)
{
  const double sum = this->Minutes + minutes;
  const double days = std::floor(sum / MinutesOfDay);
  this->SetMinutes(sum - days * MinutesOfDay);
  this->AddDays(static_cast<int>(days));
}

void SunClock::AddDays(int days)
{
  this->DayOfYear += days;
  while (this->DayOfYear < 1 && this->Year > FirstYear)
  {
    --this->Year;
    this->DayOfYear += this->DaysOfYear();
  }
  while (this->DayOfYear > this->DaysOfYear() && this->Year < LastYear)
  {
    this->DayOfYear -= this->DaysOfYear();
    ++this->Year;
  }
  this->SetDayOfYear(this->DayOfYear);
}

void SunClock::TurnMinutes(double minutes)
{
  const double sum = this->Minutes + minutes;
  this->SetMinutes(sum - std::floor(sum / MinutesOfDay) * MinutesOfDay);
}

void SunClock::MonthAndDay(int& month, int& day) const
{
  const CalendarDate date = DateOfDay(DayNumber({ this->Year, 1, this->DayOfYear }));
  month = date.Month;
  day = date.Day;
}

int SunClock::Seconds() const
{
  return static_cast<int>(std::lround(60.0 * this->Minutes));
}

std::string SunClock::ToTime() const
{
  const int seconds = std::min(this->Seconds(), 86399);
  return this->LocalDate() +
    Format("T%02d:%02d:%02d%c%02d:00", seconds / 3600, seconds / 60 % 60, seconds % 60,
      this->Zone < 0 ? '-' : '+', std::abs(this->Zone));
}

std::string SunClock::LocalDate() const
{
  int month = 1;
  int day = 1;
  this->MonthAndDay(month, day);
  return Format("%04d-%02d-%02d", this->Year, month, day);
}

std::string SunClock::LocalClock() const
{
  const int seconds = this->Seconds();
  return Format("%02d:%02d", std::min(seconds / 3600, 23), seconds / 60 % 60);
}

std::string SunClock::ZoneName() const
{
  return this->Zone == 0 ? "UTC" : Format("UTC%+d", this->Zone);
}

std::string SunClock::UtcText() const
{
  const UtcTime utc = ParseUtcTime(this->ToTime());
  return Format("%04d-%02d-%02d %02d:%02d", utc.Year, utc.Month, utc.Day, utc.Hour, utc.Minute);
}

} // namespace skyline
