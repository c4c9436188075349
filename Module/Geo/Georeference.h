// SPDX-License-Identifier: BSD-3-Clause
// The position of a height field on its body, as plain numbers, without GDAL or VTK.
#ifndef skyline_Georeference_h
#define skyline_Georeference_h

#include "SkylineCoreModule.h" // for the export macro

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace skyline
{

/// The least number of nodes along each side of the lattice of longitudes and latitudes that a
/// reader makes. Between nodes the lattice is interpolated quadratically. On a side of s radians
/// (metres divided by the radius of the body), the error is about 0.1 (s / 32)^3 radians in place
/// and 0.3 (s / 32)^2 radians in convergence: 8 cm and 0.0004 degrees on a side of 1000 km. Readers
/// add nodes until LatticeTolerance holds. Geographic rasters of any size have no error beyond
/// rounding.
constexpr int DefaultLatticeNodes = 33;

/// Largest error that the lattice may cause in the length (relative) and in the direction (radians)
/// of a step: a fifth of the total that DistanceTolerance and AzimuthTolerance (GroundMetric.h)
/// allow.
constexpr double LatticeTolerance = 2e-4;

/// The steps from a post to the next column and to the next row, in metres on the ground towards
/// true east and true north.
struct PostSteps
{
  double EastPerColumn = 0.0, NorthPerColumn = 0.0;
  double EastPerRow = 0.0, NorthPerRow = 0.0;
};

/// Position and body of a height field. Columns and rows are counted from the south-west post. They
/// may be fractions and may lie slightly beyond the edge.
struct SKYLINECORE_EXPORT Georeference
{
  std::string Crs; ///< WKT of the coordinate system; empty: none

  /// In the order of GDAL and in CRS units, for the north-up raster with these posts as pixel
  /// centres.
  std::array<double, 6> GeoTransform{ { 0, 1, 0, 0, 0, -1 } };
  bool HasGeoTransform = false; ///< false: GeoTransform has no meaning

  /// True if the steps of the raster are degrees, also those of a derived CRS (rotated pole).
  /// Azimuths on the image are then measured with the true lengths of the steps.
  bool InDegrees = false;

  /// True if azimuths at the posts are counted on the ground, clockwise from the +y axis of the
  /// image, because the plane of the image is distorted (GroundMetric.h); false if on the image.
  /// Not stored.
  bool GroundAxes = false;

  double EquatorialRadius = 0.0; ///< metres; 0: no body known (no CRS)
  double Flattening = 0.0;       ///< (a - b) / a of the body's ellipsoid
  bool Earth = false;            ///< true: air refracts; false: airless or unknown

  std::ptrdiff_t Columns = 0, Rows = 0; ///< posts

  /// Longitude and latitude (geodetic, degrees) of LatticeColumns x LatticeRows nodes that are
  /// spread evenly over the posts, row by row from the south. The first node is the south-west
  /// post, the last one the north-east post. Longitudes are continuous (no jump at the
  /// antimeridian). Empty without a CRS.
  int LatticeColumns = 0, LatticeRows = 0;
  std::vector<double> Longitude, Latitude;

  /// True metres between columns and between rows, one pair per row from the south, if rows follow
  /// parallels and columns follow meridians. Empty if all rows have the spacing of the image or,
  /// where that does not hold, the lattice gives the lengths (GroundMetric.h). ComputeRowSpacing
  /// (RowSpacing.h) fills both lists.
  std::vector<double> RowSpacingX, RowSpacingY;

  bool OnBody() const { return this->EquatorialRadius > 0.0 && !this->Longitude.empty(); }

  /// Longitude and latitude (degrees) of a post. The longitude continues those of the lattice, so
  /// that it may lie beyond 180 degrees. For the error see DefaultLatticeNodes. This and all
  /// functions below throw std::invalid_argument if there is no body, if the size of the lattice is
  /// inconsistent, or if the post lies outside the domain of the map (NaN or infinities in the
  /// lattice).
  void LonLatAt(double column, double row, double& longitude, double& latitude) const;

  /// Meridian convergence (degrees): true azimuth = grid azimuth + convergence. It is the true
  /// azimuth of the +y axis of the image, positive where that axis points east of true north, which
  /// is the convention of surveyors and of GeographicLib. On conformal maps (UTM, Mercator, polar
  /// stereographic) it holds for every azimuth. On other maps it is the rotation nearest to the
  /// distortion of the map; GridAzimuthAt and TrueAzimuthAt are exact.
  double ConvergenceAt(double column, double row) const;

  /// Steps on the ground from a post to its neighbours. For the error see LatticeTolerance.
  PostSteps StepsAt(double column, double row) const;

  /// Returns true if the rows of the raster follow parallels and its columns follow meridians.
  bool FollowsGraticule() const;

  /// Azimuth on the image (degrees clockwise from its +y axis, from 0 to below 360) of the line
  /// from a post towards `trueAzimuth` (degrees clockwise from true north). For rasters in degrees
  /// and those that follow the graticule, the axes of the image have the true lengths of the steps.
  /// On other maps they have the lengths of the geotransform, and the result is the angle on the
  /// map.
  double GridAzimuthAt(double column, double row, double trueAzimuth) const;

  /// The inverse: true azimuth (degrees, from 0 to below 360) of the line from a post in the
  /// direction `gridAzimuth` on the image.
  double TrueAzimuthAt(double column, double row, double gridAzimuth) const;

  /// Azimuth on the ground (degrees clockwise from the +y axis of the image, from 0 to below 360)
  /// of `trueAzimuth`.
  double GroundAzimuthAt(double column, double row, double trueAzimuth) const;

  /// `trueAzimuth` on the axes of the computations on this field: GroundAzimuthAt if GroundAxes is
  /// true, otherwise GridAzimuthAt.
  double AxisAzimuthAt(double column, double row, double trueAzimuth) const;

  /// Gaussian mean radius of curvature sqrt(M N) of the ellipsoid at a latitude (degrees), in
  /// metres. On a sphere this is the radius.
  double LocalRadius(double latitude) const;
};

} // namespace skyline

#endif
