// SPDX-License-Identifier: BSD-3-Clause
// Finds lamps whose position was probably given in another CRS than that of the height field.
#ifndef skyline_LampReach_h
#define skyline_LampReach_h

#include "Shared/Doubt.h"

#include <array>
#include <optional>

namespace skyline
{

/// The position of a lamp on the map, in metres.
struct LampPlace
{
  double X = 0.0, Y = 0.0; ///< in the coordinates of the bounds of the field
  double Radius = 0.0;     ///< 0 or more
};

/// Returns a warning if a lamp stands outside the field and cannot light it: it is further away
/// than the field is wide, and the irradiance at the field is less than LeastLampShare of that on
/// its own surface. `number` is that of the lamp in the message, counted from 1. `bounds` are west,
/// east, south and north, in metres.
std::optional<Doubt> FarLamp(
  int number, const LampPlace& lamp, const std::array<double, 4>& bounds);

/// The irradiance of a ball falls with (radius / distance)^2. Below a millionth, a lamp outside the
/// field is lost in the rounding of a float sum with any other light.
constexpr double LeastLampShare = 1e-6;

} // namespace skyline

#endif
