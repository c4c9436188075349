// SPDX-License-Identifier: BSD-3-Clause
#include "LengthUnit.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>

namespace skyline
{

namespace
{

struct NamedUnit
{
  const char* Name; ///< in the form that Normalise returns
  double Metres;    ///< 0 if the word means "not known"
};

constexpr std::array<NamedUnit, 36> NamedUnits{ {
  { "m", 1.0 },
  { "metre", 1.0 },
  { "mtr", 1.0 },
  { "ft", MetresPerFoot },
  { "foot", MetresPerFoot },
  { "intft", MetresPerFoot },
  { "ftint", MetresPerFoot },
  { "internationalfoot", MetresPerFoot },
  { "footinternational", MetresPerFoot },
  { "usft", MetresPerSurveyFoot },
  { "ftus", MetresPerSurveyFoot },
  { "sft", MetresPerSurveyFoot },
  { "usfoot", MetresPerSurveyFoot },
  { "footus", MetresPerSurveyFoot },
  { "surveyfoot", MetresPerSurveyFoot },
  { "ussurveyfoot", MetresPerSurveyFoot },
  { "footussurvey", MetresPerSurveyFoot },
  { "km", 1000.0 },
  { "kilometre", 1000.0 },
  { "gpm", 1.0 }, // geopotential metre: equals the height within 0.6 % below 9 km
  { "geopotentialmetre", 1.0 },
  { "gpkm", 1000.0 },
  { "dam", 10.0 },
  { "decametre", 10.0 },
  { "gpdam", 10.0 },
  { "yd", 0.9144 },
  { "yard", 0.9144 },
  { "dm", 0.1 },
  { "decimetre", 0.1 },
  { "cm", 0.01 },
  { "centimetre", 0.01 },
  { "mm", 0.001 },
  { "", 0.0 },
  { "unknown", 0.0 },
  { "none", 0.0 },
  { "other", 0.0 },
} };

void Replace(std::string& text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  if (at != std::string::npos)
  {
    text.replace(at, from.size(), to);
  }
}

/// Reduces a name to lower-case letters and digits, with one spelling and in the singular.
std::string Normalise(const std::string& name)
{
  std::string plain;
  for (const char c : name)
  {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte))
    {
      plain += static_cast<char>(std::tolower(byte));
    }
    else if (!std::isspace(byte) && !std::strchr("-_.,()[]", c))
    {
      plain += '?'; // a character such as a degree or percent sign must not be ignored
    }
  }
  Replace(plain, "metres", "metre");
  Replace(plain, "meters", "metre");
  Replace(plain, "meter", "metre");
  Replace(plain, "feet", "foot");
  return plain;
}

const NamedUnit* FindUnit(const std::string& name)
{
  const std::string plain = Normalise(name);
  const auto* const unit = std::find_if(NamedUnits.begin(), NamedUnits.end(),
    [&](const NamedUnit& candidate) { return plain == candidate.Name; });
  return unit == NamedUnits.end() ? nullptr : unit;
}

/// True if a product or power of units begins at or after `begin`: "s-1", "s**2", "/s".
bool Multiplies(const std::string& name, std::size_t begin)
{
  for (std::size_t i = begin; i < name.size(); ++i)
  {
    const bool power = name[i] == '-' && i + 1 < name.size() && std::isdigit(name[i + 1] & 0x7f);
    if (power || std::strchr("/*^", name[i]))
    {
      return true;
    }
  }
  return false;
}

} // namespace

UnitName ReadUnitName(const std::string& name, double& metres)
{
  const NamedUnit* unit = FindUnit(name);
  if (!unit)
  {
    // Accepts "metres above mean sea level", but not "m s-1".
    const std::size_t begin = name.find_first_not_of(" \t");
    const std::size_t end = name.find_first_of(" \t", begin);
    unit = Multiplies(name, end) ? nullptr : FindUnit(name.substr(begin, end - begin));
  }
  if (!unit)
  {
    return UnitName::Unknown;
  }
  if (unit->Metres == 0.0)
  {
    return UnitName::Absent;
  }
  metres = unit->Metres;
  return UnitName::Length;
}

} // namespace skyline
