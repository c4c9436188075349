// SPDX-License-Identifier: BSD-3-Clause
// Metres between the posts of each row.
#ifndef skyline_RowSpacing_h
#define skyline_RowSpacing_h

#include "Geo/Georeference.h"
#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// If the spacings of all rows differ from that of the centre row by less than this part, they
/// count as equal: an error of 0.01 % in a distance changes no horizon by more than 0.003 degrees.
constexpr double RowSpacingUniformity = 1e-4;

/// Metres between columns and between rows.
struct PostSpacing
{
  double X = 1.0, Y = 1.0;
};

/// The unit of the steps of a raster.
enum class StepUnit
{
  Metres,        ///< on a map, or without a place on a body
  Degrees,       ///< of longitude and latitude
  DerivedDegrees ///< of a derived system, such as one with a rotated pole
};

/// Fills RowSpacingX and RowSpacingY (one pair per row from the south, or empty if all rows are
/// within RowSpacingUniformity of the centre row) and returns the spacing at the centre in metres.
///
/// `nominalX`, `nominalY`: the steps of the raster, above 0. For steps in degrees, the true spacing
/// is measured with the geodesics of GeographicLib on the ellipsoid of the body, along the row and
/// along the meridian. Steps in metres are used if GroundMetric finds them true; otherwise the rows
/// of a map that follows the graticule (web Mercator, plate carree) get measured spacings. On all
/// other maps, and for derived degrees, no row has one spacing: both lists stay empty, the spacing
/// at the centre is returned, and GroundMetric gives those at the posts. A height field without a
/// body, or smaller than a metre, keeps its nominal metres.
///
/// A row at a pole has no width. It gets the spacing a quarter of a row away, which is the mean
/// over the half row that its posts stand for. Throws std::invalid_argument for steps that are not
/// positive numbers and for degrees without a body, and what GroundMetric throws.
SKYLINECORE_EXPORT PostSpacing ComputeRowSpacing(
  Georeference& place, double nominalX, double nominalY, StepUnit unit = StepUnit::Metres);

} // namespace skyline

#endif
