// SPDX-License-Identifier: BSD-3-Clause
#include "LightOptions.h"

#include "Shared/Constants.h"
#include "Sun/UtcTime.h"
#include "UnusedOptions.h"
#include "Values.h"

#include "vtkSkylineSunLight.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace skyline
{

namespace
{

constexpr double MostElevation = 90.0; // degrees

const Limits RadiusLimits{ "0 to less than 90 degrees", 0.0, 90.0, false, true };

const Limits AnyAngle{ "an angle in degrees", -std::numeric_limits<double>::max(),
  std::numeric_limits<double>::max() };

// Parses a list of numbers. Throws std::invalid_argument with the reason and the fix.
std::vector<double> ParseNumbers(const std::string& text, const std::string& cure)
{
  const auto numbers = ReadNumbers(text);
  if (!numbers)
  {
    throw std::invalid_argument(NumbersError(text) + cure);
  }
  return *numbers;
}

std::string ParseTime(const std::string& text)
{
  const std::string error = vtkSkylineSunLight::FindTimeError(text);
  if (!error.empty())
  {
    throw std::invalid_argument(error);
  }
  return text;
}

SunAngles ParseDirection(const std::string& text)
{
  const std::string cure = "; give two numbers AZ,EL";
  const auto numbers = ParseNumbers(text, cure);
  if (numbers.size() != 2)
  {
    throw std::invalid_argument(text + " is not a direction" + cure);
  }
  if (std::abs(numbers[1]) > MostElevation)
  {
    throw std::invalid_argument(
      "elevation " + NumberText(numbers[1]) + " is out of range; give -90 to 90 degrees");
  }
  return { numbers[0], numbers[1] };
}

std::array<double, 3> ParseColor(const std::string& text)
{
  const std::string cure = "; give one number or R,G,B, 0 or more";
  const auto numbers = ParseNumbers(text, cure);
  const bool one = numbers.size() == 1;
  if ((!one && numbers.size() != 3) || *std::min_element(numbers.begin(), numbers.end()) < 0.0)
  {
    throw std::invalid_argument(text + " is not an irradiance" + cure);
  }
  return { { numbers[0], numbers[one ? 0 : 1], numbers[one ? 0 : 2] } };
}

LampDescription ParseLamp(const std::string& text)
{
  const std::string cure = "; give X,Y,Z,RADIUS or X,Y,Z,RADIUS,R,G,B";
  const auto numbers = ParseNumbers(text, cure);
  if (numbers.size() != 4 && numbers.size() != 7)
  {
    throw std::invalid_argument(
      text + " has " + std::to_string(numbers.size()) + " numbers" + cure);
  }
  LampDescription lamp{ numbers[0], numbers[1], numbers[2], numbers[3], { { 1.0, 1.0, 1.0 } },
    text };
  if (!(lamp.Radius > 0.0))
  {
    throw std::invalid_argument(text + " has a radius that is not above 0; give metres, as in 1");
  }
  std::copy(numbers.begin() + 4, numbers.end(), lamp.Radiance.begin());
  if (*std::min_element(lamp.Radiance.begin(), lamp.Radiance.end()) < 0.0)
  {
    throw std::invalid_argument(text + " has a radiance below 0; give 0 or more");
  }
  return lamp;
}

CLI::Option* AddSky(
  CLI::App& command, LightDescription& lights, bool takesNone, const std::string& help)
{
  return AddParsed(
    command, "--environment",
    [takesNone](const std::string& text) { return ParseSky(text, takesNone); },
    [&lights](const SkyDescription& sky) { lights.Sky = sky; }, help);
}

bool IsTurned(const LightDescription& lights)
{
  return std::fmod(lights.Rotation, 360.0) != 0.0;
}

} // namespace

void AddSunOptions(CLI::App& command, SunDescription& sun, bool limbDarkening)
{
  CLI::Option* time = AddParsed(
    command, "--time", ParseTime, [&sun](const std::string& text) { sun.Time = text; },
    "Use the sun at this time and at the place of the DEM, for instance 2026-06-21T06:00Z or\n"
    "2026-06-21T08:00+02:00 (UTC if no time zone is given); years 1900 to 2100");
  time->type_name("TIME");
  AddParsed(
    command, "--sun", ParseDirection, [&sun](const SunAngles& angles) { sun.Direction = angles; },
    "Use a sun in this direction: azimuth in degrees clockwise from grid north (any number),\n"
    "apparent elevation in degrees, -90 to 90. Default without --time: 315,45")
    ->type_name("AZ,EL")
    ->excludes(time);
  AddNumber(command, "--sun-radius", sun.Radius, RadiusLimits,
    std::string("Angular radius of the sun's disc in degrees, 0 to less than 90") +
      (limbDarkening ? "; 0: hard shadows.\n" : ", for --soft.\n") +
      "Default: the true radius with --time, " + NumberText(MeanSunRadius) + " otherwise")
    ->type_name("DEG");
  if (limbDarkening)
  {
    command.add_flag("--limb-darkening", sun.LimbDarkening,
      "Make the sun's disc darker towards its edge, as the real one is");
  }
}

void RefuseUnusedSun(const SunDescription& sun, const UnusedOptions& options)
{
  options.Refuse(sun.Radius == 0.0, { "--limb-darkening" },
    "a sun of --sun-radius 0 is a point without a limb; leave one of the two out");
}

void WarnOfZone(const SunDescription& sun, const CommonOptions& common)
{
  if (!sun.Time.empty() && !NamesZone(sun.Time))
  {
    PrintWarning(Doubt{ "the time " + sun.Time + " has no time zone", "UTC",
                   "--time " + ToText(ParseUtcTime(sun.Time)) },
      common);
  }
}

void AddLightOptions(CLI::App& command, LightDescription& lights)
{
  AddSky(command, lights, false,
    "The sky. FILE.hdr or FILE.exr: a light map, latitude-longitude or cube;\n"
    "uniform: radiance 1 in all directions;\n"
    "cie:N: sky N of CIE S 011, 1 to 15, or 16 for the traditional overcast sky, with radiance\n"
    "1 at the zenith; perez:DIRECT,DIFFUSE: Perez's all-weather sky with DIFFUSE W/m2 on open\n"
    "level ground, and in addition its sun with DIRECT W/m2 on a plane that faces it.\n"
    "The sun of a CIE or Perez sky is that of --time or --sun")
    ->type_name("FILE|NAME");
  AddSunOptions(command, lights.Sun);
  AddLampOptions(command, lights, false);
}

void AddPictureSkyOption(CLI::App& command, LightDescription& lights)
{
  lights.Sky = SkyDescription();
  AddSky(command, lights, true,
    "The sky. uniform: equally bright in all directions;\n"
    "cie:N: sky N of CIE S 011: 1 overcast, 3 overcast with a moderate gradation, 5 uniform,\n"
    "12 clear, 16 traditional overcast (three times as bright at the zenith as at the horizon);\n"
    "none: black; FILE.hdr, FILE.exr: a light map, alone or with the sun of --sun or --time;\n"
    "perez:DIRECT,DIFFUSE: Perez's sky and its sun, W/m2")
    ->type_name("NAME|FILE")
    ->default_str(lights.Sky->Text);
}

void AddLampOptions(CLI::App& command, LightDescription& lights, bool picture)
{
  AddNumber(command, "--rotation", lights.Rotation, AnyAngle,
    "Degrees by which a light map, or a sky that is brighter around the sun, is turned\n"
    "clockwise: its north then lies at this azimuth")
    ->type_name("DEG");
  AddParsed(
    command, "--sun-irradiance", ParseColor,
    [&lights](const std::array<double, 3>& color) { lights.Sun.Irradiance = color; },
    picture
      ? "Irradiance of the sun on a plane that faces it. Default: that of a clear day, scaled\n"
        "so that sun and sky give level open ground pi; under a light map: 1; with perez: DIRECT"
      : "Irradiance of the sun of --time or --sun on a plane that faces it.\n"
        "Default: 1; with perez: DIRECT")
    ->type_name("E|R,G,B");
  command
    .add_option_function<std::vector<std::string>>(
      "--lamp",
      [&lights](const std::vector<std::string>& texts)
      {
        for (const std::string& text : texts)
        {
          Refusing("--lamp", [&] { lights.Lamps.push_back(ParseLamp(text)); });
        }
      },
      "Add a lamp, a glowing ball: X,Y in the CRS of the DEM (without a CRS: metres from the\n"
      "south-west post), height Z and radius in metres, radiance R,G,B (default 1,1,1); may be\n"
      "repeated")
    ->type_name("X,Y,Z,RADIUS[,R,G,B]")
    ->type_size(1)
    ->allow_extra_args(false)
    ->delimiter('\0');
}

void RefuseUnusedLights(const LightDescription& lights, const UnusedOptions& options, SkyKind kind,
  bool sunShines, bool keyLight)
{
  RefuseUnusedSun(lights.Sun, options);
  options.Refuse(kind == SkyKind::Perez && !lights.Sun.Asked(), { "--environment" },
    "a perez sky needs a sun; give it by --sun AZ,EL or --time");
  options.Refuse(!sunShines, { "--sun-irradiance", "--sun-radius", "--limb-darkening" },
    "no sun shines; give one by --sun AZ,EL or --time, or leave it out");
  options.Refuse(keyLight && lights.Sun.Radius.value_or(0.0) > LargestSunRadius,
    { "--limb-darkening" },
    "a sun with a radius above " + NumberText(LargestSunRadius) +
      " degrees is a key light, which has no limb; leave it out");
}

void WarnOfTurnedSky(const LightDescription& lights, SkyKind kind, const CommonOptions& common)
{
  const bool shines = lights.Sun.Irradiance != std::array<double, 3>{};
  if (shines && IsTurned(lights) && (kind == SkyKind::Formula || kind == SkyKind::Perez))
  {
    PrintWarning(Doubt{ "--rotation turns the sky " + lights.Sky->Text +
                     ", which is brighter around the sun, away from the sun that shines",
                   "a sky that does not belong to the sun", "" },
      common);
  }
  if (IsTurned(lights) && kind <= SkyKind::Zonal)
  {
    PrintWarning(Doubt{ "--rotation has no effect, because this sky is the same all around",
                   "the sky without it", "" },
      common);
  }
}

} // namespace skyline
