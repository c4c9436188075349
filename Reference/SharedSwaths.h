// SPDX-License-Identifier: BSD-3-Clause
// Key lights with overlapping swaths share one set of horizons: Snyder & Nowrouzezahrai (2008),
// section 6.
#ifndef skyline_SharedSwaths_h
#define skyline_SharedSwaths_h

#include "Reference/KeyLight.h"

#include <cstddef>
#include <vector>

namespace skyline
{

/// Lights that use one set of horizons.
struct SharedSwath
{
  Swath Extent;
  std::vector<std::size_t> Lights; ///< indices, ascending
};

/// Joins swaths that overlap, which needs the fewest azimuths: a joined swath is no wider than its
/// parts together. The other swaths keep their width. The result is in the order of the azimuths.
std::vector<SharedSwath> ShareSwaths(const std::vector<KeyLight>& lights);

} // namespace skyline

#endif
