// SPDX-License-Identifier: BSD-3-Clause
// The viewer itself, in any render window: events go in, pictures come out.
#ifndef skyline_Viewer_h
#define skyline_Viewer_h

#include "Files.h"
#include "Hud.h"
#include "HudLayout.h"
#include "LitTerrain.h"
#include "Options.h"
#include "TerrainScene.h"
#include "ViewerLights.h"
#include "ViewerMouse.h"
#include "ViewerState.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// What `skyline view` was asked for.
struct ViewerOptions
{
  TerrainOptions Terrain;
  HorizonOptions Horizon;
  LightDescription Lights;
  std::string Colors;
  std::optional<double> Exposure; ///< stops; none: automatic
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
  void Open(const TerrainOptions& terrain);
  void AddLampUnderMouse();
  void Changed();
  void Say(const std::string& text);

  bool Compute(LitTerrain& terrain, bool exact);
  void ShowSky(const TerrainLight& light, const LitTerrain& terrain);
  void Paint(bool coarse);
  void Shoot();
  HudContent MakeHud();

  ViewerOptions Options;
  Talk Told;
  vtkSmartPointer<vtkRenderWindow> Window;
  ViewerState State;

  // The terrain and its light.
  ViewerLights Lights;
  std::unique_ptr<TerrainScene> Scene;
  std::unique_ptr<LitTerrain> Full;
  std::unique_ptr<LitTerrain> Small; ///< null: Full is small enough
  std::string Lit;                   ///< ViewerLights::Key of the light shown
  std::string SkyShown;              ///< SkyImageKey
  double LitExaggeration = 1.0;
  bool Exact = false;

  // The window.
  Hud Display;
  HudLayout Layout;
  HudContent Shown;
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

  ViewerMouse Mouse;
  PassTimes LightTimes, Times;
};

} // namespace skyline

#endif
