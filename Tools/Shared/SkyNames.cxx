// SPDX-License-Identifier: BSD-3-Clause
#include "SkyNames.h"

#include "Sky/SkyModel.h"
#include "Sky/ZonalSky.h"
#include "Values.h"

#include <cmath>
#include <filesystem>
#include <system_error>
#include <vector>

namespace
{

constexpr const char* Cie = "cie:";
constexpr const char* Perez = "perez:";

bool StartsWith(const std::string& text, const char* start)
{
  return text.rfind(start, 0) == 0;
}

std::string Check(const std::string& name, const std::vector<std::string>& names)
{
  int type = 0;
  double direct = 0.0, diffuse = 0.0;
  if (StartsWith(name, Cie))
  {
    return skyline::CieType(name, type) ? "" : "no sky is named " + name + "; give cie:1 to cie:16";
  }
  if (StartsWith(name, Perez))
  {
    return skyline::PerezIrradiances(name, direct, diffuse)
      ? ""
      : name + " is no sky; give perez:DIRECT,DIFFUSE in W/m2, diffuse above 0";
  }
  for (const std::string& known : names)
  {
    if (name == known)
    {
      return "";
    }
  }
  std::error_code error;
  if (name.find_first_of("./") != std::string::npos || std::filesystem::exists(name, error))
  {
    return "";
  }
  const std::string near = skyline::DidYouMean(name, names);
  std::string all;
  for (const std::string& known : names)
  {
    all += known + ", ";
  }
  return "no sky and no file is named " + name +
    (near.empty() ? "; give " + all + "cie:1 to cie:16, perez:DIRECT,DIFFUSE or a file's name"
                  : near);
}

} // namespace

namespace skyline
{

bool CieType(const std::string& name, int& type)
{
  const auto number =
    StartsWith(name, Cie) ? ReadNumber(name.substr(std::string(Cie).size())) : std::nullopt;
  if (!number || *number != std::floor(*number) || *number < 1.0 || *number > TraditionalOvercast)
  {
    return false;
  }
  type = static_cast<int>(*number);
  return true;
}

bool PerezIrradiances(const std::string& name, double& direct, double& diffuse)
{
  const auto numbers =
    StartsWith(name, Perez) ? ReadNumbers(name.substr(std::string(Perez).size())) : std::nullopt;
  if (!numbers || numbers->size() != 2 || (*numbers)[0] < 0.0 || (*numbers)[1] <= 0.0)
  {
    return false;
  }
  direct = (*numbers)[0];
  diffuse = (*numbers)[1];
  return true;
}

SkyKind KindOfSky(const std::string& name)
{
  int type = 0;
  if (name == "none")
  {
    return SkyKind::None;
  }
  if (name == "uniform" || name.empty())
  {
    return SkyKind::Uniform;
  }
  if (CieType(name, type))
  {
    return ZonalSky::Knows(type) ? SkyKind::Zonal : SkyKind::Formula;
  }
  return StartsWith(name, Perez) ? SkyKind::Perez : SkyKind::Map;
}

bool IsMeasured(SkyKind kind)
{
  return kind == SkyKind::Perez || kind == SkyKind::Map;
}

std::string CheckEnvironment(const std::string& name)
{
  return Check(name, { "uniform" });
}

std::string CheckSky(const std::string& name)
{
  return Check(name, { "uniform", "none" });
}

} // namespace skyline
