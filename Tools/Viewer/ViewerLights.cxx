// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerLights.h"

#include "Color/ColorMaps.h"
#include "HeightRay.h"

#include "vtkImageData.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineLampLight.h"
#include "vtkSkylineSunLight.h"

#include <ctime>
#include <sstream>

namespace
{

/// Where the calendar starts if nobody says: longest day, in the afternoon.
constexpr int JuneSolstice = 172;
constexpr int DecemberSolstice = 355;
constexpr double Afternoon = 16.0 * 60.0;

int ThisYear()
{
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  return parts.tm_year + 1900;
}

// As --sun reads it.
std::string Direction(double azimuth, double elevation)
{
  std::ostringstream text;
  text.precision(9);
  text << azimuth << ',' << elevation;
  return text.str();
}

} // namespace

namespace skyline
{

ViewerLights::ViewerLights(const LightOptions& asked, const Talk& talk)
  : Asked(asked)
  , Told(talk)
{
}

void ViewerLights::SetTerrain(vtkImageData* terrain)
{
  this->Middle = CenterOf(terrain, this->Told);
  this->Terrain = terrain;
}

void ViewerLights::SetClock(ViewerState& state) const
{
  const Georeference& place = this->Middle.Place;
  const bool earth = place.OnBody() && place.Earth;
  const int zone = NauticalZone(this->Middle.Longitude);
  if (state.ByTime && earth)
  {
    const SunClock& old = state.Clock;
    state.Clock = SunClock(old.GetYear(), old.GetDayOfYear(), old.GetMinutes(), zone);
  }
  else if (earth && this->Asked.Sun.Direction.empty())
  {
    state.ByTime = true;
    const int day = this->Middle.Latitude < 0.0 ? DecemberSolstice : JuneSolstice;
    state.Clock = SunClock(ThisYear(), day, Afternoon, zone);
  }
  else
  {
    state.ByTime = false; // no place, no time: the sun stays where it stood last
  }
}

void ViewerLights::Take(ViewerState& state)
{
  const LightOptions& asked = this->Asked;
  const SunLight sun = FindSun(asked.Sun, this->Middle.Place, this->Middle.Height);
  if (sun.FromTime)
  {
    state.Clock = SunClock(asked.Sun.Time, NauticalZone(this->Middle.Longitude));
  }
  else if (!asked.Sun.Direction.empty())
  {
    state.Azimuth = sun.GridAzimuth;
    state.Elevation = sun.ApparentElevation;
  }
  state.Skies = { "uniform", "cie:1", "cie:12", "none" };
  state.Rotation = asked.Rotation;

  // The sun beside a light map, as --sun-irradiance and perez: have it.
  LightOptions beside = asked;
  beside.Lamps.clear();
  beside.Sun = SunOptions();
  beside.Sun.Direction = "180,45";
  const bool perez = KindOfSky(asked.Environment) == SkyKind::Perez;
  beside.Environment = perez ? asked.Environment : "uniform";
  for (const auto& light : MakeLights(beside, this->Terrain, this->Told))
  {
    if (auto* disc = vtkSkylineSunLight::SafeDownCast(light))
    {
      const double* e = disc->GetIrradiance();
      this->MeasuredSun = { { static_cast<float>(e[0]), static_cast<float>(e[1]),
        static_cast<float>(e[2]) } };
      if (!asked.SunIrradiance.empty())
      {
        this->AskedSun = this->MeasuredSun;
      }
    }
  }
  if (!asked.Environment.empty())
  {
    this->Find(asked.Environment);
    state.TakeSky(asked.Environment);
    state.Sun = !IsMeasured(KindOfSky(asked.Environment)) || perez || asked.Sun.Asked();
  }

  LightOptions lamps;
  lamps.Lamps = asked.Lamps;
  for (const auto& light : MakeLights(lamps, this->Terrain, this->Told))
  {
    if (auto* ball = vtkSkylineLampLight::SafeDownCast(light))
    {
      const double* at = ball->GetPosition();
      const double* l = ball->GetRadiance();
      const double ground = GroundOrZero(this->Terrain, state.Exaggeration, at[0], at[1]);
      state.AddLamp({ at[0], at[1], at[2] - ground, ball->GetRadius(), { { l[0], l[1], l[2] } } });
    }
  }
}

vtkSmartPointer<vtkSkylineEnvironmentLight> ViewerLights::Find(const std::string& name)
{
  const SkyKind kind = KindOfSky(name);
  if (kind != SkyKind::Formula && !IsMeasured(kind))
  {
    return nullptr;
  }
  auto& known = this->Environments[name];
  if (!known)
  {
    LightOptions options;
    options.Environment = name;
    known = vtkSkylineEnvironmentLight::SafeDownCast(
      MakeLights(options, this->Terrain, this->Told).front());
  }
  return known;
}

void ViewerLights::Forget(const std::string& name)
{
  this->Environments.erase(name);
}

TerrainLight ViewerLights::Make(const ViewerState& state)
{
  TerrainLight light;
  light.SunOn = state.Sun;
  light.SunAsked = this->Asked.Sun;
  light.SunAsked.Time = state.ByTime ? state.Clock.ToTime() : "";
  light.SunAsked.Direction =
    state.ByTime ? std::string() : Direction(state.Azimuth, state.Elevation);
  light.Sun = FindSun(light.SunAsked, this->Middle.Place, this->Middle.Height);
  light.Sky = state.Skies[state.Sky];
  light.Environment = this->Find(light.Sky);
  light.MeasuredSun = this->MeasuredSun;
  light.AskedSun = this->AskedSun;
  light.Air = !this->Middle.Place.OnBody() || this->Middle.Place.Earth;
  light.Rotation = state.Rotation;
  light.Lamps = state.Lamps;
  light.Exaggeration = state.Exaggeration;
  light.Colors = ColorMaps()[state.Colors].Name;
  return light;
}

std::string ViewerLights::Key(const ViewerState& state)
{
  std::ostringstream key;
  key.precision(17);
  key << state.Sun << state.ByTime << '|' << state.Skies[state.Sky] << '|' << state.Rotation << '|'
      << state.Colors << '|';
  if (state.ByTime)
  {
    key << state.Clock.ToTime();
  }
  else
  {
    key << state.Azimuth << ',' << state.Elevation;
  }
  for (const ViewerLamp& lamp : state.Lamps)
  {
    key << '|' << lamp.X << ',' << lamp.Y << ',' << lamp.Height << ',' << lamp.Radius << ','
        << lamp.Radiance[0] << ',' << lamp.Radiance[1] << ',' << lamp.Radiance[2];
  }
  return key.str();
}

} // namespace skyline
