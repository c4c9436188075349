// SPDX-License-Identifier: BSD-3-Clause
// The georeference of a height field as field data, so that it travels down a VTK pipeline.
#ifndef skyline_ImageGeoreference_h
#define skyline_ImageGeoreference_h

#include "Geo/Georeference.h"
#include "SkylineCoreModule.h"      // for the export macro
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Field data arrays of a georeference. An array that would say nothing is absent.
constexpr const char* CrsArrayName = "CRS";                   ///< string: WKT
constexpr const char* GeoTransformArrayName = "GeoTransform"; ///< 6 doubles, GDAL's order
constexpr const char* BodyArrayName = "BodyEllipsoid";    ///< metres, flattening, 1 on the Earth
constexpr const char* LatticeArrayName = "LonLatLattice"; ///< pairs of degrees, node by node
constexpr const char* LatticeSizeArrayName = "LonLatLatticeSize"; ///< 2 ints: columns, rows
constexpr const char* RowSpacingArrayName = "RowSpacing";         ///< pairs of metres, row by row
constexpr const char* DegreesArrayName =
  "StepsInDegrees"; ///< 1 double, 1: the raster's steps are degrees
constexpr const char* PostCountArrayName = "PostCount"; ///< 2 doubles: columns, rows
constexpr const char* NodataArrayName = "NodataValue";  ///< 1 double: the file's nodata value

/// Puts `georeference` into the field data of `data`, in place of the one that was there.
SKYLINECORE_EXPORT void StoreGeoreference(const Georeference& georeference, vtkDataObject* data);

/// The georeference in the field data of `data`. What is absent or malformed has its default
/// value; without PostCount an image's own dimensions count. `data` may be null.
SKYLINECORE_EXPORT Georeference LoadGeoreference(vtkDataObject* data);

/// The same for a height field whose posts it must count: std::invalid_argument where a crop or a
/// resampling has left the image with the place of other posts. Without a place, the image's own
/// dimensions count.
SKYLINECORE_EXPORT Georeference GeoreferenceOf(vtkImageData* image);

/// Puts the nodata value that a raster declared into the field data of `data`.
SKYLINECORE_EXPORT void StoreNodataValue(double value, vtkDataObject* data);

/// Reads that value into `value`; false, and `value` as it was, where none is declared.
SKYLINECORE_EXPORT bool LoadNodataValue(vtkDataObject* data, double& value);

} // namespace skyline

#endif
