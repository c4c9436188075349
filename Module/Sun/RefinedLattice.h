// SPDX-License-Identifier: BSD-3-Clause
// Expensive values over a height field: computed at the nodes of a lattice and interpolated
// linearly.
#ifndef skyline_RefinedLattice_h
#define skyline_RefinedLattice_h

#include "Geo/Georeference.h"
#include "Geo/LatticePlace.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace skyline
{

/// Node must have a function Mix(a, b, fraction).
template <typename Node>
struct RefinedLattice
{
  std::ptrdiff_t Side = 0;                        ///< nodes along each side
  double NodesPerColumn = 0.0, NodesPerRow = 0.0; ///< steps of the lattice per post
  std::vector<Node> Nodes;                        ///< row by row from the south
  double Error = 0.0;                             ///< the greatest error that Refine found

  const Node& At(std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    return this->Nodes[static_cast<std::size_t>(row * this->Side + column)];
  }

  /// The value at a post. Positions beyond the edge get the value at the edge.
  Node Interpolate(double column, double row) const
  {
    const LatticePlace across(column * this->NodesPerColumn, this->Side);
    const LatticePlace along(row * this->NodesPerRow, this->Side);
    return Mix(
      Mix(this->At(across.Lower, along.Lower), this->At(across.Lower, along.Upper), along.Fraction),
      Mix(this->At(across.Upper, along.Lower), this->At(across.Upper, along.Upper), along.Fraction),
      across.Fraction);
  }

  /// Computes the nodes valueAt(column, row) of the coarsest lattice whose
  /// `difference(interpolated, true)` is at most `tolerance`, or of the finest lattice. Stops with
  /// an empty lattice as soon as wanted(lattice) returns false.
  template <typename ValueAt, typename Difference, typename Wanted>
  void Refine(const Georeference& place, double tolerance, const ValueAt& valueAt,
    const Difference& difference, const Wanted& wanted)
  {
    // Powers of two plus one, so that each lattice contains the nodes of the previous one.
    constexpr std::ptrdiff_t firstSide = 5, lastSide = 257;
    RefinedLattice lattice = Make(place, firstSide, valueAt);
    // Refine until a lattice predicts the next finer one within the tolerance. The finer one is
    // kept; its error is about a quarter of the measured one.
    do
    {
      if (!wanted(lattice))
      {
        return;
      }
      RefinedLattice finer = Make(place, 2 * lattice.Side - 1, valueAt);
      for (std::ptrdiff_t j = 0; j < finer.Side; ++j)
      {
        for (std::ptrdiff_t i = 0; i < finer.Side; ++i)
        {
          const Node predicted = lattice.Interpolate(static_cast<double>(i) / finer.NodesPerColumn,
            static_cast<double>(j) / finer.NodesPerRow);
          finer.Error = std::max(finer.Error, difference(predicted, finer.At(i, j)));
        }
      }
      lattice = std::move(finer);
    } while (lattice.Error > tolerance && lattice.Side < lastSide);
    *this = std::move(lattice);
  }

private:
  template <typename ValueAt>
  static RefinedLattice Make(const Georeference& place, std::ptrdiff_t side, const ValueAt& valueAt)
  {
    RefinedLattice lattice;
    lattice.Side = side;
    lattice.NodesPerColumn = static_cast<double>(side - 1) / static_cast<double>(place.Columns - 1);
    lattice.NodesPerRow = static_cast<double>(side - 1) / static_cast<double>(place.Rows - 1);
    for (std::ptrdiff_t j = 0; j < side; ++j)
    {
      for (std::ptrdiff_t i = 0; i < side; ++i)
      {
        lattice.Nodes.push_back(valueAt(static_cast<double>(i) / lattice.NodesPerColumn,
          static_cast<double>(j) / lattice.NodesPerRow));
      }
    }
    return lattice;
  }
};

} // namespace skyline

#endif
