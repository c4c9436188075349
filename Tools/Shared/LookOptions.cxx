// SPDX-License-Identifier: BSD-3-Clause
#include "LookOptions.h"

#include "Color/ColorMaps.h"
#include "Values.h"

#include <CLI/CLI.hpp>

#include <vector>

namespace
{

constexpr const char* Automatic = "auto";

const skyline::Limits ExposureLimits{ "auto, or stops from -1000 to 1000", -1000.0, 1000.0 };
const skyline::Limits ExaggerationLimits{ "a number above 0, up to 1000", 0.0, 1000.0, true };

std::string CheckExposure(const std::string& text)
{
  return text == Automatic ? "" : skyline::WhyNotWithin(text, ExposureLimits);
}

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
  std::string help = "Colours of the heights";
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

void LookOptions::AddTo(CLI::App& command)
{
  command.add_option("--colors", this->Colors, MapHelp())
    ->check(OneOf(MapNames()))
    ->type_name("NAME")
    ->capture_default_str();
  command
    .add_option_function<std::string>(
      "--exposure", [this](const std::string& text) { this->Exposure = ReadNumber(text); },
      "auto, or a number of stops, -1000 to 1000: 0 shows level open ground in its own colour,\n"
      "+1 doubles the light. Bright parts are compressed, not clipped")
    ->type_name("EV")
    ->check(Checked(CheckExposure))
    ->default_str(Automatic);
  AddNumber(command, "--exaggeration", this->Exaggeration, ExaggerationLimits,
    "Factor by which heights are multiplied, for shading and shadows; above 0, up to 1000")
    ->type_name("F");
}

} // namespace skyline
