// SPDX-License-Identifier: BSD-3-Clause
// Azimuths as the public interfaces give them.
#ifndef skyline_Azimuth_h
#define skyline_Azimuth_h

#include "Shared/Constants.h"

#include <cmath>

namespace skyline
{

/// Azimuth (degrees clockwise from north, 0 up to, not including, 360) of a horizontal direction
/// with the given east and north components; 0 for no direction.
inline double AzimuthOf(double east, double north)
{
  const double azimuth = std::atan2(east, north) * DegreesPerRadian;
  if (azimuth >= 0.0)
  {
    return azimuth;
  }
  // Adding 360 to -1e-15 gives 360 itself.
  const double turned = azimuth + 360.0;
  return turned < 360.0 ? turned : 0.0;
}

/// The same direction, 0 up to, not including, 360 degrees, for an azimuth of any number of turns.
inline double NormalizedAzimuth(double degrees)
{
  const double part = std::fmod(degrees, 360.0);
  const double turned = part < 0.0 ? part + 360.0 : part;
  return turned < 360.0 ? turned : 0.0;
}

} // namespace skyline

#endif
