// SPDX-License-Identifier: BSD-3-Clause
#include "Lights.h"

#include "Constants.h"
#include "Failure.h"
#include "Files.h"

#include "vtkImageData.h"
#include "vtkLightMapReader.h"
#include "vtkNew.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineKeyLight.h"
#include "vtkSkylineLampLight.h"
#include "vtkSkylineSunLight.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

// Discs beyond this radius, degrees, are key lights: their parts have different cosines.
constexpr double LargestSun = 3.0;

// The numbers of a list with commas; false if any part is none.
bool ParseNumbers(const std::string& text, std::vector<double>& numbers)
{
  numbers.clear();
  std::size_t begin = 0;
  while (begin <= text.size())
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    double number = 0.0;
    if (!CLI::detail::lexical_cast(text.substr(begin, end - begin), number) ||
      !std::isfinite(number))
    {
      return false;
    }
    numbers.push_back(number);
    begin = end + 1;
  }
  return !numbers.empty();
}

bool StartsWith(const std::string& text, const char* start)
{
  return text.rfind(start, 0) == 0;
}

std::string CheckColor(std::string& text)
{
  std::vector<double> numbers;
  const bool fine = ParseNumbers(text, numbers) && (numbers.size() == 1 || numbers.size() == 3) &&
    *std::min_element(numbers.begin(), numbers.end()) >= 0.0;
  return fine ? "" : "needs one number or R,G,B, 0 or more, not " + text;
}

std::string CheckLamp(std::string& text)
{
  std::vector<double> numbers;
  const bool fine = ParseNumbers(text, numbers) && (numbers.size() == 4 || numbers.size() == 7);
  return fine ? "" : "needs X,Y,Z,RADIUS or X,Y,Z,RADIUS,R,G,B, not " + text;
}

std::array<double, 3> ParseColor(const std::string& text)
{
  std::vector<double> numbers;
  ParseNumbers(text, numbers);
  return numbers.size() == 3 ? std::array<double, 3>{ { numbers[0], numbers[1], numbers[2] } }
                             : std::array<double, 3>{ { numbers[0], numbers[0], numbers[0] } };
}

using LightPointer = vtkSmartPointer<vtkSkylineLight>;

vtkSmartPointer<vtkSkylineEnvironmentLight> MakeEnvironment(
  const skyline::LightOptions& options, const skyline::SunLight& sun, const skyline::Talk& talk)
{
  const std::string& name = options.Environment;
  auto light = vtkSmartPointer<vtkSkylineEnvironmentLight>::New();
  light->SetRotation(options.Rotation);
  light->SetSunAzimuth(sun.GridAzimuth);
  light->SetSunElevation(sun.ApparentElevation);
  std::vector<double> numbers;
  if (StartsWith(name, "cie:"))
  {
    ParseNumbers(name.substr(4), numbers);
    light->SetSourceToCie();
    light->SetCieType(static_cast<int>(numbers[0]));
  }
  else if (StartsWith(name, "perez:"))
  {
    ParseNumbers(name.substr(6), numbers);
    light->SetSourceToPerez();
    light->SetDirectIrradiance(numbers[0]);
    light->SetDiffuseIrradiance(numbers[1]);
  }
  else if (name != "uniform" && !name.empty())
  {
    vtkNew<vtkLightMapReader> reader;
    reader->SetFileName(name.c_str());
    skyline::RunPass(reader, "light map", talk);
    light->SetImage(reader->GetOutput());
  }
  return light;
}

LightPointer MakeSun(const skyline::SunOptions& options, const skyline::SunLight& sun,
  const std::array<double, 3>& irradiance)
{
  if (sun.Radius > LargestSun)
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
  light->SetTrueRadius(options.Radius == skyline::TrueRadius);
  light->SetUseTime(sun.FromTime);
  light->SetTime(options.Time.c_str());
  light->SetLimbDarkening(options.LimbDarkening);
  return light;
}

LightPointer MakeLamp(
  const std::string& text, vtkImageData* terrain, const skyline::Georeference& place)
{
  std::vector<double> numbers;
  ParseNumbers(text, numbers);
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

CLI::Validator Checked(std::string (*check)(std::string&))
{
  return CLI::Validator(check, "");
}

} // namespace

namespace skyline
{

std::string CheckEnvironment(std::string& name)
{
  std::vector<double> numbers;
  if (StartsWith(name, "cie:"))
  {
    const bool fine = ParseNumbers(name.substr(4), numbers) && numbers.size() == 1 &&
      numbers[0] >= 1.0 && numbers[0] <= 16.0 && numbers[0] == std::floor(numbers[0]);
    return fine ? "" : "no sky named " + name + "; CIE skies are cie:1 to cie:16";
  }
  if (StartsWith(name, "perez:"))
  {
    const bool fine = ParseNumbers(name.substr(6), numbers) && numbers.size() == 2 &&
      numbers[0] >= 0.0 && numbers[1] > 0.0;
    return fine ? "" : "needs perez:DIRECT,DIFFUSE in W/m2, diffuse above 0, not " + name;
  }
  return "";
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
  this->AddLampsTo(command);
}

void LightOptions::AddLampsTo(CLI::App& command)
{
  command
    .add_option("--rotation", this->Rotation,
      "Degrees by which the environment is turned clockwise: its north comes to this azimuth")
    ->type_name("DEG")
    ->capture_default_str();
  command
    .add_option("--sun-irradiance", this->SunIrradiance,
      "Of the sun of --time or --sun on a plane that faces it. Default 1, with perez: DIRECT")
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

std::vector<LightPointer> MakeLights(
  const LightOptions& options, vtkImageData* terrain, const Talk& talk)
{
  const Center center = CenterOf(terrain, talk);
  const SunLight sun = FindSun(options.Sun, center.Place, center.Height);
  const bool sunAsked = !options.Sun.Time.empty() || !options.Sun.Direction.empty();
  const bool perez = StartsWith(options.Environment, "perez:");
  std::vector<LightPointer> lights;
  std::array<double, 3> irradiance{ { 1.0, 1.0, 1.0 } };
  if (!options.Environment.empty() || !(sunAsked || !options.Lamps.empty()))
  {
    const auto environment = MakeEnvironment(options, sun, talk);
    irradiance.fill(perez ? environment->GetDirectIrradiance() : 1.0);
    lights.emplace_back(environment);
  }
  if (!options.SunIrradiance.empty())
  {
    irradiance = ParseColor(options.SunIrradiance);
  }
  if (sunAsked || perez)
  {
    lights.push_back(MakeSun(options.Sun, sun, irradiance));
  }
  for (const std::string& lamp : options.Lamps)
  {
    lights.push_back(MakeLamp(lamp, terrain, center.Place));
  }
  return lights;
}

} // namespace skyline
