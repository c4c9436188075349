// SPDX-License-Identifier: BSD-3-Clause
// How the values of a band are converted to metres above a datum, and which doubts remain.
#ifndef skyline_HeightConversion_h
#define skyline_HeightConversion_h

#include "CoordinateSystem.h"
#include "Shared/Doubt.h"

#include <gdal_priv.h>

#include <string>
#include <vector>

namespace skyline
{

/// metres = value * Scale + Offset
struct HeightConversion
{
  double Scale = 1.0, Offset = 0.0;
};

/// The scale and the offset of the band are applied first. The unit is the first of these that is
/// given: the unit of the band, the unit in its metadata (units, unit, GRIB_UNIT), the unit of the
/// vertical axis of the CRS, metres. Adds doubts to `doubts` about contradictory units, heights
/// without a unit on a map that is not in metres, depths, and bands of a picture. Throws IoFailure,
/// which names `file`, if the unit is not a length or the scale cannot be used.
HeightConversion ReadHeightConversion(GDALDataset& dataset, GDALRasterBand& band,
  const CoordinateSystem& crs, const std::string& file, std::vector<Doubt>& doubts);

} // namespace skyline

#endif
