// SPDX-License-Identifier: BSD-3-Clause
// Azimuths in the form of the public interfaces.
#ifndef skyline_Azimuth_h
#define skyline_Azimuth_h

#include "Shared/Constants.h"

#include <cmath>

namespace skyline
{

/// Azimuth (degrees clockwise from north, at least 0 and below 360) of the horizontal direction
/// with the given east and north components; 0 if both are 0.
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

/// The same direction as an azimuth from 0 to below 360 degrees. The input may have any number of
/// turns.
inline double NormalizedAzimuth(double degrees)
{
  const double part = std::fmod(degrees, 360.0);
  const double turned = part < 0.0 ? part + 360.0 : part;
  return turned < 360.0 ? turned : 0.0;
}

} // namespace skyline

#endif
