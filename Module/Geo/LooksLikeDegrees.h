// SPDX-License-Identifier: BSD-3-Clause
// Whether a map that does not state its unit seems to be in degrees.
#ifndef skyline_LooksLikeDegrees_h
#define skyline_LooksLikeDegrees_h

#include <algorithm>

namespace skyline
{

/// A map counts as one in degrees if the relief in metres exceeds its width and its height by this
/// factor. On a map in degrees, a relief of 12 m per degree is enough; no landscape in metres is
/// ten times as high as it is wide.
constexpr double ReliefOfDegrees = 10.0;

/// Returns true if west < east and south < north lie within the ranges of longitudes (-180 to 180
/// or 0 to 360) and latitudes, and `relief`, the range of heights in metres, is many times the
/// extent of the map.
inline bool LooksLikeDegrees(double west, double south, double east, double north, double relief)
{
  constexpr double slack = 1.0; // maps of the whole Earth often reach half a post beyond
  return west >= -180.0 - slack && east <= 360.0 + slack && south >= -90.0 - slack &&
    north <= 90.0 + slack && relief > ReliefOfDegrees * std::max(east - west, north - south);
}

} // namespace skyline

#endif
