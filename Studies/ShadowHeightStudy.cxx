// SPDX-License-Identifier: BSD-3-Clause
// Prints the figures of Documentation/shadow-height.md. Times are CPU times of one thread.
//
//   SkylineShadowHeightStudy [largest side in posts, default 2048]
#include "Reference/OracleTerrain.h"
#include "ShadowHeight/ShadowHeight.h"
#include "ShadowHeight/ShadowHeightSweep.h"
#include "SizeArgument.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <vector>

namespace
{

using namespace skyline;

constexpr double Azimuths[] = { 0.0, 20.0, 110.0, 200.0, 290.0 };

double Seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::unique_ptr<HorizonMethod> Make(int kind, const HeightField& posts, double slope)
{
  if (kind == 0)
  {
    return std::make_unique<ShadowHeightSweep>(posts, slope);
  }
  if (kind == 1)
  {
    return std::make_unique<ShadowHeightExact>(posts, slope, 0.0);
  }
  return MakeHorizonMethod(posts, {});
}

// Nanoseconds per post for everything, as the mean of the azimuths. The better of two runs.
double Cost(int kind, const HeightField& posts, double slope)
{
  const Grid& grid = posts.Posts();
  double sum = 0.0;
  for (const double azimuth : Azimuths)
  {
    double best = 1e9;
    for (int run = 0; run < 2; ++run)
    {
      const double start = Seconds();
      const auto method = Make(kind, posts, slope);
      method->SetAzimuth(grid, azimuth * RadiansPerDegree);
      method->Prepare(0, method->PrepareCount());
      const RayFrame& frame = method->Frame();
      const std::ptrdiff_t stride = (frame.Lanes + 31) / 32 * 32;
      std::vector<float> out(static_cast<std::size_t>(64 * stride));
      for (std::ptrdiff_t line = 0; line < frame.Lines; line += 64)
      {
        method->Find(line, std::min(line + 64, frame.Lines), 0, frame.Lanes, out.data(), stride);
      }
      best = std::min(best, Seconds() - start);
    }
    sum += best;
  }
  return sum / 5.0 * 1e9 / static_cast<double>(grid.Columns * grid.Rows);
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

void Times(const char* name, const oracle::OracleField& field)
{
  const HeightField posts = testing::FieldOf(field);
  for (const double elevation : { 3.0, 15.0, 45.0 })
  {
    const double slope = ShadowSlope(elevation * RadiansPerDegree);
    std::printf("| %s | %td | %.0f | %.1f | %.1f | %.1f |\n", name, field.Columns, elevation,
      Cost(0, posts, slope), Cost(1, posts, slope), Cost(2, posts, slope));
    std::fflush(stdout);
  }
}

// The errors of the published recurrence. Shadow heights below the ground count as the ground.
void Misses(const char* name, const oracle::OracleField& field, double elevation)
{
  const HeightField posts = testing::FieldOf(field);
  const double slope = ShadowSlope(elevation * RadiansPerDegree);
  const double base = testing::BaseOf(field);
  const auto sweep = Make(0, posts, slope), exact = Make(1, posts, slope);
  double square = 0.0, wrong = 0.0;
  std::vector<double> misses;
  for (double azimuth = 5.0; azimuth < 360.0; azimuth += 30.0)
  {
    const std::vector<float> found = testing::Slopes(*sweep, posts.Posts(), azimuth);
    const std::vector<float> truth = testing::Slopes(*exact, posts.Posts(), azimuth);
    for (std::size_t post = 0; post < found.size(); ++post)
    {
      const double ground = field.Heights[post] - base;
      const double miss =
        std::abs(std::max<double>(found[post], ground) - std::max<double>(truth[post], ground));
      square += miss * miss;
      wrong += (found[post] > ground) != (truth[post] > ground) ? 1.0 : 0.0;
      misses.push_back(miss);
    }
  }
  std::sort(misses.begin(), misses.end());
  const auto count = static_cast<double>(misses.size());
  std::printf("| %s | %.0f | %.2f | %.1f | %.1f | %.1f %% |\n", name, elevation,
    std::sqrt(square / count), misses[misses.size() * 999 / 1000], misses.back(),
    100.0 * wrong / count);
}

} // namespace

int main(int argc, char** argv)
{
  const std::ptrdiff_t largest = SizeArgument(argc, argv, 1, 2048);
  if (largest < 256)
  {
    std::fprintf(stderr, "usage: SkylineShadowHeightStudy [largest size, 256 or more]\n");
    return 2;
  }
  std::printf("ns per post | side | elevation | published | exact | exact horizon\n");
  for (std::ptrdiff_t side = 256; side <= largest; side *= 2)
  {
    Times("fractal", shapes::Fractal(side, side, 30.0, 1500.0, 7));
    Times("spikes", Spikes(side));
  }
  std::printf("published against exact | elevation | rmse m | 99.9 %% | greatest | posts wrong\n");
  for (const double elevation : { 5.0, 15.0, 45.0 })
  {
    Misses("fractal", shapes::Fractal(512, 512, 30.0, 1500.0, 7), elevation);
    Misses("houses", shapes::RandomBoxes(400, 400, 0.5, 240, 20, 12.0, 5), elevation);
  }
  return 0;
}
