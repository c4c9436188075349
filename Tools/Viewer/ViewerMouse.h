// SPDX-License-Identifier: BSD-3-Clause
// Dragging with the mouse: camera, sliders, sun and lamps.
#ifndef skyline_ViewerMouse_h
#define skyline_ViewerMouse_h

#include "HudLayout.h"
#include "TerrainScene.h"
#include "ViewerState.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkGenericRenderWindowInteractor;
class vtkRenderWindow;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Coordinates are pixels of the framebuffer, with the origin at the lower left. Only one object is
/// dragged at a time, with the button that started the drag.
class ViewerMouse
{
public:
  ~ViewerMouse();

  /// Sets the scene to work on, which must live until the next one is set.
  void SetScene(TerrainScene* scene, vtkRenderWindow* window);

  void Resize(int width, int height);

  /// The mouse has moved. Returns true if that changed the state or the camera.
  bool Move(double x, double y, ViewerState& state, const HudLayout& layout);

  void Press(
    MouseButton button, const Modifiers& with, ViewerState& state, const HudLayout& layout);
  void Release(MouseButton button);

  /// Moves the camera nearer or further away.
  void Wheel(double steps);

  double GetX() const { return this->X; }
  double GetY() const { return this->Y; }

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

  void TellCamera(unsigned long event);
  void StayAbove() const;
  void MoveSlider(ViewerState& state, const HudLayout& layout) const;
  void MoveLamp(double rise, ViewerState& state) const;

  TerrainScene* Scene = nullptr;
  vtkSmartPointer<vtkGenericRenderWindowInteractor> Interactor;
  double X = 0.0, Y = 0.0;
  Drag Dragging = Drag::None;
  MouseButton Button = MouseButton::Left;
  Modifiers With;
  std::size_t Slider = 0;
  double StartX = 0.0, StartY = 0.0; ///< drag start; of a lamp: its foot relative to the mouse
  ViewerState Start;
};

} // namespace skyline

#endif
