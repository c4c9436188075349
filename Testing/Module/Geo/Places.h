// SPDX-License-Identifier: BSD-3-Clause
// Height fields on maps that GeographicLib computes, for tests.
#ifndef skyline_Places_h
#define skyline_Places_h

#include "Geo/Georeference.h"
#include "Shared/Constants.h"

#include <GeographicLib/AlbersEqualArea.hpp>
#include <GeographicLib/PolarStereographic.hpp>
#include <GeographicLib/TransverseMercator.hpp>

#include <cmath>
#include <cstddef>
#include <functional>

namespace skyline
{

constexpr double WgsRadius = 6378137.0;
constexpr double WgsFlattening = 1.0 / 298.257223563;

/// Converts map coordinates to longitude and latitude.
using MapInverse = std::function<void(double x, double y, double& longitude, double& latitude)>;

/// A raster whose south-western post is at (x, y) of a map.
inline Georeference OnMap(const MapInverse& inverse, double x, double y, double stepX, double stepY,
  std::ptrdiff_t columns, std::ptrdiff_t rows, int nodes = DefaultLatticeNodes)
{
  Georeference place;
  place.Crs = "a map";
  place.EquatorialRadius = WgsRadius;
  place.Flattening = WgsFlattening;
  place.Earth = true;
  place.Columns = columns;
  place.Rows = rows;
  place.HasGeoTransform = true;
  place.GeoTransform = { { x - 0.5 * stepX, stepX, 0.0,
    y + (static_cast<double>(rows) - 0.5) * stepY, 0.0, -stepY } };
  place.LatticeColumns = place.LatticeRows = nodes;
  for (int j = 0; j < nodes; ++j)
  {
    for (int i = 0; i < nodes; ++i)
    {
      double longitude = 0.0, latitude = 0.0;
      inverse(x + stepX * static_cast<double>(columns - 1) * i / (nodes - 1),
        y + stepY * static_cast<double>(rows - 1) * j / (nodes - 1), longitude, latitude);
      // Without a jump along the row, as in the output of readers.
      if (i > 0)
      {
        longitude += 360.0 * std::round((place.Longitude.back() - longitude) / 360.0);
      }
      place.Longitude.push_back(longitude);
      place.Latitude.push_back(latitude);
    }
  }
  return place;
}

inline void Geographic(double x, double y, double& longitude, double& latitude)
{
  longitude = x;
  latitude = y;
}

/// UTM without its false easting: x is measured from the meridian `longitude0`, y from the equator.
inline MapInverse Utm(double longitude0)
{
  return [longitude0](double x, double y, double& longitude, double& latitude)
  { GeographicLib::TransverseMercator::UTM().Reverse(longitude0, x, y, latitude, longitude); };
}

/// The Albers map of the conterminous United States (EPSG:5070 with latitude of origin 37.5).
inline const GeographicLib::AlbersEqualArea& Conus()
{
  static const GeographicLib::AlbersEqualArea map(WgsRadius, WgsFlattening, 29.5, 45.5, 1.0);
  return map;
}

inline double ConusOriginY()
{
  double x = 0.0, y = 0.0;
  Conus().Forward(-96.0, 37.5, -96.0, x, y);
  return y;
}

inline void Albers(double x, double y, double& longitude, double& latitude)
{
  Conus().Reverse(-96.0, x, y + ConusOriginY(), latitude, longitude);
}

inline void NorthPolar(double x, double y, double& longitude, double& latitude)
{
  GeographicLib::PolarStereographic::UPS().Reverse(true, x, y, latitude, longitude);
}

inline void WebMercator(double x, double y, double& longitude, double& latitude)
{
  longitude = x / WgsRadius * DegreesPerRadian;
  latitude = std::atan(std::sinh(y / WgsRadius)) * DegreesPerRadian;
}

inline double WebMercatorY(double latitude)
{
  return WgsRadius * std::asinh(std::tan(latitude * RadiansPerDegree));
}

/// The difference of two azimuths, -180 to 180 degrees.
inline double Turn(double a, double b)
{
  return std::remainder(a - b, 360.0);
}

} // namespace skyline

#endif
