// SPDX-License-Identifier: BSD-3-Clause
#include "Lamps/Lamp.h"

#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace skyline
{

void CheckLamp(const Lamp& lamp)
{
  if (!std::isfinite(lamp.X) || !std::isfinite(lamp.Y) || !std::isfinite(lamp.Z))
  {
    throw std::invalid_argument("lamp: its position must be finite");
  }
  if (!(lamp.Radius >= 0.0) || !std::isfinite(lamp.Radius))
  {
    throw std::invalid_argument(
      "lamp: radius " + std::to_string(lamp.Radius) + " m; give 0 or more");
  }
  for (const float radiance : lamp.Radiance)
  {
    if (!(radiance >= 0.0f) || !std::isfinite(radiance))
    {
      throw std::invalid_argument(
        "lamp: radiance " + std::to_string(radiance) + "; give 0 or more");
    }
  }
}

LampDisc DiscOfLamp(double radius, double distance)
{
  if (!(radius > 0.0))
  {
    return {};
  }
  const double ratio = radius < distance ? radius / distance : distance / radius;
  const double cosine = std::sqrt((1.0 - ratio) * (1.0 + ratio));
  return { ratio, radius < distance ? cosine : -cosine };
}

double DiscIrradiance(const LampDisc& disc, double cosine)
{
  const double c = std::clamp(cosine, -1.0, 1.0);
  if (disc.Cosine < 0.0)
  {
    // All directions except those in the opposite disc.
    return Pi - DiscIrradiance({ disc.Sine, -disc.Cosine }, -c);
  }
  if (c >= disc.Sine)
  {
    return Pi * disc.Sine * disc.Sine * c;
  }
  if (c <= -disc.Sine || disc.Sine <= 0.0)
  {
    return 0.0;
  }
  // sin s sin t sqrt(1 - y^2) = sqrt(sin^2 s - cos^2 t), without a quotient that fails at s = 90
  // degrees; acos y is computed by atan2 for the same reason.
  const double edge = std::sqrt((disc.Sine - c) * (disc.Sine + c));
  const double angle = std::atan2(edge, -disc.Cosine * c);
  return std::max(
    0.0, disc.Sine * disc.Sine * c * angle - disc.Cosine * edge + std::atan2(edge, disc.Cosine));
}

} // namespace skyline
