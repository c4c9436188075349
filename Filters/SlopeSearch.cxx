// SPDX-License-Identifier: BSD-3-Clause
#include "SlopeSearch.h"

#include "Accumulator.h"
#include "Constants.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>

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
void FrameLines(
  const RayFrame& frame, std::ptrdiff_t begin, std::ptrdiff_t end, std::ptrdiff_t& from, std::ptrdiff_t& to)
{
  from = frame.Reversed ? frame.Lines - end : begin;
  to = frame.Reversed ? frame.Lines - begin : end;
}

void FindRows(const HorizonMethod& method, const PostRegion& region, const SlopeTaker& take)
{
  const RayFrame& frame = method.Frame();
  std::ptrdiff_t begin = 0, end = 0;
  FrameLines(frame, region.RowBegin, region.RowEnd, begin, end);
  const std::ptrdiff_t count = region.ColumnEnd - region.ColumnBegin;
  const std::ptrdiff_t stride = SlopeStride(count);
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
        method.Find(from, to, region.ColumnBegin, region.ColumnEnd, slopes.data(), stride);
        for (std::ptrdiff_t line = from; line < to; ++line)
        {
          take(frame.ImageLine(line), region.ColumnBegin, count,
            slopes.data() + (line - from) * stride);
        }
      }
    });
}

void FindColumns(const HorizonMethod& method, const PostRegion& region, const SlopeTaker& take)
{
  // Lines are columns here, and consumers take runs along rows. Tiles keep these long: every run
  // lies in other pages of memory than the one before. Their slopes stay in the cache.
  constexpr std::ptrdiff_t TileLines = 4 * ChunkLines;
  constexpr std::ptrdiff_t TileRows = 256;
  const RayFrame& frame = method.Frame();
  std::ptrdiff_t begin = 0, lines = 0;
  FrameLines(frame, region.ColumnBegin, region.ColumnEnd, begin, lines);
  lines -= begin;
  const std::ptrdiff_t across = (lines + TileLines - 1) / TileLines;
  const std::ptrdiff_t along = (region.RowEnd - region.RowBegin + TileRows - 1) / TileRows;
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
        const std::ptrdiff_t from = begin + tile / along * TileLines;
        const std::ptrdiff_t count = std::min(TileLines, begin + lines - from);
        const std::ptrdiff_t rowBegin = region.RowBegin + tile % along * TileRows;
        const std::ptrdiff_t rowEnd = std::min(rowBegin + TileRows, region.RowEnd);
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
          take(row, column, count, run);
        }
      }
    });
}

float WeightAt(const PatchSide& side, std::ptrdiff_t post)
{
  return side.Weights.empty() ? 1.0f : side.Weights[static_cast<std::size_t>(post - side.Begin)];
}

} // namespace

void FindSlopes(const HorizonMethod& method, const PostRegion& region, const SlopeTaker& take)
{
  (method.Frame().Columns ? FindColumns : FindRows)(method, region, take);
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

PatchBlend::PatchBlend(const GroundMetric& metric, const GroundPatches& patches)
  : Metric(metric)
  , Patches(patches)
  , Columns(metric.Columns())
  , Rows(metric.Rows())
  , SharedRows(static_cast<std::size_t>(metric.Rows()), patches.Columns.size() > 1)
{
  for (const PatchSide& side : patches.Rows)
  {
    for (std::ptrdiff_t row = side.Begin; row < side.End; ++row)
    {
      if (WeightAt(side, row) < 1.0f)
      {
        this->SharedRows[static_cast<std::size_t>(row)] = true;
      }
    }
  }
  if (patches.Count() > 1)
  {
    const auto posts = static_cast<std::size_t>(this->Columns * this->Rows);
    this->Sums.reset(new float[posts]);
    this->Known.reset(new float[posts]);
  }
}

bool PatchBlend::Shared(std::ptrdiff_t row) const
{
  return this->SharedRows[static_cast<std::size_t>(row)];
}

void PatchBlend::Begin()
{
  vtkSMPTools::For(0, this->Rows,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        if (this->Shared(row))
        {
          std::fill_n(this->Sums.get() + row * this->Columns, this->Columns, 0.0f);
          std::fill_n(this->Known.get() + row * this->Columns, this->Columns, 0.0f);
        }
      }
    });
}

void PatchBlend::Add(const HorizonMethod& method, const PatchSide& columns, const PatchSide& rows,
  Accumulator& consumer)
{
  const RayFrame& frame = method.Frame();
  const double along = frame.Reversed ? -1.0 : 1.0;
  const double across = frame.Drift * frame.Slant;
  const double perColumn = frame.Columns ? along : across;
  const double perRow = frame.Columns ? across : along;
  vtkSMPThreadLocal<std::vector<float>> buffers;
  FindSlopes(method, { rows.Begin, rows.End, columns.Begin, columns.End },
    [&](std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, float* slopes)
    {
      std::vector<float>& lengths = buffers.Local();
      lengths.resize(static_cast<std::size_t>(count));
      this->Metric.Lengths(row, column, count, perColumn, perRow, lengths.data());
      for (std::ptrdiff_t i = 0; i < count; ++i)
      {
        const float scale =
          static_cast<float>(frame.StepLength) / lengths[static_cast<std::size_t>(i)];
        slopes[i] = slopes[i] > NoTerrainSlope ? slopes[i] * scale : NoTerrainSlope;
      }
      if (!this->Shared(row))
      {
        consumer.Add(row, column, count, slopes);
        return;
      }
      const float weightOfRow = WeightAt(rows, row);
      float* sum = this->Sums.get() + row * this->Columns + column;
      float* known = this->Known.get() + row * this->Columns + column;
      for (std::ptrdiff_t i = 0; i < count; ++i)
      {
        // Where one of two rays meets no terrain, the other speaks for both.
        const bool terrain = slopes[i] > NoTerrainSlope;
        const float weight = terrain ? weightOfRow * WeightAt(columns, column + i) : 0.0f;
        sum[i] += weight > 0.0f ? weight * slopes[i] : 0.0f;
        known[i] += weight;
      }
    });
}

void PatchBlend::End(Accumulator& consumer)
{
  vtkSMPTools::For(0, this->Rows,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        if (!this->Shared(row))
        {
          continue;
        }
        float* sum = this->Sums.get() + row * this->Columns;
        const float* known = this->Known.get() + row * this->Columns;
        for (std::ptrdiff_t i = 0; i < this->Columns; ++i)
        {
          sum[i] = known[i] > 0.0f ? sum[i] / known[i] : NoTerrainSlope;
        }
        consumer.Add(row, 0, this->Columns, sum);
      }
    });
}

} // namespace skyline
