// SPDX-License-Identifier: BSD-3-Clause
#include "SlopeSearch.h"

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

// Lines that one thread finds in a row: the search reuses what it learnt on the line before. A fixed
// number, so that the bits do not depend on the number of threads.
constexpr std::ptrdiff_t ChunkLines = 64;

// Floats from a line of slopes to the next: lines are written in whole blocks of 32, and an odd number
// of cache lines spreads them over the cache's sets when columns are turned into rows.
std::ptrdiff_t SlopeStride(std::ptrdiff_t lanes)
{
  return (lanes + 31) / 32 * 32 + 16;
}

// Lines of the frame that hold image lines [begin, end).
void FrameLines(const RayFrame& frame, std::ptrdiff_t begin, std::ptrdiff_t end,
  std::ptrdiff_t& from, std::ptrdiff_t& to)
{
  from = frame.Reversed ? frame.Lines - end : begin;
  to = frame.Reversed ? frame.Lines - begin : end;
}

// Columns and rows that one thread takes where lines are columns: consumers take runs along rows, and
// tiles keep these long: every run lies in other pages of memory than the one before. Their slopes stay
// in the cache.
constexpr std::ptrdiff_t TileLines = 4 * ChunkLines;
constexpr std::ptrdiff_t TileRows = 256;

// Rows of up to ChunkLines, where lines are rows.
void FindChunk(const HorizonMethod& method, const PostRegion& chunk, std::vector<float>& slopes,
  const SlopeTaker& take)
{
  const RayFrame& frame = method.Frame();
  std::ptrdiff_t from = 0, to = 0;
  FrameLines(frame, chunk.RowBegin, chunk.RowEnd, from, to);
  const std::ptrdiff_t count = chunk.ColumnEnd - chunk.ColumnBegin;
  const std::ptrdiff_t stride = SlopeStride(count);
  slopes.resize(static_cast<std::size_t>(ChunkLines * stride));
  method.Find(from, to, chunk.ColumnBegin, chunk.ColumnEnd, slopes.data(), stride);
  for (std::ptrdiff_t line = from; line < to; ++line)
  {
    take(frame.ImageLine(line), chunk.ColumnBegin, count, slopes.data() + (line - from) * stride);
  }
}

// Up to TileLines columns and TileRows rows, where lines are columns.
void FindTile(const HorizonMethod& method, const PostRegion& tile, std::vector<float>& slopes,
  const SlopeTaker& take)
{
  const RayFrame& frame = method.Frame();
  std::ptrdiff_t from = 0, to = 0;
  FrameLines(frame, tile.ColumnBegin, tile.ColumnEnd, from, to);
  const std::ptrdiff_t count = to - from;
  const std::ptrdiff_t stride = SlopeStride(TileRows);
  slopes.resize(static_cast<std::size_t>(TileLines * stride));
  float run[TileLines];
  for (std::ptrdiff_t line = 0; line < count; line += ChunkLines)
  {
    const std::ptrdiff_t end = std::min(line + ChunkLines, count);
    method.Find(
      from + line, from + end, tile.RowBegin, tile.RowEnd, slopes.data() + line * stride, stride);
  }
  const std::ptrdiff_t next = frame.Reversed ? -stride : stride;
  for (std::ptrdiff_t row = tile.RowBegin; row < tile.RowEnd; ++row)
  {
    const float* slope =
      slopes.data() + (frame.Reversed ? (count - 1) * stride : 0) + (row - tile.RowBegin);
    for (std::ptrdiff_t i = 0; i < count; ++i)
    {
      run[i] = slope[i * next];
    }
    take(row, tile.ColumnBegin, count, run);
  }
}

// A part that one thread finds: rows of up to ChunkLines and columns of up to TileLines fit either way.
void FindPart(const HorizonMethod& method, const PostRegion& part, std::vector<float>& slopes,
  const SlopeTaker& take)
{
  (method.Frame().Columns ? FindTile : FindChunk)(method, part, slopes, take);
}

// Parts of a region, as the frame's lines run, so that results do not depend on the direction of rays.
std::vector<PostRegion> PartsOf(const RayFrame& frame, const PostRegion& region)
{
  std::vector<PostRegion> parts;
  std::ptrdiff_t begin = 0, end = 0;
  if (!frame.Columns)
  {
    FrameLines(frame, region.RowBegin, region.RowEnd, begin, end);
    for (std::ptrdiff_t from = begin; from < end; from += ChunkLines)
    {
      const std::ptrdiff_t to = std::min(from + ChunkLines, end);
      parts.push_back({ std::min(frame.ImageLine(from), frame.ImageLine(to - 1)),
        std::max(frame.ImageLine(from), frame.ImageLine(to - 1)) + 1, region.ColumnBegin,
        region.ColumnEnd });
    }
    return parts;
  }
  FrameLines(frame, region.ColumnBegin, region.ColumnEnd, begin, end);
  for (std::ptrdiff_t from = begin; from < end; from += TileLines)
  {
    const std::ptrdiff_t to = std::min(from + TileLines, end);
    for (std::ptrdiff_t row = region.RowBegin; row < region.RowEnd; row += TileRows)
    {
      parts.push_back({ row, std::min(row + TileRows, region.RowEnd),
        std::min(frame.ImageLine(from), frame.ImageLine(to - 1)),
        std::max(frame.ImageLine(from), frame.ImageLine(to - 1)) + 1 });
    }
  }
  return parts;
}

void FindParts(
  const HorizonMethod& method, const std::vector<PostRegion>& parts, const SlopeTaker& take)
{
  vtkSMPThreadLocal<std::vector<float>> buffers;
  vtkSMPTools::For(0, static_cast<vtkIdType>(parts.size()), 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType part = first; part < last; ++part)
      {
        FindPart(method, parts[static_cast<std::size_t>(part)], buffers.Local(), take);
      }
    });
}

// Tiles are halved until they span no more than this many steps from ray to ray each way, or are this
// small.
constexpr std::size_t StepsPerTile = 4;
constexpr std::ptrdiff_t SmallestRows = 16, SmallestColumns = 32;

// Nearness of a place to a ray: 1 on it, 0 at its neighbours.
float Nearness(float place, std::size_t ray)
{
  return std::max(0.0f, 1.0f - std::abs(place - static_cast<float>(ray)));
}

} // namespace

void FindSlopes(const HorizonMethod& method, const PostRegion& region, const SlopeTaker& take)
{
  FindParts(method, PartsOf(method.Frame(), region), take);
}

void AskFor(HorizonMethod& method, const PostRegion& region)
{
  const RayFrame& frame = method.Frame();
  std::ptrdiff_t begin = 0, end = 0;
  if (frame.Columns)
  {
    FrameLines(frame, region.ColumnBegin, region.ColumnEnd, begin, end);
    method.SetReceivers(begin, end, region.RowBegin, region.RowEnd);
  }
  else
  {
    FrameLines(frame, region.RowBegin, region.RowEnd, begin, end);
    method.SetReceivers(begin, end, region.ColumnBegin, region.ColumnEnd);
  }
}

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
  for (std::ptrdiff_t row = 0; row < this->Metric.Rows(); row += ChunkLines)
  {
    for (std::ptrdiff_t column = 0; column < columns; column += TileLines)
    {
      this->Divide({ row, std::min(row + ChunkLines, this->Metric.Rows()), column,
        std::min(column + TileLines, columns) });
    }
  }
}

void FanBlend::Divide(const PostRegion& posts)
{
  // The places of the edges and of a row in the middle hold those of all posts, but for a little.
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
        // Where one of two rays meets no terrain, the other speaks for both.
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
