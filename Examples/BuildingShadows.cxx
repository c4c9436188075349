// SPDX-License-Identifier: BSD-3-Clause
// A tower beside a hill: the shadow of the hill falls on the walls of the tower, and the shadow of
// the tower falls on the ground.
//
// Usage: BuildingShadows OUT.png
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkHeightFieldCap.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkHeightFieldShadowHeight.h"
#include "vtkHeightFieldShadowReceiver.h"
#include "vtkHeightFieldSurface.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSkylineEGLWindow.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineSoftShadowPolyDataMapper.h"
#include "vtkSkylineSoftShadowShader.h"
#include "vtkSkylineSunLight.h"
#include "vtkTessellatedBoxSource.h"
#include "vtkWindowToImageFilter.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{

constexpr int Posts = 401; // posts per side: a square of 400 m with one post per metre
constexpr double SunAzimuth = 250.0, SunElevation = 18.0, SunRadius = 0.5;
constexpr double Radians = 3.14159265358979 / 180.0;

vtkNew<vtkImageData> MakeHill()
{
  vtkNew<vtkImageData> terrain;
  terrain->SetDimensions(Posts, Posts, 1);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Elevation");
  for (int row = 0; row < Posts; ++row)
  {
    for (int column = 0; column < Posts; ++column)
    {
      const double distance = std::hypot((column - 110.0) / 50.0, (row - 170.0) / 80.0);
      heights->InsertNextValue(static_cast<float>(60.0 * std::exp(-distance * distance)));
    }
  }
  terrain->GetPointData()->SetScalars(heights);
  return terrain;
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: BuildingShadows OUT.png\n";
    return 2;
  }
  if (!vtkSkylineEGLWindow::IsSupported())
  {
    std::cerr << "skipped: no OpenGL without a window system\n";
    return 77;
  }
  const vtkNew<vtkImageData> hill = MakeHill();

  // The building: any polygons in the coordinates of the image. They are small, so that the edges
  // of shadows are visible on them.
  vtkNew<vtkTessellatedBoxSource> model;
  // The walls reach nearly to the next posts, so that the light of the roof is not interpolated
  // onto the ground beside it.
  model->SetBounds(224.05, 250.95, 194.05, 220.95, 0.0, 80.0);
  model->SetLevel(60);

  // The shadow that the building casts: on the ground, raised to the building.
  vtkNew<vtkHeightFieldCap> cap;
  cap->SetInputData(hill);
  cap->SetObjectsConnection(model->GetOutputPort());
  vtkNew<vtkSkylineSunLight> sun;
  sun->SetAzimuth(SunAzimuth);
  sun->SetElevation(SunElevation);
  sun->SetAngularRadius(SunRadius);
  sun->SetIrradiance(4.0, 3.6, 3.0);
  vtkNew<vtkSkylineEnvironmentLight> sky;
  sky->SetRadiance(0.25, 0.32, 0.45);
  vtkNew<vtkHeightFieldIrradiance> light;
  light->SetInputConnection(cap->GetOutputPort());
  light->AddLight(sun);
  light->AddLight(sky);
  light->SetNumberOfAzimuths(32);

  // The shadow that the hill casts on the building: SunVisibility at the points of the building.
  vtkNew<vtkHeightFieldShadowHeight> shadow;
  shadow->SetInputData(hill);
  shadow->SetSunAzimuth(SunAzimuth);
  shadow->SetSunElevation(SunElevation);
  shadow->SetSunAngularRadius(SunRadius);
  shadow->SoftOn();
  vtkNew<vtkHeightFieldShadowReceiver> receiver;
  receiver->SetInputConnection(model->GetOutputPort());
  receiver->SetShadowConnection(shadow->GetOutputPort());
  receiver->Update();
  vtkDataArray* lit =
    vtkPointSet::SafeDownCast(receiver->GetOutput())->GetPointData()->GetArray("SunVisibility");
  std::cout << "the tower's points see " << lit->GetRange()[0] << " to " << lit->GetRange()[1]
            << " of the sun\n";

  vtkNew<vtkHeightFieldSurface> surface;
  surface->SetInputData(hill);
  vtkNew<vtkSkylineSoftShadowPolyDataMapper> groundMapper;
  groundMapper->SetInputConnection(surface->GetOutputPort());
  groundMapper->ScalarVisibilityOff();
  groundMapper->GetShader()->SetHeightFieldConnection(light->GetOutputPort());
  vtkNew<vtkActor> ground;
  ground->SetMapper(groundMapper);
  ground->GetProperty()->SetColor(0.62, 0.68, 0.52);

  vtkNew<vtkLookupTable> colors; // colours of the walls, from full shadow to full sun
  colors->SetNumberOfTableValues(256);
  for (int i = 0; i < 256; ++i)
  {
    const double part = i / 255.0;
    colors->SetTableValue(i, 0.36 + 0.62 * part, 0.38 + 0.53 * part, 0.46 + 0.32 * part);
  }
  vtkNew<vtkPolyDataMapper> towerMapper;
  towerMapper->SetInputConnection(receiver->GetOutputPort());
  towerMapper->SetScalarModeToUsePointFieldData();
  towerMapper->SelectColorArray("SunVisibility");
  towerMapper->SetLookupTable(colors);
  towerMapper->SetScalarRange(0.0, 1.0);
  vtkNew<vtkActor> building;
  building->SetMapper(towerMapper);
  building->GetProperty()->SetAmbient(0.4);
  building->GetProperty()->SetDiffuse(0.6);
  vtkNew<vtkLight> sunlight; // lights only the walls; the ground has Skyline's light
  sunlight->SetLightTypeToSceneLight();
  sunlight->SetPosition(std::sin(Radians * SunAzimuth), std::cos(Radians * SunAzimuth),
    std::tan(Radians * SunElevation));

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(ground);
  renderer->AddActor(building);
  renderer->AddLight(sunlight);
  renderer->SetBackground(0.70, 0.79, 0.90);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(225.0, 190.0, 25.0);
  camera->SetPosition(150.0, -300.0, 260.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();

  vtkNew<vtkSkylineEGLWindow> window;
  window->SetMultiSamples(4);
  window->SetSize(800, 500);
  window->AddRenderer(renderer);
  vtkNew<vtkWindowToImageFilter> pixels;
  pixels->SetInput(window);
  pixels->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(pixels->GetOutputPort());
  writer->SetFileName(argv[1]);
  writer->Write();
  return EXIT_SUCCESS;
}
