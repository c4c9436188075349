// SPDX-License-Identifier: BSD-3-Clause
#include "LampReach.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace
{

constexpr double MetresPerKilometre = 1000.0;

std::string Length(double metres)
{
  std::ostringstream text;
  text.precision(4);
  const bool far = metres >= MetresPerKilometre;
  text << (far ? metres / MetresPerKilometre : metres) << (far ? " km" : " m");
  return text.str();
}

} // namespace

namespace skyline
{

std::optional<Doubt> FarLamp(int number, const LampPlace& lamp, const std::array<double, 4>& bounds)
{
  const double east = std::max({ bounds[0] - lamp.X, lamp.X - bounds[1], 0.0 });
  const double north = std::max({ bounds[2] - lamp.Y, lamp.Y - bounds[3], 0.0 });
  const double distance = std::hypot(east, north);
  const double width = std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  if (!(distance > width && std::pow(lamp.Radius / distance, 2) < LeastLampShare))
  {
    return std::nullopt;
  }
  return Doubt{ "lamp " + std::to_string(number) + " stands " + Length(distance) +
      " outside the height field, too far to light it",
    "its X and Y are coordinates in the CRS of the height field", "" };
}

} // namespace skyline
