// SPDX-License-Identifier: BSD-3-Clause
#include "HeightField/HeightField.h"

#include "Shared/HeightLimits.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace skyline
{

namespace
{

MissingMap MapMissing(const PaddedPlane& plane)
{
  MissingMap map;
  map.Lines = plane.Lines;
  map.Runs = (plane.Lanes + MissingMap::RunLanes - 1) / MissingMap::RunLanes;
  map.Missing.assign(static_cast<std::size_t>(map.Lines * map.Runs), 0);
  for (std::ptrdiff_t line = 0; line < plane.Lines; ++line)
  {
    const float* heights = plane.Line(line);
    std::uint8_t* runs = map.Missing.data() + line * map.Runs;
    for (std::ptrdiff_t lane = 0; lane < plane.Lanes; ++lane)
    {
      runs[lane / MissingMap::RunLanes] |= heights[lane] <= 0.5f * MissingHeight ? 1 : 0;
    }
  }
  return map;
}

} // namespace

HeightField::HeightField(const Grid& grid)
  : Lattice(grid)
{
  if (grid.Columns < 2 || grid.Rows < 2)
  {
    throw std::invalid_argument("no surface: " + std::to_string(grid.Columns) + " x " +
      std::to_string(grid.Rows) + " posts; a surface needs at least 2 x 2");
  }
  for (const double spacing : { grid.SpacingX, grid.SpacingY })
  {
    if (!(spacing > 0.0))
    {
      throw std::invalid_argument("spacing " + std::to_string(grid.SpacingX) + " x " +
        std::to_string(grid.SpacingY) + " m; both must be above 0");
    }
    if (!(spacing >= LeastSpacing && spacing <= GreatestSpacing))
    {
      std::array<char, 32> text{};
      std::snprintf(text.data(), text.size(), "%.6g", spacing);
      throw std::invalid_argument(
        "posts " + std::string(text.data()) + " m apart; give a spacing from 1e-9 to 1e9 m");
    }
  }
  this->Rows = PaddedPlane(grid.Rows, grid.Columns);
}

bool HeightField::CellComplete(std::ptrdiff_t column, std::ptrdiff_t row) const
{
  // The margin is missing, so that cells outside the data are incomplete without a test of their
  // own.
  const float* low = this->Rows.Line(row);
  const float* high = this->Rows.Line(row + 1);
  return std::min({ low[column], low[column + 1], high[column], high[column + 1] }) >
    0.5f * MissingHeight;
}

void HeightField::Close()
{
  this->IsolatedInRows.clear();
  this->IsolatedInColumns.clear();
  this->Largest = 0.0f;
  this->Missing = this->Any = false;
  this->MissingInRows = MissingMap();
  for (std::ptrdiff_t row = 0; row < this->Lattice.Rows; ++row)
  {
    const float* line = this->Rows.Line(row);
    for (std::ptrdiff_t column = 0; column < this->Lattice.Columns; ++column)
    {
      if (line[column] <= 0.5f * MissingHeight)
      {
        this->Missing = true;
      }
      else
      {
        this->Any = true;
        this->Largest = std::max(this->Largest, std::abs(line[column]));
      }
    }
  }
  if (!this->Missing)
  {
    return;
  }
  for (std::ptrdiff_t row = 0; row < this->Lattice.Rows; ++row)
  {
    const float* line = this->Rows.Line(row);
    for (std::ptrdiff_t column = 0; column < this->Lattice.Columns; ++column)
    {
      if (line[column] > 0.5f * MissingHeight && !this->CellComplete(column - 1, row - 1) &&
        !this->CellComplete(column, row - 1) && !this->CellComplete(column - 1, row) &&
        !this->CellComplete(column, row))
      {
        this->IsolatedInRows.push_back({ row, column, line[column] });
        this->IsolatedInColumns.push_back({ column, row, line[column] });
      }
    }
  }
  for (const IsolatedPost& post : this->IsolatedInRows)
  {
    this->Rows.Line(post.Line)[post.Lane] = MissingHeight;
  }
  this->MissingInRows = MapMissing(this->Rows);
  std::stable_sort(this->IsolatedInColumns.begin(), this->IsolatedInColumns.end(),
    [](const IsolatedPost& a, const IsolatedPost& b) { return a.Line < b.Line; });
}

const float* HeightField::Receivers(
  bool columns, std::ptrdiff_t line, std::vector<float>& buffer) const
{
  const PaddedPlane& plane = columns ? this->Columns : this->Rows;
  const std::vector<IsolatedPost>& isolated =
    columns ? this->IsolatedInColumns : this->IsolatedInRows;
  auto post = std::lower_bound(isolated.begin(), isolated.end(), line,
    [](const IsolatedPost& a, std::ptrdiff_t wanted) { return a.Line < wanted; });
  if (post == isolated.end() || post->Line != line)
  {
    return plane.Line(line);
  }
  buffer.assign(plane.Line(line), plane.Line(line) + plane.Lanes + PaddedPlane::Margin);
  for (; post != isolated.end() && post->Line == line; ++post)
  {
    buffer[static_cast<std::size_t>(post->Lane)] = post->Height;
  }
  return buffer.data();
}

void HeightField::Transpose()
{
  if (this->Columns.Lines > 0)
  {
    return;
  }
  this->Columns = PaddedPlane(this->Lattice.Columns, this->Lattice.Rows);
  constexpr std::ptrdiff_t tile = 16; // one cache line of floats
  for (std::ptrdiff_t row = 0; row < this->Lattice.Rows; row += tile)
  {
    const std::ptrdiff_t rowEnd = std::min(row + tile, this->Lattice.Rows);
    for (std::ptrdiff_t column = 0; column < this->Lattice.Columns; ++column)
    {
      float* line = this->Columns.Line(column);
      for (std::ptrdiff_t r = row; r < rowEnd; ++r)
      {
        line[r] = this->Rows.Line(r)[column];
      }
    }
  }
  if (this->Missing)
  {
    this->MissingInColumns = MapMissing(this->Columns);
  }
}

} // namespace skyline
