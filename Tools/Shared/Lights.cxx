// SPDX-License-Identifier: BSD-3-Clause
#include "Lights.h"

#include "Files.h"
#include "IdleOptions.h"
#include "Shared/Constants.h"
#include "Values.h"

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
#include <limits>

namespace
{

std::string CheckColor(const std::string& text)
{
  const auto numbers = skyline::ReadNumbers(text);
  const std::string cure = "; give one number or R,G,B, 0 or more";
  if (!numbers)
  {
    return skyline::WhyNoNumbers(text) + cure;
  }
  const bool fine = (numbers->size() == 1 || numbers->size() == 3) &&
    *std::min_element(numbers->begin(), numbers->end()) >= 0.0;
  return fine ? "" : text + " is no light" + cure;
}

std::string CheckLamp(const std::string& text)
{
  const auto numbers = skyline::ReadNumbers(text);
  const std::string cure = "; give X,Y,Z,RADIUS or X,Y,Z,RADIUS,R,G,B";
  if (!numbers)
  {
    return skyline::WhyNoNumbers(text) + cure;
  }
  if (numbers->size() != 4 && numbers->size() != 7)
  {
    return text + " has " + std::to_string(numbers->size()) + " numbers" + cure;
  }
  if (!((*numbers)[3] > 0.0))
  {
    return text + " has a radius that is not above 0; give metres, as in 1";
  }
  return *std::min_element(numbers->begin() + 4, numbers->end()) < 0.0
    ? text + " has a radiance below 0; give 0 or more"
    : "";
}

std::array<double, 3> ReadColor(const std::string& text)
{
  const auto numbers = *skyline::ReadNumbers(text);
  return numbers.size() == 3 ? std::array<double, 3>{ { numbers[0], numbers[1], numbers[2] } }
                             : std::array<double, 3>{ { numbers[0], numbers[0], numbers[0] } };
}

// Any angle: turns add nothing, and far from 0 a float holds no degrees any more.
double Turned(double degrees)
{
  return std::fmod(degrees, 360.0);
}

const skyline::Limits AnyAngle{ "an angle in degrees", -std::numeric_limits<double>::max(),
  std::numeric_limits<double>::max() };

using LightPointer = vtkSmartPointer<vtkSkylineLight>;

vtkSmartPointer<vtkSkylineEnvironmentLight> MakeEnvironment(
  const skyline::LightOptions& options, const skyline::SunLight& sun, const skyline::Talk& talk)
{
  const std::string& name = options.Environment;
  auto light = vtkSmartPointer<vtkSkylineEnvironmentLight>::New();
  light->SetRotation(Turned(options.Rotation));
  light->SetSunAzimuth(sun.SkyAzimuth);
  light->SetSunElevation(sun.ApparentElevation);
  int type = 0;
  double direct = 0.0, diffuse = 0.0;
  if (skyline::CieType(name, type))
  {
    light->SetSourceToCie();
    light->SetCieType(type);
  }
  else if (skyline::PerezIrradiances(name, direct, diffuse))
  {
    light->SetSourceToPerez();
    light->SetDirectIrradiance(direct);
    light->SetDiffuseIrradiance(diffuse);
  }
  else if (skyline::KindOfSky(name) == skyline::SkyKind::Map)
  {
    vtkNew<vtkSkylineLightMapReader> reader;
    reader->SetFileName(name.c_str());
    skyline::RunPass(reader, "light map", talk);
    light->SetImage(reader->GetOutput());
  }
  return light;
}

LightPointer MakeSun(const skyline::SunOptions& options, const skyline::SunLight& sun,
  const std::array<double, 3>& irradiance)
{
  if (sun.Radius > skyline::LargestSun)
  {
    auto light = vtkSmartPointer<vtkSkylineKeyLight>::New();
    light->SetAzimuth(sun.GridAzimuth);
    light->SetElevation(sun.ApparentElevation);
    light->SetAngularRadius(sun.Radius);
    const double reach = std::sin(sun.Radius * skyline::RadiansPerDegree);
    const double share = 1.0 / (skyline::Pi * reach * reach);
    light->SetRadiance(share * irradiance[0], share * irradiance[1], share * irradiance[2]);
    return light;
  }
  auto light = vtkSmartPointer<vtkSkylineSunLight>::New();
  light->SetAzimuth(sun.GridAzimuth);
  light->SetElevation(sun.ApparentElevation);
  light->SetAngularRadius(sun.Radius);
  light->SetIrradiance(irradiance[0], irradiance[1], irradiance[2]);
  light->SetTrueRadius(!options.Radius);
  light->SetUseTime(sun.FromTime);
  light->SetTime(options.Time.c_str());
  light->SetLimbDarkening(options.LimbDarkening);
  return light;
}

LightPointer MakeLamp(
  const std::string& text, vtkImageData* terrain, const skyline::Georeference& place)
{
  const std::vector<double> numbers = *skyline::ReadNumbers(text);
  double x = numbers[0], y = numbers[1];
  if (place.HasGeoTransform)
  {
    // CRS to posts to the image's coordinates.
    const auto& transform = place.GeoTransform;
    const double column = (x - transform[0]) / transform[1] - 0.5;
    const double down = (y - transform[3]) / transform[5] - 0.5;
    const double row = static_cast<double>(place.Rows - 1) - down;
    x = terrain->GetOrigin()[0] + column * terrain->GetSpacing()[0];
    y = terrain->GetOrigin()[1] + row * terrain->GetSpacing()[1];
  }
  auto light = vtkSmartPointer<vtkSkylineLampLight>::New();
  light->SetPosition(x, y, numbers[2]);
  light->SetRadius(numbers[3]);
  if (numbers.size() == 7)
  {
    light->SetRadiance(numbers[4], numbers[5], numbers[6]);
  }
  return light;
}

} // namespace

namespace skyline
{

std::optional<std::array<double, 3>> AskedSunIrradiance(const LightOptions& options)
{
  return options.SunIrradiance.empty() ? std::nullopt
                                       : std::make_optional(ReadColor(options.SunIrradiance));
}

void LightOptions::AddTo(CLI::App& command)
{
  command
    .add_option("--environment", this->Environment,
      "The sky. FILE.hdr or FILE.exr: a light map, latitude-longitude or cube;\n"
      "uniform: radiance 1 all over;\n"
      "cie:N: sky N of CIE S 011, 1 to 15, or 16 for the traditional overcast sky, with radiance\n"
      "1 in the zenith; perez:DIRECT,DIFFUSE: Perez's all-weather sky for a sun of DIRECT W/m2\n"
      "on a plane that faces it, which shines too, and DIFFUSE W/m2 from the sky on open level\n"
      "ground. The sun of a sky is that of --time or --sun")
    ->type_name("FILE|NAME")
    ->check(Checked(CheckEnvironment));
  this->Sun.AddTo(command);
  this->AddLampsTo(command, false);
}

void LightOptions::AddLampsTo(CLI::App& command, bool picture)
{
  AddNumber(command, "--rotation", this->Rotation, AnyAngle,
    "Degrees by which a light map, or a sky that is brighter about the sun, is turned clockwise: its\n"
    "north comes to this azimuth")
    ->type_name("DEG");
  command
    .add_option("--sun-irradiance", this->SunIrradiance,
      picture
        ? "Of the sun on a plane that faces it. Default: that of the day, by which level open ground\n"
          "gets pi of sun and sky; under a light map 1, with perez: DIRECT"
        : "Of the sun of --time or --sun on a plane that faces it. Default 1, with perez: DIRECT")
    ->type_name("E|R,G,B")
    ->check(Checked(CheckColor));
  command
    .add_option("--lamp", this->Lamps,
      "A glowing ball: X,Y in the CRS of the DEM (without one: from the south-west post), height Z\n"
      "and radius in metres, radiance R,G,B (default 1,1,1); may be repeated")
    ->type_name("X,Y,Z,RADIUS[,R,G,B]")
    ->type_size(1)
    ->allow_extra_args(false)
    ->delimiter('\0')
    ->check(Checked(CheckLamp));
}

void LightOptions::RefuseIdle(
  const IdleOptions& options, SkyKind kind, bool sunShines, bool keyLight) const
{
  this->Sun.RefuseIdle(options);
  options.Refuse(kind == SkyKind::Perez && !this->Sun.Asked(), { "--environment" },
    "perez is a sky of the sun; give the sun by --sun AZ,EL or --time");
  options.Refuse(!sunShines, { "--sun-irradiance", "--sun-radius", "--limb-darkening" },
    "no sun shines; give one by --sun AZ,EL or --time, or leave it out");
  options.Refuse(keyLight && this->Sun.Radius.value_or(0.0) > LargestSun, { "--limb-darkening" },
    "a sun with a radius above " + NumberText(LargestSun) +
      " degrees shines as a key light, without a limb; leave it out");
}

void LightOptions::WarnOfTurnedSky(SkyKind kind, const Talk& talk) const
{
  const auto irradiance = AskedSunIrradiance(*this);
  const bool shines = !irradiance || *irradiance != std::array<double, 3>{};
  if (shines && Turned(this->Rotation) != 0.0 &&
    (kind == SkyKind::Formula || kind == SkyKind::Perez))
  {
    PrintWarning(Doubt{ "--rotation turns the sky " + this->Environment +
                     ", which is brighter about the sun, away from the sun that shines",
                   "a sky that does not belong to the sun", "" },
      talk);
  }
  if (Turned(this->Rotation) != 0.0 &&
    (kind == SkyKind::None || kind == SkyKind::Uniform || kind == SkyKind::Zonal))
  {
    PrintWarning(Doubt{ "--rotation turns nothing, for this sky is the same all around",
                   "the sky without it", "" },
      talk);
  }
}

std::vector<LightPointer> MakeLights(
  const LightOptions& options, vtkImageData* terrain, const Talk& talk)
{
  const Center center = CenterOf(terrain, talk);
  const SunLight sun = FindSun(options.Sun, center.Place, center.Height);
  const bool sunAsked = options.Sun.Asked();
  const bool perez = KindOfSky(options.Environment) == SkyKind::Perez;
  if (KindOfSky(options.Environment) == SkyKind::Formula && sunAsked &&
    sun.ApparentElevation <= 0.0)
  {
    PrintWarning(Doubt{ "the sun is below the horizon, and " + options.Environment +
                     " is a sky by day whose brightness is relative",
                   "the sky that its formula gives for this sun", "--environment none" },
      talk);
  }
  std::vector<LightPointer> lights;
  std::array<double, 3> irradiance{ { 1.0, 1.0, 1.0 } };
  if (!options.Environment.empty() || !(sunAsked || !options.Lamps.empty()))
  {
    const auto environment = MakeEnvironment(options, sun, talk);
    irradiance.fill(perez ? environment->GetDirectIrradiance() : 1.0);
    lights.emplace_back(environment);
  }
  irradiance = AskedSunIrradiance(options).value_or(irradiance);
  if (sunAsked || perez)
  {
    lights.push_back(MakeSun(options.Sun, sun, irradiance));
  }
  for (const std::string& lamp : options.Lamps)
  {
    const auto numbers = *ReadNumbers(lamp);
    if (numbers.size() > 4 && *std::max_element(numbers.begin() + 4, numbers.end()) == 0.0)
    {
      PrintWarning(Doubt{ "the lamp " + lamp + " is black", "a lamp without light", "" }, talk);
    }
    lights.push_back(MakeLamp(lamp, terrain, center.Place));
  }
  return lights;
}

} // namespace skyline
