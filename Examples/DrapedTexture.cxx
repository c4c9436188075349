// SPDX-License-Identifier: BSD-3-Clause
// A picture draped over a DEM, in the light of sun and sky.
//
// Usage: DrapedTexture DEM OUT.png
//
// Here, the picture is computed from the heights. You can use any RGB image, for instance the
// output of vtkPNGReader.
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkHeightFieldReader.h"
#include "vtkHeightFieldSurface.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderer.h"
#include "vtkSkylineEGLWindow.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineSoftShadowPolyDataMapper.h"
#include "vtkSkylineSoftShadowShader.h"
#include "vtkSkylineSunLight.h"
#include "vtkTexture.h"
#include "vtkTextureMapToPlane.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{

constexpr double Forest[] = { 60, 84, 48 }, Meadow[] = { 134, 140, 84 }, Rock[] = { 128, 118, 108 },
                 Snow[] = { 240, 243, 248 };

// A linear ramp: 0 up to `first`, 1 from `last` on.
double Ramp(double value, double first, double last)
{
  return std::clamp((value - first) / (last - first), 0.0, 1.0);
}

// The colours as sRGB values: snow above forest, rock where it is steep, and a contour line every
// 100 metres.
vtkNew<vtkImageData> Paint(vtkImageData* terrain)
{
  const int columns = terrain->GetDimensions()[0], rows = terrain->GetDimensions()[1];
  const auto height = [&](int column, int row)
  {
    return terrain->GetScalarComponentAsDouble(
      std::clamp(column, 0, columns - 1), std::clamp(row, 0, rows - 1), 0, 0);
  };
  const auto band = [&](int column, int row) { return std::floor(height(column, row) / 100.0); };

  vtkNew<vtkImageData> picture;
  picture->SetDimensions(columns, rows, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer());
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const double here = height(column, row);
      const double east = (height(column + 1, row) - height(column - 1, row)) / 60.0;
      const double north = (height(column, row + 1) - height(column, row - 1)) / 60.0;
      const double steep = std::hypot(east, north);
      const double meadow = Ramp(here, 900.0, 1300.0), rock = Ramp(steep, 0.35, 0.55);
      const double snow = steep < 0.9 ? Ramp(here, 1700.0, 1850.0) : 0.0;
      const bool contour =
        band(column, row) != band(column, row + 1) || band(column, row) != band(column - 1, row);
      for (int i = 0; i < 3; ++i)
      {
        double color = Forest[i] + (Meadow[i] - Forest[i]) * meadow;
        color += (Rock[i] - color) * rock;
        color += (Snow[i] - color) * snow;
        color = std::isnan(color) ? 128.0 : color * (contour ? 0.75 : 1.0);
        *pixel++ = static_cast<unsigned char>(std::clamp(color, 0.0, 255.0));
      }
    }
  }
  return picture;
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: DrapedTexture DEM OUT.png\n";
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

  vtkNew<vtkSkylineEnvironmentLight> sky;
  sky->SetRadiance(0.22, 0.28, 0.40);
  vtkNew<vtkSkylineSunLight> sun;
  sun->SetAzimuth(285.0);
  sun->SetElevation(20.0);
  sun->SetIrradiance(4.2, 3.7, 3.0);
  vtkNew<vtkHeightFieldIrradiance> light;
  light->SetInputConnection(reader->GetOutputPort());
  light->SetNumberOfAzimuths(64);
  light->AddLight(sun);
  light->AddLight(sky);

  vtkNew<vtkHeightFieldSurface> surface;
  surface->SetInputConnection(reader->GetOutputPort());
  double bounds[6]; // west, east, south, north
  terrain->GetBounds(bounds);
  vtkNew<vtkTextureMapToPlane> drape; // texture coordinates: 0 to 1, towards east and north
  drape->SetInputConnection(surface->GetOutputPort());
  drape->SetOrigin(bounds[0], bounds[2], 0.0);
  drape->SetPoint1(bounds[1], bounds[2], 0.0);
  drape->SetPoint2(bounds[0], bounds[3], 0.0);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(Paint(terrain));
  texture->InterpolateOn();
  texture->MipmapOn();

  vtkNew<vtkSkylineSoftShadowPolyDataMapper> mapper;
  mapper->SetInputConnection(drape->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->GetShader()->SetHeightFieldConnection(light->GetOutputPort());
  vtkNew<vtkActor> ground;
  ground->SetMapper(mapper);
  ground->SetTexture(texture);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(ground);
  renderer->GradientBackgroundOn();
  renderer->SetBackground(0.80, 0.86, 0.93);
  renderer->SetBackground2(0.45, 0.62, 0.85);

  const double middle = 0.5 * (bounds[0] + bounds[1]);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(middle, 0.52 * bounds[2] + 0.48 * bounds[3], 1400.0);
  camera->SetPosition(middle - 4000.0, bounds[2] - 13500.0, 11000.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->Zoom(1.25);
  vtkNew<vtkSkylineEGLWindow> window;
  window->SetMultiSamples(4);
  window->SetSize(800, 500);
  window->AddRenderer(renderer);
  renderer->ResetCameraClippingRange();

  vtkNew<vtkWindowToImageFilter> pixels;
  pixels->SetInput(window);
  pixels->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(pixels->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->Write();
  return EXIT_SUCCESS;
}
