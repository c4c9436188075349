// SPDX-License-Identifier: BSD-3-Clause
#include "Lights.h"

#include "Files.h"
#include "Shared/Constants.h"
#include "SunLight.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineKeyLight.h"
#include "vtkSkylineLampLight.h"
#include "vtkSkylineLightMapReader.h"
#include "vtkSkylineSunLight.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace skyline
{

namespace
{

using LightPointer = vtkSmartPointer<vtkSkylineLight>;

LightPointer MakeSun(
  const SunDescription& asked, const SunLight& sun, const std::array<double, 3>& irradiance)
{
  if (sun.Radius > LargestSunRadius)
  {
    auto light = vtkSmartPointer<vtkSkylineKeyLight>::New();
    light->SetAzimuth(sun.GridAzimuth);
    light->SetElevation(sun.ApparentElevation);
    light->SetAngularRadius(sun.Radius);
    const double reach = std::sin(sun.Radius * RadiansPerDegree);
    const double share = 1.0 / (Pi * reach * reach);
    light->SetRadiance(share * irradiance[0], share * irradiance[1], share * irradiance[2]);
    return light;
  }
  auto light = vtkSmartPointer<vtkSkylineSunLight>::New();
  ApplySun(asked, sun, light);
  light->SetIrradiance(irradiance[0], irradiance[1], irradiance[2]);
  return light;
}

void WarnOfNight(const SkyDescription& sky, const SunLight& sun, const CommonOptions& common)
{
  if (sky.Kind == SkyKind::Formula && sun.ApparentElevation <= 0.0)
  {
    PrintWarning(Doubt{ "the sun is below the horizon, and " + sky.Text +
                     " is a daylight sky whose brightness is relative",
                   "the sky that its formula gives for this sun", "--environment none" },
      common);
  }
}

} // namespace

std::array<double, 3> SunIrradianceOf(const LightDescription& lights)
{
  std::array<double, 3> irradiance{};
  irradiance.fill(lights.KindOfSky() == SkyKind::Perez ? lights.Sky->DirectIrradiance : 1.0);
  return lights.Sun.Irradiance.value_or(irradiance);
}

vtkSmartPointer<vtkSkylineEnvironmentLight> MakeSky(
  const SkyDescription& sky, const CommonOptions& common)
{
  auto light = vtkSmartPointer<vtkSkylineEnvironmentLight>::New();
  if (!light->SetSky(sky))
  {
    vtkNew<vtkSkylineLightMapReader> reader;
    reader->SetFileName(sky.Text.c_str());
    RunPass(reader, "light map", common);
    light->SetImage(reader->GetOutput());
  }
  return light;
}

vtkSmartPointer<vtkSkylineLampLight> MakeLamp(
  const LampDescription& lamp, vtkImageData* terrain, const CommonOptions& common)
{
  if (*std::max_element(lamp.Radiance.begin(), lamp.Radiance.end()) == 0.0)
  {
    PrintWarning(
      Doubt{ "the lamp " + lamp.Text + " is black", "a lamp without light", "" }, common);
  }
  auto light = vtkSmartPointer<vtkSkylineLampLight>::New();
  light->SetMapPosition(terrain, lamp.X, lamp.Y, lamp.Z);
  light->SetRadius(lamp.Radius);
  light->SetRadiance(lamp.Radiance[0], lamp.Radiance[1], lamp.Radiance[2]);
  return light;
}

std::vector<LightPointer> MakeLights(
  const LightDescription& lights, vtkImageData* terrain, const CommonOptions& common)
{
  const Center center = CenterOf(terrain, common);
  const SunLight sun = FindSun(lights.Sun, center.Place, center.Height);
  const bool sunAsked = lights.Sun.Asked();
  std::vector<LightPointer> made;
  if (lights.Sky || !(sunAsked || !lights.Lamps.empty()))
  {
    const SkyDescription sky = lights.Sky.value_or(SkyDescription());
    if (sunAsked)
    {
      WarnOfNight(sky, sun, common);
    }
    const auto light = MakeSky(sky, common);
    light->SetRotation(lights.Rotation);
    light->SetSunAzimuth(sun.SkyAzimuth);
    light->SetSunElevation(sun.ApparentElevation);
    made.emplace_back(light);
  }
  if (sunAsked || lights.KindOfSky() == SkyKind::Perez)
  {
    made.push_back(MakeSun(lights.Sun, sun, SunIrradianceOf(lights)));
  }
  for (const LampDescription& lamp : lights.Lamps)
  {
    made.emplace_back(MakeLamp(lamp, terrain, common));
  }
  return made;
}

} // namespace skyline
