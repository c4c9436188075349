// SPDX-License-Identifier: BSD-3-Clause
// The light that the ground of a map picture sends up, row by row.
#ifndef skyline_MapLight_h
#define skyline_MapLight_h

#include "Color/ColorMaps.h"
#include "Geo/GroundMetric.h"
#include "Sun/SunField.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkType.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
class vtkScalarsToColors;
class vtkSkylineSunLight;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// The colour of the ground (albedo, linear RGB) by its height, from a named colour map or a lookup
/// table.
struct GroundColors
{
  const ColorMap* Map;
  vtkScalarsToColors* Table; ///< null: use Map
  double Low, High;          ///< heights of the first and last colour of Map, metres

  Rgb operator()(double height) const;
};

/// The light on all posts. Arrays may be null; the others have one tuple per post.
struct MapLights
{
  std::array<double, 3> SunIrradiance; ///< on a surface that faces the sun
  std::array<double, 3> SkyRadiance;
  vtkDataArray* SunVisibility; ///< 0 to 1; null: the sun is never hidden
  vtkDataArray* Sky;           ///< share of the light of the sky; null: as on an open plane
  vtkDataArray* Further;       ///< further irradiance, RGB; null: none
};

/// The posts of an image and the sun over them, ready for lighting.
class MapLight
{
public:
  /// `heights` has one height in metres per post. Image and heights must outlive this. Throws
  /// std::exception, with a reason of one line, if the georeference or the time of the sun cannot
  /// be used.
  MapLight(vtkImageData* image, vtkDataArray* heights, vtkSkylineSunLight* sun);

  /// Writes the radiance of a Lambertian ground in the rows [first, last): three floats per post of
  /// the image, NaN where the height is missing.
  void LightRows(const MapLights& lights, const GroundColors& colors, vtkIdType first,
    vtkIdType last, float* radiance) const;

private:
  MapLight(
    vtkDataArray* heights, const PostSpacing& spacing, Georeference place, vtkSkylineSunLight* sun);
  void ReadHeights(vtkIdType row, double* heights) const;

  vtkDataArray* Heights;
  vtkIdType Columns, Rows;
  GroundMetric Metric;
  SunField Sun;
};

} // namespace skyline

#endif
