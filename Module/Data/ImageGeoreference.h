// SPDX-License-Identifier: BSD-3-Clause
// Stores the georeference of a height field as field data, so that it passes through a VTK
// pipeline.
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

/// Field data arrays of a georeference. An array without information is absent.
constexpr const char* CrsArrayName = "CRS";                   ///< string: WKT
constexpr const char* GeoTransformArrayName = "GeoTransform"; ///< 6 doubles in GDAL's order
constexpr const char* BodyArrayName = "BodyEllipsoid";        ///< equatorial radius in metres,
                                                              ///< flattening, 1 on the Earth or
                                                              ///< 0 elsewhere
constexpr const char* LatticeArrayName = "LonLatLattice"; ///< longitude and latitude in degrees of
                                                          ///< each node
constexpr const char* LatticeSizeArrayName = "LonLatLatticeSize"; ///< 2 ints: columns, rows
constexpr const char* RowSpacingArrayName = "RowSpacing";         ///< pairs of metres, one pair per
                                                                  ///< row
constexpr const char* DegreesArrayName =
  "StepsInDegrees"; ///< 1 double, 1: the raster's steps are degrees
constexpr const char* PostCountArrayName = "PostCount"; ///< 2 doubles: columns, rows
constexpr const char* NodataArrayName = "NodataValue";  ///< 1 double: the file's nodata value

/// Stores `georeference` in the field data of `data`, replacing an earlier one.
SKYLINECORE_EXPORT void StoreGeoreference(const Georeference& georeference, vtkDataObject* data);

/// Reads the georeference from the field data of `data`, which may be null. Absent or malformed
/// items get their default values. Without PostCount, the dimensions of an image are used.
SKYLINECORE_EXPORT Georeference LoadGeoreference(vtkDataObject* data);

/// The same for a height field. Throws std::invalid_argument if the number of posts in the
/// georeference differs from that of the image, as after cropping or resampling. A georeference
/// without geotransform, body and row spacings gets the dimensions of the image instead.
SKYLINECORE_EXPORT Georeference GeoreferenceOf(vtkImageData* image);

/// Stores the nodata value that a raster declares in the field data of `data`.
SKYLINECORE_EXPORT void StoreNodataValue(double value, vtkDataObject* data);

/// Reads the nodata value into `value`. If none is stored, returns false and leaves `value`
/// unchanged.
SKYLINECORE_EXPORT bool LoadNodataValue(vtkDataObject* data, double& value);

} // namespace skyline

#endif
