// SPDX-License-Identifier: BSD-3-Clause
// The viewer, in any render window: it receives events and draws pictures.
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

/// The options of `skyline view`.
struct ViewerOptions
{
  TerrainOptions Terrain;
  HorizonOptions Horizon;
  LightDescription Lights;
  std::string Colors;
  std::optional<double> Exposure; ///< stops; empty: automatic
  double Exaggeration = 1.0;
  double FromAzimuth = 180.0, FromElevation = 35.0; ///< degrees
  std::string ShotFolder = ".";
};

/// The viewer. Coordinates of events are pixels of the framebuffer, with the origin at the lower
/// left.
class Viewer
{
public:
  /// Reads the terrain and the lights. Throws Failure. The window must have its size and a current
  /// OpenGL context when the viewer draws.
  Viewer(vtkRenderWindow* window, const ViewerOptions& options, const CommonOptions& common);
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

  /// Processes waiting events, so that long work can be stopped; may be empty.
  std::function<void()> Poll;

  /// Computes and draws what is due at the time `now` (seconds of any monotonic clock). Returns
  /// true if the window has a new picture.
  bool Draw(double now);

  /// Seconds until Draw has work without a further event; negative: never.
  double GetPatience(double now) const;

  bool WantsToLeave() const { return this->Leaving; }
  bool IsExact() const { return this->Exact; } ///< the picture will not become better
  const ViewerState& GetState() const { return this->State; }
  ViewerState& GetState() { return this->State; }
  TerrainScene& GetScene() { return *this->Scene; }
  const HudLayout& GetLayout() const { return this->Layout; }
  const HudContent& GetHud() const { return this->Shown; }
  const std::string& GetMessage() const { return this->Message; }
  const PassTimes& GetTimes() const { return this->Times; } ///< of the last picture
  std::string GetTitle() const;                             ///< of the window

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
  CommonOptions Common;
  vtkSmartPointer<vtkRenderWindow> Window;
  ViewerState State;

  // The terrain and its light.
  ViewerLights Lights;
  std::unique_ptr<TerrainScene> Scene;
  std::unique_ptr<LitTerrain> Full;
  std::unique_ptr<LitTerrain> Small; ///< null: Full is small enough
  std::string Lit;                   ///< ViewerLights::Key of the light that is shown
  std::string SkyShown;              ///< SkyImageKey
  double LitExaggeration = 1.0;
  bool Exact = false;

  // The window.
  Hud Display;
  HudLayout Layout;
  HudContent Shown;
  bool Away = false;
  bool Leaving = false;
  ViewerRequest Shot = ViewerRequest::Nothing; ///< to be written with the next picture
  bool Drawn = false;                          ///< this terrain was drawn once
  bool Stale = true;                           ///< the picture does not show the present state
  bool FirstView = true;
  unsigned long Events = 0; ///< number of events so far
  unsigned long SeenEvents = 0;
  double LastEvent = 0.0, LastDraw = 0.0;
  double FineSeconds = 1.0e9; ///< drawing time of the last fine picture
  std::string Message;

  ViewerMouse Mouse;
  PassTimes LightTimes, Times;
};

} // namespace skyline

#endif
