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

/// The colour of the ground (albedo, linear RGB) by its height: of a named map, or of VTK's colours.
struct GroundColors
{
  const ColorMap* Map;
  vtkScalarsToColors* Table; ///< null: Map
  double Low, High;          ///< metres, the first and the last colour of Map

  Rgb operator()(double height) const;
};

/// What shines on all posts. The arrays, which may be null, have one tuple for each post.
struct MapLights
{
  std::array<double, 3> SunIrradiance; ///< of a surface that faces the sun
  std::array<double, 3> SkyRadiance;
  vtkDataArray* SunVisibility; ///< 0 to 1; null: the sun is never hidden
  vtkDataArray* Sky;     ///< share of the sky's light; null: that of a plane with the post's slope
  vtkDataArray* Further; ///< irradiance, RGB; null: none
};

/// The posts of an image and the sun over them, ready to be lit.
class MapLight
{
public:
  /// Heights in metres, one for each post; both must outlive this. Throws std::exception with a one-line
  /// reason where the georeference or the time of the sun is not usable.
  MapLight(vtkImageData* image, vtkDataArray* heights, vtkSkylineSunLight* sun);

  /// Radiance of a Lambertian ground in the rows [first, last): three floats for each post of the image,
  /// NaN where the height is missing.
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
