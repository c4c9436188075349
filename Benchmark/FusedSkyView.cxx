// SPDX-License-Identifier: BSD-3-Clause
#include "FusedSkyView.h"

#include "HorizonDriver.h"
#include "Measure.h"
#include "SceneImage.h"
#include "Sky/SkyAccumulator.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cmath>
#include <memory>

namespace skyline
{
namespace benchmark
{

namespace
{

// The error of the sky view factor. The reference value is the oracle's sum over the horizons of
// `truth`.
double SkyViewRmse(const Scene& scene, const ReferenceHorizons& truth, const float* found)
{
  constexpr std::size_t most = 256; // the oracle's sums are slow
  constexpr int steps = 500;
  double squares = 0.0;
  const std::size_t count = std::min(most, truth.Posts.size());
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::ptrdiff_t post = truth.Posts[i];
    std::vector<double> slopes;
    for (std::size_t azimuth = 0; azimuth < truth.Azimuths.size(); ++azimuth)
    {
      slopes.push_back(std::tan(truth.Elevation(azimuth, i) * RadiansPerDegree));
    }
    double east = 0.0;
    double north = 0.0;
    oracle::Gradient(
      scene.Field, post % scene.Field.Columns, post / scene.Field.Columns, east, north);
    const double error =
      found[post] - oracle::SkyFromHorizons(slopes, east, north, steps).SkyViewFactor;
    squares += error * error;
  }
  return std::sqrt(squares / static_cast<double>(count));
}

} // namespace

Result MeasureFusedSkyView(const Scene& scene, const ReferenceHorizons& truth, int repeats)
{
  const vtkSmartPointer<vtkImageData> image = ImageOf(scene.Field);
  vtkDataArray* heights = image->GetPointData()->GetScalars();
  const auto posts = static_cast<std::size_t>(image->GetNumberOfPoints());
  std::vector<double> azimuths = truth.Azimuths;
  for (double& azimuth : azimuths)
  {
    azimuth *= RadiansPerDegree;
  }
  const double width = 2.0 * Pi / static_cast<double>(truth.Azimuths.size());

  RepeatTimer timer;
  const PeakMemory memory;
  std::unique_ptr<float[]> sky;
  for (int repeat = 0; repeat < repeats; ++repeat)
  {
    const Seconds start = Now();
    sky.reset(); // the results of the previous repeat must not count
    sky.reset(new float[4 * posts]);
    HorizonInput surface(image, heights);
    HorizonDriver driver(surface, HorizonSettings());
    const std::unique_ptr<float[]> gradients(new float[2 * posts]);
    surface.FillGradients(gradients.get(), gradients.get() + posts);
    SkyBuffers buffers;
    buffers.SkyViewFactor.Values = sky.get();
    buffers.SkyViewFactorHorizontal.Values = sky.get() + posts;
    buffers.VisibleSkyFraction.Values = sky.get() + 2 * posts;
    buffers.PositiveOpenness.Values = sky.get() + 3 * posts;
    SkyAccumulator accumulator(
      scene.Field.Columns, buffers, gradients.get(), gradients.get() + posts);
    driver.Run(azimuths, width, accumulator);
    const Seconds end = Now();
    // The driver measures the share of the preparation itself.
    const Seconds total{ end.Cpu - start.Cpu, end.Wall - start.Wall };
    const double share = driver.PrepareSeconds / total.Wall;
    timer.Add({ share * total.Cpu, share * total.Wall },
      { (1.0 - share) * total.Cpu, (1.0 - share) * total.Wall });
  }
  Result result;
  result.FloatsPerPost = memory.FloatsPerPost(static_cast<double>(posts));
  timer.Report(result, static_cast<double>(posts * truth.Azimuths.size()));
  result.SkyViewRmse = SkyViewRmse(scene, truth, sky.get());
  result.Ran = true;
  return result;
}

} // namespace benchmark
} // namespace skyline
