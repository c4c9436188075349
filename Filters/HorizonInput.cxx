// SPDX-License-Identifier: BSD-3-Clause
#include "HorizonInput.h"

#include "Data/ImageGeoreference.h"
#include "Data/MemoryDemand.h"
#include "Geo/RayBending.h"
#include "HeightChecksum.h"
#include "HeightField/BaseHeight.h"
#include "HeightField/Normals.h"
#include "Shared/Constants.h"
#include "Shared/HeightLimits.h"
#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkSMPTools.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>

namespace skyline
{

namespace
{

// Errors of straight rays at their far end that need no warning, since terrain that forms a horizon
// is seldom further away. Rasters in degrees stay below both limits up to 80 degrees of latitude.
constexpr double BendingReach = 20000.0; // metres
constexpr double BendingDistance = 0.005;
constexpr double BendingAzimuth = 0.6; // degrees

const char* const WarpCure = "a raster warped to a local map such as UTM (gdalwarp -t_srs)";

// The height, or NaN if it is missing.
double Known(double height)
{
  return std::abs(height) <= GreatestHeight ? height : std::numeric_limits<double>::quiet_NaN();
}

// Calls f(height), where height(column, row) reads the array in its own type.
template <typename Function>
void WithHeights(vtkDataArray* array, std::ptrdiff_t columns, Function&& function)
{
  const auto worker = [&](auto* typed)
  {
    const auto values = vtk::DataArrayValueRange<1>(typed);
    function([values, columns](std::ptrdiff_t column, std::ptrdiff_t row)
      { return Known(static_cast<double>(values[vtkIdType{ row } * columns + column])); });
  };
  if (!vtkArrayDispatch::Dispatch::Execute(array, worker))
  {
    worker(array);
  }
}

void CheckImage(vtkImageData* image)
{
  const int* dimensions = image->GetDimensions();
  if (dimensions[2] != 1)
  {
    throw std::invalid_argument(
      "the height field has " + std::to_string(dimensions[2]) + " slices; give an image with one");
  }
  if (!image->GetDirectionMatrix()->IsIdentity())
  {
    throw std::invalid_argument(
      "the height field's axes are turned; give an image whose x points east and y north");
  }
  // The heights, and the bounds of one azimuth: two floats per 16 lines, and per 8 times 16 lines.
  constexpr double bytes = sizeof(float) * (1.0 + 2.0 * (1.0 + 1.0 / 8.0) / 16.0);
  DemandMemory("the heights", dimensions[0], dimensions[1], bytes);
}

Georeference PlaceOf(vtkImageData* image)
{
  CheckImage(image);
  return GeoreferenceOf(image);
}

PostSpacing SpacingOf(vtkImageData* image)
{
  return { image->GetSpacing()[0], image->GetSpacing()[1] };
}

// The grid with the lengths at the centre.
Grid GridOf(vtkImageData* image, const GroundMetric& metric)
{
  const PostSpacing spacing = SpacingOf(image);
  Grid grid{ image->GetDimensions()[0], image->GetDimensions()[1], spacing.X, spacing.Y };
  if (!metric.Uniform() && !metric.ByRows())
  {
    return WithSpacing(grid, metric.Centre());
  }
  return grid;
}

// The number with two significant digits.
std::string ShortText(double number)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.2g", number);
  return text;
}

} // namespace

Grid WithSpacing(Grid posts, const PostMetric& metric)
{
  posts.SpacingX = metric.X;
  posts.SpacingY = metric.Y;
  posts.Shear = metric.Shear;
  return posts;
}

Grid WithSpacing(Grid posts, const RowBand& band)
{
  posts.SpacingX = band.SpacingX;
  posts.SpacingY = band.SpacingY;
  return posts;
}

HorizonInput::HorizonInput(vtkImageData* image, vtkDataArray* heights)
  : Values(heights)
  , Where(PlaceOf(image))
  , Metric(this->Where, SpacingOf(image))
  , Heights(GridOf(image, this->Metric))
{
  this->Where.GroundAxes = !this->Metric.Uniform();
  const Grid& grid = this->Posts();
  double range[2] = { 0.0, 0.0 };
  heights->GetFiniteRange(range, 0);
  if (!(range[0] <= range[1]) || !std::isfinite(range[0]) || !std::isfinite(range[1]))
  {
    throw std::invalid_argument("no surface: every post is missing");
  }
  WithHeights(heights, grid.Columns,
    [&](const auto& height)
    {
      this->Base = skyline::BaseHeight(grid.Columns * grid.Rows, range[0], range[1],
        [&](std::ptrdiff_t post) { return height(post % grid.Columns, post / grid.Columns); });
      vtkSMPTools::For(0, grid.Rows,
        [&](vtkIdType begin, vtkIdType end)
        { this->Heights.Fill(begin, end, this->Base, height); });
    });
  this->Heights.Close();
  if (this->Heights.AllMissing())
  {
    throw std::invalid_argument("no surface: every post is missing, or higher than any body");
  }
  this->RowsOfOneSpacing = RowBands(this->Metric);
}

double HorizonInput::CurvatureDrop(double refraction) const
{
  if (!this->Where.OnBody())
  {
    return 0.0;
  }
  double longitude = 0.0;
  double latitude = 0.0;
  this->Where.LonLatAt(0.5 * static_cast<double>(this->Posts().Columns - 1),
    0.5 * static_cast<double>(this->Posts().Rows - 1), longitude, latitude);
  return (1.0 - (this->Where.Earth ? refraction : 0.0)) / (2.0 * this->Where.LocalRadius(latitude));
}

std::uint64_t HorizonInput::Checksum()
{
  if (this->Sum == 0)
  {
    this->Sum = HeightChecksum(this->Heights);
  }
  return this->Sum;
}

PostMetric HorizonInput::CentreMetric() const
{
  const Grid& grid = this->Posts();
  return { grid.SpacingX, grid.Shear, grid.SpacingY };
}

void HorizonInput::FillGradients(float* east, float* north) const
{
  const Grid& grid = this->Posts();
  WithHeights(this->Values, grid.Columns,
    [&](const auto& height)
    {
      vtkSMPTools::For(0, grid.Rows,
        [&](vtkIdType begin, vtkIdType end)
        {
          Gradients(grid, height, begin, end, east, north, this->Metric.RowSpacingX(),
            this->Metric.RowSpacingY());
          for (vtkIdType row = begin; row < end && !this->Metric.ByRows(); ++row)
          {
            this->Metric.TurnGradients(row, { grid.SpacingX, grid.SpacingY }, grid.Columns,
              east + row * grid.Columns, north + row * grid.Columns);
          }
        });
    });
}

std::optional<Doubt> HorizonInput::BendingDoubt() const
{
  if (this->Metric.Uniform())
  {
    return std::nullopt;
  }
  const RayBending bending = MeasureRayBending(this->Where, BendingReach);
  if (bending.Distance <= BendingDistance && bending.Azimuth <= BendingAzimuth)
  {
    return std::nullopt;
  }
  return Doubt{ "the map bends long rays: at a distance of " +
      std::to_string(std::lround(bending.Length)) + " m, distances are wrong by up to " +
      ShortText(100.0 * bending.Distance) + " % and directions by up to " +
      ShortText(bending.Azimuth) + " degrees",
    "rays are straight on the map, with the lengths at their receivers", WarpCure };
}

std::optional<Doubt> HorizonInput::OneMetricDoubt(
  const std::string& what, const PostMetric& used) const
{
  if (this->Metric.Uniform() || this->Metric.ByRows())
  {
    return std::nullopt; // the method uses bands of rows
  }
  const MetricError error = this->Metric.WorstError(used);
  if (error.Distance <= DistanceTolerance && error.Azimuth <= AzimuthTolerance * RadiansPerDegree)
  {
    return std::nullopt;
  }
  return Doubt{ "the map is distorted: distances of " + what + " are wrong by up to " +
      ShortText(100.0 * error.Distance) + " % and directions by up to " +
      ShortText(error.Azimuth * DegreesPerRadian) + " degrees somewhere in the raster",
    "the lengths of its centre everywhere", WarpCure };
}

} // namespace skyline
