// SPDX-License-Identifier: BSD-3-Clause
// Terrain that changes with every frame, together with its shadows.
//
// Usage: DynamicTerrain OUT.png [FRAMES]
//
// The picture shows four of the frames. In your own window, call Move and Render for each frame.
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkHeightFieldSurface.h"
#include "vtkImageAppend.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSkylineEGLWindow.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineSunLight.h"
#include "vtkSoftShadowPolyDataMapper.h"
#include "vtkSoftShadowShader.h"
#include "vtkWindowToImageFilter.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{

constexpr int Posts = 160;
constexpr int Shown = 4;

// A circular wave runs outwards from a drop in the middle; `time` goes from 0 to 1.
void Move(vtkImageData* terrain, double time)
{
  auto* heights = vtkFloatArray::SafeDownCast(terrain->GetPointData()->GetScalars());
  for (int row = 0; row < Posts; ++row)
  {
    for (int column = 0; column < Posts; ++column)
    {
      const double distance = std::hypot(column - 80.0, row - 80.0);
      const double behind = (distance - 90.0 * time) / 9.0;
      const double height = 14.0 * std::exp(-behind * behind) * std::cos(0.9 * behind);
      heights->SetValue(row * Posts + column, static_cast<float>(height));
    }
  }
  heights->Modified(); // this is all that the filters and the mapper need
  terrain->Modified();
}

} // namespace

int main(int argc, char* argv[])
{
  const int frames = argc == 3 ? static_cast<int>(std::strtol(argv[2], nullptr, 10)) : Shown;
  if (argc < 2 || argc > 3 || frames < Shown)
  {
    std::cerr << "usage: DynamicTerrain OUT.png [FRAMES, at least " << Shown << "]\n";
    return 2;
  }
  if (!vtkSkylineEGLWindow::IsSupported())
  {
    std::cerr << "skipped: no OpenGL without a window system\n";
    return 77;
  }

  vtkNew<vtkImageData> terrain;
  terrain->SetDimensions(Posts, Posts, 1);
  terrain->AllocateScalars(VTK_FLOAT, 1);

  vtkNew<vtkSkylineSunLight> sun;
  sun->SetAzimuth(290.0);
  sun->SetElevation(22.0);
  sun->SetAngularRadius(1.5); // larger than the real one, for softer shadows
  sun->SetIrradiance(4.2, 3.8, 3.2);
  vtkNew<vtkSkylineEnvironmentLight> sky;
  sky->SetRadiance(0.22, 0.28, 0.38);
  vtkNew<vtkHeightFieldIrradiance> light;
  light->SetInputData(terrain);
  light->SetMethodToFast();
  light->SetNumberOfAzimuths(16);
  light->AddLight(sun);
  light->AddLight(sky);

  vtkNew<vtkHeightFieldSurface> surface;
  surface->SetInputData(terrain);
  vtkNew<vtkSoftShadowPolyDataMapper> mapper;
  mapper->SetInputConnection(surface->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->GetShader()->SetHeightFieldConnection(light->GetOutputPort());
  vtkNew<vtkActor> ground;
  ground->SetMapper(mapper);
  ground->GetProperty()->SetColor(0.80, 0.70, 0.55);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(ground);
  renderer->SetBackground(0.72, 0.80, 0.90);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(80.0, 76.0, 0.0);
  camera->SetPosition(80.0, -230.0, 230.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->Zoom(1.25);
  renderer->ResetCameraClippingRange(0.0, Posts, 0.0, Posts, -20.0, 20.0);
  vtkNew<vtkSkylineEGLWindow> window;
  window->SetMultiSamples(4);
  window->SetSize(320, 240);
  window->AddRenderer(renderer);

  vtkNew<vtkImageAppend> strip;
  const auto start = std::chrono::steady_clock::now();
  for (int frame = 0; frame < frames; ++frame)
  {
    Move(terrain, (frame + 0.6) / frames);
    window->Render();
    if ((frame * Shown) / frames != ((frame + 1) * Shown) / frames)
    {
      vtkNew<vtkWindowToImageFilter> pixels;
      pixels->SetInput(window);
      pixels->ReadFrontBufferOff();
      pixels->ShouldRerenderOff();
      pixels->Update();
      vtkNew<vtkImageData> shown;
      shown->DeepCopy(pixels->GetOutput());
      strip->AddInputData(shown);
    }
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  std::cout << frames << " frames, " << 1000.0 * passed.count() / frames << " ms each\n";

  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(strip->GetOutputPort());
  writer->SetFileName(argv[1]);
  writer->Write();
  return EXIT_SUCCESS;
}
