// SPDX-License-Identifier: BSD-3-Clause
// A search tells of every post whether terrain lies beyond it in an azimuth. Whether it does beyond a
// point at a distance, the post nearest to that point knows: so what an azimuth says of all posts is
// kept, and counted while the next one is fed.
#include "EdgeTrustAccumulator.h"

#include "Constants.h"

#include <algorithm>
#include <cmath>

namespace skyline
{

namespace
{

constexpr std::uint8_t TerrainBeyond = 1;
constexpr std::uint8_t TerrainHere = 2;

} // namespace

EdgeTrustAccumulator::EdgeTrustAccumulator(const HeightField& field, double distance,
  const PostBuffer& trust, const double* rowSpacingX, const double* rowSpacingY)
  : Field(field)
  , Distance(distance)
  , Trust(trust)
  , RowSpacingX(rowSpacingX)
  , RowSpacingY(rowSpacingY)
{
  const auto posts = static_cast<std::size_t>(field.Posts().Columns * field.Posts().Rows);
  this->Now.Posts.resize(posts);
  this->Before.Posts.resize(posts);
}

void EdgeTrustAccumulator::Begin(double azimuth, double)
{
  std::swap(this->Now, this->Before);
  this->Now.East = this->Distance * std::sin(azimuth);
  this->Now.North = this->Distance * std::cos(azimuth);
  ++this->Azimuths;
}

void EdgeTrustAccumulator::Add(
  std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes)
{
  const float* heights = this->Field.RowPlane().Line(row) + column;
  std::uint8_t* beyond = this->Now.Posts.data() + row * this->Field.Posts().Columns + column;
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    beyond[i] = static_cast<std::uint8_t>((slopes[i] > NoTerrainSlope ? TerrainBeyond : 0) |
      (heights[i] > 0.5f * MissingHeight ? TerrainHere : 0));
  }
  if (this->Azimuths > 1)
  {
    this->Count(this->Before, row, column, count);
    return;
  }
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    this->Trust.Values[(row * this->Field.Posts().Columns + column + i) * this->Trust.Stride] = 0.0f;
  }
}

/// Adds what an azimuth tells of a run of posts.
void EdgeTrustAccumulator::Count(
  const View& view, std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count) const
{
  const Grid& posts = this->Field.Posts();
  float* trust = this->Trust.Values + (row * posts.Columns + column) * this->Trust.Stride;
  const double spacingX = this->RowSpacingX ? this->RowSpacingX[row] : posts.SpacingX;
  const double spacingY = this->RowSpacingY ? this->RowSpacingY[row] : posts.SpacingY;
  // Beyond the field's ends all is the same; so is it for distances past any integer.
  const auto columns = static_cast<double>(posts.Columns), rows = static_cast<double>(posts.Rows);
  const auto right =
    static_cast<std::ptrdiff_t>(std::clamp(std::round(view.East / spacingX), -columns, columns));
  const auto up =
    static_cast<std::ptrdiff_t>(std::clamp(std::round(view.North / spacingY), -rows, rows));
  if (row + up < 0 || row + up >= posts.Rows)
  {
    return;
  }
  const std::uint8_t known =
    right == 0 && up == 0 ? TerrainBeyond : TerrainBeyond | TerrainHere;
  const std::uint8_t* there = view.Posts.data() + (row + up) * posts.Columns;
  const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, -(column + right));
  const std::ptrdiff_t last = std::min(count, posts.Columns - (column + right));
  for (std::ptrdiff_t i = first; i < last; ++i)
  {
    trust[i * this->Trust.Stride] += (there[column + right + i] & known) != 0 ? 1.0f : 0.0f;
  }
}

void EdgeTrustAccumulator::Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd)
{
  const std::ptrdiff_t columns = this->Field.Posts().Columns;
  for (std::ptrdiff_t row = rowBegin; row < rowEnd; ++row)
  {
    this->Count(this->Now, row, 0, columns); // no azimuth came after the last
    for (std::ptrdiff_t post = row * columns; post < (row + 1) * columns; ++post)
    {
      this->Trust.Values[post * this->Trust.Stride] /= static_cast<float>(this->Azimuths);
    }
  }
}

} // namespace skyline
