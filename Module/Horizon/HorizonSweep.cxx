// SPDX-License-Identifier: BSD-3-Clause
#include "Horizon/HorizonSweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skyline
{

namespace
{

struct Sample
{
  double Place, Height; // metres towards the azimuth, and metres
};

double SlopeBetween(const Sample& from, const Sample& to)
{
  return (to.Height - from.Height) / (to.Place - from.Place);
}

// Computes the bilinear height at a fractional (column, row). Returns false outside the data and in
// incomplete cells.
bool HeightAt(const PaddedPlane& rows, double column, double row, double& height)
{
  const double columnFloor = std::floor(column);
  const double rowFloor = std::floor(row);
  if (!(columnFloor >= 0.0) || !(rowFloor >= 0.0) || column > static_cast<double>(rows.Lanes - 1) ||
    row > static_cast<double>(rows.Lines - 1))
  {
    return false;
  }
  const auto i = static_cast<std::ptrdiff_t>(columnFloor);
  const auto j = static_cast<std::ptrdiff_t>(rowFloor);
  const double x = column - columnFloor;
  const double y = row - rowFloor;
  const std::ptrdiff_t right = x > 0.0 ? 1 : 0;
  const std::ptrdiff_t up = y > 0.0 ? 1 : 0;
  const float* low = rows.Line(j) + i;
  const float* high = rows.Line(j + up) + i;
  if (std::min({ low[0], low[right], high[0], high[right] }) <= 0.5f * MissingHeight)
  {
    return false;
  }
  height =
    (1.0 - y) * ((1.0 - x) * low[0] + x * low[right]) + y * ((1.0 - x) * high[0] + x * high[right]);
  return true;
}

} // namespace

HorizonSweep::HorizonSweep(const HeightField& field, const HorizonSettings& settings)
  : Field(field)
  , Settings(settings)
{
}

void HorizonSweep::SetAzimuth(const Grid& grid, double azimuth)
{
  this->Ray = std::make_unique<RayFrame>(this->Field, grid, azimuth, this->Settings.CurvatureDrop);
  // The step is one post for any spacing. On a grid whose posts are 1000 times as far apart along
  // one axis as along the other, a step of the shorter spacing would make several 100000 samples
  // per post.
  const PostsPerMetre ray = RayOfAzimuth(grid, azimuth);
  const double rate = std::hypot(ray.Columns, ray.Rows);
  this->Along = { ray.Columns / rate, ray.Rows / rate };
  this->Step = 1.0 / rate;
  const auto width = static_cast<double>(grid.Columns - 1);
  const auto height = static_cast<double>(grid.Rows - 1);
  const double alongEast = this->Along.East * width;
  const double alongNorth = this->Along.North * height;
  const double acrossEast = this->Along.North * width;
  const double acrossNorth = -this->Along.East * height;
  this->AlongBegin = std::min(alongEast, 0.0) + std::min(alongNorth, 0.0);
  this->AcrossBegin = std::min(acrossEast, 0.0) + std::min(acrossNorth, 0.0);
  const double length = std::abs(alongEast) + std::abs(alongNorth);
  const double breadth = std::abs(acrossEast) + std::abs(acrossNorth);
  this->Samples = static_cast<std::ptrdiff_t>(std::ceil(length - 1e-9)) + 1;
  this->LineCount = static_cast<std::ptrdiff_t>(std::ceil(breadth - 1e-9)) + 1;
  this->Slopes.resize(static_cast<std::size_t>(this->LineCount * this->Samples));
}

SweepLines HorizonSweep::LinesOfSweep() const
{
  const Direction& to = this->Along;
  const double along = this->AlongBegin;
  const double across = this->AcrossBegin;
  return { this->LineCount, this->Samples,
    { along * to.East + across * to.North, along * to.North - across * to.East },
    { to.East, to.North }, { to.North, -to.East }, along * this->Step, this->Step,
    this->Settings.CurvatureDrop };
}

void HorizonSweep::Prepare(std::ptrdiff_t begin, std::ptrdiff_t end)
{
  const double drop = this->Settings.CurvatureDrop;
  std::vector<Sample> hull(static_cast<std::size_t>(this->Samples));
  for (std::ptrdiff_t line = begin; line < end; ++line)
  {
    float* slopes = this->Slopes.data() + line * this->Samples;
    const double across = this->AcrossBegin + static_cast<double>(line);
    std::size_t depth = 0;
    for (std::ptrdiff_t index = this->Samples - 1; index >= 0; --index)
    {
      const double along = this->AlongBegin + static_cast<double>(index);
      const double column = along * this->Along.East + across * this->Along.North;
      const double row = along * this->Along.North - across * this->Along.East;
      const double place = along * this->Step;
      Sample sample{ place, 0.0 };
      if (!HeightAt(this->Field.RowPlane(), column, row, sample.Height))
      {
        slopes[index] = std::numeric_limits<float>::quiet_NaN();
        continue;
      }
      // Curvature adds a parabola along the line, which does not change the order of slopes.
      sample.Height -= drop * place * place;
      while (depth >= 2 &&
        SlopeBetween(sample, hull[depth - 1]) <= SlopeBetween(sample, hull[depth - 2]))
      {
        --depth;
      }
      slopes[index] = depth == 0
        ? NoTerrainSlope
        : static_cast<float>(SlopeBetween(sample, hull[depth - 1]) + 2.0 * drop * place);
      hull[depth++] = sample;
    }
  }
}

void HorizonSweep::Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
  std::ptrdiff_t laneEnd, float* slopes, std::ptrdiff_t stride) const
{
  const RayFrame& frame = *this->Ray;
  for (std::ptrdiff_t line = lineBegin; line < lineEnd; ++line)
  {
    const double imageLine = static_cast<double>(frame.ImageLine(line));
    float* out = slopes + (line - lineBegin) * stride;
    for (std::ptrdiff_t lane = laneBegin; lane < laneEnd; ++lane)
    {
      const double column = frame.Columns ? imageLine : static_cast<double>(lane);
      const double row = frame.Columns ? static_cast<double>(lane) : imageLine;
      const double s = column * this->Along.East + row * this->Along.North - this->AlongBegin;
      const double t = column * this->Along.North - row * this->Along.East - this->AcrossBegin;
      // The four samples around the post. If some lie outside the data, or have no terrain beyond
      // them, the others share their weight.
      double sum = 0.0;
      double weights = 0.0;
      for (int corner = 0; corner < 4; ++corner)
      {
        const double sampleFloor = std::floor(s) + (corner & 1);
        const double lineFloor = std::floor(t) + (corner >> 1);
        const double weight = (1.0 - std::abs(s - sampleFloor)) * (1.0 - std::abs(t - lineFloor));
        const auto i = static_cast<std::ptrdiff_t>(sampleFloor);
        const auto j = static_cast<std::ptrdiff_t>(lineFloor);
        if (weight <= 0.0 || i < 0 || j < 0 || i >= this->Samples || j >= this->LineCount)
        {
          continue;
        }
        const float slope = this->Slopes[static_cast<std::size_t>(j * this->Samples + i)];
        if (std::isnan(slope) || slope == NoTerrainSlope)
        {
          continue;
        }
        sum += weight * slope;
        weights += weight;
      }
      out[lane - laneBegin] = weights > 0.0 ? static_cast<float>(sum / weights) : NoTerrainSlope;
    }
  }
}

} // namespace skyline
