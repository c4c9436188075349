// SPDX-License-Identifier: BSD-3-Clause
#include "HorizonScene.h"

#include "BaseHeight.h"
#include "HeightLimits.h"
#include "HeightPyramid.h"
#include "MemoryDemand.h"
#include "Normals.h"
#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkSkylineGeoreference.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

namespace skyline
{

namespace
{

// Lines that one thread finds in a row: the search reuses what it learnt on the line before. A fixed
// number, so that the bits do not depend on the number of threads.
constexpr std::ptrdiff_t ChunkLines = 64;

// Error of a distance inside a band of rows with one spacing; 0.05 % turns no horizon by more than
// 0.0143 degrees, and one of 15 degrees by 0.0072 at the band's edge.
constexpr double BandTolerance = 0.0005;

// Floats from a line of slopes to the next: lines are written in whole blocks of 32, and an odd number
// of cache lines spreads them over the cache's sets when columns are turned into rows.
std::ptrdiff_t SlopeStride(std::ptrdiff_t lanes)
{
  return (lanes + 31) / 32 * 32 + 16;
}

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

Grid GridOf(vtkImageData* image)
{
  const int* dimensions = image->GetDimensions();
  const double* spacing = image->GetSpacing();
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
  return Grid{ dimensions[0], dimensions[1], spacing[0], spacing[1] };
}

} // namespace

HorizonScene::HorizonScene(vtkImageData* image, vtkDataArray* heights, const Options& options)
  : Heights(heights)
  , Where(LoadGeoreference(image))
  , Field(GridOf(image))
  , Settings(options.Settings)
  , Kept(options.Kept)
{
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

bool HorizonScene::Run(const std::vector<double>& azimuths, double width, Accumulator& consumer)
{
  const bool keep = this->Kept && this->Settings.Method == HorizonMethodKind::Pyramid;
  const auto method =
    MakeHorizonMethod(this->Field, this->Settings, keep ? this->PyramidOfHeights() : nullptr);
  return this->Run(*method, azimuths, width, consumer);
}

bool HorizonScene::Run(
  HorizonMethod& method, const std::vector<double>& azimuths, double width, Accumulator& consumer)
{
  Grid grid = this->Field.Posts();
  const double total = static_cast<double>(azimuths.size() * this->Bands.size());
  double done = 0.0;
  for (const double azimuth : azimuths)
  {
    consumer.Begin(azimuth * RadiansPerDegree, width);
    for (const RowBand& band : this->Bands)
    {
      if (this->Progress && !this->Progress(done++ / total))
      {
        return false;
      }
      const double start = Now();
      grid.SpacingX = band.SpacingX;
      grid.SpacingY = band.SpacingY;
      if (RayFrame::TakesColumns(grid, azimuth))
      {
        this->Field.Transpose(); // the first time; a sun in the north or south needs none
      }
      method.SetAzimuth(grid, azimuth);
      vtkSMPTools::For(0, method.PrepareCount(),
        [&](vtkIdType begin, vtkIdType end) { method.Prepare(begin, end); });
      const double prepared = Now();
      this->FindBand(method, band, consumer);
      this->PrepareSeconds += prepared - start;
      this->SearchSeconds += Now() - prepared;
    }
  }
  vtkSMPTools::For(
    0, grid.Rows, [&](vtkIdType begin, vtkIdType end) { consumer.Finish(begin, end); });
  return true;
}

void HorizonScene::FindBand(
  const HorizonMethod& method, const RowBand& band, Accumulator& consumer) const
{
  if (method.Frame().Columns)
  {
    this->FindColumns(method, band, consumer);
  }
  else
  {
    this->FindRows(method, band, consumer);
  }
}

void HorizonScene::FindRows(
  const HorizonMethod& method, const RowBand& band, Accumulator& consumer) const
{
  const RayFrame& frame = method.Frame();
  const std::ptrdiff_t begin = frame.Reversed ? frame.Lines - band.RowEnd : band.RowBegin;
  const std::ptrdiff_t end = frame.Reversed ? frame.Lines - band.RowBegin : band.RowEnd;
  const std::ptrdiff_t stride = SlopeStride(frame.Lanes);
  vtkSMPThreadLocal<std::vector<float>> buffers;
  vtkSMPTools::For(0, (end - begin + ChunkLines - 1) / ChunkLines, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<float>& slopes = buffers.Local();
      slopes.resize(static_cast<std::size_t>(ChunkLines * stride));
      for (std::ptrdiff_t chunk = first; chunk < last; ++chunk)
      {
        const std::ptrdiff_t from = begin + chunk * ChunkLines;
        const std::ptrdiff_t to = std::min(from + ChunkLines, end);
        method.Find(from, to, 0, frame.Lanes, slopes.data(), stride);
        for (std::ptrdiff_t line = from; line < to; ++line)
        {
          consumer.Add(
            frame.ImageLine(line), 0, frame.Lanes, slopes.data() + (line - from) * stride);
        }
      }
    });
}

void HorizonScene::FindColumns(
  const HorizonMethod& method, const RowBand& band, Accumulator& consumer) const
{
  // Lines are columns here, and consumers take runs along rows. Tiles keep these long: every run
  // lies in other pages of memory than the one before. Their slopes stay in the cache.
  constexpr std::ptrdiff_t TileLines = 4 * ChunkLines;
  constexpr std::ptrdiff_t TileRows = 256;
  const RayFrame& frame = method.Frame();
  const std::ptrdiff_t across = (frame.Lines + TileLines - 1) / TileLines;
  const std::ptrdiff_t along = (band.RowEnd - band.RowBegin + TileRows - 1) / TileRows;
  const std::ptrdiff_t stride = SlopeStride(TileRows);
  vtkSMPThreadLocal<std::vector<float>> buffers;
  vtkSMPTools::For(0, across * along, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<float>& slopes = buffers.Local();
      slopes.resize(static_cast<std::size_t>(TileLines * stride));
      float run[TileLines];
      for (std::ptrdiff_t tile = first; tile < last; ++tile)
      {
        const std::ptrdiff_t from = tile / along * TileLines;
        const std::ptrdiff_t count = std::min(TileLines, frame.Lines - from);
        const std::ptrdiff_t rowBegin = band.RowBegin + tile % along * TileRows;
        const std::ptrdiff_t rowEnd = std::min(rowBegin + TileRows, band.RowEnd);
        for (std::ptrdiff_t line = 0; line < count; line += ChunkLines)
        {
          const std::ptrdiff_t end = std::min(line + ChunkLines, count);
          method.Find(
            from + line, from + end, rowBegin, rowEnd, slopes.data() + line * stride, stride);
        }
        const std::ptrdiff_t column = frame.Reversed ? frame.ImageLine(from + count - 1) : from;
        const std::ptrdiff_t next = frame.Reversed ? -stride : stride;
        for (std::ptrdiff_t row = rowBegin; row < rowEnd; ++row)
        {
          const float* slope =
            slopes.data() + (frame.Reversed ? (count - 1) * stride : 0) + (row - rowBegin);
          for (std::ptrdiff_t i = 0; i < count; ++i)
          {
            run[i] = slope[i * next];
          }
          consumer.Add(row, column, count, run);
        }
      }
    });
}

void HorizonScene::FillGradients(float* east, float* north) const
{
  const Grid& grid = this->Field.Posts();
  const Georeference& place = this->Where;
  const double* spacingX = place.RowSpacingX.empty() ? nullptr : place.RowSpacingX.data();
  const double* spacingY = place.RowSpacingY.empty() ? nullptr : place.RowSpacingY.data();
  WithHeights(this->Heights, grid.Columns,
    [&](const auto& height)
    {
      vtkSMPTools::For(0, grid.Rows,
        [&](vtkIdType begin, vtkIdType end)
        { Gradients(grid, height, begin, end, east, north, spacingX, spacingY); });
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
  for (const RowBand& band : this->Bands)
  {
    grid.SpacingX = band.SpacingX;
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
  double all = static_cast<double>(floats + (this->TakesColumns(azimuths) ? 1 : 0));
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
