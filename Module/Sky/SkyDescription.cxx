// SPDX-License-Identifier: BSD-3-Clause
#include "Sky/SkyDescription.h"

#include "Shared/NearName.h"
#include "Shared/NumberText.h"
#include "Sky/SkyModel.h"
#include "Sky/ZonalSky.h"

#include <cmath>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace skyline
{

namespace
{

/// The rest of a text that begins with `start`; no value if it does not.
std::optional<std::string> After(const std::string& start, const std::string& text)
{
  return text.rfind(start, 0) == 0 ? std::make_optional(text.substr(start.size())) : std::nullopt;
}

SkyDescription ParseCie(const std::string& text, const std::string& type)
{
  const auto number = ReadNumber(type);
  if (!number || *number != std::floor(*number) || *number < 1.0 || *number > TraditionalOvercast)
  {
    throw std::invalid_argument("no sky is named " + text + "; give cie:1 to cie:16");
  }
  SkyDescription sky;
  sky.CieType = static_cast<int>(*number);
  sky.Kind = ZonalSky::Knows(sky.CieType) ? SkyKind::Zonal : SkyKind::Formula;
  sky.Text = text;
  return sky;
}

SkyDescription ParsePerez(const std::string& text, const std::string& irradiances)
{
  const auto numbers = ReadNumbers(irradiances);
  if (!numbers || numbers->size() != 2 || (*numbers)[0] < 0.0 || (*numbers)[1] <= 0.0)
  {
    throw std::invalid_argument(
      text + " is not a sky; give perez:DIRECT,DIFFUSE in W/m2, diffuse above 0");
  }
  SkyDescription sky;
  sky.Kind = SkyKind::Perez;
  sky.DirectIrradiance = (*numbers)[0];
  sky.DiffuseIrradiance = (*numbers)[1];
  sky.Text = text;
  return sky;
}

} // namespace

SkyDescription SkyOfFile(const std::string& file)
{
  SkyDescription sky;
  sky.Kind = SkyKind::Map;
  sky.Text = file;
  return sky;
}

SkyDescription ParseSky(const std::string& text, bool takesNone)
{
  if (const auto type = After("cie:", text))
  {
    return ParseCie(text, *type);
  }
  if (const auto irradiances = After("perez:", text))
  {
    return ParsePerez(text, *irradiances);
  }
  SkyDescription sky;
  if (text == sky.Text)
  {
    return sky;
  }
  std::vector<std::string> names{ sky.Text };
  if (takesNone)
  {
    names.emplace_back("none");
    if (text == names.back())
    {
      sky.Kind = SkyKind::None;
      sky.Text = text;
      return sky;
    }
  }
  std::error_code error;
  if (text.find_first_of("./") != std::string::npos || std::filesystem::exists(text, error))
  {
    return SkyOfFile(text);
  }
  const std::string near = DidYouMean(text, names);
  std::string all;
  for (const std::string& name : names)
  {
    all += name + ", ";
  }
  throw std::invalid_argument("no sky and no file is named " + text +
    (near.empty() ? "; give " + all + "cie:1 to cie:16, perez:DIRECT,DIFFUSE or a file's name"
                  : near));
}

} // namespace skyline
