// SPDX-License-Identifier: BSD-3-Clause
// How far a straight line on the map leaves the geodesic that it begins as.
#ifndef skyline_RayBending_h
#define skyline_RayBending_h

#include "Geo/Georeference.h"
#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// The greatest errors at the ends of rays, which run straight over the image with the lengths and
/// angles of their receiver.
struct RayBending
{
  double Distance = 0.0; ///< relative
  double Azimuth = 0.0;  ///< degrees
  double Length = 0.0;   ///< metres: the longest ray that was measured
};

/// Measures rays of at most `longest` metres between the corners, the middles of the sides and the
/// centre of the raster against GeographicLib's geodesics. All 0 without a place on a body. Throws as
/// Georeference::LonLatAt.
SKYLINECORE_EXPORT RayBending MeasureRayBending(const Georeference& place, double longest);

} // namespace skyline

#endif
