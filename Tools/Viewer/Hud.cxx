// SPDX-License-Identifier: BSD-3-Clause
#include "Hud.h"

#include "Shared/Constants.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cmath>
#include <initializer_list>

namespace
{

using Color = std::array<unsigned char, 4>;
using Corner = std::array<double, 2>;

constexpr Color Dark{ { 20, 24, 30, 190 } };
constexpr Color Light{ { 240, 240, 235, 255 } };
constexpr Color Warm{ { 255, 190, 70, 255 } };
constexpr double KnobRadius = 8.0; // pixels, for a font size of 14
constexpr int KnobCorners = 20;
constexpr double PanelOpacity = 0.65;

// Convex polygons, each with one colour.
class Canvas
{
public:
  explicit Canvas(vtkPolyData* target)
    : Target(target)
  {
    this->Colors->SetName("Colors");
    this->Colors->SetNumberOfComponents(4);
  }

  void Polygon(const std::vector<Corner>& corners, const Color& color)
  {
    this->Cells->InsertNextCell(static_cast<int>(corners.size()));
    for (const Corner& corner : corners)
    {
      this->Cells->InsertCellPoint(this->Points->InsertNextPoint(corner[0], corner[1], 0.0));
    }
    this->Colors->InsertNextTypedTuple(color.data());
  }

  void Box(const skyline::HudBox& box, const Color& color)
  {
    this->Polygon(
      { { { box.X, box.Y } }, { { box.X + box.Width, box.Y } },
        { { box.X + box.Width, box.Y + box.Height } }, { { box.X, box.Y + box.Height } } },
      color);
  }

  void Disc(double x, double y, double radius, const Color& color)
  {
    std::vector<Corner> corners;
    for (int k = 0; k < KnobCorners; ++k)
    {
      const double angle = 2.0 * skyline::Pi * k / KnobCorners;
      corners.push_back({ { x + radius * std::cos(angle), y + radius * std::sin(angle) } });
    }
    this->Polygon(corners, color);
  }

  void Finish()
  {
    this->Target->Initialize();
    this->Target->SetPoints(this->Points);
    this->Target->SetPolys(this->Cells);
    this->Target->GetCellData()->SetScalars(this->Colors);
  }

private:
  vtkPolyData* Target;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkUnsignedCharArray> Colors;
};

/// The distance of the letter from the middle of the arrow's disc, in its radii.
constexpr double LetterPlace = 0.62;

// Draws the arrow to the north as the camera sees it: upwards if the camera looks north. Returns
// the place of the letter.
Corner DrawArrow(Canvas& canvas, const skyline::HudLayout& layout, double heading)
{
  const double angle = -heading * skyline::RadiansPerDegree;
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  const auto corner = [&](double right, double ahead)
  {
    const double r = layout.ArrowRadius;
    return Corner{ { layout.ArrowCenter[0] + r * (right * c + ahead * s),
      layout.ArrowCenter[1] + r * (ahead * c - right * s) } };
  };
  canvas.Disc(layout.ArrowCenter[0], layout.ArrowCenter[1], layout.ArrowRadius, Dark);
  canvas.Polygon({ corner(0.0, 0.3), corner(-0.36, -0.7), corner(0.0, -0.5) }, Warm);
  canvas.Polygon({ corner(0.0, 0.3), corner(0.0, -0.5), corner(0.36, -0.7) }, Light);
  return corner(0.0, LetterPlace);
}

} // namespace

namespace skyline
{

Hud::Hud()
  : Renderer(vtkSmartPointer<vtkRenderer>::New())
  , Shapes(vtkSmartPointer<vtkPolyData>::New())
{
  this->Renderer->SetLayer(1);
  this->Renderer->InteractiveOff();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(this->Shapes);
  mapper->ScalarVisibilityOn();
  mapper->SetScalarModeToUseCellData();
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor2D(actor);

  this->Status = this->MakeText(VTK_TEXT_LEFT, VTK_TEXT_TOP, true);
  this->Times = this->MakeText(VTK_TEXT_RIGHT, VTK_TEXT_TOP, true);
  this->Message = this->MakeText(VTK_TEXT_LEFT, VTK_TEXT_BOTTOM, false);
  this->Message->GetTextProperty()->SetColor(1.0, 0.8, 0.4);
  this->Help = this->MakeText(VTK_TEXT_LEFT, VTK_TEXT_CENTERED, true);
  this->Help->GetTextProperty()->SetBackgroundOpacity(0.9);
  this->Bar = this->MakeText(VTK_TEXT_RIGHT, VTK_TEXT_BOTTOM, false);
  this->North = this->MakeText(VTK_TEXT_CENTERED, VTK_TEXT_CENTERED, false);
  this->North->GetTextProperty()->SetBackgroundOpacity(0.0);
  for (auto& label : this->Labels)
  {
    label = this->MakeText(VTK_TEXT_LEFT, VTK_TEXT_CENTERED, true);
  }
}

vtkRenderer* Hud::GetRenderer() const
{
  return this->Renderer;
}

vtkSmartPointer<vtkTextActor> Hud::MakeText(int align, int valign, bool fixed)
{
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  vtkTextProperty* look = actor->GetTextProperty();
  look->SetJustification(align);
  look->SetVerticalJustification(valign);
  if (fixed)
  {
    look->SetFontFamilyToCourier();
    look->BoldOn();
  }
  look->SetColor(0.95, 0.95, 0.92);
  look->SetBackgroundColor(Dark[0] / 255.0, Dark[1] / 255.0, Dark[2] / 255.0);
  look->SetBackgroundOpacity(PanelOpacity);
  this->Renderer->AddActor2D(actor);
  return actor;
}

void Hud::Write(vtkTextActor* actor, const std::string& text, double x, double y, int size)
{
  actor->SetVisibility(!text.empty());
  if (!text.empty())
  {
    actor->SetInput(text.c_str());
    actor->SetPosition(std::round(x), std::round(y));
    actor->GetTextProperty()->SetFontSize(size);
  }
}

void Hud::Show(const HudContent& content, const HudLayout& layout)
{
  const int width = layout.Width;
  const int height = layout.Height;
  const double margin = layout.Margin;
  const int size = layout.FontSize;
  const double unit = size / 14.0; // scale of the layout
  Canvas canvas(this->Shapes);

  // The help is scaled down until it fits; then there is no room for other lines.
  const double lines = 25.0;
  const double letters = 92.0;
  const int fitting = static_cast<int>(
    std::min({ static_cast<double>(size), height / (lines * 1.25), width / (letters * 0.62) }));
  const bool crowded = !content.Help.empty() && fitting < size;
  const bool status = layout.Status && !crowded;
  const bool times = layout.Times && !crowded;

  this->Write(this->Status, status ? content.Status : std::string(), margin, height - margin, size);
  this->Write(this->Times, times ? content.Times : std::string(), width - margin,
    height - 2.0 * margin - 2.0 * layout.ArrowRadius, size);

  double above = margin;
  for (std::size_t k = 0; k < layout.Tracks.size(); ++k)
  {
    const HudBox& track = layout.Tracks[k];
    const ViewerSlider& slider = content.Sliders[k];
    if (track.Width <= 0.0)
    {
      this->Write(this->Labels[k], "", 0.0, 0.0, size);
      continue;
    }
    const double part = (slider.Value - slider.Low) / (slider.High - slider.Low);
    canvas.Box(track, Dark);
    canvas.Box({ track.X, track.Y, part * track.Width, track.Height }, Warm);
    const double middle = track.Y + 0.5 * track.Height;
    canvas.Disc(track.X + part * track.Width, middle, KnobRadius * unit, Dark);
    canvas.Disc(track.X + part * track.Width, middle, (KnobRadius - 2.0) * unit, Light);
    this->Write(this->Labels[k], slider.Label, track.X + track.Width + margin, middle, size);
    above = layout.Sliders[0].Y + layout.Sliders[0].Height + margin;
  }
  this->Write(this->Message, layout.Arrow ? content.Message : std::string(), margin, above, size);

  if (layout.Arrow)
  {
    const Corner north = DrawArrow(canvas, layout, content.Heading);
    this->Write(this->North, "N", north[0], north[1], size);
  }
  this->North->SetVisibility(layout.Arrow);

  const double length = layout.Bar ? RoundLength(layout.LongestBar * content.MetresPerPixel) : 0.0;
  this->Write(this->Bar, length > 0.0 ? LengthText(length) : std::string(), layout.BarRight[0],
    layout.BarRight[1] + 0.75 * margin, size);
  if (length > 0.0)
  {
    const double pixels = length / content.MetresPerPixel;
    const double left = layout.BarRight[0] - pixels;
    canvas.Box({ left - unit, layout.BarRight[1] - unit, pixels + 2.0 * unit, 7.0 * unit }, Dark);
    canvas.Box({ left, layout.BarRight[1], pixels, 5.0 * unit }, Light);
  }

  this->Write(this->Help, fitting >= 5 ? content.Help : std::string(), 0.5 * width, 0.5 * height,
    std::max(fitting, 5));
  double box[2] = { 0.0, 0.0 };
  this->Help->GetSize(this->Renderer, box);
  this->Help->SetPosition(std::round(0.5 * (width - box[0])), 0.5 * height);
  canvas.Finish();
}

} // namespace skyline
