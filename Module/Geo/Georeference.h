// SPDX-License-Identifier: BSD-3-Clause
// Where a height field lies on its body, as plain numbers: no GDAL, no VTK.
#ifndef skyline_Georeference_h
#define skyline_Georeference_h

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace skyline
{

/// Nodes that a reader gives the lattice of longitudes and latitudes along each side. Between nodes
/// a quadratic interpolates, so a side of s radians (metres over the body's radius) costs about 0.1
/// (s / 32)^3 radians of place and 0.3 (s / 32)^2 radians of convergence: 8 cm and 0.0004 degrees
/// on a side of 1000 km. Geographic rasters of any size have no error beyond rounding.
constexpr int DefaultLatticeNodes = 33;

/// Position and body of a height field. Post (column, row) counts from the south-west post; columns
/// and rows may be fractional, and reach a little over the edge.
struct Georeference
{
  std::string Crs; ///< WKT of the coordinate system; empty: none

  /// GDAL's, in CRS units, of the north-up raster with the same posts as pixel centres.
  std::array<double, 6> GeoTransform{ { 0, 1, 0, 0, 0, -1 } };
  bool HasGeoTransform = false; ///< false: the numbers above mean nothing

  double EquatorialRadius = 0.0; ///< metres; 0: no body known (no CRS)
  double Flattening = 0.0;       ///< (a - b) / a of the body's ellipsoid
  bool Earth = false;            ///< true: air refracts; false: airless or unknown

  std::ptrdiff_t Columns = 0, Rows = 0; ///< posts

  /// Longitude and latitude (degrees, geodetic) of LatticeColumns x LatticeRows nodes spread evenly
  /// over the posts, first node = south-west post, last = north-east post; row by row from the
  /// south. Longitudes are continuous (no jump at the antimeridian). Empty: no CRS.
  int LatticeColumns = 0, LatticeRows = 0;
  std::vector<double> Longitude, Latitude;

  /// True metres between columns and between rows, one pair a row from the south; empty: the same
  /// everywhere (the image's spacing). ComputeRowSpacing (RowSpacing.h) fills them.
  std::vector<double> RowSpacingX, RowSpacingY;

  bool OnBody() const { return this->EquatorialRadius > 0.0 && !this->Longitude.empty(); }

  /// Longitude and latitude (degrees) of a post. The longitude continues the lattice's, so it may
  /// lie beyond 180. Error: see DefaultLatticeNodes. Throws std::invalid_argument, as all functions
  /// below do, when there is no body, the lattice does not have the size it says, or the post lies
  /// outside the map's domain (NaN or infinities in the lattice).
  void LonLatAt(double column, double row, double& longitude, double& latitude) const;

  /// Meridian convergence (degrees): true azimuth = grid azimuth + convergence. It is the true
  /// azimuth of the image's +y axis, positive where that points east of true north, as surveyors
  /// and GeographicLib count it. On maps that keep angles (UTM, Mercator, polar stereographic) it
  /// serves every azimuth; on others it is the rotation nearest to the map's distortion, and
  /// GridAzimuthAt is exact.
  double ConvergenceAt(double column, double row) const;

  /// Azimuth on the image (degrees clockwise from its +y axis, 0 up to 360) of the line that runs
  /// from a post towards `trueAzimuth` (degrees clockwise from true north). The image is taken with
  /// the spacing it is computed with: RowSpacing where there is one, the geotransform's otherwise.
  double GridAzimuthAt(double column, double row, double trueAzimuth) const;

  /// Metres: Gaussian mean radius of curvature sqrt(M N) of the body's ellipsoid at a latitude
  /// (degrees); the radius itself on a sphere.
  double LocalRadius(double latitude) const;
};

} // namespace skyline

#endif
