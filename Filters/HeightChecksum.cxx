// SPDX-License-Identifier: BSD-3-Clause
#include "HeightChecksum.h"

#include "HeightField/HeightField.h"
#include "vtkSMPTools.h"

#include <cstring>
#include <vector>

namespace skyline
{

namespace
{

// Mixes a value into a sum, so that each bit affects all bits.
std::uint64_t Mixed(std::uint64_t sum, std::uint64_t value)
{
  constexpr std::uint64_t odd = 0x9e3779b97f4a7c15; // 2^64 over the golden ratio
  const std::uint64_t product = (sum ^ value) * odd;
  return product ^ (product >> 32);
}

} // namespace

std::uint64_t HeightChecksum(const HeightField& field)
{
  const Grid& grid = field.Posts();
  std::vector<std::uint64_t> rows(static_cast<std::size_t>(grid.Rows));
  vtkSMPTools::For(0, grid.Rows,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<float> buffer;
      for (vtkIdType row = begin; row < end; ++row)
      {
        const float* line = field.Receivers(false, row, buffer);
        std::uint64_t sum = static_cast<std::uint64_t>(grid.Columns);
        for (std::ptrdiff_t column = 0; column < grid.Columns; ++column)
        {
          std::uint32_t bits = 0;
          std::memcpy(&bits, line + column, sizeof(bits));
          sum = Mixed(sum, bits);
        }
        rows[static_cast<std::size_t>(row)] = sum;
      }
    });
  std::uint64_t sum = 0;
  for (const std::uint64_t row : rows)
  {
    sum = Mixed(sum, row);
  }
  return sum | 1;
}

} // namespace skyline
