// SPDX-License-Identifier: BSD-3-Clause
// Glowing balls above a crater at night, under a faint sky.
//
// Usage: LampsAtNight DEM OUT.png
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkHeightFieldReader.h"
#include "vtkHeightFieldSurface.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSkylineEGLWindow.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineLampLight.h"
#include "vtkSoftShadowPolyDataMapper.h"
#include "vtkSoftShadowShader.h"
#include "vtkSphereSource.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>
#include <iostream>

namespace
{

struct Lamp
{
  int Column, Row; // of the DEM, counted from the north-west
  double Above;    // metres above the ground
  double Radius;
  double Color[3];
};

constexpr Lamp Lamps[] = {
  { 165, 222, 150.0, 60.0, { 1.0, 0.55, 0.2 } },
  { 135, 200, 120.0, 40.0, { 1.0, 0.8, 0.5 } },
  { 196, 196, 120.0, 40.0, { 0.5, 0.75, 1.0 } },
  { 160, 150, 200.0, 60.0, { 0.9, 1.0, 0.6 } },
};
constexpr double Radiance = 40.0;

// The ball that shows the lamp itself in the picture.
vtkNew<vtkActor> MakeBall(const double center[3], const Lamp& lamp)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(center[0], center[1], center[2]);
  ball->SetRadius(lamp.Radius);
  ball->SetThetaResolution(32);
  ball->SetPhiResolution(32);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(
    0.5 + 0.5 * lamp.Color[0], 0.5 + 0.5 * lamp.Color[1], 0.5 + 0.5 * lamp.Color[2]);
  return actor;
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: LampsAtNight DEM OUT.png\n";
    return 2;
  }
  if (!vtkSkylineEGLWindow::IsSupported())
  {
    std::cerr << "skipped: no OpenGL without a window system\n";
    return 77;
  }

  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(argv[1]);
  reader->Update();
  vtkImageData* terrain = reader->GetOutput();
  if (terrain->GetNumberOfPoints() == 0)
  {
    return EXIT_FAILURE; // the reason has been printed
  }
  const double west = terrain->GetOrigin()[0], south = terrain->GetOrigin()[1];
  const double dx = terrain->GetSpacing()[0], dy = terrain->GetSpacing()[1];

  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkHeightFieldIrradiance> light;
  light->SetInputConnection(reader->GetOutputPort());
  light->SetNumberOfAzimuths(64);
  vtkNew<vtkSkylineEnvironmentLight> sky;
  sky->SetRadiance(0.06, 0.08, 0.14);
  light->AddLight(sky);
  for (const Lamp& lamp : Lamps)
  {
    const int row = terrain->GetDimensions()[1] - 1 - lamp.Row; // row 0 of an image is in the south
    const double ground = terrain->GetScalarComponentAsDouble(lamp.Column, row, 0, 0);
    const double place[3] = { west + lamp.Column * dx, south + row * dy, ground + lamp.Above };
    vtkNew<vtkSkylineLampLight> shining;
    shining->SetPosition(place[0], place[1], place[2]);
    shining->SetRadius(lamp.Radius);
    shining->SetRadiance(
      Radiance * lamp.Color[0], Radiance * lamp.Color[1], Radiance * lamp.Color[2]);
    light->AddLight(shining);
    renderer->AddActor(MakeBall(place, lamp));
  }
  light->Update();
  double range[2];
  light->GetOutput()->GetPointData()->GetArray("Irradiance")->GetFiniteRange(range, 1);
  std::cout << "green irradiance " << range[0] << " to " << range[1] << "\n";

  vtkNew<vtkHeightFieldSurface> surface;
  surface->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkSoftShadowPolyDataMapper> mapper;
  mapper->SetInputConnection(surface->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->GetShader()->SetHeightFieldConnection(light->GetOutputPort());
  vtkNew<vtkActor> ground;
  ground->SetMapper(mapper);
  ground->GetProperty()->SetColor(0.75, 0.72, 0.68);
  renderer->AddActor(ground);
  renderer->SetBackground(0.02, 0.025, 0.05);

  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(west + 165 * dx, south + 265 * dy, 1900.0);
  camera->SetPosition(west + 140 * dx, south + 460 * dy, 5200.0); // from the north, into the crater
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->Zoom(1.15);
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
  writer->SetFileName(argv[2]);
  writer->Write();
  return EXIT_SUCCESS;
}
