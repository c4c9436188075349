// SPDX-License-Identifier: BSD-3-Clause
#include "LampShading.h"

#include "Color/ToneMap.h"
#include "Reference/LampPyramid.h"

#include "vtkSMPTools.h"

#include <memory>

namespace skyline
{
namespace gallery
{

namespace
{

constexpr double LevelOffset = 4.0; // THESIS, captions of the figures 6.3 to 6.5
constexpr vtkIdType RowsAtOnce = 8;

Lamp LampOf(const Scene& scene, const ColoredLamp& colored)
{
  Lamp lamp;
  lamp.X = colored.Ball.Centre.X;
  lamp.Y = colored.Ball.Centre.Y;
  lamp.Z = colored.Ball.Centre.Z - testing::BaseOf(scene.Heights);
  lamp.Radius = colored.Ball.Radius;
  lamp.Radiance = colored.Radiance;
  return lamp;
}

} // namespace

std::vector<float> DirectLamps(const Scene& scene, const std::vector<ColoredLamp>& lamps)
{
  std::vector<float> rgb(3 * scene.East.size(), 0.0f);
  for (const ColoredLamp& colored : lamps)
  {
    const Lamp lamp = LampOf(scene, colored);
    vtkSMPTools::For(0, scene.Posts.Rows, RowsAtOnce,
      [&](vtkIdType begin, vtkIdType end)
      {
        AddLampIrradiance(scene.Terrain, scene.Posts, scene.East.data(), scene.North.data(), lamp,
          scene.Settings, begin, end, rgb.data());
      });
  }
  return rgb;
}

std::vector<float> HarmonicLamps(
  const Scene& scene, const std::vector<ColoredLamp>& lamps, int azimuths, double levelStep)
{
  std::unique_ptr<HeightPyramid> pyramid;
  LampHarmonicSettings settings;
  settings.Azimuths = azimuths;
  settings.Product = LampProduct::Triple;
  if (levelStep > 0.0)
  {
    pyramid = std::make_unique<HeightPyramid>(scene.Field, levelStep);
    settings.Pyramid = pyramid.get();
    settings.Levels.LevelStep = levelStep;
    settings.Levels.LevelOffset = LevelOffset;
  }
  std::vector<float> rgb(3 * scene.East.size(), 0.0f);
  for (const ColoredLamp& colored : lamps)
  {
    const Lamp lamp = LampOf(scene, colored);
    vtkSMPTools::For(0, scene.Posts.Rows, RowsAtOnce,
      [&](vtkIdType begin, vtkIdType end)
      {
        AddLampHarmonics(scene.Terrain, scene.Posts, scene.East.data(), scene.North.data(), lamp,
          settings, begin, end, rgb.data());
      });
  }
  return rgb;
}

std::vector<float> LuminanceOf(const std::vector<float>& rgb)
{
  std::vector<float> light;
  for (std::size_t k = 0; k + 2 < rgb.size(); k += 3)
  {
    light.push_back(Luminance({ { rgb[k], rgb[k + 1], rgb[k + 2] } }));
  }
  return light;
}

} // namespace gallery
} // namespace skyline
