// SPDX-License-Identifier: BSD-3-Clause
#include "HeightField/HeightPyramid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace skyline
{

namespace
{

constexpr double LeastStep = 1.0; // below this, bilinear samples would skip posts
constexpr double GreatestStep = 16.0;

std::vector<SplineTaps> TapsOf(double scale, std::ptrdiff_t posts, std::ptrdiff_t samples)
{
  std::vector<SplineTaps> taps(static_cast<std::size_t>(posts));
  for (std::ptrdiff_t post = 0; post < posts; ++post)
  {
    taps[static_cast<std::size_t>(post)] = TapsAt(static_cast<double>(post), scale, samples);
  }
  return taps;
}

std::ptrdiff_t SamplesOf(std::ptrdiff_t posts, double scale)
{
  // 1e-9 allows for rounding, because the scale is a power of the ratio.
  const double samples = std::ceil(static_cast<double>(posts) / scale - 1e-9);
  return std::max<std::ptrdiff_t>(1, static_cast<std::ptrdiff_t>(samples));
}

} // namespace

int PyramidLevels(std::ptrdiff_t posts, double step)
{
  return static_cast<int>(std::ceil(step * std::log2(static_cast<double>(posts)) - 1e-9)) + 1;
}

std::vector<PyramidSize> PyramidSizes(std::ptrdiff_t columns, std::ptrdiff_t rows, double step)
{
  if (!(step >= LeastStep && step <= GreatestStep))
  {
    throw std::invalid_argument(
      "the pyramid has " + std::to_string(step) + " levels per octave; give 1 to 16");
  }
  const int levels = PyramidLevels(std::max(columns, rows), step);
  std::vector<PyramidSize> sizes(static_cast<std::size_t>(levels));
  for (int i = 0; i < levels; ++i)
  {
    const double scale = std::exp2((levels - 1 - i) / step);
    sizes[static_cast<std::size_t>(i)] = { scale, SamplesOf(columns, scale),
      SamplesOf(rows, scale) };
  }
  sizes.back() = { 1.0, columns, rows };
  return sizes;
}

std::vector<LinearTaps> DecimationTaps(double ratio, std::ptrdiff_t fine, std::ptrdiff_t coarse)
{
  std::vector<LinearTaps> taps(static_cast<std::size_t>(coarse));
  for (std::ptrdiff_t c = 0; c < coarse; ++c)
  {
    const double place = (static_cast<double>(c) + 0.5) * ratio - 0.5;
    const double low = std::floor(place);
    const auto first = static_cast<std::ptrdiff_t>(low);
    taps[static_cast<std::size_t>(c)] = { std::min(first, fine - 1), std::min(first + 1, fine - 1),
      static_cast<float>(place - low) };
  }
  return taps;
}

SplineTaps TapsAt(double place, double scale, std::ptrdiff_t samples)
{
  const double at = (place + 0.5) / scale - 0.5;
  const double low = std::floor(at);
  const double u = at - low;
  const double v = 1.0 - u;
  SplineTaps taps;
  taps.Weights = { static_cast<float>(v * v * v / 6.0),
    static_cast<float>((3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0),
    static_cast<float>((3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0),
    static_cast<float>(u * u * u / 6.0) };
  for (std::ptrdiff_t k = 0; k < 4; ++k)
  {
    taps.Samples[static_cast<std::size_t>(k)] =
      std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(low) - 1 + k, 0, samples - 1);
  }
  return taps;
}

HeightPyramid::HeightPyramid(const HeightField& field, double step)
  : Columns(field.Posts().Columns)
  , Stride((field.Posts().Columns + 2 * Margin + 15) / 16 * 16)
  , Missing(field.HasMissing())
{
  const Grid& grid = field.Posts();
  const std::vector<PyramidSize> sizes = PyramidSizes(grid.Columns, grid.Rows, step);
  const int levels = static_cast<int>(sizes.size());
  this->Pyramid.resize(sizes.size());

  PyramidLevel& finest = this->Pyramid.back();
  finest.Columns = grid.Columns;
  finest.Rows = grid.Rows;
  finest.Heights.resize(static_cast<std::size_t>(grid.Columns * grid.Rows));
  finest.Coverage.resize(this->Missing ? finest.Heights.size() : 0);
  for (std::ptrdiff_t row = 0; row < grid.Rows; ++row)
  {
    const float* line = field.RowPlane().Line(row);
    float* heights = finest.Heights.data() + row * grid.Columns;
    for (std::ptrdiff_t column = 0; column < grid.Columns; ++column)
    {
      heights[column] = line[column] > 0.5f * MissingHeight ? line[column] : 0.0f;
    }
    if (this->Missing)
    {
      float* coverage = finest.Coverage.data() + row * grid.Columns;
      for (std::ptrdiff_t column = 0; column < grid.Columns; ++column)
      {
        coverage[column] = line[column] > 0.5f * MissingHeight ? 1.0f : 0.0f;
      }
    }
  }
  for (int i = levels - 2; i >= 0; --i)
  {
    const auto index = static_cast<std::size_t>(i);
    PyramidLevel& level = this->Pyramid[index];
    level.Scale = sizes[index].Scale;
    level.Columns = sizes[index].Columns;
    level.Rows = sizes[index].Rows;
    this->Decimate(this->Pyramid[index + 1], level);
  }

  this->FirstRow.push_back(0);
  for (const PyramidLevel& level : this->Pyramid)
  {
    this->FirstRow.push_back(this->FirstRow.back() + level.Rows);
    const bool last = &level == &finest; // read without smoothing
    this->Across.push_back(TapsOf(level.Scale, last ? 0 : grid.Columns, level.Columns));
    this->Along.push_back(TapsOf(level.Scale, last ? 0 : grid.Rows, level.Rows));
  }
  this->Expanded.resize(static_cast<std::size_t>(this->RowCount() * this->Stride));
  this->ExpandedCoverage.resize(this->Missing ? this->Expanded.size() : 0);
}

void HeightPyramid::Decimate(const PyramidLevel& fine, PyramidLevel& coarse) const
{
  const double ratio = coarse.Scale / fine.Scale;
  const std::vector<LinearTaps> across = DecimationTaps(ratio, fine.Columns, coarse.Columns);
  const std::vector<LinearTaps> along = DecimationTaps(ratio, fine.Rows, coarse.Rows);
  std::vector<float> mixed(static_cast<std::size_t>(fine.Columns));
  const auto decimate = [&](const std::vector<float>& from, std::vector<float>& to)
  {
    to.resize(static_cast<std::size_t>(coarse.Columns * coarse.Rows));
    for (std::ptrdiff_t row = 0; row < coarse.Rows; ++row)
    {
      const LinearTaps& taps = along[static_cast<std::size_t>(row)];
      const float* first = from.data() + taps.First * fine.Columns;
      const float* second = from.data() + taps.Second * fine.Columns;
      const float weight = taps.Weight;
      float* mix = mixed.data();
      for (std::ptrdiff_t column = 0; column < fine.Columns; ++column)
      {
        mix[column] = first[column] + weight * (second[column] - first[column]);
      }
      float* out = to.data() + row * coarse.Columns;
      for (const LinearTaps& tap : across)
      {
        *out++ = mix[tap.First] + tap.Weight * (mix[tap.Second] - mix[tap.First]);
      }
    }
  };
  decimate(fine.Heights, coarse.Heights);
  if (this->Missing)
  {
    decimate(fine.Coverage, coarse.Coverage);
  }
}

void HeightPyramid::Expand(std::ptrdiff_t begin, std::ptrdiff_t end)
{
  int i = 0;
  for (std::ptrdiff_t row = begin; row < end; ++row)
  {
    while (this->FirstRow[static_cast<std::size_t>(i) + 1] <= row)
    {
      ++i;
    }
    this->ExpandRow(i, row - this->FirstRow[static_cast<std::size_t>(i)]);
  }
}

void HeightPyramid::ExpandRow(int i, std::ptrdiff_t row)
{
  const PyramidLevel& level = this->Level(i);
  const std::vector<SplineTaps>& taps = this->Across[static_cast<std::size_t>(i)];
  const auto expand = [&](const std::vector<float>& samples, const std::vector<float>& rows)
  {
    const float* from = samples.data() + row * level.Columns;
    float* out = const_cast<float*>(this->At(rows, i, row));
    if (taps.empty())
    {
      std::copy_n(from, this->Columns, out);
      return;
    }
    for (const SplineTaps& tap : taps)
    {
      *out++ = tap.Weights[0] * from[tap.Samples[0]] + tap.Weights[1] * from[tap.Samples[1]] +
        tap.Weights[2] * from[tap.Samples[2]] + tap.Weights[3] * from[tap.Samples[3]];
    }
  };
  expand(level.Heights, this->Expanded);
  if (this->Missing)
  {
    expand(level.Coverage, this->ExpandedCoverage);
  }
}

} // namespace skyline
