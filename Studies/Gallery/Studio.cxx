// SPDX-License-Identifier: BSD-3-Clause
#include "Studio.h"

#include "Color/ToneMap.h"
#include "OffscreenWindow.h"
#include "vtkHeightFieldSurface.h"
#include "vtkSkylineSoftShadowPolyDataMapper.h"
#include "vtkSkylineSoftShadowShader.h"

#include "vtkActor.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <stdexcept>

namespace skyline
{
namespace gallery
{

namespace
{

constexpr int Samples = 3; // per pixel, in each direction
constexpr double Paper = 0.95, GroundColor = 0.93;

vtkSmartPointer<vtkImageData> ImageOf(
  const oracle::OracleField& terrain, const std::vector<float>& irradiance)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(terrain.Columns), static_cast<int>(terrain.Rows), 1);
  image->SetSpacing(terrain.SpacingX, terrain.SpacingY, 1.0);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Elevation");
  heights->SetNumberOfValues(static_cast<vtkIdType>(terrain.Heights.size()));
  std::copy(terrain.Heights.begin(), terrain.Heights.end(), heights->GetPointer(0));
  image->GetPointData()->SetScalars(heights);
  vtkNew<vtkFloatArray> light;
  light->SetName("Irradiance");
  light->SetNumberOfComponents(3);
  light->SetNumberOfTuples(static_cast<vtkIdType>(terrain.Heights.size()));
  std::transform(irradiance.begin(), irradiance.end(), light->GetPointer(0),
    [](float value) { return std::max(value, 0.0f); });
  image->GetPointData()->AddArray(light);
  return image;
}

/// The points of the mesh that must be in the picture.
vtkSmartPointer<vtkPoints> PointsIn(vtkPoints* points, const std::array<double, 4>& region)
{
  if (region[0] >= region[1])
  {
    return points;
  }
  auto inside = vtkSmartPointer<vtkPoints>::New();
  for (vtkIdType k = 0; k < points->GetNumberOfPoints(); ++k)
  {
    const double* p = points->GetPoint(k);
    if (p[0] >= region[0] && p[0] <= region[1] && p[1] >= region[2] && p[1] <= region[3])
    {
      inside->InsertNextPoint(p);
    }
  }
  return inside;
}

vtkSmartPointer<vtkActor> ActorOf(const Bulb& bulb)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(bulb.Ball.Centre.X, bulb.Ball.Centre.Y, bulb.Ball.Centre.Z);
  sphere->SetRadius(bulb.Ball.Radius);
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  std::array<double, 3> code{};
  for (std::size_t c = 0; c < code.size(); ++c)
  {
    code[c] = static_cast<double>(EncodeSrgb(static_cast<float>(bulb.Color[c])));
  }
  actor->GetProperty()->SetColor(code.data());
  return actor;
}

/// The means of Samples x Samples codes, computed in linear light.
Picture Reduced(vtkUnsignedCharArray* samples, int width, int height)
{
  Picture picture(width, height, 0);
  const unsigned char* codes = samples->GetPointer(0);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        float sum = 0.0f;
        for (int k = 0; k < Samples * Samples; ++k)
        {
          const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(y) * Samples + k / Samples;
          const std::ptrdiff_t column = static_cast<std::ptrdiff_t>(x) * Samples + k % Samples;
          sum += DecodeSrgb(
            static_cast<float>(codes[3 * (row * width * Samples + column) + c]) / 255.0f);
        }
        picture.At(x, y)[c] = SrgbByte(sum / (Samples * Samples));
      }
    }
  }
  return picture;
}

} // namespace

std::vector<float> Grey(const std::vector<float>& light)
{
  std::vector<float> rgb;
  rgb.reserve(3 * light.size());
  for (const float value : light)
  {
    rgb.insert(rgb.end(), 3, value);
  }
  return rgb;
}

bool Studio::Open(std::string& reason)
{
  this->Window = MakeOffscreenWindow(reason);
  return this->Window != nullptr;
}

Picture Studio::Draw(
  const oracle::OracleField& terrain, const std::vector<float>& irradiance, const Look& look)
{
  const auto image = ImageOf(terrain, irradiance);
  vtkNew<vtkHeightFieldSurface> surface;
  surface->SetInputData(image);
  surface->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
  surface->Update();
  vtkNew<vtkSkylineSoftShadowPolyDataMapper> mapper;
  mapper->SetInputConnection(surface->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->GetShader()->SetHeightField(image);
  mapper->GetShader()->SetExposure(look.Exposure);
  vtkNew<vtkActor> ground;
  ground->SetMapper(mapper);
  ground->GetProperty()->SetColor(GroundColor, GroundColor, GroundColor);
  std::vector<vtkSmartPointer<vtkActor>> actors{ ground.Get() };
  for (const Bulb& bulb : look.Bulbs)
  {
    actors.push_back(ActorOf(bulb));
  }
  return this->Draw(actors, PointsIn(surface->GetOutput()->GetPoints(), look.Region), look);
}

Picture Studio::Draw(
  const std::vector<vtkSmartPointer<vtkActor>>& actors, vtkPoints* inside, const Look& look)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(Paper, Paper, Paper);
  for (vtkActor* actor : actors)
  {
    renderer->AddActor(actor);
  }
  Standpoint from = look.From;
  from.Aspect = static_cast<double>(look.Width) / look.Height;
  FitCamera(renderer->GetActiveCamera(), { inside }, from);
  renderer->ResetCameraClippingRange();

  const int width = Samples * look.Width, height = Samples * look.Height;
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(renderer);
  this->Window->Render();
  vtkNew<vtkUnsignedCharArray> samples;
  this->Window->GetPixelData(0, 0, width - 1, height - 1, 0, samples, 0);
  this->Window->RemoveRenderer(renderer);
  if (samples->GetNumberOfValues() != 3 * static_cast<vtkIdType>(width) * height)
  {
    throw std::runtime_error("OpenGL returned no picture");
  }
  return Reduced(samples, look.Width, look.Height);
}

} // namespace gallery
} // namespace skyline
