// SPDX-License-Identifier: BSD-3-Clause
// A harmonic is a polar part times a wave in azimuth, so that the sum over a map proceeds row by
// row: first the sums of the waves over the row, 2 bands - 1 numbers per channel, then each of
// these is added to its bands. Over a pixel,
//   Int cos(m p) dp = cos(m p_centre) 2 sin(m w / 2) / m,   w = 2 pi / Columns
// and the polar part is integrated by a Gauss rule. A trigonometric polynomial of degree 8 over at
// most pi / 16 is close to one of low degree: 8 nodes have an error of 1e-20.
#include "Sky/LightMap.h"

#include "Shared/Constants.h"
#include "Shared/GaussRule.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skyline
{

namespace
{

/// Least number of rows, or parts of rows, into which the range of polar angles is divided.
constexpr std::ptrdiff_t LeastPolarSteps = 16;

constexpr int PolarNodes = 8;

} // namespace

LightMapDirection PixelDirection(const LightMap& map, std::ptrdiff_t row, std::ptrdiff_t column)
{
  const double polar = Pi * (row + 0.5) / map.Rows;
  const double azimuth = 2.0 * Pi * (column + 0.5) / map.Columns - Pi;
  const double level = std::sin(polar);
  return { level * std::sin(azimuth), level * std::cos(azimuth), std::cos(polar) };
}

// cos t - cos(t + s) = 2 sin(t + s / 2) sin(s / 2), which is accurate at the zenith.
double PixelSolidAngle(const LightMap& map, std::ptrdiff_t row)
{
  const double middle = Pi * (row + 0.5) / map.Rows, half = 0.5 * Pi / map.Rows;
  return 2.0 * Pi / map.Columns * 2.0 * std::sin(middle) * std::sin(half);
}

LightMapDefects SanitizeLightMap(float* values, std::ptrdiff_t pixels)
{
  LightMapDefects defects;
  float largest[3] = { 0.0f, 0.0f, 0.0f };
  for (std::ptrdiff_t pixel = 0; pixel < pixels; ++pixel)
  {
    float* channels = values + 3 * pixel;
    bool negative = false, notNumber = false, infinite = false;
    for (int c = 0; c < 3; ++c)
    {
      const float value = channels[c];
      const bool finite = std::abs(value) <= std::numeric_limits<float>::max();
      negative = negative || value < 0.0f;
      notNumber = notNumber || value != value;
      infinite = infinite || (value > 0.0f && !finite);
      if (finite)
      {
        largest[c] = std::max(largest[c], value);
      }
      if (!(value > 0.0f)) // also makes minus zero zero
      {
        channels[c] = 0.0f;
      }
    }
    defects.Negative += negative ? 1 : 0;
    defects.NotNumbers += notNumber ? 1 : 0;
    defects.Infinite += infinite ? 1 : 0;
  }
  if (defects.Infinite > 0)
  {
    for (std::ptrdiff_t pixel = 0; pixel < pixels; ++pixel)
    {
      for (int c = 0; c < 3; ++c)
      {
        values[3 * pixel + c] =
          std::isinf(values[3 * pixel + c]) ? largest[c] : values[3 * pixel + c];
      }
    }
  }
  return defects;
}

LightMapProjection::LightMapProjection(
  std::ptrdiff_t columns, std::ptrdiff_t rows, int bands, PixelRule rule)
  : Columns(columns)
  , Rows(rows)
  , Bands(bands)
  , Rule(rule)
  , WaveCount(bands > 4 ? 8 : 4)
  , Waves(static_cast<std::size_t>(columns) * 2 * WaveCount)
  , PixelWidth(static_cast<std::size_t>(WaveCount))
{
  const double width = 2.0 * Pi / columns;
  for (int m = 0; m < this->WaveCount; ++m)
  {
    this->PixelWidth[m] =
      m == 0 || rule == PixelRule::Centre ? width : 2.0 * std::sin(0.5 * m * width) / m;
    for (std::ptrdiff_t column = 0; column < columns; ++column)
    {
      // Counter-clockwise from east: pi / 2 - azimuth.
      const double angle = 1.5 * Pi - width * (column + 0.5);
      double* waves = &this->Waves[static_cast<std::size_t>(column) * 2 * this->WaveCount];
      waves[m] = std::cos(m * angle);
      waves[this->WaveCount + m] = std::sin(m * angle);
    }
  }
}

/// Integrals of the polar parts over a row, at the index of the harmonic (l, m >= 0).
void LightMapProjection::PolarParts(std::ptrdiff_t row, double* parts) const
{
  double values[HarmonicCount(MaxHarmonicBands)];
  const int count = HarmonicCount(this->Bands);
  if (this->Rule == PixelRule::Centre)
  {
    const double polar = Pi * (row + 0.5) / this->Rows;
    EvaluateHarmonics(this->Bands, std::sin(polar), 0.0, std::cos(polar), values);
    const double height = 2.0 * std::sin(polar) * std::sin(0.5 * Pi / this->Rows);
    for (int i = 0; i < count; ++i)
    {
      parts[i] = values[i] * height;
    }
    return;
  }

  constexpr GaussRule<PolarNodes> rule;
  const std::ptrdiff_t pieces = (LeastPolarSteps + this->Rows - 1) / this->Rows;
  const double half = 0.5 * Pi / (this->Rows * pieces);
  std::fill_n(parts, count, 0.0);
  for (std::ptrdiff_t piece = 0; piece < pieces; ++piece)
  {
    const double middle = (2 * (row * pieces + piece) + 1) * half;
    for (int node = 0; node < PolarNodes; ++node)
    {
      const int mirrored = node / 2;
      const double side = node % 2 == 0 ? 1.0 : -1.0;
      const double polar = middle + side * half * rule.Node[mirrored];
      const double sine = std::sin(polar);
      EvaluateHarmonics(this->Bands, sine, 0.0, std::cos(polar), values);
      for (int i = 0; i < count; ++i)
      {
        parts[i] += half * rule.Weight[mirrored] * sine * values[i];
      }
    }
  }
}

template <int Waves>
void LightMapProjection::AddRowsOf(
  const LightMap& map, std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd, double* coefficients) const
{
  const int count = HarmonicCount(this->Bands);
  for (std::ptrdiff_t row = rowBegin; row < rowEnd; ++row)
  {
    double sums[3][2 * Waves] = {};
    for (std::ptrdiff_t column = 0; column < this->Columns; ++column)
    {
      const float* pixel = map.Pixel(row, column);
      const double* waves = &this->Waves[static_cast<std::size_t>(column) * 2 * Waves];
      const double red = pixel[0], green = pixel[1], blue = pixel[2];
      for (int k = 0; k < 2 * Waves; ++k)
      {
        sums[0][k] += waves[k] * red;
        sums[1][k] += waves[k] * green;
        sums[2][k] += waves[k] * blue;
      }
    }

    double polar[HarmonicCount(MaxHarmonicBands)];
    this->PolarParts(row, polar);
    for (int channel = 0; channel < 3; ++channel)
    {
      double* out = coefficients + channel * count;
      for (int l = 0; l < this->Bands; ++l)
      {
        out[HarmonicIndex(l, 0)] +=
          polar[HarmonicIndex(l, 0)] * this->PixelWidth[0] * sums[channel][0];
        for (int m = 1; m <= l; ++m)
        {
          const double part = polar[HarmonicIndex(l, m)] * this->PixelWidth[m];
          out[HarmonicIndex(l, m)] += part * sums[channel][m];
          out[HarmonicIndex(l, -m)] += part * sums[channel][Waves + m];
        }
      }
    }
  }
}

void LightMapProjection::AddRows(
  const LightMap& map, std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd, double* coefficients) const
{
  if (this->WaveCount == 4)
  {
    this->AddRowsOf<4>(map, rowBegin, rowEnd, coefficients);
  }
  else
  {
    this->AddRowsOf<8>(map, rowBegin, rowEnd, coefficients);
  }
}

std::vector<double> ProjectLightMap(const LightMap& map, int bands, PixelRule rule)
{
  std::vector<double> coefficients(static_cast<std::size_t>(3 * HarmonicCount(bands)), 0.0);
  LightMapProjection(map.Columns, map.Rows, bands, rule)
    .AddRows(map, 0, map.Rows, coefficients.data());
  return coefficients;
}

} // namespace skyline
