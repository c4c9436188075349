// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerMouse.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkInteractorStyleTerrain.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{

/// Distance in pixels, at scale 1, within which a lamp is picked.
constexpr double LampReach = 12.0;

/// Factor by which one step of the wheel brings the camera nearer.
constexpr double WheelFactor = 1.15;

constexpr unsigned long Presses[3] = { vtkCommand::LeftButtonPressEvent,
  vtkCommand::MiddleButtonPressEvent, vtkCommand::RightButtonPressEvent };
constexpr unsigned long Releases[3] = { vtkCommand::LeftButtonReleaseEvent,
  vtkCommand::MiddleButtonReleaseEvent, vtkCommand::RightButtonReleaseEvent };

} // namespace

namespace skyline
{

ViewerMouse::~ViewerMouse()
{
  if (this->Interactor)
  {
    this->Interactor->SetInteractorStyle(nullptr);
    this->Interactor->SetRenderWindow(nullptr);
  }
}

void ViewerMouse::SetScene(TerrainScene* scene, vtkRenderWindow* window)
{
  this->Scene = scene;
  this->Dragging = Drag::None;
  this->Interactor = vtkSmartPointer<vtkGenericRenderWindowInteractor>::New();
  this->Interactor->SetRenderWindow(window);
  this->Interactor->EnableRenderOff();
  vtkNew<vtkInteractorStyleTerrain> style;
  this->Interactor->SetInteractorStyle(style);
  style->SetCurrentRenderer(scene->GetRenderer());
  this->Interactor->Initialize();
}

void ViewerMouse::Resize(int width, int height)
{
  this->Interactor->UpdateSize(width, height);
}

void ViewerMouse::TellCamera(unsigned long event)
{
  this->Interactor->SetEventInformation(
    static_cast<int>(this->X), static_cast<int>(this->Y), 0, this->With.Shift);
  this->Interactor->InvokeEvent(event);
}

// Keeps the camera from looking at the terrain from below: it stops level with its focus.
void ViewerMouse::StayAbove() const
{
  vtkCamera* camera = this->Scene->GetRenderer()->GetActiveCamera();
  const double* eye = camera->GetPosition();
  const double* focus = camera->GetFocalPoint();
  const double east = eye[0] - focus[0];
  const double north = eye[1] - focus[1];
  const double level = std::hypot(east, north);
  if (eye[2] < focus[2] && level > 0.0)
  {
    const double factor = camera->GetDistance() / level;
    camera->SetPosition(focus[0] + factor * east, focus[1] + factor * north, focus[2]);
    camera->SetViewUp(0.0, 0.0, 1.0);
  }
}

void ViewerMouse::MoveSlider(ViewerState& state, const HudLayout& layout) const
{
  const ViewerSlider slider = state.GetSlider(this->Slider);
  const double part = layout.PartAt(this->Slider, this->X);
  state.SetSlider(this->Slider, slider.Low + part * (slider.High - slider.Low));
}

void ViewerMouse::MoveLamp(double rise, ViewerState& state) const
{
  if (!state.HasChosen())
  {
    return;
  }
  ViewerLamp& lamp = state.Lamps[state.Chosen];
  ScenePoint place;
  if (this->Dragging == Drag::LampHeight)
  {
    lamp.Height = std::max(0.0, lamp.Height + rise * this->Scene->GetMetresPerPixel());
  }
  else if (this->Scene->FindPlace(this->X + this->StartX, this->Y + this->StartY, place))
  {
    lamp.X = place[0];
    lamp.Y = place[1];
  }
}

bool ViewerMouse::Move(double x, double y, ViewerState& state, const HudLayout& layout)
{
  const double dx = x - this->X;
  const double dy = y - this->Y;
  this->X = x;
  this->Y = y;
  if (this->Dragging == Drag::None || (dx == 0.0 && dy == 0.0))
  {
    return false;
  }
  switch (this->Dragging)
  {
    case Drag::Camera:
      this->TellCamera(vtkCommand::MouseMoveEvent);
      this->StayAbove();
      break;
    case Drag::Slider:
      this->MoveSlider(state, layout);
      break;
    case Drag::Sun:
      state.Clock = this->Start.Clock;
      state.Azimuth = this->Start.Azimuth;
      state.Elevation = this->Start.Elevation;
      state.DragSun((x - this->StartX) / std::max(layout.Width, 1),
        (y - this->StartY) / std::max(layout.Height, 1));
      break;
    default:
      this->MoveLamp(dy, state);
  }
  return true;
}

void ViewerMouse::Press(
  MouseButton button, const Modifiers& with, ViewerState& state, const HudLayout& layout)
{
  if (this->Dragging != Drag::None)
  {
    return; // only one drag at a time
  }
  this->Button = button;
  this->With = with;
  this->StartX = this->X;
  this->StartY = this->Y;
  for (std::size_t k = 0; k < layout.Sliders.size(); ++k)
  {
    if (button == MouseButton::Left && layout.Sliders[k].Contains(this->X, this->Y))
    {
      this->Dragging = Drag::Slider;
      this->Slider = k;
      this->MoveSlider(state, layout);
      return;
    }
  }
  if (button == MouseButton::Left && with.Control)
  {
    this->Dragging = Drag::Sun;
    this->Start = state;
    return;
  }
  const std::size_t lamp = this->Scene->FindLamp(this->X, this->Y, LampReach * layout.Scale);
  if (button != MouseButton::Middle && lamp < state.Lamps.size())
  {
    state.Chosen = lamp;
    this->Dragging = button == MouseButton::Left ? Drag::Lamp : Drag::LampHeight;
    const ScenePoint foot = this->Scene->GetFoot(state.Lamps[lamp]);
    this->StartX = foot[0] - this->X;
    this->StartY = foot[1] - this->Y;
    return;
  }
  this->Dragging = Drag::Camera;
  this->Scene->FocusOnGround();
  this->TellCamera(Presses[static_cast<std::size_t>(button)]);
}

void ViewerMouse::Release(MouseButton button)
{
  if (this->Dragging == Drag::None || this->Button != button)
  {
    return;
  }
  if (this->Dragging == Drag::Camera)
  {
    this->TellCamera(Releases[static_cast<std::size_t>(button)]);
  }
  this->Dragging = Drag::None;
}

void ViewerMouse::Wheel(double steps)
{
  vtkCamera* camera = this->Scene->GetRenderer()->GetActiveCamera();
  camera->Dolly(std::pow(WheelFactor, std::clamp(steps, -10.0, 10.0)));
}

} // namespace skyline
