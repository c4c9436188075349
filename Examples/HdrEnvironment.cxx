// SPDX-License-Identifier: BSD-3-Clause
// A DEM in the light of an HDR environment, drawn without a window.
//
// Usage: HdrEnvironment DEM MAP.hdr OUT.png [DEGREES]
//
// DEGREES is the angle by which the map is turned clockwise.
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkHeightFieldReader.h"
#include "vtkHeightFieldSurface.h"
#include "vtkImageData.h"
#include "vtkLightMapReader.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSkylineEGLWindow.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSoftShadowPolyDataMapper.h"
#include "vtkSoftShadowShader.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 4 && argc != 5)
  {
    std::cerr << "usage: HdrEnvironment DEM MAP.hdr OUT.png [DEGREES]\n";
    return 2;
  }
  if (!vtkSkylineEGLWindow::IsSupported())
  {
    std::cerr << "skipped: no OpenGL without a window system\n";
    return 77;
  }

  vtkNew<vtkHeightFieldReader> terrain;
  terrain->SetFileName(argv[1]);

  vtkNew<vtkLightMapReader> map;
  map->SetFileName(argv[2]);
  map->Update();
  vtkNew<vtkSkylineEnvironmentLight> environment;
  environment->SetImage(map->GetOutput());
  environment->SetRotation(argc == 5 ? std::strtod(argv[4], nullptr) : 0.0);

  vtkNew<vtkHeightFieldIrradiance> light;
  light->SetInputConnection(terrain->GetOutputPort());
  light->AddLight(environment);
  light->SetNumberOfAzimuths(64);
  light->Update();
  if (light->GetOutput()->GetNumberOfPoints() == 0)
  {
    return EXIT_FAILURE; // the reasons have been printed
  }

  vtkNew<vtkHeightFieldSurface> surface;
  surface->SetInputConnection(terrain->GetOutputPort());
  vtkNew<vtkSoftShadowPolyDataMapper> mapper;
  mapper->SetInputConnection(surface->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->GetShader()->SetHeightFieldConnection(light->GetOutputPort());
  mapper->GetShader()->SetExposure(-1.2); // in stops: a factor of 2^-1.2
  vtkNew<vtkActor> ground;
  ground->SetMapper(mapper);
  ground->GetProperty()->SetColor(0.82, 0.78, 0.72);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(ground);
  renderer->SetBackground(0.45, 0.58, 0.74);
  renderer->ResetCamera();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->Elevation(-55.0); // seen from the south
  camera->Pitch(-2.0);
  camera->Zoom(1.7);
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
  writer->SetFileName(argv[3]);
  writer->Write();
  return EXIT_SUCCESS;
}
