// SPDX-License-Identifier: BSD-3-Clause
// Lamps whose place was probably given in another CRS than that of the height field.
#ifndef skyline_LampReach_h
#define skyline_LampReach_h

#include "Shared/Doubt.h"

#include <array>
#include <optional>

namespace skyline
{

/// A lamp stands on the map, metres.
struct LampPlace
{
  double X = 0.0, Y = 0.0; ///< as the field's bounds
  double Radius = 0.0;     ///< 0 or more
};

/// What is doubtful about a lamp that stands beside the field and cannot light it: further away than the
/// field is wide, with less than LeastLampShare of the light that it gives on its own surface.
/// `number`: of the lamp, from 1, for the message; `bounds`: west, east, south, north, metres.
std::optional<Doubt> FarLamp(
  int number, const LampPlace& lamp, const std::array<double, 4>& bounds);

/// The irradiance of a ball falls with (radius / distance)^2. Below a millionth, a lamp beside the field
/// is no more than rounding in a float's sum with any other light.
constexpr double LeastLampShare = 1e-6;

} // namespace skyline

#endif
