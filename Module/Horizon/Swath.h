// SPDX-License-Identifier: BSD-3-Clause
// A range of azimuths.
#ifndef skyline_Swath_h
#define skyline_Swath_h

#include "Shared/Constants.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace skyline
{

/// The azimuths from Azimuth - Width / 2 to Azimuth + Width / 2, in radians clockwise from grid
/// north.
struct Swath
{
  double Azimuth = 0.0;
  double Width = 2.0 * Pi; ///< above 0, at most 2 pi (the full circle)

  bool IsCircle() const { return this->Width >= 2.0 * Pi * (1.0 - 1.0e-12); }
  bool Holds(double azimuth) const
  {
    return std::abs(std::remainder(azimuth - this->Azimuth, 2.0 * Pi)) <=
      0.5 * this->Width + 1.0e-12;
  }
};

/// The centres of `count` equal parts of a swath, each Width / count wide: azimuths for a
/// VisibilityAccumulator.
inline std::vector<double> AzimuthsOf(const Swath& swath, int count)
{
  std::vector<double> azimuths(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
  {
    azimuths[static_cast<std::size_t>(k)] = swath.Azimuth + ((k + 0.5) / count - 0.5) * swath.Width;
  }
  return azimuths;
}

} // namespace skyline

#endif
