// SPDX-License-Identifier: BSD-3-Clause
// The viewer itself, in any render window: events go in, pictures come out.
#ifndef skyline_Viewer_h
#define skyline_Viewer_h

#include "../Files.h"
#include "../Lights.h"
#include "../Options.h"
#include "Hud.h"
#include "HudLayout.h"
#include "LitTerrain.h"
#include "TerrainScene.h"
#include "ViewerState.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkGenericRenderWindowInteractor;
class vtkRenderWindow;

namespace skyline
{

/// What `skyline view` was asked for.
struct ViewerOptions
{
  TerrainOptions Terrain;
  HorizonOptions Horizon;
  LightOptions Lights;
  std::string Colors;
  std::string Exposure = "auto"; ///< or stops
  double Exaggeration = 1.0;
  double FromAzimuth = 180.0, FromElevation = 35.0; ///< degrees
  std::string ShotFolder = ".";
};

/// Coordinates of events are pixels of the framebuffer, origin lower left.
class Viewer
{
public:
  /// Reads the terrain and the lights. Throws Failure. The window has its size and a current OpenGL
  /// context as soon as it draws.
  Viewer(vtkRenderWindow* window, const ViewerOptions& options, const Talk& talk);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  ///@{ What happens to the window. Nothing is drawn or computed here, but for files dropped.
  void Resize(int width, int height, double scale);
  void Minimise(bool away);
  void Expose() { this->Stale = true; }
  void MouseMove(double x, double y);
  void MousePress(MouseButton button, bool down, const Modifiers& with);
  void Wheel(double steps);
  void KeyPress(int key, const Modifiers& with);
  void Drop(const std::vector<std::string>& files);
  ///@}

  /// Takes in waiting events, so that long work can be left; may be empty.
  std::function<void()> Poll;

  /// Computes and draws what is due at a moment (seconds of any clock that does not jump). True if
  /// the window has a new picture.
  bool Draw(double now);

  /// Seconds until Draw has something to do without an event; below 0: never.
  double GetPatience(double now) const;

  bool WantsToLeave() const { return this->Leaving; }
  bool IsExact() const { return this->Exact; } ///< the picture is as good as it gets
  const ViewerState& GetState() const { return this->State; }
  ViewerState& GetState() { return this->State; }
  TerrainScene& GetScene() { return *this->Scene; }
  const HudLayout& GetLayout() const { return this->Layout; }
  const HudContent& GetHud() const { return this->Shown; }
  const std::string& GetMessage() const { return this->Message; }
  const PassTimes& GetTimes() const { return this->Times; } ///< of the last picture
  std::string GetTitle() const;                             ///< for the window

private:
  enum class Drag
  {
    None,
    Camera,
    Slider,
    Sun,
    Lamp,
    LampHeight
  };

  void Open(const TerrainOptions& terrain);
  void SetClock();
  void TakeLights();
  vtkSmartPointer<vtkSkylineEnvironmentLight> EnvironmentOf(const std::string& name);
  void ConnectCamera();
  void AddLampUnderMouse();
  void MoveSlider();
  TerrainLight MakeLight() const;
  std::string LightKey() const; ///< all of the light but for the exaggeration
  bool Compute(LitTerrain& terrain, bool exact);
  double Stops() const;
  void Paint(bool coarse);
  void Shoot();
  HudContent MakeHud() const;
  void Say(const std::string& text);

  ViewerOptions Options;
  Talk Told;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkGenericRenderWindowInteractor> Interactor;
  ViewerState State;

  // The terrain and its light.
  Center Middle;
  std::unique_ptr<TerrainScene> Scene;
  std::unique_ptr<LitTerrain> Full;
  std::unique_ptr<LitTerrain> Small; ///< null: Full is small enough
  std::map<std::string, vtkSmartPointer<vtkSkylineEnvironmentLight>> Environments;
  Rgb MeasuredSun{ { 1, 1, 1 } };
  std::string Lit; ///< LightKey of the light shown
  double LitExaggeration = 1.0;
  double AutomaticStops = 0.0;
  bool Exact = false;

  // The window.
  Hud Display;
  HudLayout Layout;
  HudContent Shown;
  int Width = 0, Height = 0;
  double Scale = 1.0;
  bool Away = false;
  bool Leaving = false;
  ViewerWish Shot = ViewerWish::Nothing; ///< due with the next picture
  bool Drawn = false;                    ///< this terrain, once
  bool Stale = true;                     ///< the picture is not that of the state
  bool FirstView = true;
  unsigned long Events = 0; ///< so far
  unsigned long SeenEvents = 0;
  double LastEvent = 0.0, LastDraw = 0.0;
  double FineSeconds = 1.0e9; ///< that the last fine picture took to draw
  std::string Message;

  // The mouse.
  double MouseX = 0.0, MouseY = 0.0;
  Drag Dragging = Drag::None;
  MouseButton DragButton = MouseButton::Left;
  Modifiers DragWith;
  std::size_t DragSlider = 0;
  double DragX = 0.0, DragY = 0.0;
  ViewerState DragStart;

  PassTimes LightTimes, Times;
};

} // namespace skyline

#endif
