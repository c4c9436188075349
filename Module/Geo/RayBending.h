// SPDX-License-Identifier: BSD-3-Clause
// How far a straight line on the map departs from the geodesic with the same starting direction.
#ifndef skyline_RayBending_h
#define skyline_RayBending_h

#include "Geo/Georeference.h"
#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// The greatest errors at the ends of rays that run straight over the image with the lengths and
/// angles at their receiver.
struct RayBending
{
  double Distance = 0.0; ///< relative
  double Azimuth = 0.0;  ///< degrees
  double Length = 0.0;   ///< metres: length of the longest measured ray
};

/// Compares rays of at most `longest` metres between the corners, the middles of the sides and the
/// centre of the raster with the geodesics of GeographicLib. All results are 0 without a place on a
/// body. Throws what Georeference::LonLatAt throws.
SKYLINECORE_EXPORT RayBending MeasureRayBending(const Georeference& place, double longest);

} // namespace skyline

#endif
