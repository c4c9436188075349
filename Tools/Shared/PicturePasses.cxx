// SPDX-License-Identifier: BSD-3-Clause
#include "PicturePasses.h"

#include "vtkDataArray.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkHeightFieldShading.h"
#include "vtkHeightFieldSkyLight.h"
#include "vtkHeightFieldSkyView.h"
#include "vtkHeightFieldSunShadow.h"
#include "vtkImageData.h"
#include "vtkImageShiftScale.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>

namespace skyline
{

namespace
{

template <typename Filter>
vtkSmartPointer<Filter> MakePass(vtkImageData* terrain, const HorizonOptions& horizon)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(terrain);
  horizon.Apply(filter.GetPointer());
  return filter;
}

} // namespace

vtkSmartPointer<vtkImageData> Exaggerate(
  vtkImageData* heights, double factor, const RunFunction& run)
{
  if (factor == 1.0)
  {
    return heights;
  }
  vtkNew<vtkImageShiftScale> scale;
  scale->SetInputData(heights);
  scale->SetScale(factor);
  scale->SetOutputScalarTypeToDouble();
  run(scale, "exaggeration");
  scale->GetOutput()->GetPointData()->GetScalars()->SetName("Elevation");
  return scale->GetOutput();
}

bool HasSkyPass(SkyKind kind)
{
  return kind == SkyKind::Uniform || kind == SkyKind::Zonal;
}

bool HasEnvironment(SkyKind kind)
{
  return kind != SkyKind::None && !HasSkyPass(kind);
}

SkyPass MakeSkyPass(const SkyDescription& sky, vtkImageData* terrain, const HorizonOptions& horizon)
{
  if (sky.Kind == SkyKind::Zonal)
  {
    const auto light = MakePass<vtkHeightFieldSkyLight>(terrain, horizon);
    light->SetNumberOfAzimuths(horizon.Azimuths);
    light->SetCieType(sky.CieType);
    return { light, "SkyLight" };
  }
  const auto view = MakePass<vtkHeightFieldSkyView>(terrain, horizon);
  view->SetNumberOfAzimuths(horizon.Azimuths);
  view->SetSkyViewFactorHorizontal(false);
  view->SetVisibleSkyFraction(false);
  view->SetPositiveOpenness(false);
  return { view, "SkyViewFactor" };
}

vtkSmartPointer<vtkHeightFieldIrradiance> MakeIrradiancePass(
  vtkImageData* terrain, const HorizonOptions& horizon)
{
  auto filter = MakePass<vtkHeightFieldIrradiance>(terrain, horizon);
  filter->SetNumberOfAzimuths(horizon.Azimuths);
  return filter;
}

vtkSmartPointer<vtkHeightFieldSunShadow> MakeShadowPass(
  vtkImageData* terrain, const HorizonOptions& horizon)
{
  return MakePass<vtkHeightFieldSunShadow>(terrain, horizon);
}

bool SunShines(const Daylight& day)
{
  return Luminance(day.SunIrradiance) > 0.0f;
}

void ReplaceSun(const std::optional<std::array<double, 3>>& asked, Daylight& day)
{
  if (asked && SunShines(day))
  {
    std::transform(asked->begin(), asked->end(), day.SunIrradiance.begin(),
      [](double part) { return static_cast<float>(part); });
  }
}

void SetDaylight(const Daylight& day, vtkHeightFieldShading* shading)
{
  shading->SetSunIrradiance(day.SunIrradiance[0], day.SunIrradiance[1], day.SunIrradiance[2]);
  shading->SetSkyRadiance(day.SkyRadiance[0], day.SkyRadiance[1], day.SkyRadiance[2]);
}

} // namespace skyline
