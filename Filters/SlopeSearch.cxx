// SPDX-License-Identifier: BSD-3-Clause
#include "SlopeSearch.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace skyline
{

namespace
{

// Lines that one thread searches in sequence: each line reuses results of the line before. The
// number is fixed, so that the bits of the result do not depend on the number of threads.
constexpr std::ptrdiff_t ChunkLines = SearchRows;

// Floats from one line of slopes to the next. Lines are written in whole blocks of 32; an odd
// number of cache lines spreads them over the sets of the cache when columns are turned into rows.
std::ptrdiff_t SlopeStride(std::ptrdiff_t lanes)
{
  return (lanes + 31) / 32 * 32 + 16;
}

// Finds the lines of the frame for the image lines [begin, end).
void FrameLines(const RayFrame& frame, std::ptrdiff_t begin, std::ptrdiff_t end,
  std::ptrdiff_t& from, std::ptrdiff_t& to)
{
  from = frame.Reversed ? frame.Lines - end : begin;
  to = frame.Reversed ? frame.Lines - begin : end;
}

// Columns and rows that one thread takes if lines are columns. Consumers take runs along rows, each
// in other memory pages than the run before; tiles keep these runs long, and their slopes in the
// cache.
constexpr std::ptrdiff_t TileLines = SearchColumns;
constexpr std::ptrdiff_t TileRows = 256;

// Finds up to ChunkLines rows if lines are rows.
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

// Finds up to TileLines columns and TileRows rows if lines are columns.
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

// Finds a part for one thread. Up to ChunkLines rows and TileLines columns fit in both cases.
void FindPart(const HorizonMethod& method, const PostRegion& part, std::vector<float>& slopes,
  const SlopeTaker& take)
{
  (method.Frame().Columns ? FindTile : FindChunk)(method, part, slopes, take);
}

// Divides a region along the lines of the frame, so that results do not depend on the direction of
// rays.
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

} // namespace

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

} // namespace skyline
