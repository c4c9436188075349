// SPDX-License-Identifier: BSD-3-Clause
// Frame times of moving terrain on the graphics processor, by pass, compared with the host. Sizes
// are those of Snyder & Nowrouzezahrai (2008), table 1. Usage: SkylineGpuTimes [largest size,
// default 1024]
#include "vtkOpenGLHeightFieldDevice.h"
#include "vtkOpenGLHeightFieldIrradiance.h"

#include "vtkSkylineKeyLight.h"

#include "Reference/FieldImage.h"
#include "Reference/Shapes.h"
#include "SizeArgument.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <numeric>

namespace
{

constexpr int Repeats = 2;

double Now()
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return 1000.0 * std::chrono::duration<double>(now).count();
}

/// Milliseconds of an update after a change of the heights: a moving wave.
double Update(vtkHeightFieldIrradiance* filter, vtkImageData* image, int frame)
{
  vtkDataArray* heights = image->GetPointData()->GetScalars();
  for (vtkIdType post = 0; post < heights->GetNumberOfTuples(); ++post)
  {
    heights->SetComponent(post, 0, heights->GetComponent(post, 0) + (post + frame) % 3 - 1.0);
  }
  image->Modified();
  const double start = Now();
  filter->Update();
  return Now() - start;
}

void Measure(vtkOpenGLHeightFieldDevice* device, std::ptrdiff_t size, bool spline, int azimuths)
{
  const auto image =
    skyline::testing::ImageOf<vtkDoubleArray>(skyline::shapes::Fractal(size, size, 30.0, 1500.0));
  vtkNew<vtkSkylineKeyLight> key;
  vtkNew<vtkOpenGLHeightFieldIrradiance> gpu;
  gpu->SetDevice(device);
  gpu->ReadBackOff();
  vtkNew<vtkHeightFieldIrradiance> host;
  host->SetLightMethodToHarmonics();
  for (vtkHeightFieldIrradiance* filter :
    { static_cast<vtkHeightFieldIrradiance*>(gpu), host.GetPointer() })
  {
    filter->SetInputData(image);
    filter->SetMethodToPyramid();
    filter->SetLevelSpline(spline);
    filter->SetNumberOfAzimuths(azimuths);
    filter->AddLight(key);
  }
  Update(gpu, image, 0);  // builds the shaders
  gpu->MeasurePassesOn(); // each pass then ends before the next one begins
  double whole = 0.0;
  double ofHost = 0.0;
  std::array<double, 5> best{};
  for (int repeat = 0; repeat < Repeats; ++repeat)
  {
    const double frame = Update(gpu, image, repeat);
    const double hosts = Update(host, image, repeat + 1);
    ofHost = repeat == 0 ? hosts : std::min(ofHost, hosts);
    if (repeat == 0 || frame < whole)
    {
      whole = frame;
      gpu->GetPassSeconds(best.data());
    }
  }
  const double passes = std::accumulate(best.begin(), best.end(), 0.0);
  std::printf("%5td  %-7s %8d %8.1f %9.1f %7.1f %6.1f %8.1f %8.1f %8.1f\n", size,
    spline ? "spline" : "max", azimuths, 1000.0 * best[0], 1000.0 * best[1], 1000.0 * best[2],
    1000.0 * best[3], 1000.0 * passes, whole, ofHost);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  const std::ptrdiff_t largest = skyline::SizeArgument(argc, argv, 1, 1024);
  if (largest < 64 || largest > 8192)
  {
    std::cerr << "usage: SkylineGpuTimes [largest size, 64 to 8192]" << std::endl;
    return 2;
  }
  vtkNew<vtkOpenGLHeightFieldDevice> device;
  if (!device->IsAvailable())
  {
    std::cerr << "no OpenGL context: " << device->GetReason() << std::endl;
    return 1;
  }
  std::cout
    << "device: " << device->GetName() << "\n"
    << "fractal, pyramid k = 4, o = 2, irradiance by transfer of order 4; milliseconds\n"
    << "load: upload and pyramid; frame: a whole update, no read-back; host: the same on the host\n"
    << " size  levels  azimuths     load  horizons  wedges  light   passes    frame     host"
    << std::endl;
  for (std::ptrdiff_t size = std::min<std::ptrdiff_t>(256, largest); size <= largest; size *= 2)
  {
    for (const bool spline : { true, false })
    {
      for (const int azimuths : { 3, 16, 32 })
      {
        Measure(device, size, spline, azimuths);
      }
    }
  }
  return 0;
}
