// SPDX-License-Identifier: BSD-3-Clause
#include "LookOptions.h"

#include "ColorMaps.h"
#include "Failure.h"
#include "Lights.h"

#include <cmath>
#include <vector>

namespace
{

std::vector<std::string> MapNames()
{
  std::vector<std::string> names;
  for (const skyline::ColorMap& map : skyline::ColorMaps())
  {
    names.emplace_back(map.Name);
  }
  return names;
}

std::string MapHelp()
{
  std::string help = "Colours of heights, each list growing lighter upwards";
  for (const skyline::ColorMap& map : skyline::ColorMaps())
  {
    help += "\n" + std::string(map.Name) + ": " + std::string(map.Description);
  }
  return help;
}

} // namespace

namespace skyline
{

LookOptions::LookOptions()
  : Colors(ColorMaps()[0].Name)
{
}

void LookOptions::Check() const
{
  if (!(this->Exaggeration > 0.0 && this->Exaggeration <= 1000.0))
  {
    throw Failure("exaggeration is out of range: above 0, up to 1000");
  }
}

void LookOptions::AddSkyTo(CLI::App& command)
{
  command
    .add_option("--environment", this->Environment,
      "The sky. uniform: equally bright all over;\n"
      "cie:N: sky N of CIE S 011: 1 overcast, 3 overcast with a moderate gradation, 5 uniform,\n"
      "12 clear, 16 traditional overcast (three times as bright in the zenith as at the horizon);\n"
      "none: black; FILE.hdr, FILE.exr: a light map, alone or with the sun of --sun or --time;\n"
      "perez:DIRECT,DIFFUSE: Perez's sky and its sun, W/m2")
    ->type_name("NAME|FILE")
    ->check(CLI::Validator(
      [](std::string& name)
      {
        if (name == "uniform" || name == "none" || name.rfind("cie:", 0) == 0 ||
          name.rfind("perez:", 0) == 0 || name.find('.') != std::string::npos)
        {
          return CheckEnvironment(name);
        }
        return "no sky named " + name +
          "; use uniform, none, cie:1 to cie:16, perez:DIRECT,DIFFUSE or a file's name";
      },
      ""))
    ->capture_default_str();
}

void LookOptions::AddTo(CLI::App& command)
{
  command.add_option("--colors", this->Colors, MapHelp())
    ->check(CLI::IsMember(MapNames()))
    ->type_name("NAME")
    ->capture_default_str();
  command
    .add_option("--exposure", this->Exposure,
      "auto, or stops: 0 shows level open ground as its colour, +1 twice as bright.\nHowever "
      "bright, nothing burns out")
    ->type_name("EV")
    ->check(CLI::Validator(
      [](std::string& text)
      {
        double stops;
        return text == "auto" || (CLI::detail::lexical_cast(text, stops) && std::isfinite(stops))
          ? std::string()
          : "needs auto or a number, not " + text;
      },
      ""))
    ->capture_default_str();
  command
    .add_option("--exaggeration", this->Exaggeration,
      "Factor on heights, in shading and shadows alike; above 0, up to 1000")
    ->type_name("F")
    ->capture_default_str();
}

} // namespace skyline
