// SPDX-License-Identifier: BSD-3-Clause
#include "MapLight.h"

#include "Color/ToneMap.h"
#include "Data/ImageGeoreference.h"
#include "HeightArray.h"
#include "HeightField/Normals.h"
#include "PlacedSun.h"
#include "Shared/Constants.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkScalarsToColors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace skyline
{

namespace
{

constexpr double Missing = std::numeric_limits<double>::quiet_NaN();

/// Reads an array row by row, as doubles.
class ArrayRow
{
public:
  ArrayRow(vtkDataArray* array, vtkIdType columns)
    : Array(array)
    , Columns(columns)
    , Components(array ? array->GetNumberOfComponents() : 0)
    , Values(static_cast<std::size_t>(columns * this->Components))
  {
  }

  void Read(vtkIdType row)
  {
    if (this->Array)
    {
      ReadTuples(this->Array, row * this->Columns, this->Columns, this->Values.data());
    }
  }

  /// The components at a column; null if there is no array.
  const double* At(vtkIdType column) const
  {
    return this->Array ? this->Values.data() + column * this->Components : nullptr;
  }

private:
  vtkDataArray* Array;
  vtkIdType Columns, Components;
  std::vector<double> Values;
};

/// The light that reaches one post.
struct PostLight
{
  const double* SunVisibility; ///< null: all of the sun is visible
  const double* Sky;           ///< null: as on an open plane with the slope of the post
  const double* Further;       ///< null: none
};

/// Irradiance / pi of a post with the slopes east and north and a sun in the direction x, y, z.
Rgb LightOf(const MapLights& lights, const PostLight& post, double east, double north, double x,
  double y, double z)
{
  const double up = 1.0 / std::sqrt(1.0 + east * east + north * north);
  const double facing = std::max(0.0, up * (z - east * x - north * y));
  const double lit = post.SunVisibility ? *post.SunVisibility : 1.0;
  const double sky = post.Sky ? *post.Sky : 0.5 * (1.0 + up);
  Rgb light;
  for (std::size_t c = 0; c < 3; ++c)
  {
    light[c] = static_cast<float>(lights.SunIrradiance[c] * lit * facing / Pi +
      lights.SkyRadiance[c] * sky + (post.Further ? post.Further[c] / Pi : 0.0));
  }
  return light;
}

/// The georeference with the axes on which its directions are counted.
Georeference WithAxes(Georeference place, const GroundMetric& metric)
{
  place.GroundAxes = !metric.Uniform();
  return place;
}

} // namespace

Rgb GroundColors::operator()(double height) const
{
  if (!this->Table)
  {
    return ColorAt(*this->Map, PlaceOnMap(*this->Map, height, this->Low, this->High));
  }
  const unsigned char* color = this->Table->MapValue(height);
  return Rgb{ { DecodeSrgb(color[0] / 255.0f), DecodeSrgb(color[1] / 255.0f),
    DecodeSrgb(color[2] / 255.0f) } };
}

MapLight::MapLight(vtkImageData* image, vtkDataArray* heights, vtkSkylineSunLight* sun)
  : MapLight(
      heights, { image->GetSpacing()[0], image->GetSpacing()[1] }, GeoreferenceOf(image), sun)
{
}

MapLight::MapLight(
  vtkDataArray* heights, const PostSpacing& spacing, Georeference place, vtkSkylineSunLight* sun)
  : Heights(heights)
  , Columns(place.Columns)
  , Rows(place.Rows)
  , Metric(place, spacing)
  , Sun(SunFieldOf(sun, WithAxes(std::move(place), this->Metric), BaseHeightOf(heights)))
{
}

// Missing posts are NaN, and so are all posts outside the image.
void MapLight::ReadHeights(vtkIdType row, double* heights) const
{
  if (row < 0 || row >= this->Rows)
  {
    std::fill_n(heights, this->Columns, Missing);
    return;
  }
  ReadTuples(this->Heights, row * this->Columns, this->Columns, heights);
  std::replace_if(
    heights, heights + this->Columns, [](double height) { return !std::isfinite(height); },
    Missing);
}

void MapLight::LightRows(const MapLights& lights, const GroundColors& colors, vtkIdType first,
  vtkIdType last, float* radiance) const
{
  const vtkIdType columns = this->Columns;
  std::vector<double> lines(static_cast<std::size_t>(3 * columns));
  double* south = lines.data();
  double* here = south + columns;
  double* north = here + columns;
  std::vector<float> directions(static_cast<std::size_t>(3 * columns));
  float* x = directions.data();
  float* y = x + columns;
  float* z = y + columns;
  ArrayRow visibility(lights.SunVisibility, columns);
  ArrayRow sky(lights.Sky, columns);
  ArrayRow further(lights.Further, columns);
  const bool alike = this->Metric.Uniform() || this->Metric.ByRows();
  this->ReadHeights(first - 1, south);
  this->ReadHeights(first, here);
  for (vtkIdType row = first; row < last; ++row)
  {
    this->ReadHeights(row + 1, north);
    this->Sun.Row(row, 0, columns, x, y, z);
    visibility.Read(row);
    sky.Read(row);
    further.Read(row);
    const PostMetric ofRow = this->Metric.At(0.0, static_cast<double>(row));
    float* to = radiance + 3 * row * columns;
    for (vtkIdType i = 0; i < columns; ++i, to += 3)
    {
      if (std::isnan(here[i]))
      {
        std::fill_n(to, 3, std::numeric_limits<float>::quiet_NaN());
        continue;
      }
      const PostMetric metric =
        alike ? ofRow : this->Metric.At(static_cast<double>(i), static_cast<double>(row));
      const double west = i > 0 ? here[i - 1] : Missing;
      const double east = i + 1 < columns ? here[i + 1] : Missing;
      const double slopeY = AxisGradient(south[i], here[i], north[i], metric.Y);
      // On a sheared map a column lies further north than the column before.
      const double slopeX =
        AxisGradient(west, here[i], east, metric.X) - slopeY * metric.Shear / metric.X;
      const PostLight post{ visibility.At(i), sky.At(i), further.At(i) };
      const Rgb light = LightOf(lights, post, slopeX, slopeY, x[i], y[i], z[i]);
      const Rgb albedo = colors(here[i]);
      for (std::size_t c = 0; c < 3; ++c)
      {
        to[c] = albedo[c] * light[c];
      }
    }
    std::swap(south, here);
    std::swap(here, north);
  }
}

} // namespace skyline
