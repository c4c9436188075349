// SPDX-License-Identifier: BSD-3-Clause
// The names that rasters use for the unit of their heights.
#ifndef skyline_LengthUnit_h
#define skyline_LengthUnit_h

#include "SkylineIOModule.h" // for the export macro

#include <string>

namespace skyline
{

constexpr double MetresPerFoot = 0.3048;                ///< international foot (1959), exact
constexpr double MetresPerSurveyFoot = 1200.0 / 3937.0; ///< US survey foot (1893), exact

/// What the name of a unit means.
enum class UnitName
{
  Absent, ///< empty, or a word that means "not known"
  Length, ///< a length
  Unknown ///< anything else
};

/// Interprets a name such as "m", "metres above sea level", "ft" or "US survey foot". Case, spaces
/// and punctuation do not matter. If it is a length, `metres` becomes the number of metres in one
/// unit.
SKYLINEIO_EXPORT UnitName ReadUnitName(const std::string& name, double& metres);

} // namespace skyline

#endif
