// SPDX-License-Identifier: BSD-3-Clause
// A written GeoTIFF read back, before anybody else sees it.
#ifndef skyline_GeoTiffCheck_h
#define skyline_GeoTiffCheck_h

#include "GeoTiffFile.h"

#include <gdal.h>

#include <functional>
#include <string>

namespace skyline
{

class AtomicFile;

/// What was to be written.
struct GeoTiffPromise
{
  const GeoTiffContent* Content = nullptr;
  GDALDataType Buffer = GDT_Float32; ///< numbers as they were handed to GDAL: Float32 or Float64
  double Nodata = 0.0;               ///< in place of missing posts
  bool DeclareNodata = false;
};

/// Reads every block of the file, on all threads, and compares every number with the arrays, and the
/// place on the map, the nodata value and the descriptions with what they should be. Overviews are
/// read, not compared. Throws IoFailure where the file is not what was promised.
/// `report` gets the part done and may throw.
void CheckGeoTiff(
  const GeoTiffPromise& promise, const AtomicFile& file, const std::function<void(double)>& report);

} // namespace skyline

#endif
