// SPDX-License-Identifier: BSD-3-Clause
// How the values of a band become metres upwards, and what is doubtful about it.
#ifndef skyline_HeightMeaning_h
#define skyline_HeightMeaning_h

#include "CoordinateSystem.h"
#include "Shared/Doubt.h"

#include <gdal_priv.h>

#include <string>
#include <vector>

namespace skyline
{

/// metres = value * Scale + Offset
struct HeightMeaning
{
  double Scale = 1.0, Offset = 0.0;
};

/// The unit is the band's; else that of the band's metadata (units, unit, GRIB_UNIT), else that of the
/// CRS's vertical axis, else metres. Scale and offset of the band come first. Doubts are added to
/// `doubts`: units that contradict each other, heights of no unit on a map that does not count in
/// metres, depths, parts of pictures. IoFailure, which names `file`, for a unit that is no length and a
/// scale that cannot be used.
HeightMeaning ReadHeightMeaning(GDALDataset& dataset, GDALRasterBand& band,
  const CoordinateSystem& crs, const std::string& file, std::vector<Doubt>& doubts);

} // namespace skyline

#endif
