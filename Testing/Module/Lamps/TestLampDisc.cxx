// SPDX-License-Identifier: BSD-3-Clause
// The irradiance of a lamp without shadow: the closed form compared with quadrature, and limits of
// the formula.
#include "Lamps/Lamp.h"
#include "Shared/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace skyline
{
namespace testing
{
namespace
{

/// The closed form compared with the quadrature below, for irradiances up to pi.
constexpr double QuadratureBound = 1.0e-7;

/// The error of a few roundings of numbers near 1.
constexpr double RoundingBound = 1.0e-14;

/// The irradiance of a disc with the angular radius s around the direction at the angle t from the
/// normal, by rings around the normal. On the ring r the disc covers an arc of half width w, with
/// cos w = (cos s - cos t cos r) / (sin t sin r). The irradiance is the integral of 2 w cos r sin r
/// over r up to the plane.
/// Midpoints in an angle that makes the square roots at the ends of the arc smooth.
double ByRings(double s, double t)
{
  const int steps = 200000;
  // Rings from |t - s| to t + s. Those nearer to the normal than s - t are full circles.
  const double whole = std::max(0.0, s - t);
  const double wholeEnd = std::min(whole, 0.5 * Pi);
  double sum = Pi * std::sin(wholeEnd) * std::sin(wholeEnd);
  const double from = std::abs(t - s), to = t + s;
  for (int k = 0; k < steps; ++k)
  {
    const double turn = Pi * (k + 0.5) / steps;
    const double r = 0.5 * (from + to) - 0.5 * (to - from) * std::cos(turn);
    if (r >= 0.5 * Pi)
    {
      break;
    }
    const double step = 0.5 * (to - from) * std::sin(turn) * Pi / steps;
    const double bottom = std::sin(t) * std::sin(r);
    const double c = bottom > 0.0 ? (std::cos(s) - std::cos(t) * std::cos(r)) / bottom : -1.0;
    sum += 2.0 * std::acos(std::min(1.0, std::max(-1.0, c))) * std::cos(r) * std::sin(r) * step;
  }
  return sum;
}

TEST(LampDisc, IrradianceIsTheIntegralForEveryTilt)
{
  for (const double s : { 0.001, 0.1, 0.5, 1.0, 1.5, 0.5 * Pi })
  {
    for (const double t : { 0.0, 0.3, 0.5 * Pi - 0.1, 0.5 * Pi, 1.7, 2.5, Pi })
    {
      const LampDisc disc{ std::sin(s), std::cos(s) };
      // If the plane cuts a step in its middle, the ring of this step is lost.
      const double bound = QuadratureBound + 2.0 * s / 200000.0 * s;
      EXPECT_NEAR(DiscIrradiance(disc, std::cos(t)), ByRings(s, t), bound) << s << " " << t;
    }
  }
}

TEST(LampDisc, HalfAPlane)
{
  // A lamp whose centre lies in the plane of the receiver: half of the disc, s - sin s cos s, by
  // integration of sin^2 over it.
  for (const double s : { 0.01, 0.4, 1.2, 0.5 * Pi })
  {
    const LampDisc disc{ std::sin(s), std::cos(s) };
    EXPECT_NEAR(DiscIrradiance(disc, 0.0), s - std::sin(s) * std::cos(s), RoundingBound) << s;
  }
}

TEST(LampDisc, JoinsAtItsCases)
{
  // The formulas for the whole disc and for the cut disc agree at t = 90 degrees - s. The latter is
  // 0 at 90 degrees + s.
  for (const double s : { 0.01, 0.4, 1.2 })
  {
    const LampDisc disc{ std::sin(s), std::cos(s) };
    const double step = 1.0e-9;
    EXPECT_NEAR(
      DiscIrradiance(disc, disc.Sine + step), DiscIrradiance(disc, disc.Sine - step), 8.0 * step);
    EXPECT_NEAR(DiscIrradiance(disc, -disc.Sine + step), 0.0, step);
    EXPECT_EQ(DiscIrradiance(disc, -disc.Sine), 0.0);
  }
}

TEST(LampDisc, IsContinuousOnTheWayIntoTheLamp)
{
  for (const double cosine : { -1.0, -0.7, 0.0, 0.2, 1.0 })
  {
    // At the surface of the lamp, light comes from a half space.
    const double skin = 0.5 * Pi * (1.0 + cosine);
    EXPECT_NEAR(DiscIrradiance(DiscOfLamp(5.0, 5.0), cosine), skin, RoundingBound);
    // The angle changes with the square root of the distance, which is 2e-9 of the radius: 6e-5.
    EXPECT_NEAR(DiscIrradiance(DiscOfLamp(5.0, 5.0 * (1.0 + 1e-9)), cosine), skin, 2.0e-4);
    EXPECT_NEAR(DiscIrradiance(DiscOfLamp(5.0, 5.0 * (1.0 - 1e-9)), cosine), skin, 2.0e-4);
    // At the centre light comes from all directions, so the direction to the lamp has no effect.
    EXPECT_NEAR(DiscIrradiance(DiscOfLamp(5.0, 0.0), cosine), Pi, RoundingBound);
    EXPECT_NEAR(DiscIrradiance(DiscOfLamp(5.0, 1e-6), cosine), Pi, 1.0e-12);
  }
}

TEST(LampDisc, GrowsOnTheWayIn)
{
  double before = 0.0;
  for (int step = 80; step >= 0; --step)
  {
    const double distance = 0.25 * step;
    const double now = DiscIrradiance(DiscOfLamp(5.0, distance), 0.3);
    EXPECT_GE(now, before - RoundingBound) << distance;
    before = now;
  }
}

TEST(LampDisc, NoRadiusNoLight)
{
  EXPECT_EQ(DiscIrradiance(DiscOfLamp(0.0, 10.0), 1.0), 0.0);
  EXPECT_EQ(DiscIrradiance(DiscOfLamp(0.0, 0.0), 1.0), 0.0);
  // Towards this limit, the irradiance follows the square of the radius to the last digit.
  for (const double radius : { 1e-3, 1e-8, 1e-100 })
  {
    EXPECT_NEAR(DiscIrradiance(DiscOfLamp(radius, 2.0), 0.6) / (0.15 * Pi * radius * radius), 1.0,
      RoundingBound);
  }
}

TEST(LampDisc, FarAwayKeepsItsDigits)
{
  // An angular radius of 1 degree at any distance.
  const double sine = std::sin(RadiansPerDegree);
  for (const double distance : { 1.0, 1e6, 1e15 })
  {
    const LampDisc disc = DiscOfLamp(sine * distance, distance);
    EXPECT_NEAR(DiscIrradiance(disc, 0.5) / (0.5 * Pi * sine * sine), 1.0, RoundingBound);
  }
}

TEST(Lamp, TellsWhatIsWrong)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Lamp lamp;
  lamp.Radius = 1.0;
  EXPECT_NO_THROW(CheckLamp(lamp));
  lamp.Radius = -1.0;
  EXPECT_THROW(CheckLamp(lamp), std::invalid_argument);
  lamp.Radius = nan;
  EXPECT_THROW(CheckLamp(lamp), std::invalid_argument);
  lamp.Radius = 0.0;
  lamp.Y = nan;
  EXPECT_THROW(CheckLamp(lamp), std::invalid_argument);
  lamp.Y = 0.0;
  lamp.Radiance[2] = -1.0f;
  EXPECT_THROW(CheckLamp(lamp), std::invalid_argument);
}

} // namespace
} // namespace testing
} // namespace skyline
