// SPDX-License-Identifier: BSD-3-Clause
#include "Geo/RayBending.h"

#include "Geo/Azimuth.h"

#include <GeographicLib/Geodesic.hpp>

#include <algorithm>
#include <cmath>

namespace skyline
{

namespace
{

constexpr int PlacesAlongSide = 3;

/// Shorter rays are not measured: geodesics are accurate to some nanometres, lattices to some
/// centimetres.
constexpr double ShortestRay = 100.0; // metres

} // namespace

RayBending MeasureRayBending(const Georeference& place, double longest)
{
  RayBending worst;
  if (!place.OnBody())
  {
    return worst;
  }
  const GeographicLib::Geodesic ellipsoid(place.EquatorialRadius, place.Flattening);
  constexpr int places = PlacesAlongSide * PlacesAlongSide;
  // Fraction of the way from the first post to the last.
  const auto part = [](int step) { return static_cast<double>(step) / (PlacesAlongSide - 1); };
  const double lastColumn = static_cast<double>(place.Columns - 1);
  const double lastRow = static_cast<double>(place.Rows - 1);
  const auto columnOf = [&](int i) { return lastColumn * part(i % PlacesAlongSide); };
  const auto rowOf = [&](int i) { return lastRow * part(i / PlacesAlongSide); };
  for (int from = 0; from < places; ++from)
  {
    const double column = columnOf(from), row = rowOf(from);
    const PostSteps steps = place.StepsAt(column, row);
    double longitude = 0.0, latitude = 0.0;
    place.LonLatAt(column, row, longitude, latitude);
    for (int to = 0; to < places; ++to)
    {
      double columns = columnOf(to) - column, rows = rowOf(to) - row;
      double east = columns * steps.EastPerColumn + rows * steps.EastPerRow;
      double north = columns * steps.NorthPerColumn + rows * steps.NorthPerRow;
      const double whole = std::hypot(east, north);
      if (!(whole >= ShortestRay))
      {
        continue;
      }
      const double used = std::min(1.0, longest / whole);
      columns *= used;
      rows *= used;
      double endLongitude = 0.0, endLatitude = 0.0, metres = 0.0, azimuth = 0.0, endAzimuth = 0.0;
      place.LonLatAt(column + columns, row + rows, endLongitude, endLatitude);
      ellipsoid.Inverse(
        latitude, longitude, endLatitude, endLongitude, metres, azimuth, endAzimuth);
      const double turn = std::remainder(azimuth - AzimuthOf(east, north), 360.0);
      worst.Distance = std::max(worst.Distance, std::abs(used * whole / metres - 1.0));
      worst.Azimuth = std::max(worst.Azimuth, std::abs(turn));
      worst.Length = std::max(worst.Length, used * whole);
    }
  }
  return worst;
}

} // namespace skyline
