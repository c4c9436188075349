// SPDX-License-Identifier: BSD-3-Clause
// Whether a map that says nothing of its unit seems to count in degrees.
#ifndef skyline_LooksLikeDegrees_h
#define skyline_LooksLikeDegrees_h

#include <algorithm>

namespace skyline
{

/// How many times the relief exceeds the width and the height of a map of degrees, and of no map in
/// metres: a relief of 12 m in a degree does, and no model of a landscape is ten times as high as wide.
constexpr double ReliefOfDegrees = 10.0;

/// True where west < east and south < north lie within the ranges of longitudes (to either count) and
/// latitudes, and `relief`, highest less lowest in metres, is many times the map's extent.
inline bool LooksLikeDegrees(double west, double south, double east, double north, double relief)
{
  constexpr double slack = 1.0; // maps of the whole Earth often reach half a post beyond
  return west >= -180.0 - slack && east <= 360.0 + slack && south >= -90.0 - slack &&
    north <= 90.0 + slack && relief > ReliefOfDegrees * std::max(east - west, north - south);
}

} // namespace skyline

#endif
