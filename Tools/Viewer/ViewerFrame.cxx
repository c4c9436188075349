// SPDX-License-Identifier: BSD-3-Clause
// The viewer from one picture to the next: what is computed, and when.
#include "Viewer.h"

#include "Failure.h"
#include "IoFailure.h"
#include "Screenshot.h"
#include "ViewerStatus.h"

#include "vtkCallbackCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineSoftShadowShader.h"

#include <algorithm>
#include <chrono>

namespace
{

/// Seconds without an event after which the light is computed exactly.
constexpr double RestSeconds = 0.2;

/// If a fine picture takes more seconds than this to draw, a coarse one is drawn while something
/// moves.
constexpr double FluidSeconds = 0.04;

/// The longest step of the animation in seconds. A slow machine shows fewer pictures, not larger
/// steps.
constexpr double LongestStep = 0.25;

/// At this elevation in degrees or below, no part of the sun's disc is above the horizon.
constexpr double LowestSun = -1.0;

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

namespace skyline
{

void Viewer::ShowSky(const TerrainLight& light, const LitTerrain& terrain)
{
  SkyDome& dome = this->Scene->GetSky();
  const std::string key = SkyImageKey(light, terrain.GetSkyRadiance(), terrain.GetGroundLight());
  if (key != this->SkyShown)
  {
    dome.SetSky(MakeSkyImage(light, terrain.GetSkyRadiance(), terrain.GetGroundLight()));
    this->SkyShown = key;
  }
  dome.SetRotation(light.Environment ? light.Rotation : 0.0);
  dome.SetSun(light.SunOn && light.Sun.ApparentElevation > LowestSun, light.Sun.GridAzimuth,
    light.Sun.ApparentElevation, light.Sun.Radius);
}

bool Viewer::Compute(LitTerrain& terrain, bool exact)
{
  try
  {
    TerrainLight light = this->Lights.Make(this->State);
    if (!exact)
    {
      light.Exaggeration = this->LitExaggeration; // new shadows take too long while it changes
    }
    if (!terrain.Light(light, exact))
    {
      return false;
    }
    this->LitExaggeration = light.Exaggeration;
    this->ShowSky(light, terrain);
  }
  catch (const std::exception& reason)
  {
    this->Say(FirstLine(reason.what()));
  }
  if (terrain.GetOutput())
  {
    this->State.MeteredStops = terrain.GetExposure();
    this->Scene->SetLight(terrain.GetOutput());
  }
  this->LightTimes = terrain.GetTimes();
  this->Stale = true;
  return true;
}

bool Viewer::Draw(double now)
{
  const double step = std::min(now - this->LastDraw, LongestStep);
  this->LastDraw = now;
  if (this->Events != this->SeenEvents)
  {
    this->SeenEvents = this->Events;
    this->LastEvent = now;
  }
  if (this->Away || this->Layout.Width < 1 || this->Layout.Height < 1)
  {
    return false;
  }
  if (this->State.Animated)
  {
    this->State.Advance(step);
    this->Stale = true;
  }
  this->LightTimes.clear();
  const std::string key = ViewerLights::Key(this->State);
  if (key != this->Lit)
  {
    this->Compute(this->Small ? *this->Small : *this->Full, false);
    this->Lit = key;
    this->Exact = false;
  }
  this->Scene->SetExaggeration(this->State.Exaggeration);
  this->Exact = this->Exact && this->LitExaggeration == this->State.Exaggeration;
  const bool resting = !this->State.Animated && now - this->LastEvent >= RestSeconds;
  if (resting && !this->Exact)
  {
    this->Exact = this->Compute(*this->Full, true);
    if (!this->Exact)
    {
      return false; // stopped by an event, which is handled first
    }
  }
  const bool coarse = !resting && this->FineSeconds > FluidSeconds;
  if (!this->Stale && coarse >= this->Scene->IsCoarse())
  {
    return false;
  }
  this->Paint(coarse);
  return true;
}

double Viewer::GetPatience(double now) const
{
  if (this->Away || this->Layout.Width < 1 || this->Layout.Height < 1)
  {
    return -1.0;
  }
  if (this->State.Animated || this->Stale || this->Events != this->SeenEvents)
  {
    return 0.0;
  }
  return this->Exact && !this->Scene->IsCoarse()
    ? -1.0
    : std::max(0.0, this->LastEvent + RestSeconds - now);
}

void Viewer::Paint(bool coarse)
{
  if (this->FirstView)
  {
    this->Scene->ResetCamera(this->Options.FromAzimuth, this->Options.FromElevation,
      static_cast<double>(this->Layout.Width) / this->Layout.Height);
    this->FirstView = false;
  }
  const bool shot = this->Shot != ViewerRequest::Nothing;
  const bool fine = !coarse || shot;
  const auto start = Clock::now();
  this->Scene->SetCoarse(!fine);
  this->Scene->GetRenderer()->SetUseFXAA(fine); // smooth edges, if there is time
  this->Scene->SetLamps(this->State.Lamps);
  this->Scene->SetExposure(this->State.Stops());
  this->Scene->Prepare();
  if (shot)
  {
    this->Shoot();
  }
  this->Shown = this->MakeHud();
  this->Display.Show(this->Shown, this->Layout);
  const double labels = SecondsSince(start);

  double terrain = 0.0;
  vtkNew<vtkCallbackCommand> end;
  struct Mark
  {
    vtkRenderWindow* Window;
    Clock::time_point Start;
    double* Seconds;
  } mark{ this->Window, Clock::now(), &terrain };
  end->SetClientData(&mark);
  end->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*)
    {
      auto* at = static_cast<Mark*>(data);
      at->Window->WaitForCompletion();
      *at->Seconds = SecondsSince(at->Start);
    });
  const unsigned long tag = this->Scene->GetRenderer()->AddObserver(vtkCommand::EndEvent, end);
  this->Window->Render();
  this->Window->WaitForCompletion();
  this->Scene->GetRenderer()->RemoveObserver(tag);
  const double all = SecondsSince(mark.Start);

  if (fine && this->Drawn)
  {
    this->FineSeconds = terrain; // the first picture also builds buffers and shaders
  }
  this->Drawn = true;
  this->Times = this->LightTimes;
  this->Times.emplace_back(fine ? "terrain" : "coarse terrain", terrain);
  this->Times.emplace_back("display", labels + all - terrain);
  this->Stale = false;
}

void Viewer::Shoot()
{
  const bool linear = this->Shot == ViewerRequest::Exr;
  vtkRenderer* display = this->Display.GetRenderer();
  display->DrawOff();
  try
  {
    if (!this->Exact)
    {
      this->Exact = this->Compute(*this->Full, true);
      this->Scene->SetExposure(this->State.Stops());
    }
    const std::string file = FreeName(this->Options.ShotFolder, linear ? ".exr" : ".png");
    if (linear)
    {
      this->Scene->SetLamps({}); // light on the ground without the drawn balls
      WriteExr(this->Window, this->Scene->GetRenderer(), this->Scene->GetShader(),
        this->Scene->GetSky(), file);
      this->Scene->SetLamps(this->State.Lamps);
      this->Scene->Prepare();
    }
    else
    {
      this->Window->Render();
      WritePng(this->Window, file);
    }
    this->Say("wrote " + file);
  }
  catch (const std::exception& reason)
  {
    this->Say(FirstLine(reason.what()));
  }
  display->DrawOn();
  this->Shot = ViewerRequest::Nothing;
}

HudContent Viewer::MakeHud()
{
  const SunLight sun = this->Lights.Make(this->State).Sun;
  HudContent content;
  content.Status = StatusText(this->Options.Terrain.File, this->State, sun, this->Exact);
  content.Times = this->State.Times ? TimesText(this->Times) : "";
  content.Message = this->Message.empty() && !this->State.Help ? "H: help" : this->Message;
  content.Help = this->State.Help ? ViewerHelp() : "";
  for (std::size_t k = 0; k < content.Sliders.size(); ++k)
  {
    content.Sliders[k] = this->State.GetSlider(k);
  }
  content.Heading = this->Scene->GetHeading() + sun.TrueAzimuth - sun.GridAzimuth;
  content.MetresPerPixel = this->Scene->GetMetresPerPixel();
  return content;
}

} // namespace skyline
