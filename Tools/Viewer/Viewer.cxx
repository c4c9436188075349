// SPDX-License-Identifier: BSD-3-Clause
// The terrain of the viewer, and what events do. ViewerFrame.cxx draws.
#include "Viewer.h"

#include "Color/ColorMaps.h"
#include "Failure.h"
#include "IoFailure.h"
#include "ThinTerrain.h"
#include "ViewerStatus.h"

#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace
{

/// Terrain with more posts is lit only at every n-th post while something moves.
constexpr double QuickPosts = 40000.0;

/// A lamp that the user adds with the mouse: its radius in widths of the terrain, its height above
/// the ground in radii, its radiance at an exposure of 0 stops, and its (warm) colour.
constexpr double LampRadius = 1.0 / 250.0;
constexpr double LampHeight = 3.0;
constexpr double LampRadiance = 60.0;
constexpr std::array<double, 3> LampColor{ { 1.0, 0.72, 0.42 } };

bool IsLightMap(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".hdr" || extension == ".exr";
}

} // namespace

namespace skyline
{

Viewer::Viewer(vtkRenderWindow* window, const ViewerOptions& options, const CommonOptions& common)
  : Options(options)
  , Common(common)
  , Window(window)
  , Lights(options.Lights, common)
{
  if (options.Exposure)
  {
    this->State.AutoExposure = false;
    this->State.FixedStops = *options.Exposure;
  }
  this->State.Exaggeration = options.Exaggeration;
  this->State.ColorCount = ColorMaps().size();
  for (std::size_t k = 0; k < ColorMaps().size(); ++k)
  {
    this->State.Colors = ColorMaps()[k].Name == options.Colors ? k : this->State.Colors;
  }
  this->Window->SetNumberOfLayers(2);
  this->Window->AddRenderer(this->Display.GetRenderer());
  this->Open(options.Terrain);
  this->Lights.Take(this->State);
}

Viewer::~Viewer()
{
  this->Window->RemoveRenderer(this->Display.GetRenderer());
  this->Window->RemoveRenderer(this->Scene->GetRenderer());
}

void Viewer::Open(const TerrainOptions& terrain)
{
  const auto image = ReadTerrain(terrain, this->Common);
  auto scene = std::make_unique<TerrainScene>(image); // throws if there is nothing to see
  this->Lights.SetTerrain(image);
  // Nothing can fail from here on.
  if (this->Scene)
  {
    this->Window->RemoveRenderer(this->Scene->GetRenderer());
    this->State.Lamps.clear();
  }
  this->Scene = std::move(scene);
  this->Options.Terrain = terrain;
  this->Window->AddRenderer(this->Scene->GetRenderer());
  this->Full = std::make_unique<LitTerrain>(image, this->Options.Horizon);
  this->Full->Stop = [this]
  {
    if (this->Poll)
    {
      this->Poll();
    }
    // For a picture that is written to a file, the user waits.
    return this->Shot == ViewerRequest::Nothing && this->Events != this->SeenEvents;
  };
  this->Small.reset();
  if (static_cast<double>(image->GetNumberOfPoints()) > QuickPosts)
  {
    this->Small =
      std::make_unique<LitTerrain>(ThinTerrain(image, QuickPosts), this->Options.Horizon);
  }
  this->Lit.clear();
  this->SkyShown.clear();
  this->LitExaggeration = this->State.Exaggeration;
  this->Scene->SetExaggeration(this->State.Exaggeration);
  this->Exact = false;
  this->FirstView = true;
  this->FineSeconds = 1.0e9;
  this->Drawn = false;
  this->Lights.SetClock(this->State);
  this->Mouse.SetScene(this->Scene.get(), this->Window);
}

void Viewer::Say(const std::string& text)
{
  this->Message = text;
  this->Stale = true;
}

std::string Viewer::GetTitle() const
{
  return NameOf(this->Options.Terrain.File) + " - skyline";
}

void Viewer::Changed()
{
  ++this->Events;
  this->Stale = true;
}

void Viewer::Resize(int width, int height, double scale)
{
  this->Changed();
  this->Layout = HudLayout(width, height, scale);
  if (width > 0 && height > 0)
  {
    this->Mouse.Resize(width, height);
    this->Window->SetSize(width, height);
  }
}

void Viewer::Minimise(bool away)
{
  this->Away = away;
  this->Stale = true;
}

void Viewer::MouseMove(double x, double y)
{
  if (this->Mouse.Move(x, y, this->State, this->Layout))
  {
    this->Changed();
  }
}

void Viewer::MousePress(MouseButton button, bool down, const Modifiers& with)
{
  this->Changed();
  if (down)
  {
    this->Mouse.Press(button, with, this->State, this->Layout);
  }
  else
  {
    this->Mouse.Release(button);
  }
}

void Viewer::Wheel(double steps)
{
  this->Changed();
  this->Mouse.Wheel(steps);
}

void Viewer::KeyPress(int key, const Modifiers& with)
{
  const ViewerRequest request = this->State.Press(key, with);
  if (request == ViewerRequest::Nothing)
  {
    return;
  }
  ++this->Events;
  this->Say("");
  if (key == 'K')
  {
    this->State.Sun = !this->State.GetSky().Measured();
  }
  switch (request)
  {
    case ViewerRequest::Leave:
      this->Leaving = true;
      break;
    case ViewerRequest::Camera:
      this->FirstView = true;
      break;
    case ViewerRequest::Lamp:
      this->AddLampUnderMouse();
      break;
    case ViewerRequest::Png:
    case ViewerRequest::Exr:
      this->Shot = request;
      break;
    default:
      break;
  }
}

void Viewer::AddLampUnderMouse()
{
  ScenePoint place;
  if (!this->Scene->FindPlace(this->Mouse.GetX(), this->Mouse.GetY(), place))
  {
    this->Say("no ground under the mouse for a lamp");
    return;
  }
  const double* bounds = this->Scene->GetHeights()->GetBounds();
  ViewerLamp lamp;
  lamp.X = place[0];
  lamp.Y = place[1];
  lamp.Radius = LampRadius * std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  lamp.Height = LampHeight * lamp.Radius;
  for (std::size_t c = 0; c < 3; ++c)
  {
    lamp.Radiance[c] = LampColor[c] * LampRadiance * std::exp2(-this->State.Stops());
  }
  this->State.AddLamp(lamp);
}

void Viewer::Drop(const std::vector<std::string>& files)
{
  for (const std::string& file : files)
  {
    ++this->Events;
    try
    {
      if (IsLightMap(file))
      {
        const SkyDescription sky = SkyOfFile(file);
        this->Lights.Find(sky);
        this->State.TakeSky(sky);
        this->State.Sun = false;
        this->Say("sky: " + NameOf(file) + "; S adds the sun");
      }
      else
      {
        TerrainOptions terrain;
        terrain.File = file;
        this->Open(terrain);
        this->Say("");
      }
    }
    catch (const std::exception& reason)
    {
      this->Lights.Forget(file);
      this->Say(FirstLine(reason.what()));
    }
  }
}

} // namespace skyline
