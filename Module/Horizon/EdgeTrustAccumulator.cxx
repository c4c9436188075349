// SPDX-License-Identifier: BSD-3-Clause
// For each post, the search finds whether terrain lies beyond the post in an azimuth. Whether
// terrain lies beyond a point at a distance follows from the result of the post nearest to that
// point. Therefore the results of all posts in one azimuth are kept, and counted while the next
// azimuth is added.
#include "Horizon/EdgeTrustAccumulator.h"

#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>

namespace skyline
{

namespace
{

constexpr std::uint8_t TerrainBeyond = 1;
constexpr std::uint8_t TerrainHere = 2;

/// Tolerance, in posts, within which a point beyond the edge of the field counts as on the edge.
constexpr double Rounding = 1e-6;

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
    // The slope of a missing post is not used, because it differs between methods.
    const bool here = heights[i] > 0.5f * MissingHeight;
    beyond[i] = static_cast<std::uint8_t>(
      here ? TerrainHere | (slopes[i] > NoTerrainSlope ? TerrainBeyond : 0) : 0);
  }
  if (this->Azimuths > 1)
  {
    this->Count(this->Before, row, column, count);
    return;
  }
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    this->Trust.Values[(row * this->Field.Posts().Columns + column + i) * this->Trust.Stride] =
      0.0f;
  }
}

/// Counts the result of one azimuth for a run of posts.
void EdgeTrustAccumulator::Count(
  const View& view, std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count) const
{
  const Grid& posts = this->Field.Posts();
  float* trust = this->Trust.Values + (row * posts.Columns + column) * this->Trust.Stride;
  const double spacingX = this->RowSpacingX ? this->RowSpacingX[row] : posts.SpacingX;
  const double spacingY = this->RowSpacingY ? this->RowSpacingY[row] : posts.SpacingY;
  const double right = view.East / spacingX; // in posts
  const double up = (view.North - posts.Shear * right) / spacingY;
  const double lastColumn = static_cast<double>(posts.Columns - 1);
  const double lastRow = static_cast<double>(posts.Rows - 1);
  const double there = static_cast<double>(row) + up;
  if (there < -Rounding || there > lastRow + Rounding)
  {
    return;
  }
  // The posts of the run for which the point lies within the field, and the distance of the nearest
  // post.
  const double begin = static_cast<double>(column) + right;
  const double first = std::max(0.0, std::ceil(-begin - Rounding));
  const double last =
    std::min(static_cast<double>(count - 1), std::floor(lastColumn - begin + Rounding));
  if (first > last)
  {
    return;
  }
  const std::ptrdiff_t shift = column + static_cast<std::ptrdiff_t>(std::round(right));
  const std::uint8_t* own = view.Posts.data() + row * posts.Columns + column;
  const std::uint8_t* line =
    view.Posts.data() + static_cast<std::ptrdiff_t>(std::round(there)) * posts.Columns;
  const bool itself = this->Distance < 0.5 * std::min(spacingX, spacingY);
  for (auto i = static_cast<std::ptrdiff_t>(first); i <= static_cast<std::ptrdiff_t>(last); ++i)
  {
    const std::ptrdiff_t nearest = std::clamp<std::ptrdiff_t>(shift + i, 0, posts.Columns - 1);
    const bool known = own[i] != 0 &&
      ((!itself && line[nearest] != 0) || this->LiesBeyond(view, row, column + i, right, up));
    trust[i * this->Trust.Stride] += known ? 1.0f : 0.0f;
  }
}

/// Whether terrain lies beyond the point (right, up) posts away, if the post there is missing or is
/// the receiver itself. The answer is that of the last post before the point that is not missing.
bool EdgeTrustAccumulator::LiesBeyond(
  const View& view, std::ptrdiff_t row, std::ptrdiff_t column, double right, double up) const
{
  const Grid& posts = this->Field.Posts();
  const auto steps =
    static_cast<std::ptrdiff_t>(std::ceil(std::max(std::abs(right), std::abs(up))));
  for (std::ptrdiff_t step = steps; step >= 0; --step)
  {
    const double part = steps > 0 ? static_cast<double>(step) / static_cast<double>(steps) : 0.0;
    const auto i = static_cast<std::ptrdiff_t>(std::round(part * right)) + column;
    const auto j = static_cast<std::ptrdiff_t>(std::round(part * up)) + row;
    const std::uint8_t bits = view.Posts[static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(j, 0, posts.Rows - 1) * posts.Columns +
      std::clamp<std::ptrdiff_t>(i, 0, posts.Columns - 1))];
    if (bits != 0)
    {
      return (bits & TerrainBeyond) != 0;
    }
  }
  return false;
}

void EdgeTrustAccumulator::Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd)
{
  const std::ptrdiff_t columns = this->Field.Posts().Columns;
  for (std::ptrdiff_t row = rowBegin; row < rowEnd; ++row)
  {
    this->Count(this->Now, row, 0, columns); // the last azimuth has no next one
    for (std::ptrdiff_t post = row * columns; post < (row + 1) * columns; ++post)
    {
      this->Trust.Values[post * this->Trust.Stride] /= static_cast<float>(this->Azimuths);
    }
  }
}

} // namespace skyline
