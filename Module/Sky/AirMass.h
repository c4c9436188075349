// SPDX-License-Identifier: BSD-3-Clause
// The path length of light through the air.
#ifndef skyline_AirMass_h
#define skyline_AirMass_h

#include "Shared/Constants.h"

#include <cmath>

namespace skyline
{

/// Relative path length of light through the air at an apparent elevation in degrees; 1 at the
/// zenith. Kasten and Young, Applied Optics 28 (1989), eq. 3. Below the horizon, the value at the
/// horizon is returned.
inline double AirMass(double elevation)
{
  const double e = elevation > 0.0 ? elevation : 0.0;
  return 1.0 / (std::sin(e * RadiansPerDegree) + 0.50572 * std::pow(e + 6.07995, -1.6364));
}

} // namespace skyline

#endif
