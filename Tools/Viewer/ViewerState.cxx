// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerState.h"

#include "Geo/Azimuth.h"

#include <algorithm>
#include <cmath>

namespace
{

constexpr double MinutesPerStep = 10.0;
constexpr int DaysPerJump = 30;
constexpr double AzimuthStep = 2.0;   // degrees
constexpr double ElevationStep = 1.0; // degrees
constexpr double FinePart = 0.1;
constexpr double RotationStep = 10.0; // degrees
constexpr double HeightFactor = 1.25;
constexpr double LampFactor = 1.25;
constexpr double StopsPerStep = 1.0 / 3.0;
constexpr double GreatestStops = 12.0;
constexpr double LowestSun = -20.0;    // degrees: night
constexpr double HighestSun = 90.0;    // degrees
constexpr double SecondsOfADay = 30.0; // for a day of the animation
constexpr double SunnyHalf = 0.5 * (HighestSun - LowestSun);

} // namespace

namespace skyline
{

void ViewerState::StepAcross(double steps, bool fine)
{
  const double part = fine ? FinePart * steps : steps;
  if (this->ByTime)
  {
    this->Clock.AddMinutes(MinutesPerStep * part);
  }
  else
  {
    this->Azimuth = NormalizedAzimuth(this->Azimuth + AzimuthStep * part);
  }
}

void ViewerState::StepUp(int steps, bool shift)
{
  if (this->ByTime)
  {
    this->Clock.AddDays(shift ? DaysPerJump * steps : steps);
  }
  else
  {
    const double part = shift ? FinePart * steps : steps;
    this->Elevation = std::clamp(this->Elevation + ElevationStep * part, LowestSun, HighestSun);
  }
}

ViewerRequest ViewerState::ChangeLamp(int key)
{
  if (!this->HasChosen())
  {
    return ViewerRequest::Changed;
  }
  ViewerLamp& lamp = this->Lamps[this->Chosen];
  switch (key)
  {
    case KeyDelete:
      this->Lamps.erase(this->Lamps.begin() + static_cast<std::ptrdiff_t>(this->Chosen));
      this->Chosen = this->Lamps.empty() ? 0 : this->Lamps.size() - 1;
      break;
    case KeyPageUp:
      lamp.Height += lamp.Radius;
      break;
    case KeyPageDown:
      lamp.Height = std::max(0.0, lamp.Height - lamp.Radius);
      break;
    case ',':
      lamp.Radius /= LampFactor;
      break;
    case '.':
      lamp.Radius *= LampFactor;
      break;
    default:
      for (double& channel : lamp.Radiance)
      {
        channel *= key == ']' ? LampFactor : 1.0 / LampFactor;
      }
  }
  return ViewerRequest::Changed;
}

ViewerRequest ViewerState::Press(int key, const Modifiers& with)
{
  switch (key)
  {
    case KeyLeft:
    case KeyRight:
      this->StepAcross(key == KeyRight ? 1.0 : -1.0, with.Shift);
      return ViewerRequest::Changed;
    case KeyUp:
    case KeyDown:
      this->StepUp(key == KeyUp ? 1 : -1, with.Shift);
      return ViewerRequest::Changed;
    case KeyDelete:
    case KeyPageUp:
    case KeyPageDown:
    case '[':
    case ']':
    case ',':
    case '.':
      return this->ChangeLamp(key);
    case KeySpace:
      this->Animated = !this->Animated;
      return ViewerRequest::Changed;
    case 'S':
      this->Sun = !this->Sun;
      return ViewerRequest::Changed;
    case 'K':
      this->Sky = (this->Sky + 1) % this->Skies.size();
      return ViewerRequest::Changed;
    case 'R':
      this->Rotation =
        NormalizedAzimuth(this->Rotation + (with.Shift ? -RotationStep : RotationStep));
      return ViewerRequest::Changed;
    case 'X':
      this->Exaggeration =
        std::clamp(this->Exaggeration * (with.Shift ? 1.0 / HeightFactor : HeightFactor),
          LeastExaggeration, GreatestExaggeration);
      if (std::abs(this->Exaggeration - 1.0) < 1.0e-9)
      {
        this->Exaggeration = 1.0; // removes the rounding when it returns
      }
      return ViewerRequest::Changed;
    case '-':
    case '=':
    case '+':
      this->Exposure = std::clamp(this->Exposure + (key == '-' ? -StopsPerStep : StopsPerStep),
        -GreatestStops, GreatestStops);
      return ViewerRequest::Changed;
    case 'A':
      this->FixedStops = this->AutoExposure ? this->MeteredStops : this->FixedStops;
      this->AutoExposure = !this->AutoExposure;
      return ViewerRequest::Changed;
    case 'C':
      this->Colors = (this->Colors + 1) % this->ColorCount;
      return ViewerRequest::Changed;
    case 'H':
      this->Help = !this->Help;
      return ViewerRequest::Changed;
    case 'T':
      this->Times = !this->Times;
      return ViewerRequest::Changed;
    case 'L':
      return ViewerRequest::Lamp;
    case 'P':
      return with.Shift ? ViewerRequest::Exr : ViewerRequest::Png;
    case 'V':
    case KeyHome:
      return ViewerRequest::Camera;
    case KeyEscape:
      if (this->Help)
      {
        this->Help = false;
        return ViewerRequest::Changed;
      }
      return ViewerRequest::Leave;
    case 'Q':
      return ViewerRequest::Leave;
    default:
      return ViewerRequest::Nothing;
  }
}

ViewerSlider ViewerState::GetSlider(std::size_t which) const
{
  ViewerSlider slider;
  if (this->ByTime && which == 0)
  {
    slider.High = SunClock::MinutesOfDay;
    slider.Value = this->Clock.GetMinutes();
    slider.Label = this->Clock.LocalClock();
  }
  else if (this->ByTime)
  {
    slider.Low = 1.0;
    slider.High = this->Clock.DaysOfYear();
    slider.Value = this->Clock.GetDayOfYear();
    slider.Label = this->Clock.LocalDate();
  }
  else if (which == 0)
  {
    slider.High = 360.0;
    slider.Value = this->Azimuth;
    slider.Label = "azimuth";
  }
  else
  {
    slider.Low = LowestSun;
    slider.High = HighestSun;
    slider.Value = this->Elevation;
    slider.Label = "elevation";
  }
  return slider;
}

void ViewerState::SetSlider(std::size_t which, double value)
{
  const ViewerSlider slider = this->GetSlider(which);
  const double inside = std::clamp(value, slider.Low, slider.High);
  if (this->ByTime && which == 0)
  {
    this->Clock.SetMinutes(inside);
  }
  else if (this->ByTime)
  {
    this->Clock.SetDayOfYear(static_cast<int>(std::lround(inside)));
  }
  else if (which == 0)
  {
    this->Azimuth = std::min(inside, 359.999);
  }
  else
  {
    this->Elevation = inside;
  }
}

void ViewerState::DragSun(double across, double up)
{
  if (this->ByTime)
  {
    this->Clock.TurnMinutes(across * SunClock::MinutesOfDay);
    this->Clock.AddDays(static_cast<int>(std::lround(up * this->Clock.DaysOfYear())));
  }
  else
  {
    this->Azimuth = NormalizedAzimuth(this->Azimuth + 360.0 * across);
    this->Elevation = std::clamp(this->Elevation + 2.0 * SunnyHalf * up, LowestSun, HighestSun);
  }
}

void ViewerState::Advance(double seconds)
{
  if (!this->Animated)
  {
    return;
  }
  const double days = seconds / SecondsOfADay;
  if (this->ByTime)
  {
    this->Clock.TurnMinutes(days * SunClock::MinutesOfDay);
  }
  else
  {
    this->Azimuth = NormalizedAzimuth(this->Azimuth + 360.0 * days);
  }
}

void ViewerState::TakeSky(const SkyDescription& sky)
{
  const auto known = std::find_if(this->Skies.begin(), this->Skies.end(),
    [&](const SkyDescription& one) { return one.Text == sky.Text; });
  this->Sky = static_cast<std::size_t>(known - this->Skies.begin());
  if (known == this->Skies.end())
  {
    this->Skies.push_back(sky);
  }
}

void ViewerState::AddLamp(const ViewerLamp& lamp)
{
  this->Chosen = this->Lamps.size();
  this->Lamps.push_back(lamp);
}

} // namespace skyline
