// SPDX-License-Identifier: BSD-3-Clause
// Where a height field lies on its body, as plain numbers: no GDAL, no VTK.
#ifndef skyline_Georeference_h
#define skyline_Georeference_h

#include "SkylineCoreModule.h" // for the export macro

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace skyline
{

/// Nodes that a reader gives the lattice of longitudes and latitudes along each side at least. Between
/// nodes a quadratic interpolates, so a side of s radians (metres over the body's radius) costs about
/// 0.1 (s / 32)^3 radians of place and 0.3 (s / 32)^2 radians of convergence: 8 cm and 0.0004 degrees
/// on a side of 1000 km. Readers take more nodes until LatticeTolerance holds. Geographic rasters of any
/// size have no error beyond rounding.
constexpr int DefaultLatticeNodes = 33;

/// Largest error of a step's length (relative) and direction (radians) that a lattice may bring: a fifth
/// of what DistanceTolerance and AzimuthTolerance (GroundMetric.h) leave in all.
constexpr double LatticeTolerance = 2e-4;

/// The steps from a post to the next column and to the next row, metres on the ground to the true east
/// and north.
struct PostSteps
{
  double EastPerColumn = 0.0, NorthPerColumn = 0.0;
  double EastPerRow = 0.0, NorthPerRow = 0.0;
};

/// Position and body of a height field. Post (column, row) counts from the south-west post; columns
/// and rows may be fractional, and reach a little over the edge.
struct SKYLINECORE_EXPORT Georeference
{
  std::string Crs; ///< WKT of the coordinate system; empty: none

  /// GDAL's, in CRS units, of the north-up raster with the same posts as pixel centres.
  std::array<double, 6> GeoTransform{ { 0, 1, 0, 0, 0, -1 } };
  bool HasGeoTransform = false; ///< false: the numbers above mean nothing

  /// The raster's steps are degrees, be it of a derived CRS (rotated pole): azimuths on the image are
  /// then measured with the steps' true lengths.
  bool InDegrees = false;

  /// Directions over the posts are counted on the ground, clockwise from the image's +y axis, because
  /// the image's own plane is distorted (GroundMetric.h); false: on the image. Not stored.
  bool GroundAxes = false;

  double EquatorialRadius = 0.0; ///< metres; 0: no body known (no CRS)
  double Flattening = 0.0;       ///< (a - b) / a of the body's ellipsoid
  bool Earth = false;            ///< true: air refracts; false: airless or unknown

  std::ptrdiff_t Columns = 0, Rows = 0; ///< posts

  /// Longitude and latitude (degrees, geodetic) of LatticeColumns x LatticeRows nodes spread evenly
  /// over the posts, first node = south-west post, last = north-east post; row by row from the
  /// south. Longitudes are continuous (no jump at the antimeridian). Empty: no CRS.
  int LatticeColumns = 0, LatticeRows = 0;
  std::vector<double> Longitude, Latitude;

  /// True metres between columns and between rows, one pair a row from the south, where rows follow
  /// parallels and columns meridians; empty: the same everywhere (the image's spacing) or, if that does
  /// not hold, what the lattice says (GroundMetric.h). ComputeRowSpacing (RowSpacing.h) fills them.
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
  /// GridAzimuthAt and TrueAzimuthAt are exact.
  double ConvergenceAt(double column, double row) const;

  /// How a post's neighbours lie on the ground. Error: see LatticeTolerance.
  PostSteps StepsAt(double column, double row) const;

  /// True where the raster's rows follow parallels and its columns meridians.
  bool FollowsGraticule() const;

  /// Azimuth on the image (degrees clockwise from its +y axis, 0 up to 360) of the line that runs
  /// from a post towards `trueAzimuth` (degrees clockwise from true north). The image's axes count in
  /// the steps' true lengths on rasters in degrees and on those that follow the graticule, in the
  /// geotransform's lengths on other maps: there it is the angle on the map.
  double GridAzimuthAt(double column, double row, double trueAzimuth) const;

  /// The inverse: true azimuth (degrees, 0 up to 360) of the line that runs from a post in the direction
  /// `gridAzimuth` on the image.
  double TrueAzimuthAt(double column, double row, double gridAzimuth) const;

  /// Azimuth on the ground, clockwise from the image's +y axis (0 up to 360), of `trueAzimuth`.
  double GroundAzimuthAt(double column, double row, double trueAzimuth) const;

  /// `trueAzimuth` as the computations on this field count: GroundAzimuthAt with GroundAxes, else
  /// GridAzimuthAt.
  double AxisAzimuthAt(double column, double row, double trueAzimuth) const;

  /// Metres: Gaussian mean radius of curvature sqrt(M N) of the body's ellipsoid at a latitude
  /// (degrees); the radius itself on a sphere.
  double LocalRadius(double latitude) const;
};

} // namespace skyline

#endif
