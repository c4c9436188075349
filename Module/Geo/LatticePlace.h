// SPDX-License-Identifier: BSD-3-Clause
#ifndef skyline_LatticePlace_h
#define skyline_LatticePlace_h

#include <algorithm>
#include <cstddef>

namespace skyline
{

/// A position between two of the nodes 0 .. nodes - 1 of a row. Positions beyond an end are moved
/// to it.
struct LatticePlace
{
  std::ptrdiff_t Lower = 0, Upper = 0;
  double Fraction = 0.0;

  LatticePlace(double position, std::ptrdiff_t nodes)
  {
    const double inside = std::clamp(position, 0.0, static_cast<double>(nodes - 1));
    const std::ptrdiff_t lastCell = std::max<std::ptrdiff_t>(nodes - 2, 0);
    this->Lower = std::min(static_cast<std::ptrdiff_t>(inside), lastCell);
    this->Upper = std::min(this->Lower + 1, nodes - 1);
    this->Fraction = inside - static_cast<double>(this->Lower);
  }
};

} // namespace skyline

#endif
