// SPDX-License-Identifier: BSD-3-Clause
// The numbers of bands of spherical harmonics that filters accept.
#ifndef skyline_HarmonicBands_h
#define skyline_HarmonicBands_h

#include "Harmonics/SphericalHarmonics.h"

#include <stdexcept>
#include <string>

namespace skyline
{

constexpr int LeastHarmonicBands = 2; ///< fewer bands have no direction

/// Throws std::invalid_argument unless there are 2 to 8 bands.
inline void CheckHarmonicBands(int bands)
{
  if (bands < LeastHarmonicBands || bands > MaxHarmonicBands)
  {
    throw std::invalid_argument(std::to_string(bands) + " bands of spherical harmonics; give " +
      std::to_string(LeastHarmonicBands) + " to " + std::to_string(MaxHarmonicBands));
  }
}

} // namespace skyline

#endif
