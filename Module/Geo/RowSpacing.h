// SPDX-License-Identifier: BSD-3-Clause
// How many metres lie between the posts of each row.
#ifndef skyline_RowSpacing_h
#define skyline_RowSpacing_h

#include "Geo/Georeference.h"
#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// Rows whose spacing differs less than this from the centre row's count as all the same: a
/// distance off by 0.01 % turns no horizon by more than 0.003 degrees.
constexpr double RowSpacingUniformity = 1e-4;

/// Metres between columns and between rows.
struct PostSpacing
{
  double X = 1.0, Y = 1.0;
};

/// What the steps of a raster are.
enum class StepUnit
{
  Metres,        ///< on a map or without a place
  Degrees,       ///< of longitude and latitude
  DerivedDegrees ///< of another sphere of longitudes and latitudes, such as one with a rotated pole
};

/// Fills RowSpacingX and RowSpacingY (one pair a row from the south, or empty where every row is
/// within RowSpacingUniformity of the centre row) and returns the centre's spacing, metres.
///
/// `nominalX`, `nominalY`: the raster's steps, above 0. In degrees the true spacing is measured, by
/// GeographicLib's geodesics on the body's ellipsoid along the row and along the meridian. Metres are
/// true where GroundMetric finds them so; elsewhere the rows of a map that follows the graticule (web
/// Mercator, plate carree) get measured spacings. On every other map, and for derived degrees, no row has
/// one spacing: the rows stay empty, the centre's is returned, and GroundMetric tells the posts'. A height
/// field without a body, or smaller than a metre, keeps its nominal metres.
///
/// A row at a pole has no width; it gets the one a quarter of a row away, the mean over the half
/// row that its posts stand for. Throws std::invalid_argument for steps that are not positive
/// numbers, for degrees without a body, and what GroundMetric throws.
SKYLINECORE_EXPORT PostSpacing ComputeRowSpacing(
  Georeference& place, double nominalX, double nominalY, StepUnit unit = StepUnit::Metres);

} // namespace skyline

#endif
