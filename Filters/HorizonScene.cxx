// SPDX-License-Identifier: BSD-3-Clause
#include "HorizonScene.h"

#include "Data/ImageGeoreference.h"
#include "Data/MemoryDemand.h"
#include "Geo/RayBending.h"
#include "HeightField/BaseHeight.h"
#include "HeightField/HeightPyramid.h"
#include "HeightField/Normals.h"
#include "Shared/HeightLimits.h"
#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

namespace skyline
{

namespace
{

// What straight rays may be wrong by at their far end without a warning: terrain that shapes a horizon is
// seldom further away. Rasters in degrees stay within both up to 80 degrees of latitude.
constexpr double BendingReach = 20000.0; // metres
constexpr double BendingDistance = 0.005;
constexpr double BendingAzimuth = 0.6; // degrees

void SetMetric(Grid& grid, const PostMetric& metric)
{
  grid.SpacingX = metric.X;
  grid.SpacingY = metric.Y;
  grid.Shear = metric.Shear;
}

// Error of a distance inside a band of rows with one spacing, for the methods that take bands; 0.05 %
// turns no horizon by more than 0.0143 degrees, and one of 15 degrees by 0.0072 at the band's edge.
constexpr double BandTolerance = 0.0005;

double Now()
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

// Turns a sum and what is added to it into the next sum, all bits into all bits.
std::uint64_t Mixed(std::uint64_t sum, std::uint64_t value)
{
  constexpr std::uint64_t odd = 0x9e3779b97f4a7c15; // 2^64 over the golden ratio
  const std::uint64_t product = (sum ^ value) * odd;
  return product ^ (product >> 32);
}

// A height, or NaN where a number is none.
double Known(double height)
{
  return std::abs(height) <= GreatestHeight ? height : std::numeric_limits<double>::quiet_NaN();
}

// Calls f(height) with a height(column, row) that reads the array in its own type.
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
  // The plane of rows, and the bounds of one azimuth: two floats for 16 lines, and for 8 times 16.
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

// With the lengths of the centre.
Grid GridOf(vtkImageData* image, const GroundMetric& metric)
{
  const PostSpacing spacing = SpacingOf(image);
  Grid grid{ image->GetDimensions()[0], image->GetDimensions()[1], spacing.X, spacing.Y };
  if (!metric.Uniform() && !metric.ByRows())
  {
    SetMetric(grid, metric.Centre());
  }
  return grid;
}

std::string Percent(double part)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.2g", 100.0 * part);
  return text;
}

std::string Degrees(double radians)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.2g", radians * DegreesPerRadian);
  return text;
}

} // namespace

HorizonScene::HorizonScene(vtkImageData* image, vtkDataArray* heights, const Options& options)
  : Heights(heights)
  , Where(PlaceOf(image))
  , Metric(this->Where, SpacingOf(image))
  , Field(GridOf(image, this->Metric))
  , Settings(options.Settings)
  , Kept(options.Kept)
{
  this->Where.GroundAxes = !this->Metric.Uniform();
  const Grid& grid = this->Field.Posts();
  double range[2] = { 0.0, 0.0 };
  heights->GetFiniteRange(range, 0);
  if (!(range[0] <= range[1]) || !std::isfinite(range[0]) || !std::isfinite(range[1]))
  {
    throw std::invalid_argument("no surface: every post is missing");
  }
  WithHeights(heights, grid.Columns,
    [&](const auto& height)
    {
      this->Mean = BaseHeight(grid.Columns * grid.Rows, range[0], range[1],
        [&](std::ptrdiff_t post) { return height(post % grid.Columns, post / grid.Columns); });
      vtkSMPTools::For(0, grid.Rows,
        [&](vtkIdType begin, vtkIdType end) { this->Field.Fill(begin, end, this->Mean, height); });
    });
  this->Field.Close();
  if (this->Field.AllMissing())
  {
    throw std::invalid_argument("no surface: every post is missing, or higher than any body");
  }

  if (!options.Flat && this->Where.OnBody())
  {
    double longitude = 0.0;
    double latitude = 0.0;
    this->Where.LonLatAt(0.5 * static_cast<double>(grid.Columns - 1),
      0.5 * static_cast<double>(grid.Rows - 1), longitude, latitude);
    const double refraction = this->Where.Earth ? options.Refraction : 0.0;
    this->Settings.Sink = (1.0 - refraction) / (2.0 * this->Where.LocalRadius(latitude));
  }
  this->Bands = RowBands(this->Where, PostSpacing{ grid.SpacingX, grid.SpacingY }, BandTolerance);
  this->DoubtBending();
}

void HorizonScene::DoubtBending()
{
  if (this->Metric.Uniform())
  {
    return;
  }
  const RayBending bending = MeasureRayBending(this->Where, BendingReach);
  if (bending.Distance <= BendingDistance && bending.Azimuth <= BendingAzimuth)
  {
    return;
  }
  this->Doubts.push_back(
    { "the map bends far rays: at " + std::to_string(std::lround(bending.Length)) +
        " m distances are wrong by up to " + Percent(bending.Distance) +
        " % and directions by up to " + Degrees(bending.Azimuth * RadiansPerDegree) + " degrees",
      "rays straight on the map, with the lengths at their receiver",
      "a raster warped to a local map such as UTM (gdalwarp -t_srs)" });
}

std::uint64_t HorizonScene::Fingerprint()
{
  if (this->Heights64 == 0)
  {
    const Grid& grid = this->Field.Posts();
    std::vector<std::uint64_t> rows(static_cast<std::size_t>(grid.Rows));
    vtkSMPTools::For(0, grid.Rows,
      [&](vtkIdType begin, vtkIdType end)
      {
        std::vector<float> buffer;
        for (vtkIdType row = begin; row < end; ++row)
        {
          const float* line = this->Field.Receivers(false, row, buffer);
          std::uint64_t sum = static_cast<std::uint64_t>(grid.Columns);
          for (std::ptrdiff_t column = 0; column < grid.Columns; ++column)
          {
            std::uint32_t bits = 0;
            std::memcpy(&bits, line + column, sizeof(bits));
            sum = Mixed(sum, bits);
          }
          rows[static_cast<std::size_t>(row)] = sum;
        }
      });
    for (const std::uint64_t row : rows)
    {
      this->Heights64 = Mixed(this->Heights64, row);
    }
    this->Heights64 |= 1; // 0: not yet asked for
  }
  return this->Heights64;
}

std::shared_ptr<const HeightPyramid> HorizonScene::PyramidOfHeights()
{
  const double step = this->Settings.Pyramid.LevelStep;
  if (!this->Kept->Pyramid || this->Kept->LevelStep != step ||
    this->Kept->Heights != this->Fingerprint())
  {
    const double start = Now();
    this->Kept->Pyramid = nullptr; // its memory first
    const auto pyramid = std::make_shared<HeightPyramid>(this->Field, step);
    vtkSMPTools::For(
      0, pyramid->RowCount(), [&](vtkIdType begin, vtkIdType end) { pyramid->Expand(begin, end); });
    *this->Kept = { this->Fingerprint(), step, pyramid };
    ++this->PyramidBuilds;
    this->PrepareSeconds += Now() - start;
  }
  return this->Kept->Pyramid;
}

bool HorizonScene::Run(
  const std::vector<double>& azimuths, double width, Accumulator& consumer, AzimuthAxes axes)
{
  const bool keep = this->Kept && this->Settings.Method == HorizonMethodKind::Pyramid;
  const auto method =
    MakeHorizonMethod(this->Field, this->Settings, keep ? this->PyramidOfHeights() : nullptr);
  if (this->Metric.Uniform() || !this->FollowsGround())
  {
    if (!this->FollowsGround())
    {
      this->DoubtOneMetric(
        this->Settings.Method == HorizonMethodKind::Sweep ? "the sweep" : "the pyramid",
        this->CentreMetric());
    }
    return this->Run(*method, azimuths, width, consumer, axes);
  }
  return this->RunFans(*method, azimuths, width, consumer, axes);
}

bool HorizonScene::FollowsGround() const
{
  return this->Settings.Method == HorizonMethodKind::Exact ||
    this->Settings.Method == HorizonMethodKind::Fast;
}

void HorizonScene::Prepare(
  HorizonMethod& method, const Grid& grid, double azimuth, const PostRegion& region)
{
  if (RayFrame::TakesColumns(grid, azimuth))
  {
    this->Field.Transpose(); // the first time; a sun in the north or south needs none
  }
  method.SetAzimuth(grid, azimuth);
  AskFor(method, region);
  vtkSMPTools::For(
    0, method.PrepareCount(), [&](vtkIdType begin, vtkIdType end) { method.Prepare(begin, end); });
}

bool HorizonScene::RunFans(HorizonMethod& method, const std::vector<double>& azimuths, double width,
  Accumulator& consumer, AzimuthAxes axes)
{
  Grid grid = this->Field.Posts();
  const PostRegion whole{ 0, grid.Rows, 0, grid.Columns };
  std::unique_ptr<FanBlend> blend;
  for (std::size_t number = 0; number < azimuths.size(); ++number)
  {
    consumer.Begin(azimuths[number] * RadiansPerDegree, width);
    const RayFan fan(
      this->Metric, azimuths[number], axes == AzimuthAxes::Image, this->Settings.Sink > 0.0);
    if (!fan.IsOne())
    {
      if (!blend)
      {
        blend = std::make_unique<FanBlend>(this->Metric);
      }
      blend->Begin(fan);
    }
    for (std::size_t i = 0; i < fan.Directions.size(); ++i)
    {
      for (std::size_t j = 0; j < fan.Lengths.size(); ++j)
      {
        const double part = static_cast<double>(i * fan.Lengths.size() + j) /
          static_cast<double>(fan.Directions.size() * fan.Lengths.size());
        if (this->Progress &&
          !this->Progress(
            (static_cast<double>(number) + part) / static_cast<double>(azimuths.size())))
        {
          return false;
        }
        PostRegion posts = whole;
        if (!fan.IsOne() && !blend->Asks(i, j, posts))
        {
          continue;
        }
        const double start = Now();
        SetMetric(grid, fan.MetricOf(j));
        this->Prepare(method, grid, fan.Directions[i], posts);
        const double prepared = Now();
        if (fan.IsOne())
        {
          FindSlopes(method, whole,
            [&](std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, float* slopes)
            {
              FanBlend::Lengthen(this->Metric, method.Frame(), row, column, count, slopes);
              consumer.Add(row, column, count, slopes);
            });
        }
        else
        {
          blend->Add(method);
        }
        this->PrepareSeconds += prepared - start;
        this->SearchSeconds += Now() - prepared;
      }
    }
    if (!fan.IsOne())
    {
      blend->End(consumer);
    }
  }
  vtkSMPTools::For(
    0, grid.Rows, [&](vtkIdType begin, vtkIdType end) { consumer.Finish(begin, end); });
  return true;
}

bool HorizonScene::Run(HorizonMethod& method, const std::vector<double>& azimuths, double width,
  Accumulator& consumer, AzimuthAxes axes)
{
  Grid grid = this->Field.Posts();
  const double total = static_cast<double>(azimuths.size() * this->Bands.size());
  double done = 0.0;
  const auto add = [&](std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count,
                     const float* slopes) { consumer.Add(row, column, count, slopes); };
  for (const double azimuth : azimuths)
  {
    consumer.Begin(azimuth * RadiansPerDegree, width);
    const double ground = axes == AzimuthAxes::Image
      ? this->Metric.GroundAzimuth(this->CentreMetric(), azimuth)
      : azimuth;
    for (const RowBand& band : this->Bands)
    {
      if (this->Progress && !this->Progress(done++ / total))
      {
        return false;
      }
      const double start = Now();
      grid.SpacingX = band.SpacingX;
      grid.SpacingY = band.SpacingY;
      const PostRegion region{ band.RowBegin, band.RowEnd, 0, grid.Columns };
      this->Prepare(method, grid, ground, region);
      const double prepared = Now();
      FindSlopes(method, region, add);
      this->PrepareSeconds += prepared - start;
      this->SearchSeconds += Now() - prepared;
    }
  }
  vtkSMPTools::For(
    0, grid.Rows, [&](vtkIdType begin, vtkIdType end) { consumer.Finish(begin, end); });
  return true;
}

PostMetric HorizonScene::CentreMetric() const
{
  const Grid& grid = this->Field.Posts();
  return { grid.SpacingX, grid.Shear, grid.SpacingY };
}

void HorizonScene::DoubtOneMetric(const std::string& what, const PostMetric& used)
{
  if (this->Metric.Uniform() || this->Metric.ByRows())
  {
    return; // bands of rows follow
  }
  const MetricError error = this->Metric.WorstError(used);
  if (error.Distance <= DistanceTolerance && error.Azimuth <= AzimuthTolerance * RadiansPerDegree)
  {
    return;
  }
  const Doubt doubt{ "the map is distorted: distances of " + what + " are wrong by up to " +
      Percent(error.Distance) + " % and directions by up to " + Degrees(error.Azimuth) +
      " degrees somewhere in the raster",
    "the lengths of its centre everywhere",
    "a raster warped to a local map such as UTM (gdalwarp -t_srs)" };
  for (const Doubt& known : this->Doubts)
  {
    if (DoubtText(known) == DoubtText(doubt))
    {
      return;
    }
  }
  this->Doubts.push_back(doubt);
}

void HorizonScene::FillGradients(float* east, float* north) const
{
  const Grid& grid = this->Field.Posts();
  const bool own = this->Metric.ByRows();
  const double* spacingX = own ? this->Where.RowSpacingX.data() : nullptr;
  const double* spacingY = own ? this->Where.RowSpacingY.data() : nullptr;
  WithHeights(this->Heights, grid.Columns,
    [&](const auto& height)
    {
      vtkSMPTools::For(0, grid.Rows,
        [&](vtkIdType begin, vtkIdType end)
        {
          Gradients(grid, height, begin, end, east, north, spacingX, spacingY);
          for (vtkIdType row = begin; row < end && !own; ++row)
          {
            this->Metric.TurnGradients(row, { grid.SpacingX, grid.SpacingY }, grid.Columns,
              east + row * grid.Columns, north + row * grid.Columns);
          }
        });
    });
}

void HorizonScene::BlankMissing(vtkFloatArray* array) const
{
  if (!this->Field.HasMissing())
  {
    return;
  }
  const std::ptrdiff_t components = array->GetNumberOfComponents();
  float* values = array->GetPointer(0);
  std::vector<float> buffer;
  for (std::ptrdiff_t row = 0; row < this->Posts().Rows; ++row)
  {
    const float* heights = this->Field.Receivers(false, row, buffer);
    for (std::ptrdiff_t column = 0; column < this->Posts().Columns; ++column)
    {
      if (heights[column] <= 0.5f * MissingHeight)
      {
        float* post = values + (row * this->Posts().Columns + column) * components;
        std::fill(post, post + components, std::numeric_limits<float>::quiet_NaN());
      }
    }
  }
}

std::ptrdiff_t HorizonScene::CountNotFinite(vtkFloatArray* array) const
{
  const std::ptrdiff_t components = array->GetNumberOfComponents();
  const float* post = array->GetPointer(0);
  std::ptrdiff_t count = 0;
  std::vector<float> buffer;
  for (std::ptrdiff_t row = 0; row < this->Posts().Rows; ++row)
  {
    const float* heights = this->Field.Receivers(false, row, buffer);
    for (std::ptrdiff_t column = 0; column < this->Posts().Columns; ++column, post += components)
    {
      const bool finite =
        std::all_of(post, post + components, [](float value) { return std::isfinite(value); });
      count += finite || heights[column] <= 0.5f * MissingHeight ? 0 : 1;
    }
  }
  return count;
}

bool HorizonScene::TakesColumns(const std::vector<double>& azimuths) const
{
  Grid grid = this->Field.Posts();
  // Whatever the azimuths' axes: near the diagonal one more plane is asked for than may be needed.
  const double slack = this->Metric.Uniform() ? 1.0 : 2.0;
  for (const RowBand& band : this->Bands)
  {
    grid.SpacingX = band.SpacingX / slack;
    grid.SpacingY = band.SpacingY;
    for (const double azimuth : azimuths)
    {
      if (RayFrame::TakesColumns(grid, azimuth))
      {
        return true;
      }
    }
  }
  return false;
}

void HorizonScene::DemandFloats(
  const char* what, std::ptrdiff_t floats, const std::vector<double>& azimuths) const
{
  const std::ptrdiff_t blend =
    this->Metric.Uniform() || !this->FollowsGround() ? 0 : FanBlend::Floats;
  double all = static_cast<double>(floats + blend + (this->TakesColumns(azimuths) ? 1 : 0));
  if (this->Settings.Method == HorizonMethodKind::Pyramid && !(this->Kept && this->Kept->Pyramid))
  {
    // Each level is 1 / b of the one below in rows, and of its own samples 1 / b^2 (HeightPyramid.h).
    const double ratio = std::exp2(-1.0 / this->Settings.Pyramid.LevelStep);
    const double copies = 1.0 / (1.0 - ratio) + 1.0 / (1.0 - ratio * ratio);
    all += copies * (this->Field.HasMissing() ? 2.0 : 1.0);
  }
  DemandMemory(what, this->Posts().Columns, this->Posts().Rows, all * sizeof(float));
}

vtkFloatArray* HorizonScene::AddArray(vtkImageData* output, const char* name, int components) const
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(output->GetNumberOfPoints());
  if (array->GetNumberOfTuples() != output->GetNumberOfPoints())
  {
    throw std::runtime_error(std::string("no memory for ") + name + ": " +
      std::to_string(output->GetNumberOfPoints()) + " posts of " + std::to_string(components) +
      " floats; ask for less at a time, or give a coarser or smaller raster");
  }
  output->GetPointData()->AddArray(array);
  return array;
}

} // namespace skyline
