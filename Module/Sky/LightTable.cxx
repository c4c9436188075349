// SPDX-License-Identifier: BSD-3-Clause
#include "Sky/LightTable.h"

#include "Shared/Constants.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace skyline
{

namespace
{

/// A column is divided into parts of at most this angle (radians). Over such a part, the
/// three-point Gauss rule has an error of 1e-13 for a linear weight times a sine.
constexpr double LargestPart = 0.05;

/// D(e) = (pi/2 - e) - sin e cos e for the elevation e at the zenith angle z.
double Bow(double z)
{
  return z - std::sin(z) * std::cos(z);
}

double Square(double x)
{
  return x * x;
}

} // namespace

void LightTable::AddColumns(const TurnedLightMap& light, const SwathPiece& piece)
{
  const LightMap& map = light.Map;
  const double rotation = light.Rotation;
  const double nodes[3] = { 0.5 - 0.5 * std::sqrt(0.6), 0.5, 0.5 + 0.5 * std::sqrt(0.6) };
  const double weights[3] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };
  const double width = piece.End - piece.Begin;
  const double perRadian = static_cast<double>(map.Columns) / (2.0 * Pi);
  // The centre column is north, so that the left edge of the map is south.
  const auto place = [&](double azimuth) { return (azimuth - rotation + Pi) * perRadian; };
  const auto first = static_cast<std::ptrdiff_t>(std::floor(place(piece.Begin)));
  const auto last = static_cast<std::ptrdiff_t>(std::ceil(place(piece.End)));
  for (std::ptrdiff_t column = first; column < last; ++column)
  {
    const double left = static_cast<double>(column) / perRadian - Pi + rotation;
    const double begin = std::max(piece.Begin, left);
    const double end = std::min(piece.End, left + 1.0 / perRadian);
    if (!(begin < end))
    {
      continue;
    }
    ColumnWeight sum{ (column % map.Columns + map.Columns) % map.Columns, 0.0, 0.0, 0.0 };
    const double parts = std::ceil((end - begin) / LargestPart);
    const double step = (end - begin) / parts;
    for (int part = 0; part < static_cast<int>(parts); ++part)
    {
      for (int k = 0; k < 3; ++k)
      {
        const double azimuth = begin + (part + nodes[k]) * step;
        const double along = (azimuth - piece.Begin) / width;
        const double weight = weights[k] * step *
          (piece.WeightAtBegin + along * (piece.WeightAtEnd - piece.WeightAtBegin));
        sum.Plain += weight;
        sum.Sine += weight * std::sin(azimuth);
        sum.Cosine += weight * std::cos(azimuth);
      }
    }
    this->Columns.push_back(sum);
  }
}

void LightTable::Build(
  const TurnedLightMap& light, const SwathPiece* piecesBegin, const SwathPiece* piecesEnd)
{
  const LightMap& map = light.Map;
  this->Columns.clear();
  for (const SwathPiece* piece = piecesBegin; piece != piecesEnd; ++piece)
  {
    this->AddColumns(light, *piece);
  }
  this->Count = (map.Rows + 1) / 2; // if odd, the middle row contains the horizon
  this->PerRadian = static_cast<double>(map.Rows) / Pi;
  this->Values.assign(static_cast<std::size_t>(this->Count * LineSize), 0.0f);
  this->Lit = false;

  double above[9] = {}; // Z, X, Y of the rows above, three colours each
  for (std::ptrdiff_t row = 0; row < this->Count; ++row)
  {
    double sums[9] = {};
    for (const ColumnWeight& column : this->Columns)
    {
      const float* pixel = map.Pixel(row, column.Column);
      for (int c = 0; c < 3; ++c)
      {
        const auto radiance = static_cast<double>(pixel[c]);
        sums[c] += column.Plain * radiance;
        sums[3 + c] += column.Sine * radiance;
        sums[6 + c] += column.Cosine * radiance;
      }
    }
    for (int k = 0; k < 9; ++k)
    {
      sums[k] *= light.Scale[k % 3];
    }
    const double top = static_cast<double>(row) / this->PerRadian;
    const double bottom = static_cast<double>(row + 1) / this->PerRadian;
    const double heads[3] = { Square(std::sin(top)), Bow(top), Bow(top) };
    const double feet[3] = { Square(std::sin(bottom)), Bow(bottom), Bow(bottom) };
    float* line = this->Values.data() + row * LineSize;
    for (int k = 0; k < 9; ++k)
    {
      const double half = 0.5 * sums[k];
      float* to = line + k / 3 * 8 + k % 3;
      to[0] = static_cast<float>(above[k] - half * heads[k / 3]);
      to[4] = static_cast<float>(half);
      above[k] += half * (feet[k / 3] - heads[k / 3]);
      this->Lit = this->Lit || sums[k] != 0.0;
    }
  }
}

} // namespace skyline
