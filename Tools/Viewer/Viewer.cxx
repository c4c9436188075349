// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer.h"

#include "../Failure.h"
#include "ColorMaps.h"
#include "IoFailure.h"
#include "Screenshot.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkImageData.h"
#include "vtkInteractorStyleTerrain.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineLampLight.h"
#include "vtkSkylineSunLight.h"
#include "vtkSoftShadowShader.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <sstream>

namespace
{

/// Seconds without an event after which the light is made exact.
constexpr double RestSeconds = 0.2;

/// A fine picture that takes longer to draw is replaced by a coarse one while something moves.
constexpr double FluidSeconds = 0.04;

/// The longest step of the animation: a slow machine shows fewer pictures, not wilder ones.
constexpr double LongestStep = 0.25;

/// Terrain with more posts is lit at every n-th while something moves.
constexpr double QuickPosts = 40000.0;

/// A lamp that the mouse places: its radius in widths of the terrain, its height over the ground in
/// radii, its radiance where the exposure is 0 stops, and its colour, a warm one.
constexpr double LampRadius = 1.0 / 250.0;
constexpr double LampHeight = 3.0;
constexpr double LampRadiance = 60.0;
constexpr std::array<double, 3> LampColor{ { 1.0, 0.72, 0.42 } };

/// Pixels at scale 1 within which a lamp is taken.
constexpr double LampReach = 12.0;

/// A turn of the wheel brings the camera nearer by this factor.
constexpr double WheelFactor = 1.15;

/// Where the calendar starts if nobody says: longest day, in the afternoon.
constexpr int JuneSolstice = 172;
constexpr int DecemberSolstice = 355;
constexpr double Afternoon = 16.0 * 60.0;

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

int ThisYear()
{
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  return parts.tm_year + 1900;
}

std::string Lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool IsLightMap(const std::string& file)
{
  const std::string extension = Lower(std::filesystem::path(file).extension().string());
  return extension == ".hdr" || extension == ".exr";
}

std::string NameOf(const std::string& file)
{
  return std::filesystem::path(file).filename().string();
}

template <typename... Numbers>
std::string Format(const char* format, Numbers... numbers)
{
  char text[160];
  std::snprintf(text, sizeof(text), format, numbers...);
  return text;
}

// Every n-th post, so that few enough remain.
vtkSmartPointer<vtkImageData> ThinOut(vtkImageData* image)
{
  const int step = static_cast<int>(
    std::ceil(std::sqrt(static_cast<double>(image->GetNumberOfPoints()) / QuickPosts)));
  const int* size = image->GetDimensions();
  const int columns = (size[0] - 1) / step + 1;
  const int rows = (size[1] - 1) / step + 1;
  auto thin = vtkSmartPointer<vtkImageData>::New();
  thin->SetDimensions(columns, rows, 1);
  thin->SetOrigin(image->GetOrigin());
  thin->SetSpacing(step * image->GetSpacing()[0], step * image->GetSpacing()[1], 1.0);
  vtkDataArray* from = image->GetPointData()->GetArray("Elevation");
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Elevation");
  heights->SetNumberOfTuples(static_cast<vtkIdType>(columns) * rows);
  vtkIdType post = 0;
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column, ++post)
    {
      const vtkIdType source = static_cast<vtkIdType>(row) * step * size[0] + column * step;
      heights->SetValue(post, static_cast<float>(from->GetComponent(source, 0)));
    }
  }
  thin->GetPointData()->SetScalars(heights);
  return thin;
}

} // namespace

namespace skyline
{

Viewer::Viewer(vtkRenderWindow* window, const ViewerOptions& options, const Talk& talk)
  : Options(options)
  , Told(talk)
  , Window(window)
{
  this->State.Exaggeration = options.Exaggeration;
  this->State.ColorCount = ColorMaps().size();
  for (std::size_t k = 0; k < ColorMaps().size(); ++k)
  {
    this->State.Colors = ColorMaps()[k].Name == options.Colors ? k : this->State.Colors;
  }
  this->Window->SetNumberOfLayers(2);
  this->Window->AddRenderer(this->Display.GetRenderer());
  this->Open(options.Terrain);
  this->TakeLights();
}

Viewer::~Viewer()
{
  if (this->Interactor)
  {
    this->Interactor->SetInteractorStyle(nullptr);
    this->Interactor->SetRenderWindow(nullptr);
  }
  this->Window->RemoveRenderer(this->Display.GetRenderer());
  this->Window->RemoveRenderer(this->Scene->GetRenderer());
}

void Viewer::Open(const TerrainOptions& terrain)
{
  const auto image = ReadTerrain(terrain, this->Told);
  auto scene = std::make_unique<TerrainScene>(image); // throws where there is nothing to see
  const Center middle = CenterOf(image);
  // From here on nothing fails.
  if (this->Scene)
  {
    this->Window->RemoveRenderer(this->Scene->GetRenderer());
    this->State.Lamps.clear();
  }
  this->Scene = std::move(scene);
  this->Middle = middle;
  this->Options.Terrain = terrain;
  this->Window->AddRenderer(this->Scene->GetRenderer());
  this->Full = std::make_unique<LitTerrain>(image, this->Options.Horizon);
  this->Full->Stop = [this]
  {
    if (this->Poll)
    {
      this->Poll();
    }
    // A picture that is kept is worth the wait.
    return this->Shot == ViewerWish::Nothing && this->Events != this->SeenEvents;
  };
  this->Small.reset();
  if (static_cast<double>(image->GetNumberOfPoints()) > QuickPosts)
  {
    this->Small = std::make_unique<LitTerrain>(ThinOut(image), this->Options.Horizon);
  }
  this->Lit.clear();
  this->LitExaggeration = this->State.Exaggeration;
  this->Scene->SetExaggeration(this->State.Exaggeration);
  this->Exact = false;
  this->FirstView = true;
  this->FineSeconds = 1.0e9;
  this->Drawn = false;
  this->SetClock();
  this->ConnectCamera();
}

void Viewer::SetClock()
{
  const SunOptions& asked = this->Options.Lights.Sun;
  const Georeference& place = this->Middle.Place;
  const bool earth = place.OnBody() && place.Earth;
  const int zone = NauticalZone(this->Middle.Longitude);
  ViewerState& state = this->State;
  if (state.ByTime && earth)
  {
    const SunClock& old = state.Clock;
    state.Clock = SunClock(old.GetYear(), old.GetDayOfYear(), old.GetMinutes(), zone);
  }
  else if (earth && asked.Direction.empty())
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

void Viewer::TakeLights()
{
  const LightOptions& asked = this->Options.Lights;
  ViewerState& state = this->State;
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
  vtkImageData* terrain = this->Scene->GetHeights();

  // The sun beside a light map, as --sun-irradiance and perez: have it.
  LightOptions beside = asked;
  beside.Lamps.clear();
  beside.Sun = SunOptions();
  beside.Sun.Direction = "180,45";
  const bool perez = asked.Environment.rfind("perez:", 0) == 0;
  beside.Environment = perez ? asked.Environment : "uniform";
  for (const auto& light : MakeLights(beside, terrain, this->Told))
  {
    if (auto* disc = vtkSkylineSunLight::SafeDownCast(light))
    {
      const double* e = disc->GetIrradiance();
      this->MeasuredSun = { { static_cast<float>(e[0]), static_cast<float>(e[1]),
        static_cast<float>(e[2]) } };
    }
  }
  if (!asked.Environment.empty())
  {
    this->EnvironmentOf(asked.Environment);
    state.TakeSky(asked.Environment);
    state.Sun = KindOfSky(asked.Environment) != SkyKind::Measured || perez ||
      !asked.Sun.Time.empty() || !asked.Sun.Direction.empty();
  }

  LightOptions lamps;
  lamps.Lamps = asked.Lamps;
  for (const auto& light : MakeLights(lamps, terrain, this->Told))
  {
    if (auto* ball = vtkSkylineLampLight::SafeDownCast(light))
    {
      const double* at = ball->GetPosition();
      const double* l = ball->GetRadiance();
      const double ground = GroundOrZero(terrain, state.Exaggeration, at[0], at[1]);
      state.AddLamp({ at[0], at[1], at[2] - ground, ball->GetRadius(), { { l[0], l[1], l[2] } } });
    }
  }
}

vtkSmartPointer<vtkSkylineEnvironmentLight> Viewer::EnvironmentOf(const std::string& name)
{
  const SkyKind kind = KindOfSky(name);
  if (kind != SkyKind::Formula && kind != SkyKind::Measured)
  {
    return nullptr;
  }
  auto& known = this->Environments[name];
  if (!known)
  {
    LightOptions options;
    options.Environment = name;
    known = vtkSkylineEnvironmentLight::SafeDownCast(
      MakeLights(options, this->Scene->GetHeights(), this->Told).front());
  }
  return known;
}

void Viewer::ConnectCamera()
{
  this->Interactor = vtkSmartPointer<vtkGenericRenderWindowInteractor>::New();
  this->Interactor->SetRenderWindow(this->Window);
  this->Interactor->EnableRenderOff();
  vtkNew<vtkInteractorStyleTerrain> style;
  this->Interactor->SetInteractorStyle(style);
  style->SetCurrentRenderer(this->Scene->GetRenderer());
  this->Interactor->Initialize();
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

void Viewer::Resize(int width, int height, double scale)
{
  this->Width = width;
  this->Height = height;
  this->Scale = scale;
  ++this->Events;
  if (width > 0 && height > 0)
  {
    this->Layout = HudLayout(width, height, scale);
    this->Interactor->UpdateSize(width, height);
    this->Window->SetSize(width, height);
    this->Stale = true;
  }
}

void Viewer::Minimise(bool away)
{
  this->Away = away;
  this->Stale = true;
}

void Viewer::MouseMove(double x, double y)
{
  const double dx = x - this->MouseX;
  const double dy = y - this->MouseY;
  this->MouseX = x;
  this->MouseY = y;
  if (this->Dragging == Drag::None || (dx == 0.0 && dy == 0.0))
  {
    return;
  }
  ++this->Events;
  this->Stale = true;
  switch (this->Dragging)
  {
    case Drag::Camera:
      this->Interactor->SetEventInformation(
        static_cast<int>(x), static_cast<int>(y), this->DragWith.Control, this->DragWith.Shift);
      this->Interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
      break;
    case Drag::Slider:
      this->MoveSlider();
      break;
    case Drag::Sun:
    {
      this->State.Clock = this->DragStart.Clock;
      this->State.Azimuth = this->DragStart.Azimuth;
      this->State.Elevation = this->DragStart.Elevation;
      this->State.DragSun((x - this->DragX) / this->Width, (y - this->DragY) / this->Height);
      break;
    }
    case Drag::Lamp:
    {
      ScenePoint place;
      if (this->State.HasChosen() &&
        this->Scene->FindPlace(x + this->DragX, y + this->DragY, place))
      {
        this->State.Lamps[this->State.Chosen].X = place[0];
        this->State.Lamps[this->State.Chosen].Y = place[1];
      }
      break;
    }
    default:
      if (this->State.HasChosen())
      {
        ViewerLamp& lamp = this->State.Lamps[this->State.Chosen];
        lamp.Height = std::max(0.0, lamp.Height + dy * this->Scene->GetMetresAPixel());
      }
  }
}

void Viewer::MoveSlider()
{
  const ViewerSlider slider = this->State.GetSlider(this->DragSlider);
  const double part = this->Layout.PartAt(this->DragSlider, this->MouseX);
  this->State.SetSlider(this->DragSlider, slider.Low + part * (slider.High - slider.Low));
}

void Viewer::MousePress(MouseButton button, bool down, const Modifiers& with)
{
  static constexpr unsigned long presses[3] = { vtkCommand::LeftButtonPressEvent,
    vtkCommand::MiddleButtonPressEvent, vtkCommand::RightButtonPressEvent };
  static constexpr unsigned long releases[3] = { vtkCommand::LeftButtonReleaseEvent,
    vtkCommand::MiddleButtonReleaseEvent, vtkCommand::RightButtonReleaseEvent };
  const auto which = static_cast<std::size_t>(button);
  const auto tellCamera = [&](unsigned long event)
  {
    this->Interactor->SetEventInformation(static_cast<int>(this->MouseX),
      static_cast<int>(this->MouseY), this->DragWith.Control, this->DragWith.Shift);
    this->Interactor->InvokeEvent(event);
  };
  ++this->Events;
  this->Stale = true;
  if (!down)
  {
    if (this->Dragging == Drag::Camera && this->DragButton == button)
    {
      tellCamera(releases[which]);
    }
    this->Dragging = this->DragButton == button ? Drag::None : this->Dragging;
    return;
  }
  if (this->Dragging != Drag::None)
  {
    return; // one thing at a time
  }
  this->DragButton = button;
  this->DragWith = with;
  this->DragX = this->MouseX;
  this->DragY = this->MouseY;
  for (std::size_t k = 0; k < this->Layout.Sliders.size(); ++k)
  {
    if (button == MouseButton::Left && this->Layout.Sliders[k].Contains(this->MouseX, this->MouseY))
    {
      this->Dragging = Drag::Slider;
      this->DragSlider = k;
      this->MoveSlider();
      return;
    }
  }
  if (button == MouseButton::Left && with.Control)
  {
    this->Dragging = Drag::Sun;
    this->DragStart = this->State;
    return;
  }
  const std::size_t lamp =
    this->Scene->FindLamp(this->MouseX, this->MouseY, LampReach * this->Scale);
  if (button != MouseButton::Middle && lamp < this->State.Lamps.size())
  {
    this->State.Chosen = lamp;
    this->Dragging = button == MouseButton::Left ? Drag::Lamp : Drag::LampHeight;
    const ScenePoint foot = this->Scene->GetFoot(this->State.Lamps[lamp]);
    this->DragX = foot[0] - this->MouseX;
    this->DragY = foot[1] - this->MouseY;
    return;
  }
  this->Dragging = Drag::Camera;
  this->DragWith.Control = false;
  tellCamera(presses[which]);
}

void Viewer::Wheel(double steps)
{
  ++this->Events;
  this->Stale = true;
  vtkCamera* camera = this->Scene->GetRenderer()->GetActiveCamera();
  camera->Dolly(std::pow(WheelFactor, std::clamp(steps, -10.0, 10.0)));
}

void Viewer::KeyPress(int key, const Modifiers& with)
{
  const ViewerWish wish = this->State.Press(key, with);
  if (wish == ViewerWish::Nothing)
  {
    return;
  }
  ++this->Events;
  this->Say("");
  if (key == 'K')
  {
    const SkyKind kind = KindOfSky(this->State.Skies[this->State.Sky]);
    this->State.Sun = kind != SkyKind::Measured;
  }
  switch (wish)
  {
    case ViewerWish::Leave:
      this->Leaving = true;
      break;
    case ViewerWish::Camera:
      this->FirstView = true;
      break;
    case ViewerWish::Lamp:
      this->AddLampUnderMouse();
      break;
    case ViewerWish::Png:
    case ViewerWish::Exr:
      this->Shot = wish;
      break;
    default:
      break;
  }
}

void Viewer::AddLampUnderMouse()
{
  ScenePoint place;
  if (!this->Scene->FindPlace(this->MouseX, this->MouseY, place))
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
    lamp.Radiance[c] = LampColor[c] * LampRadiance * std::exp2(-this->Stops());
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
        this->EnvironmentOf(file);
        this->State.TakeSky(file);
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
      this->Environments.erase(file);
      this->Say(FirstLine(reason.what()));
    }
  }
}

TerrainLight Viewer::MakeLight() const
{
  const ViewerState& state = this->State;
  TerrainLight light;
  light.SunOn = state.Sun;
  light.SunAsked = this->Options.Lights.Sun;
  light.SunAsked.Time = state.ByTime ? state.Clock.ToTime() : "";
  light.SunAsked.Direction =
    state.ByTime ? std::string() : Format("%.9g,%.9g", state.Azimuth, state.Elevation);
  light.Sun = FindSun(light.SunAsked, this->Middle.Place, this->Middle.Height);
  light.Sky = state.Skies[state.Sky];
  const auto environment = this->Environments.find(light.Sky);
  light.Environment = environment != this->Environments.end() ? environment->second : nullptr;
  light.MeasuredSun = this->MeasuredSun;
  light.Air = !this->Middle.Place.OnBody() || this->Middle.Place.Earth;
  light.Rotation = state.Rotation;
  light.Lamps = state.Lamps;
  light.Exaggeration = state.Exaggeration;
  light.Colors = ColorMaps()[state.Colors].Name;
  return light;
}

std::string Viewer::LightKey() const
{
  const ViewerState& state = this->State;
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

double Viewer::Stops() const
{
  double fixed = 0.0;
  const bool automatic = !CLI::detail::lexical_cast(this->Options.Exposure, fixed);
  return (automatic ? this->AutomaticStops : fixed) + this->State.Exposure;
}

bool Viewer::Compute(LitTerrain& terrain, bool exact)
{
  try
  {
    this->EnvironmentOf(this->State.Skies[this->State.Sky]);
    TerrainLight light = this->MakeLight();
    if (!exact)
    {
      light.Exaggeration = this->LitExaggeration; // new shadows take too long while it changes
    }
    if (!terrain.Light(light, exact))
    {
      return false;
    }
    this->LitExaggeration = light.Exaggeration;
  }
  catch (const std::exception& reason)
  {
    this->Say(FirstLine(reason.what()));
  }
  if (terrain.GetOutput())
  {
    this->AutomaticStops = terrain.GetExposure();
    this->Scene->SetLight(terrain.GetOutput(), terrain.GetSkyRadiance());
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
  if (this->Away || this->Width < 1 || this->Height < 1)
  {
    return false;
  }
  if (this->State.Animated)
  {
    this->State.Advance(step);
    this->Stale = true;
  }
  this->LightTimes.clear();
  const std::string key = this->LightKey();
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
      return false; // stopped by an event, which goes first
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
  if (this->Away || this->Width < 1 || this->Height < 1)
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
      static_cast<double>(this->Width) / this->Height);
    this->FirstView = false;
  }
  const bool shot = this->Shot != ViewerWish::Nothing;
  const bool fine = !coarse || shot;
  const auto start = Clock::now();
  this->Scene->SetCoarse(!fine);
  this->Scene->GetRenderer()->SetUseFXAA(fine); // smooth rims, where there is time for them
  this->Scene->SetLamps(this->State.Lamps);
  this->Scene->SetExposure(this->Stops());
  this->Scene->Prepare();
  if (shot)
  {
    this->Shoot();
  }
  this->Shown = this->MakeHud();
  this->Display.Show(this->Shown, this->Layout, this->Width, this->Height);
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
    this->FineSeconds = terrain; // the first picture builds buffers and shaders
  }
  this->Drawn = true;
  this->Times = this->LightTimes;
  this->Times.emplace_back(fine ? "terrain" : "coarse terrain", terrain);
  this->Times.emplace_back("display", labels + all - terrain);
  this->Stale = false;
}

void Viewer::Shoot()
{
  const bool linear = this->Shot == ViewerWish::Exr;
  vtkRenderer* display = this->Display.GetRenderer();
  display->DrawOff();
  try
  {
    if (!this->Exact)
    {
      this->Exact = this->Compute(*this->Full, true);
      this->Scene->SetExposure(this->Stops());
    }
    const std::string file = FreeName(this->Options.ShotFolder, linear ? ".exr" : ".png");
    if (linear)
    {
      this->Scene->SetLamps({}); // light on the ground, not the balls' screen colours
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
  this->Shot = ViewerWish::Nothing;
}

HudContent Viewer::MakeHud() const
{
  const ViewerState& state = this->State;
  HudContent content;
  const SunLight sun = this->MakeLight().Sun;
  std::ostringstream text;
  text << NameOf(this->Options.Terrain.File) << (this->Exact ? "" : "  (preview)") << "\n";
  text << Format("sun    %s%05.1f\xc2\xb0  elevation %.1f\xc2\xb0", sun.TrueNorth ? "" : "grid ",
            sun.TrueNorth ? sun.TrueAzimuth : sun.GridAzimuth, sun.ApparentElevation)
       << (state.Sun ? "" : "  off") << "\n";
  if (state.ByTime)
  {
    text << "local  " << state.Clock.LocalDate() << " " << state.Clock.LocalClock() << " "
         << state.Clock.ZoneName() << "\n"
         << "UTC    " << state.Clock.UtcText() << "\n";
  }
  text << "sky    " << NameOf(state.Skies[state.Sky]);
  if (state.Rotation != 0.0)
  {
    text << Format("  turned %.0f\xc2\xb0", state.Rotation);
  }
  if (!state.Lamps.empty())
  {
    text << "\nlamps  " << state.Lamps.size();
    if (state.HasChosen())
    {
      const ViewerLamp& lamp = state.Lamps[state.Chosen];
      text << Format("; chosen: radius %.3g m, %.3g m up", lamp.Radius, lamp.Height);
    }
  }
  if (state.Exaggeration != 1.0)
  {
    text << Format("\nheights x %.3g", state.Exaggeration);
  }
  if (state.Exposure != 0.0)
  {
    text << Format("\nexposure %+.1f stops", state.Exposure);
  }
  content.Status = text.str();

  if (state.Times && !this->Times.empty())
  {
    std::ostringstream times;
    double sum = 0.0;
    for (const auto& [name, seconds] : this->Times)
    {
      times << Format("%s %6.1f ms\n", name.c_str(), 1000.0 * seconds);
      sum += seconds;
    }
    times << Format("frame %6.1f ms", 1000.0 * sum);
    content.Times = times.str();
  }
  content.Message = this->Message.empty() && !state.Help ? "H: help" : this->Message;
  content.Help = state.Help ? ViewerHelp() : "";
  for (std::size_t k = 0; k < content.Sliders.size(); ++k)
  {
    content.Sliders[k] = state.GetSlider(k);
  }
  content.Heading = this->Scene->GetHeading() + sun.TrueAzimuth - sun.GridAzimuth;
  content.MetresAPixel = this->Scene->GetMetresAPixel();
  return content;
}

} // namespace skyline
