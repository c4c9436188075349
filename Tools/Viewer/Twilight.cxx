// SPDX-License-Identifier: BSD-3-Clause
#include "Twilight.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

// The decimal logarithm of lux as a polynomial of the elevation in right angles, down to Lowest
// degrees.
struct Stretch
{
  double Lowest;
  std::array<double, 4> Coefficients;
};

constexpr std::array<Stretch, 4> Stretches{ {
  { -0.8, { { 2.88, 22.26, -207.64, 1034.30 } } },
  { -5.0, { { 2.88, 21.81, -258.11, -858.36 } } },
  { -12.0, { { 2.70, 12.17, -431.69, -1899.83 } } },
  { -18.0, { { 13.84, 262.72, 1447.42, 2797.93 } } },
} };

// The colour of twilight relative to that of day, and the elevation in degrees of a sun below which
// only twilight is left: the light that ozone lets through on the long way. The values were chosen
// by eye.
constexpr skyline::Rgb TwilightColor{ { 0.75f, 1.0f, 1.6f } };
constexpr double BlueHour = -6.0;

} // namespace

namespace skyline
{

double TwilightIlluminance(double elevation)
{
  const double inside = elevation < -18.0 ? -18.0 : elevation < 0.0 ? elevation : 0.0;
  const Stretch* stretch = Stretches.data();
  while (inside < stretch->Lowest)
  {
    ++stretch;
  }
  const double x = inside / 90.0;
  const auto& c = stretch->Coefficients;
  return std::pow(10.0, c[0] + x * (c[1] + x * (c[2] + x * c[3])));
}

double TwilightShare(double elevation)
{
  return TwilightIlluminance(elevation) / TwilightIlluminance(0.0);
}

Daylight DaylightAndNight(double elevation, bool air)
{
  Daylight day = ClearDaylight(elevation, air);
  const auto share = static_cast<float>(TwilightShare(elevation));
  const auto blue = static_cast<float>(air ? std::clamp(elevation / BlueHour, 0.0, 1.0) : 0.0);
  const float before = Luminance(day.SkyRadiance);
  for (std::size_t c = 0; c < 3; ++c)
  {
    day.SkyRadiance[c] *= 1.0f + blue * (TwilightColor[c] - 1.0f);
  }
  const float gain = share * before / Luminance(day.SkyRadiance);
  for (float& channel : day.SkyRadiance)
  {
    channel *= gain;
  }
  return day;
}

} // namespace skyline
