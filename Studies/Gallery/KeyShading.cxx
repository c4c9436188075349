// SPDX-License-Identifier: BSD-3-Clause
#include "KeyShading.h"

#include "Harmonics/HarmonicProduct.h"
#include "Harmonics/SphericalHarmonics.h"
#include "Harmonics/VisibilityAccumulator.h"
#include "Reference/VisibilityWedge.h"
#include "Sun/SunDisc.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace skyline
{
namespace gallery
{

namespace
{

constexpr int Bands = 4;
constexpr std::size_t Count = 16;

/// Number of normals, half a degree apart, among which the brightest one is searched, from level to
/// vertical.
constexpr int Tilts = 180;

/// The coefficients of the clamped cosine around the normal of a plane with the given gradient.
Light16 CosineOf(double east, double north)
{
  double zonal[Bands];
  for (int l = 0; l < Bands; ++l)
  {
    zonal[l] = ClampedCosineZonal(l);
  }
  const double up = 1.0 / std::sqrt(1.0 + east * east + north * north);
  Light16 cosine{};
  RotateZonal(Bands, zonal, -east * up, -north * up, up, cosine.data());
  return cosine;
}

/// The gradient of the plane that faces a direction.
std::array<double, 2> GradientFacing(double azimuth, double elevation)
{
  const double slope = -1.0 / std::tan(elevation);
  return { { slope * std::sin(azimuth), slope * std::cos(azimuth) } };
}

Light16 Scaled(Light16 light, double factor)
{
  for (double& coefficient : light)
  {
    coefficient *= factor;
  }
  return light;
}

} // namespace

HorizonsAt HorizonsOf(const Scene& scene, const HorizonSettings& settings)
{
  const std::shared_ptr<HorizonMethod> method = MakeHorizonMethod(scene.Field, settings);
  return [method, &scene](double azimuth)
  {
    std::vector<float> horizons = testing::Slopes(*method, scene.Posts, azimuth * DegreesPerRadian);
    for (float& horizon : horizons)
    {
      horizon = std::atan(std::max(horizon, 0.0f));
    }
    return horizons;
  };
}

HorizonsAt ExactHorizons(const Scene& scene)
{
  return HorizonsOf(scene, HorizonSettings());
}

HorizonsAt PyramidHorizons(const Scene& scene, double levelStep, double levelOffset, bool spline)
{
  HorizonSettings settings;
  settings.Method = HorizonMethodKind::Pyramid;
  settings.Pyramid.LevelStep = levelStep;
  settings.Pyramid.LevelOffset = levelOffset;
  settings.Pyramid.Spline = spline;
  return HorizonsOf(scene, settings);
}

std::vector<float> PublishedVisibility(
  std::size_t posts, const HorizonsAt& horizons, const Swath& swath, int azimuths)
{
  const double width = swath.Width / azimuths;
  static WedgeTables tables; // only one thread draws the figures
  const std::shared_ptr<const WedgeTable> table = tables.Get(Bands, width);
  const std::vector<double> middles = AzimuthsOf(swath, azimuths);
  std::vector<double> sums(Count * posts, 0.0);
  const std::vector<float> first = horizons(middles.front());
  std::vector<float> before = first;
  const auto add = [&](double azimuth, const std::vector<float>& from, const std::vector<float>& to)
  {
    for (std::size_t post = 0; post < posts; ++post)
    {
      table->AddInterior(azimuth, from[post], to[post], sums.data() + Count * post);
    }
  };
  for (std::size_t k = 1; k < middles.size(); ++k)
  {
    std::vector<float> here = horizons(middles[k]);
    add(middles[k - 1], before, here);
    before = std::move(here);
  }
  if (swath.IsCircle())
  {
    add(middles.back(), before, first);
  }
  else
  {
    for (std::size_t post = 0; post < posts; ++post)
    {
      table->AddStart(middles.front(), first[post], sums.data() + Count * post);
      table->AddEnd(middles.back(), before[post], sums.data() + Count * post);
    }
  }
  return { sums.begin(), sums.end() };
}

std::vector<float> PublishedShading(
  const Scene& scene, const std::vector<float>& visibility, const Light16& light)
{
  std::array<double, Count * Count> matrix{};
  HarmonicProduct::ForBands(Bands).Matrix(light.data(), matrix.data());
  std::vector<float> shading(scene.East.size());
  for (std::size_t post = 0; post < shading.size(); ++post)
  {
    const Light16 cosine = CosineOf(scene.East[post], scene.North[post]);
    const float* seen = visibility.data() + Count * post;
    double sum = 0.0;
    for (std::size_t i = 0; i < Count; ++i)
    {
      double lit = 0.0;
      for (std::size_t j = 0; j < Count; ++j)
      {
        lit += matrix[Count * i + j] * static_cast<double>(seen[j]);
      }
      sum += cosine[i] * lit;
    }
    shading[post] = static_cast<float>(sum);
  }
  return shading;
}

Light16 PublishedUnit(const Light16& light, const Swath& swath, int azimuths)
{
  const std::vector<float> open = PublishedVisibility(
    1, [](double) { return std::vector<float>{ 0.0f }; }, swath, azimuths);
  const std::vector<double> seen(open.begin(), open.end());
  Light16 lit{};
  HarmonicProduct::ForBands(Bands).Product(light.data(), seen.data(), lit.data());
  double brightest = 0.0;
  for (int k = 1; k < Tilts; ++k)
  {
    const auto gradient = GradientFacing(swath.Azimuth, 0.5 * Pi * k / Tilts);
    const Light16 cosine = CosineOf(gradient[0], gradient[1]);
    double sum = 0.0;
    for (std::size_t i = 0; i < Count; ++i)
    {
      sum += cosine[i] * lit[i];
    }
    brightest = std::max(brightest, sum);
  }
  return Scaled(light, 1.0 / brightest);
}

std::vector<float> TransferShading(const Scene& scene, const HorizonsAt& horizons,
  const Swath& swath, int azimuths, const Light16& light)
{
  const Grid& posts = scene.Posts;
  std::vector<float> transfer(Count * scene.East.size());
  VisibilityAccumulator sums({ posts.Columns, posts.Rows, Bands, transfer.data(), SkyPart::Upper },
    scene.East.data(), scene.North.data());
  for (const double azimuth : AzimuthsOf(swath, azimuths))
  {
    std::vector<float> slopes = horizons(azimuth);
    for (float& slope : slopes)
    {
      slope = std::tan(slope);
    }
    sums.Begin(azimuth, swath.Width / azimuths);
    for (std::ptrdiff_t row = 0; row < posts.Rows; ++row)
    {
      sums.Add(row, 0, posts.Columns, slopes.data() + row * posts.Columns);
    }
  }
  sums.Finish(0, posts.Rows);
  std::vector<float> shading(scene.East.size());
  for (std::size_t post = 0; post < shading.size(); ++post)
  {
    double sum = 0.0;
    for (std::size_t k = 0; k < Count; ++k)
    {
      sum += light[k] * static_cast<double>(transfer[Count * post + k]);
    }
    shading[post] = static_cast<float>(sum);
  }
  return shading;
}

Light16 TransferUnit(const Light16& light, const Swath& swath)
{
  constexpr int azimuths = 64;
  double brightest = 0.0;
  for (int k = 1; k < Tilts; ++k)
  {
    const auto gradient = GradientFacing(swath.Azimuth, 0.5 * Pi * k / Tilts);
    const auto east = static_cast<float>(gradient[0]), north = static_cast<float>(gradient[1]);
    std::array<float, Count> transfer{};
    VisibilityAccumulator sums({ 1, 1, Bands, transfer.data(), SkyPart::Upper }, &east, &north);
    for (const double azimuth : AzimuthsOf(swath, azimuths))
    {
      const float open = 0.0f;
      sums.Begin(azimuth, swath.Width / azimuths);
      sums.Add(0, 0, 1, &open);
    }
    sums.Finish(0, 1);
    double sum = 0.0;
    for (std::size_t i = 0; i < Count; ++i)
    {
      sum += light[i] * static_cast<double>(transfer[i]);
    }
    brightest = std::max(brightest, sum);
  }
  return Scaled(light, 1.0 / brightest);
}

std::vector<float> DirectShading(const Scene& scene, const KeyLight& light, int azimuths)
{
  const SunDisc disc{ light.Azimuth, light.Elevation, light.Radius };
  const double half = 0.5 * SwathOf(light).Width;
  const HorizonsAt horizons = ExactHorizons(scene);
  std::vector<double> sums(scene.East.size(), 0.0);
  for (int k = 0; k < azimuths; ++k)
  {
    // The azimuths are at the sines of even steps, so that the chords become shorter as in a
    // circle.
    const double turn = Pi * ((k + 0.5) / azimuths - 0.5);
    const double offset = half * std::sin(turn);
    const double weight = half * std::cos(turn) * Pi / azimuths;
    const DiscChord chord = ChordOfDisc(disc, offset); // relative to the disc's centre
    const double bottom = light.Elevation + chord.Low, top = light.Elevation + chord.High;
    const double azimuth = light.Azimuth + offset;
    const std::vector<float> low = horizons(azimuth);
    for (std::size_t post = 0; post < sums.size(); ++post)
    {
      const double east = scene.East[post], north = scene.North[post];
      const double up = 1.0 / std::sqrt(1.0 + east * east + north * north);
      const double ahead = -up * (east * std::sin(azimuth) + north * std::cos(azimuth));
      const double plane = std::atan2(-ahead, up);
      const double from = std::max({ bottom, static_cast<double>(low[post]), plane, 0.0 });
      if (from >= top)
      {
        continue;
      }
      // The integral of (up sin u + ahead cos u) cos u.
      const auto whole = [&](double u)
      { return 0.5 * (up * std::sin(u) * std::sin(u) + ahead * (u + std::sin(u) * std::cos(u))); };
      sums[post] += weight * (whole(top) - whole(from));
    }
  }
  return { sums.begin(), sums.end() };
}

Light16 PeakLight(double azimuth, double elevation)
{
  Light16 light{};
  EvaluateHarmonics(Bands, std::sin(azimuth) * std::cos(elevation),
    std::cos(azimuth) * std::cos(elevation), std::sin(elevation), light.data());
  return light;
}

} // namespace gallery
} // namespace skyline
