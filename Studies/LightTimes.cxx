// SPDX-License-Identifier: BSD-3-Clause
// Prints the times in Documentation/irradiance.md and shadow-height.md as comma-separated values.
// Times are CPU seconds of all threads. A frame is a whole filter, from heights to its array.
//
//   SkylineLightTimes [largest side in posts, default 1024] [largest on the graphics processor, default 512]
#include "Reference/FieldImage.h"
#include "Reference/Shapes.h"
#include "SizeArgument.h"

#include "vtkHeightFieldHorizon.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkHeightFieldSkyView.h"
#include "vtkOpenGLHeightFieldDevice.h"
#include "vtkOpenGLHeightFieldHorizon.h"
#include "vtkOpenGLHeightFieldShadowHeight.h"
#include "vtkSkylineEnvironmentLight.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

namespace
{

using namespace skyline;
using namespace skyline::testing;

double CpuSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// A dim sky with a sun of half a degree and 1e5 times the mean radiance.
vtkSmartPointer<vtkImageData> SunnySky()
{
  constexpr int columns = 1024, rows = 512;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, 1);
  vtkNew<vtkFloatArray> radiance;
  radiance->SetName("Radiance");
  radiance->SetNumberOfComponents(3);
  radiance->SetNumberOfTuples(static_cast<vtkIdType>(columns) * rows);
  radiance->Fill(1.0);
  radiance->SetTuple3(static_cast<vtkIdType>(columns) * 340 + 700, 1.0e5, 0.9e5, 0.8e5);
  image->GetPointData()->SetScalars(radiance);
  return image;
}

oracle::OracleField Spikes(std::ptrdiff_t side)
{
  oracle::OracleField field = shapes::Plane(side, side, 30.0, 0.0, 0.0);
  shapes::Random random(5);
  for (std::ptrdiff_t k = 0; k < side * side / 100; ++k)
  {
    const std::ptrdiff_t column = random.Below(side);
    field.At(column, random.Below(side)) = 300.0;
  }
  return field;
}

void Print(const char* what, const char* scene, int side, int azimuths, vtkAlgorithm* filter)
{
  filter->Modified();
  const double begin = CpuSeconds();
  filter->Update();
  const double seconds = CpuSeconds() - begin;
  std::printf("%s,%s,%d,%d,%.3f,%.2f\n", what, scene, side, azimuths, seconds,
    1.0e9 * seconds / (static_cast<double>(side) * side * azimuths));
  std::fflush(stdout);
}

void OnHost(const char* scene, vtkImageData* image, int azimuths)
{
  const int side = image->GetDimensions()[0];
  vtkNew<vtkHeightFieldSkyView> uniform;
  uniform->SetInputData(image);
  uniform->SetNumberOfAzimuths(azimuths);
  Print("uniform", scene, side, azimuths, uniform);
  vtkNew<vtkSkylineEnvironmentLight> sky;
  sky->SetImage(SunnySky());
  vtkNew<vtkHeightFieldIrradiance> environment;
  environment->SetInputData(image);
  environment->SetNumberOfAzimuths(azimuths);
  environment->RefineOff();
  environment->AddLight(sky);
  Print("environment", scene, side, azimuths, environment);
}

/// Measures the published sweeps and shadow heights, with a device also on the graphics processor.
void Sweeps(
  const char* scene, vtkImageData* image, int azimuths, vtkOpenGLHeightFieldDevice* device)
{
  const int side = image->GetDimensions()[0];
  vtkNew<vtkHeightFieldHorizon> horizon;
  vtkNew<vtkHeightFieldShadowHeight> shadow;
  std::vector<vtkSmartPointer<vtkHeightFieldHorizon>> horizons{ horizon.Get() };
  std::vector<vtkSmartPointer<vtkHeightFieldShadowHeight>> shadows{ shadow.Get() };
  if (device)
  {
    vtkNew<vtkOpenGLHeightFieldHorizon> otherHorizon;
    otherHorizon->SetDevice(device);
    horizons.emplace_back(otherHorizon);
    vtkNew<vtkOpenGLHeightFieldShadowHeight> otherShadow;
    otherShadow->SetDevice(device);
    shadows.emplace_back(otherShadow);
  }
  for (std::size_t k = 0; k < horizons.size(); ++k)
  {
    horizons[k]->SetInputData(image);
    horizons[k]->SetMethodToSweep();
    horizons[k]->SetNumberOfAzimuths(azimuths);
    Print(k == 0 ? "sweep" : "sweep gpu", scene, side, azimuths, horizons[k]);
    shadows[k]->SetInputData(image);
    shadows[k]->SetSunAzimuth(200.0);
    shadows[k]->SetSunElevation(15.0);
    shadows[k]->SetMethodToSweep();
    Print(k == 0 ? "shadow sweep" : "shadow sweep gpu", scene, side, 1, shadows[k]);
    shadows[k]->SetMethodToExact();
    Print(k == 0 ? "shadow exact" : "shadow exact gpu", scene, side, 1, shadows[k]);
  }
}

} // namespace

int main(int argc, char** argv)
{
  const int largest = SizeArgument(argc, argv, 1, 1024);
  const int most = SizeArgument(argc, argv, 2, 512);
  if (largest < 256 || most < 0)
  {
    std::fprintf(stderr,
      "usage: SkylineLightTimes [largest size, 256 or more [largest size of sweeps "
      "on the GPU]]\n");
    return 2;
  }
  std::printf("what,scene,posts per side,azimuths,CPU seconds,ns per post and azimuth\n");
  vtkNew<vtkOpenGLHeightFieldDevice> device;
  const bool there = device->IsAvailable();
  for (int side = 256; side <= largest; side *= 2)
  {
    const struct
    {
      const char* Name;
      oracle::OracleField Field;
    } scenes[2] = { { "fractal", shapes::Fractal(side, side, 30.0, 1500.0, 7) },
      { "spikes", Spikes(side) } };
    for (const auto& scene : scenes)
    {
      const auto image = ImageOf<vtkFloatArray>(scene.Field);
      OnHost(scene.Name, image, side > 2048 ? 4 : 16);
      Sweeps(scene.Name, image, 4, there && side <= most ? device.Get() : nullptr);
    }
  }
  const auto image = ImageOf<vtkFloatArray>(shapes::Fractal(512, 512, 30.0, 1500.0, 7));
  for (const int azimuths : { 8, 32, 64, 128 })
  {
    OnHost("fractal", image, largest < 512 ? 8 : azimuths);
  }
  // The parts of a frame: on a field of 16 x 16 posts, the tables take all of the time.
  const auto tiny = ImageOf<vtkFloatArray>(shapes::Fractal(16, 16, 30.0, 1500.0, 7));
  for (const int azimuths : { 16, 128 })
  {
    OnHost("tables", tiny, azimuths);
    vtkNew<vtkHeightFieldHorizon> horizon;
    horizon->SetInputData(image);
    horizon->SetNumberOfAzimuths(azimuths);
    Print("horizon alone", "fractal", 512, azimuths, horizon);
  }
  return 0;
}
