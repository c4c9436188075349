// SPDX-License-Identifier: BSD-3-Clause
#include "TerrainActors.h"

#include "Color/ToneMap.h"
#include "Shared/Constants.h"

#include "vtkActor.h"
#include "vtkHeightFieldSurface.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSkylineSoftShadowPolyDataMapper.h"
#include "vtkSkylineSoftShadowShader.h"

#include <algorithm>
#include <cmath>

namespace
{

/// The depth of the block below the lowest point of the terrain, in widths of the terrain.
constexpr double SkirtDepth = 0.02;

/// A sky that is the only light would exceed the range of a picture.
constexpr float BrightestSky = 0.22f;

} // namespace

namespace skyline
{

vtkSmartPointer<vtkHeightFieldSurface> MakeMesh(vtkImageData* terrain, double posts)
{
  auto surface = vtkSmartPointer<vtkHeightFieldSurface>::New();
  surface->SetInputData(terrain);
  surface->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
  surface->SetStride(static_cast<int>(
    std::ceil(std::sqrt(static_cast<double>(terrain->GetNumberOfPoints()) / posts))));
  return surface;
}

vtkSmartPointer<vtkHeightFieldSurface> MakeSkirt(
  vtkImageData* terrain, double posts, vtkPolyData* mesh)
{
  auto skirt = MakeMesh(terrain, posts);
  const double* bounds = mesh->GetBounds();
  skirt->SkirtOn();
  skirt->SetSkirtBase(
    bounds[4] - SkirtDepth * std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]));
  return skirt;
}

// The shader draws a white ground under pi times as much light.
double ShaderExposure(double exposure)
{
  return exposure + std::log2(Pi);
}

vtkSmartPointer<vtkSkylineSoftShadowPolyDataMapper> MakeMapper(
  vtkAlgorithm* mesh, vtkImageData* terrain, double exposure)
{
  auto mapper = vtkSmartPointer<vtkSkylineSoftShadowPolyDataMapper>::New();
  mapper->SetInputConnection(mesh->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->GetShader()->SetHeightField(terrain);
  mapper->GetShader()->SetIrradianceArrayName("Radiance");
  mapper->GetShader()->SetExposure(ShaderExposure(exposure));
  return mapper;
}

vtkSmartPointer<vtkActor> MakeActor(vtkMapper* mapper, double color)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color, color, color);
  return actor;
}

void PaintSky(vtkRenderer* renderer, const std::array<float, 3>& radiance, double exposure)
{
  const float gray = Luminance(radiance);
  const float gain =
    std::min(static_cast<float>(std::exp2(exposure)), gray > 0.0f ? BrightestSky / gray : 0.0f);
  Rgb low;
  Rgb high;
  for (std::size_t c = 0; c < 3; ++c)
  {
    low[c] = gain * (2.0f * gray + 2.0f * radiance[c]);
    high[c] = gain * 2.0f * radiance[c];
  }
  low = ToneMap(low);
  high = ToneMap(high);
  renderer->GradientBackgroundOn();
  renderer->SetBackground(EncodeSrgb(low[0]), EncodeSrgb(low[1]), EncodeSrgb(low[2]));
  renderer->SetBackground2(EncodeSrgb(high[0]), EncodeSrgb(high[1]), EncodeSrgb(high[2]));
}

} // namespace skyline
