// SPDX-License-Identifier: BSD-3-Clause
// A written GeoTIFF is read back before it gets its final name.
#ifndef skyline_GeoTiffCheck_h
#define skyline_GeoTiffCheck_h

#include "GeoTiffFile.h"

#include <gdal.h>

#include <functional>
#include <string>

namespace skyline
{

class AtomicFile;

/// What the file should contain.
struct ExpectedGeoTiff
{
  const GeoTiffContent* Content = nullptr;
  GDALDataType Buffer = GDT_Float32; ///< type of the numbers given to GDAL: Float32 or Float64
  double Nodata = 0.0;               ///< written for missing posts
  bool DeclareNodata = false;
};

/// Reads every block of the file, on all threads. Compares each number with the arrays, and the
/// georeference, the nodata value and the descriptions with the expected ones. Overviews are read
/// but not compared. Throws IoFailure if the file differs from `expected`. `report` receives the
/// completed part (0 to 1) and may throw.
void CheckGeoTiff(const ExpectedGeoTiff& expected, const AtomicFile& file,
  const std::function<void(double)>& report);

} // namespace skyline

#endif
