// SPDX-License-Identifier: BSD-3-Clause
// Frame times of soft shadows, by pass, at the sizes of Snyder & Nowrouzezahrai (2008), table 1.
// CPU time of one core. Usage: SkylineSoftShadowTimes [largest size, default 1024]
#include "Harmonics/VisibilityAccumulator.h"
#include "HeightField/Normals.h"
#include "Horizon/HorizonPyramid.h"
#include "Reference/KeyLight.h"
#include "Reference/OracleTerrain.h"
#include "SizeArgument.h"

#include "hwy/targets.h"

#include <cstdio>
#include <ctime>
#include <iostream>

namespace
{

using namespace skyline;

constexpr int Repeats = 3;
constexpr std::ptrdiff_t ChunkLines = 64;

double Now() // CPU seconds of this thread
{
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1.0e-9 * static_cast<double>(time.tv_nsec);
}

/// Milliseconds of the passes of one frame.
struct Frame
{
  double Build = 0.0, Horizons = 0.0, Wedges = 0.0, Light = 0.0;
  double Sum() const { return this->Build + this->Horizons + this->Wedges + this->Light; }
};

/// One light: horizons in some azimuths, their transfer, and its product with the coefficients of
/// three colours.
Frame Shade(const HeightField& field, const HorizonSettings& settings, const Swath& swath,
  int azimuths, const std::vector<float>& east, const std::vector<float>& north)
{
  const Grid& grid = field.Posts();
  Frame frame;
  double start = Now();
  const auto lap = [&start](double& sum)
  {
    const double now = Now();
    sum += 1000.0 * (now - start);
    start = now;
  };
  const auto method = MakeHorizonMethod(field, settings);
  std::vector<float> values(static_cast<std::size_t>(grid.Columns * grid.Rows * 16));
  VisibilityAccumulator sums(
    { grid.Columns, grid.Rows, 4, values.data(), SkyPart::Upper }, east.data(), north.data());
  lap(frame.Build);
  std::vector<float> lines, run;
  for (const double azimuth : AzimuthsOf(swath, azimuths))
  {
    sums.Begin(azimuth, swath.Width / azimuths);
    method->SetAzimuth(grid, azimuth);
    method->Prepare(0, method->PrepareCount());
    lap(frame.Build);
    const RayFrame& ray = method->Frame();
    const std::ptrdiff_t stride = (ray.Lanes + 31) / 32 * 32 + 16;
    lines.resize(static_cast<std::size_t>(ChunkLines * stride));
    run.resize(static_cast<std::size_t>(ChunkLines));
    for (std::ptrdiff_t from = 0; from < ray.Lines; from += ChunkLines)
    {
      const std::ptrdiff_t count = std::min(ChunkLines, ray.Lines - from);
      method->Find(from, from + count, 0, ray.Lanes, lines.data(), stride);
      lap(frame.Horizons);
      for (std::ptrdiff_t i = 0; i < (ray.Columns ? ray.Lanes : count); ++i)
      {
        if (!ray.Columns)
        {
          sums.Add(ray.ImageLine(from + i), 0, ray.Lanes, lines.data() + i * stride);
          continue;
        }
        const std::ptrdiff_t column = ray.Reversed ? ray.ImageLine(from + count - 1) : from;
        for (std::ptrdiff_t k = 0; k < count; ++k)
        {
          run[static_cast<std::size_t>(k)] =
            lines[static_cast<std::size_t>((ray.Reversed ? count - 1 - k : k) * stride + i)];
        }
        sums.Add(i, column, count, run.data());
      }
      lap(frame.Wedges);
    }
  }
  sums.Finish(0, grid.Rows);
  lap(frame.Wedges);
  std::vector<float> colours(static_cast<std::size_t>(grid.Columns * grid.Rows * 3));
  for (std::size_t post = 0; post < colours.size() / 3; ++post)
  {
    for (std::size_t colour = 0; colour < 3; ++colour)
    {
      float sum = 0.0f;
      for (std::size_t c = 0; c < 16; ++c)
      {
        sum += values[16 * post + c] * static_cast<float>(c + colour);
      }
      colours[3 * post + colour] = sum;
    }
  }
  lap(frame.Light);
  volatile const float drop = colours[colours.size() / 2];
  static_cast<void>(drop);
  return frame;
}

void Print(std::ptrdiff_t size, const char* method, const char* light, const Frame& frame)
{
  std::printf("%5td  %-20s %-22s %8.1f %9.1f %7.1f %6.1f %8.1f\n", size, method, light, frame.Build,
    frame.Horizons, frame.Wedges, frame.Light, frame.Sum());
}

void Measure(std::ptrdiff_t size)
{
  const oracle::OracleField terrain = shapes::Fractal(size, size, 30.0, 1500.0);
  const HeightField field = testing::FieldOf(terrain);
  std::vector<float> east(terrain.Heights.size()), north(terrain.Heights.size());
  Gradients(field.Posts(), PostView<double>{ terrain.Heights.data(), 1, size }, 0, size,
    east.data(), north.data());
  struct
  {
    const char* Name;
    HorizonMethodKind Kind;
    bool Spline;
  } const methods[] = { { "pyramid", HorizonMethodKind::Pyramid, true },
    { "pyramid, max alone", HorizonMethodKind::Pyramid, false },
    { "exact", HorizonMethodKind::Exact, false } };
  for (const auto& method : methods)
  {
    HorizonSettings settings;
    settings.Method = method.Kind;
    settings.Pyramid.Spline = method.Spline;
    const auto best = [&](const Swath& swath, int azimuths)
    {
      Frame least = Shade(field, settings, swath, azimuths, east, north);
      for (int repeat = 1; repeat < Repeats; ++repeat)
      {
        const Frame frame = Shade(field, settings, swath, azimuths, east, north);
        least = frame.Sum() < least.Sum() ? frame : least;
      }
      return least;
    };
    const Swath key = SwathOf({ 2.3, 0.5, 0.15 });
    Print(size, method.Name, "key, 3 azimuths", best(key, 3));
    Print(size, method.Name, "circle, 16 azimuths", best(Swath(), 16));
    Print(size, method.Name, "circle, 32 azimuths", best(Swath(), 32));
  }
}

} // namespace

int main(int argc, char** argv)
{
  const std::ptrdiff_t largest = SizeArgument(argc, argv, 1, 1024);
  if (largest < 64 || largest > 8192)
  {
    std::cerr << "usage: SkylineSoftShadowTimes [largest size, 64 to 8192]" << std::endl;
    return 2;
  }
  const auto targets = hwy::SupportedTargets() & (HWY_TARGETS);
  std::cout << "vectors of " << hwy::TargetName(targets & -targets) << "\n"
            << "fractal, k = 4, o = 2, transfer of order 4; milliseconds of one core\n"
            << " size  horizons             light                     build  horizons  wedges"
            << "  light      sum" << std::endl;
  for (std::ptrdiff_t size = std::min<std::ptrdiff_t>(256, largest); size <= largest; size *= 2)
  {
    Measure(size);
  }
  return 0;
}
