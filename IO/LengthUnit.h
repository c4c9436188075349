// SPDX-License-Identifier: BSD-3-Clause
// The names under which rasters give the unit of their heights.
#ifndef skyline_LengthUnit_h
#define skyline_LengthUnit_h

#include "SkylineIOModule.h" // for the export macro

#include <string>

namespace skyline
{

constexpr double MetresPerFoot = 0.3048;                ///< international foot (1959), exact
constexpr double MetresPerSurveyFoot = 1200.0 / 3937.0; ///< US survey foot (1893), exact

/// What a unit's name says.
enum class UnitName
{
  Absent, ///< empty, or a word for "not known"
  Length, ///< a length
  Unknown ///< something else
};

/// Reads a name such as "m", "metres above sea level", "ft" or "US survey foot"; letter case,
/// spaces and signs do not matter. For a length, `metres` becomes the metres in one unit.
SKYLINEIO_EXPORT UnitName ReadUnitName(const std::string& name, double& metres);

} // namespace skyline

#endif
