// SPDX-License-Identifier: BSD-3-Clause
#include "FanBlend.h"

#include "Horizon/Accumulator.h"
#include "Shared/Constants.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace skyline
{

namespace
{

// Tiles are halved until they span at most this many steps from ray to ray, both in direction and
// in length, or until they have this size.
constexpr std::size_t StepsPerTile = 4;
constexpr std::ptrdiff_t SmallestRows = 16, SmallestColumns = 32;

// Weight of a ray: 1 if `place` is on the ray, 0 at the neighbouring rays.
float Nearness(float place, std::size_t ray)
{
  return std::max(0.0f, 1.0f - std::abs(place - static_cast<float>(ray)));
}

} // namespace

FanBlend::FanBlend(const GroundMetric& metric)
  : Metric(metric)
  , Sums(new float[static_cast<std::size_t>(metric.Columns() * metric.Rows())])
  , Known(new float[static_cast<std::size_t>(metric.Columns() * metric.Rows())])
{
}

void FanBlend::Begin(const RayFan& fan)
{
  this->Fan = &fan;
  const std::ptrdiff_t columns = this->Metric.Columns();
  vtkSMPTools::For(0, this->Metric.Rows(),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::fill(this->Sums.get() + begin * columns, this->Sums.get() + end * columns, 0.0f);
      std::fill(this->Known.get() + begin * columns, this->Known.get() + end * columns, 0.0f);
    });
  this->Tiles.clear();
  for (std::ptrdiff_t row = 0; row < this->Metric.Rows(); row += SearchRows)
  {
    for (std::ptrdiff_t column = 0; column < columns; column += SearchColumns)
    {
      this->Divide({ row, std::min(row + SearchRows, this->Metric.Rows()), column,
        std::min(column + SearchColumns, columns) });
    }
  }
}

void FanBlend::Divide(const PostRegion& posts)
{
  // The places of the edges and of the middle row contain those of all posts, up to a small slack.
  float least[2] = { 1e9f, 1e9f }, greatest[2] = { -1e9f, -1e9f };
  const std::ptrdiff_t count = posts.ColumnEnd - posts.ColumnBegin;
  std::vector<float> places(static_cast<std::size_t>(2 * count));
  for (const std::ptrdiff_t row :
    { posts.RowBegin, (posts.RowBegin + posts.RowEnd) / 2, posts.RowEnd - 1 })
  {
    this->Fan->Places(row, posts.ColumnBegin, count, places.data(), places.data() + count);
    for (std::ptrdiff_t i = 0; i < count; ++i)
    {
      for (std::ptrdiff_t k = 0; k < 2; ++k)
      {
        const float place = places[static_cast<std::size_t>(k * count + i)];
        least[k] = std::min(least[k], place);
        greatest[k] = std::max(greatest[k], place);
      }
    }
  }
  const auto ray = [](float place, std::size_t rays, float slack)
  {
    const float last = static_cast<float>(rays - 1);
    return static_cast<std::size_t>(std::clamp(place + slack, 0.0f, last));
  };
  constexpr float slack = 0.05f;
  const std::size_t directions = this->Fan->Directions.size(), lengths = this->Fan->Lengths.size();
  const FanTile tile{ posts, ray(least[0], directions, -slack),
    ray(std::ceil(greatest[0] + slack), directions, 0.0f), ray(least[1], lengths, -slack),
    ray(std::ceil(greatest[1] + slack), lengths, 0.0f) };
  const std::ptrdiff_t rows = posts.RowEnd - posts.RowBegin;
  const std::size_t used =
    std::max(tile.LastDirection - tile.FirstDirection, tile.LastLength - tile.FirstLength);
  const bool tall = rows > SmallestRows, wide = count > SmallestColumns;
  if (used <= StepsPerTile || (!tall && !wide))
  {
    this->Tiles.push_back(tile);
  }
  else if (tall && (!wide || rows * SmallestColumns >= count * SmallestRows))
  {
    const std::ptrdiff_t middle = posts.RowBegin + rows / 2;
    this->Divide({ posts.RowBegin, middle, posts.ColumnBegin, posts.ColumnEnd });
    this->Divide({ middle, posts.RowEnd, posts.ColumnBegin, posts.ColumnEnd });
  }
  else
  {
    const std::ptrdiff_t middle = posts.ColumnBegin + count / 2;
    this->Divide({ posts.RowBegin, posts.RowEnd, posts.ColumnBegin, middle });
    this->Divide({ posts.RowBegin, posts.RowEnd, middle, posts.ColumnEnd });
  }
}

bool FanBlend::Asks(std::size_t direction, std::size_t length, PostRegion& posts)
{
  this->Direction = direction;
  this->Length = length;
  this->Asked.clear();
  for (const FanTile& tile : this->Tiles)
  {
    if (tile.FirstDirection <= direction && direction <= tile.LastDirection &&
      tile.FirstLength <= length && length <= tile.LastLength)
    {
      const PostRegion& part = tile.Posts;
      posts = this->Asked.empty()
        ? part
        : PostRegion{ std::min(posts.RowBegin, part.RowBegin), std::max(posts.RowEnd, part.RowEnd),
            std::min(posts.ColumnBegin, part.ColumnBegin),
            std::max(posts.ColumnEnd, part.ColumnEnd) };
      this->Asked.push_back(part);
    }
  }
  return !this->Asked.empty();
}

void FanBlend::Lengthen(const GroundMetric& metric, const RayFrame& frame, std::ptrdiff_t row,
  std::ptrdiff_t column, std::ptrdiff_t count, float* slopes)
{
  const double along = frame.Reversed ? -1.0 : 1.0;
  const double across = frame.Drift * frame.Slant;
  constexpr std::ptrdiff_t piece = 256;
  float lengths[piece];
  for (std::ptrdiff_t begin = 0; begin < count; begin += piece)
  {
    const std::ptrdiff_t here = std::min(piece, count - begin);
    metric.Lengths(row, column + begin, here, frame.Columns ? along : across,
      frame.Columns ? across : along, lengths);
    for (std::ptrdiff_t i = 0; i < here; ++i)
    {
      float& slope = slopes[begin + i];
      slope = slope > NoTerrainSlope ? slope * (static_cast<float>(frame.StepLength) / lengths[i])
                                     : NoTerrainSlope;
    }
  }
}

void FanBlend::Add(const HorizonMethod& method)
{
  const std::ptrdiff_t columns = this->Metric.Columns();
  vtkSMPThreadLocal<std::vector<float>> buffers;
  FindParts(method, this->Asked,
    [&](std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, float* slopes)
    {
      Lengthen(this->Metric, method.Frame(), row, column, count, slopes);
      std::vector<float>& places = buffers.Local();
      places.resize(static_cast<std::size_t>(2 * count));
      float* directions = places.data();
      float* lengths = directions + count;
      this->Fan->Places(row, column, count, directions, lengths);
      float* sum = this->Sums.get() + row * columns + column;
      float* known = this->Known.get() + row * columns + column;
      for (std::ptrdiff_t i = 0; i < count; ++i)
      {
        const float weight =
          Nearness(directions[i], this->Direction) * Nearness(lengths[i], this->Length);
        // Where one of two rays meets no terrain, the slope of the other is used for both.
        const bool counts = weight > 0.0f && slopes[i] > NoTerrainSlope;
        sum[i] += counts ? weight * slopes[i] : 0.0f;
        known[i] += counts ? weight : 0.0f;
      }
    });
}

void FanBlend::End(Accumulator& consumer)
{
  const std::ptrdiff_t columns = this->Metric.Columns();
  vtkSMPTools::For(0, this->Metric.Rows(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        float* sum = this->Sums.get() + row * columns;
        const float* known = this->Known.get() + row * columns;
        for (std::ptrdiff_t i = 0; i < columns; ++i)
        {
          sum[i] = known[i] > 0.0f ? sum[i] / known[i] : NoTerrainSlope;
        }
        consumer.Add(row, 0, columns, sum);
      }
    });
}

} // namespace skyline
