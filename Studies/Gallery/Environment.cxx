// SPDX-License-Identifier: BSD-3-Clause
#include "Environment.h"

#include "Harmonics/LightFit.h"
#include "Sky/LightAccumulator.h"
#include "Sky/LightMap.h"

#include <algorithm>
#include <cmath>

namespace skyline
{
namespace gallery
{

namespace
{

constexpr std::ptrdiff_t Columns = 128, Rows = 64;
constexpr int DirectAzimuths = 96;
constexpr int SeriesAzimuths = 32; // THESIS, chapter 6

} // namespace

Environment::Environment(double brightness)
  : Pixels(static_cast<std::size_t>(3 * Columns * Rows), 0.0f)
{
  const LightMap map = ViewTopDown(this->Pixels.data(), Columns, Rows);
  double level = 0.0;
  for (std::ptrdiff_t row = 0; row < Rows / 2; ++row)
  {
    for (std::ptrdiff_t column = 0; column < Columns; ++column)
    {
      const LightMapDirection d = PixelDirection(map, row, column);
      const double low = std::exp(-5.0 * d.Z);
      const double glow = 4.0 * low * std::pow(0.5 - 0.5 * d.X, 3.0);
      const double sky[3] = { 0.35 + 0.3 * low + 1.3 * glow, 0.50 + 0.25 * low + 0.8 * glow,
        0.85 + 0.1 * low + 0.35 * glow };
      float* pixel = this->Pixels.data() + 3 * (row * Columns + column);
      std::copy_n(sky, 3, pixel);
      level +=
        PixelSolidAngle(map, row) * d.Z * (0.2126 * sky[0] + 0.7152 * sky[1] + 0.0722 * sky[2]);
    }
  }
  for (float& value : this->Pixels)
  {
    value = static_cast<float>(static_cast<double>(value) * brightness / level);
  }
}

std::vector<float> Environment::Direct(const Scene& scene) const
{
  const LightMap map = ViewTopDown(this->Pixels.data(), Columns, Rows);
  std::vector<double> azimuths;
  azimuths.reserve(DirectAzimuths);
  for (int k = 0; k < DirectAzimuths; ++k)
  {
    azimuths.push_back(2.0 * Pi * k / DirectAzimuths);
  }
  std::vector<float> rgb(3 * scene.East.size(), 0.0f);
  LightAccumulator sums(scene.Posts.Columns, scene.Posts.Rows, { TurnedLightMap{ map } }, azimuths,
    LightAccumulator::Options(), scene.East.data(), scene.North.data(), rgb.data());
  const HorizonsAt horizons = ExactHorizons(scene);
  for (const double azimuth : sums.HorizonAzimuths())
  {
    std::vector<float> slopes = horizons(azimuth);
    for (float& slope : slopes)
    {
      slope = std::tan(slope);
    }
    sums.Begin(azimuth, 2.0 * Pi / DirectAzimuths);
    for (std::ptrdiff_t row = 0; row < scene.Posts.Rows; ++row)
    {
      sums.Add(row, 0, scene.Posts.Columns, slopes.data() + row * scene.Posts.Columns);
    }
  }
  sums.Finish(0, scene.Posts.Rows);
  return rgb;
}

std::vector<float> Environment::Series(
  const Scene& scene, const std::function<std::vector<float>(const Light16&)>& shade) const
{
  const std::vector<double> light =
    ProjectLightMap(ViewTopDown(this->Pixels.data(), Columns, Rows));
  std::vector<float> rgb(3 * scene.East.size());
  for (std::size_t color = 0; color < 3; ++color)
  {
    Light16 part{};
    std::copy_n(light.begin() + static_cast<std::ptrdiff_t>(16 * color), 16, part.begin());
    const std::vector<float> shading = shade(part);
    for (std::size_t post = 0; post < shading.size(); ++post)
    {
      rgb[3 * post + color] = shading[post];
    }
  }
  return rgb;
}

std::vector<float> Environment::Published(const Scene& scene, const HorizonsAt& horizons) const
{
  const std::vector<float> visibility =
    PublishedVisibility(scene.East.size(), horizons, Swath(), SeriesAzimuths);
  return this->Series(
    scene, [&](const Light16& light) { return PublishedShading(scene, visibility, light); });
}

std::vector<float> Environment::Transferred(const Scene& scene) const
{
  return this->Series(scene,
    [&](const Light16& light)
    {
      Light16 fitted{}; // the map is black below the horizon, so it is projected as a sky
      FitLight(Swath(), 4, light.data(), fitted.data());
      return TransferShading(scene, ExactHorizons(scene), Swath(), SeriesAzimuths, fitted);
    });
}

} // namespace gallery
} // namespace skyline
