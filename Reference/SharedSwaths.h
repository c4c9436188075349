// SPDX-License-Identifier: BSD-3-Clause
// Key lights whose swaths overlap share one set of horizons: Snyder & Nowrouzezahrai 2008, section 6.
#ifndef skyline_SharedSwaths_h
#define skyline_SharedSwaths_h

#include "Harmonics/KeyLight.h"

#include <cstddef>
#include <vector>

namespace skyline
{

/// Lights that are lit by one set of horizons.
struct SharedSwath
{
  Swath Extent;
  std::vector<std::size_t> Lights; ///< indices, rising
};

/// As few azimuths as the lights need: swaths that overlap become one, for it is no wider than they
/// were together; the others stay as sharp as they were. In the order of their azimuths.
std::vector<SharedSwath> ShareSwaths(const std::vector<KeyLight>& lights);

} // namespace skyline

#endif
