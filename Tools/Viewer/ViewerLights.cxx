// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerLights.h"

#include "Color/ColorMaps.h"
#include "HeightRay.h"
#include "Lights.h"
#include "PicturePasses.h"

#include "vtkImageData.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineLampLight.h"

#include <algorithm>
#include <ctime>
#include <sstream>

namespace
{

/// The day on which the calendar starts by default: the longest day; the time is in the afternoon.
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

} // namespace

namespace skyline
{

ViewerLights::ViewerLights(const LightDescription& asked, const CommonOptions& common)
  : Asked(asked)
  , Common(common)
{
}

void ViewerLights::SetTerrain(vtkImageData* terrain)
{
  this->Middle = CenterOf(terrain, this->Common);
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
  else if (earth && !this->Asked.Sun.Direction)
  {
    state.ByTime = true;
    const int day = this->Middle.Latitude < 0.0 ? DecemberSolstice : JuneSolstice;
    state.Clock = SunClock(ThisYear(), day, Afternoon, zone);
  }
  else
  {
    state.ByTime = false; // without a place there is no time: the sun stays where it was
  }
}

void ViewerLights::Take(ViewerState& state)
{
  const LightDescription& asked = this->Asked;
  const SunLight sun = FindSun(asked.Sun, this->Middle.Place, this->Middle.Height);
  if (sun.FromTime)
  {
    state.Clock = SunClock(asked.Sun.Time, NauticalZone(this->Middle.Longitude));
  }
  else if (asked.Sun.Direction)
  {
    state.Azimuth = sun.GridAzimuth;
    state.Elevation = sun.ApparentElevation;
  }
  state.Skies.clear();
  for (const char* name : { "uniform", "cie:1", "cie:12", "none" })
  {
    state.Skies.push_back(ParseSky(name, true));
  }
  state.Rotation = asked.Rotation;
  const auto irradiance = SunIrradianceOf(asked);
  std::transform(irradiance.begin(), irradiance.end(), this->MeasuredSun.begin(),
    [](double part) { return static_cast<float>(part); });
  if (asked.Sky)
  {
    this->Find(*asked.Sky);
    state.TakeSky(*asked.Sky);
    state.Sun = asked.Sky->Kind != SkyKind::Map || asked.Sun.Asked();
  }
  for (const LampDescription& lamp : asked.Lamps)
  {
    const auto ball = MakeLamp(lamp, this->Terrain, this->Common);
    const double* at = ball->GetPosition();
    const double ground = GroundOrZero(this->Terrain, state.Exaggeration, at[0], at[1]);
    state.AddLamp({ at[0], at[1], at[2] - ground, lamp.Radius, lamp.Radiance });
  }
}

vtkSmartPointer<vtkSkylineEnvironmentLight> ViewerLights::Find(const SkyDescription& sky)
{
  if (!HasEnvironment(sky.Kind))
  {
    return nullptr;
  }
  auto& known = this->Environments[sky.Text];
  if (!known)
  {
    known = MakeSky(sky, this->Common);
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
  light.SunAsked.Direction = SunAngles{ state.Azimuth, state.Elevation };
  light.Sun = FindSun(light.SunAsked, this->Middle.Place, this->Middle.Height);
  light.Sky = state.GetSky();
  light.Environment = this->Find(light.Sky);
  light.MeasuredSun = this->MeasuredSun;
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
  key << state.Sun << state.ByTime << '|' << state.GetSky().Text << '|' << state.Rotation << '|'
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
