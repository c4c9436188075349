// SPDX-License-Identifier: BSD-3-Clause
// The heads-up display: texts, sliders, north arrow and scale bar over the picture.
#ifndef skyline_Hud_h
#define skyline_Hud_h

#include "HudLayout.h"
#include "ViewerState.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor2D;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// What the display shows.
struct HudContent
{
  std::string Status;
  std::string Times;
  std::string Message;
  std::string Help; ///< in the middle of the window; empty: none
  std::array<ViewerSlider, ViewerState::Sliders> Sliders;
  double Heading = 0.0;        ///< direction of view, degrees clockwise from north
  double MetresPerPixel = 0.0; ///< 0: no scale bar
};

/// Draws the display in a renderer of its own, for a layer above the picture.
class Hud
{
public:
  Hud();

  vtkRenderer* GetRenderer() const;

  void Show(const HudContent& content, const HudLayout& layout);

private:
  vtkSmartPointer<vtkTextActor> MakeText(int align, int valign, bool fixed);
  void Write(vtkTextActor* actor, const std::string& text, double x, double y, int size);

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkPolyData> Shapes;
  vtkSmartPointer<vtkTextActor> Status, Times, Message, Help, Bar, North;
  std::array<vtkSmartPointer<vtkTextActor>, ViewerState::Sliders> Labels;
};

} // namespace skyline

#endif
