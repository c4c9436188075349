// SPDX-License-Identifier: BSD-3-Clause
// Evenly spaced azimuths.
#ifndef skyline_Azimuths_h
#define skyline_Azimuths_h

#include "Shared/Constants.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace skyline
{

constexpr int MaximumAzimuths = 3600; ///< one per tenth of a degree: finer than any raster resolves

/// Returns 360 k / count degrees, k = 0 .. count - 1. Throws std::invalid_argument unless count is
/// 1 to 3600.
inline std::vector<double> EvenDegrees(int count)
{
  if (count < 1 || count > MaximumAzimuths)
  {
    throw std::invalid_argument(
      std::to_string(count) + " azimuths; give 1 to " + std::to_string(MaximumAzimuths));
  }
  std::vector<double> azimuths(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
  {
    azimuths[static_cast<std::size_t>(k)] = 360.0 * k / count;
  }
  return azimuths;
}

/// The same in radians.
inline std::vector<double> EvenAzimuths(int count)
{
  std::vector<double> azimuths = EvenDegrees(count);
  for (double& azimuth : azimuths)
  {
    azimuth *= RadiansPerDegree;
  }
  return azimuths;
}

} // namespace skyline

#endif
