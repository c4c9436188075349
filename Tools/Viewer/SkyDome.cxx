// SPDX-License-Identifier: BSD-3-Clause
#include "SkyDome.h"

#include "Shared/Constants.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegularPolygonSource.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{

/// Number of pieces of the sphere around the horizon, and from the zenith to the nadir.
constexpr int Slices = 120;
constexpr int Stacks = 60;

/// The facets of the sphere are nearer than its corners, by less than this factor.
constexpr double Slack = 1.01;

/// Least distance of the near plane as a part of that of the far plane.
constexpr double NearestPart = 1.0e-4;

/// Least change of the exposure, in stops, for which the picture is made again.
constexpr double LeastChange = 0.002;

constexpr vtkIdType PixelsPerPiece = 8192;

// Makes a sphere of radius 1 seen from inside: u clockwise from the south, v up from the nadir.
vtkSmartPointer<vtkPolyData> MakeSphere()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> cells;
  for (int stack = 0; stack <= Stacks; ++stack)
  {
    const double polar = skyline::Pi * stack / Stacks;
    for (int slice = 0; slice <= Slices; ++slice)
    {
      const double azimuth = 2.0 * skyline::Pi * slice / Slices - skyline::Pi;
      points->InsertNextPoint(
        std::sin(polar) * std::sin(azimuth), std::sin(polar) * std::cos(azimuth), std::cos(polar));
      const double place[2] = { static_cast<double>(slice) / Slices,
        1.0 - static_cast<double>(stack) / Stacks };
      places->InsertNextTuple(place);
    }
  }
  for (vtkIdType stack = 0; stack < Stacks; ++stack)
  {
    for (vtkIdType slice = 0; slice < Slices; ++slice)
    {
      const vtkIdType corner = stack * (Slices + 1) + slice;
      const vtkIdType cell[4] = { corner, corner + 1, corner + Slices + 2, corner + Slices + 1 };
      cells->InsertNextCell(4, cell);
    }
  }
  auto sphere = vtkSmartPointer<vtkPolyData>::New();
  sphere->SetPoints(points);
  sphere->SetPolys(cells);
  sphere->GetPointData()->SetTCoords(places);
  return sphere;
}

// Makes an unlit actor that the camera ignores when it sets its planes.
vtkSmartPointer<vtkActor> MakeBackdrop(vtkPolyData* shape)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->SetUseBounds(false);
  actor->PickableOff();
  return actor;
}

// Converts the values of a sky, top row first, to those of a texture, bottom row first.
template <typename Value, typename Code>
void Encode(const skyline::SkyImage& sky, Value* to, Code code)
{
  const vtkIdType pixels = sky.Columns * sky.Rows;
  vtkSMPTools::For(0, pixels, PixelsPerPiece,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType pixel = first; pixel < last; ++pixel)
      {
        const vtkIdType row = sky.Rows - 1 - pixel / sky.Columns;
        const float* from = sky.Values.data() + 3 * (row * sky.Columns + pixel % sky.Columns);
        code(from, to + 3 * pixel);
      }
    });
}

} // namespace

namespace skyline
{

SkyDome::SkyDome(vtkRenderer* renderer)
  : Renderer(renderer)
  , Dome(MakeBackdrop(MakeSphere()))
  , Texture(vtkSmartPointer<vtkTexture>::New())
{
  this->Texture->InterpolateOn();
  this->Texture->SetColorModeToDirectScalars();
  this->Dome->SetTexture(this->Texture);
  this->Places =
    vtkFloatArray::SafeDownCast(vtkPolyDataMapper::SafeDownCast(this->Dome->GetMapper())
                                  ->GetInput()
                                  ->GetPointData()
                                  ->GetTCoords());
  this->Dome->VisibilityOff();
  vtkNew<vtkRegularPolygonSource> disc;
  disc->SetNumberOfSides(48);
  disc->SetRadius(1.0);
  disc->GeneratePolylineOff();
  disc->Update();
  this->Sun = MakeBackdrop(disc->GetOutput());
  this->Sun->VisibilityOff();
  const float white = EncodeSrgb(ToneWhite);
  this->Sun->GetProperty()->SetColor(white, white, EncodeSrgb(0.75f * ToneWhite));
  renderer->AddActor(this->Dome);
  renderer->AddActor(this->Sun);
}

void SkyDome::SetSky(SkyImage sky)
{
  this->Sky = std::move(sky);
  this->Developed = false;
}

void SkyDome::SetRotation(double degrees)
{
  this->Dome->SetOrientation(0.0, 0.0, -degrees);
}

void SkyDome::SetSun(bool on, double azimuth, double elevation, double radius)
{
  this->SunOn = on;
  this->SunAzimuth = azimuth * RadiansPerDegree;
  this->SunElevation = elevation * RadiansPerDegree;
  this->SunRadius = radius * RadiansPerDegree;
  this->Sun->SetVisibility(on);
}

void SkyDome::Show(vtkDataArray* pixels)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(this->Sky.Columns), static_cast<int>(this->Sky.Rows), 1);
  image->GetPointData()->SetScalars(pixels);
  // The texture is periodic; at the zenith and the nadir it ends in the middle of its last rows.
  const double end = 0.5 / static_cast<double>(this->Sky.Rows);
  for (vtkIdType slice = 0; slice <= Slices; ++slice)
  {
    this->Places->SetComponent(slice, 1, 1.0 - end);
    this->Places->SetComponent(Stacks * (Slices + 1) + slice, 1, end);
  }
  this->Places->Modified();
  this->Texture->SetInputData(image);
  this->Dome->VisibilityOn();
}

void SkyDome::Develop(double stops)
{
  this->Sun->SetVisibility(this->SunOn);
  if (this->Sky.Values.empty() || (this->Developed && std::abs(stops - this->Stops) < LeastChange))
  {
    return;
  }
  float gain = static_cast<float>(std::exp2(std::clamp(stops, -120.0, 120.0)));
  if (this->Sky.Typical > 0.0f)
  {
    gain = std::min(gain, BrightestTypical / this->Sky.Typical);
  }
  vtkNew<vtkUnsignedCharArray> pixels;
  pixels->SetNumberOfComponents(3);
  pixels->SetNumberOfTuples(this->Sky.Columns * this->Sky.Rows);
  Encode(this->Sky, pixels->GetPointer(0),
    [gain](const float* light, unsigned char* code)
    {
      const Rgb tone = ToneMap({ { gain * light[0], gain * light[1], gain * light[2] } });
      std::transform(tone.begin(), tone.end(), code, SrgbByte);
    });
  this->Show(pixels);
  this->Stops = stops;
  this->Developed = true;
}

void SkyDome::DevelopLinear(float peak)
{
  vtkNew<vtkFloatArray> pixels;
  pixels->SetNumberOfComponents(3);
  pixels->SetNumberOfTuples(this->Sky.Columns * this->Sky.Rows);
  Encode(this->Sky, pixels->GetPointer(0),
    [peak](const float* light, float* code)
    {
      std::transform(
        light, light + 3, code, [peak](float value) { return EncodeSrgb(value / peak); });
    });
  this->Show(pixels);
  this->Developed = false;
  this->Sun->VisibilityOff();
}

void SkyDome::Surround()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double* range = camera->GetClippingRange();
  // A camera that looks away from everything has no useful planes.
  const double reach = std::max(range[1], camera->GetDistance());
  const double near = std::max(range[0], NearestPart * reach);
  const double half = std::tan(0.5 * camera->GetViewAngle() * RadiansPerDegree);
  // In the corner of the picture the sphere must still be behind the far plane of all other
  // objects.
  const double corner =
    std::hypot(1.0, half * std::hypot(1.0, this->Renderer->GetTiledAspectRatio()));
  const double radius = Slack * Slack * reach * corner;
  camera->SetClippingRange(near, Slack * radius);
  const double* eye = camera->GetPosition();
  this->Dome->SetPosition(eye[0], eye[1], eye[2]);
  this->Dome->SetScale(radius);

  const double level = std::cos(this->SunElevation);
  const double away = radius / Slack;
  this->Sun->SetPosition(eye[0] + away * level * std::sin(this->SunAzimuth),
    eye[1] + away * level * std::cos(this->SunAzimuth),
    eye[2] + away * std::sin(this->SunElevation));
  this->Sun->SetScale(away * std::tan(this->SunRadius));
  // The disc is perpendicular to the z axis: tilt it towards the camera, then turn it.
  this->Sun->SetOrientation(0.0, 0.0, 0.0);
  this->Sun->RotateZ(-this->SunAzimuth / RadiansPerDegree);
  this->Sun->RotateX(90.0 + this->SunElevation / RadiansPerDegree);
}

} // namespace skyline
