// SPDX-License-Identifier: BSD-3-Clause
#include "Twilight.h"

#include <array>
#include <cmath>

namespace
{

// The common logarithm of lux as a polynomial of the elevation in right angles, down to Lowest degrees.
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

} // namespace skyline
