// SPDX-License-Identifier: BSD-3-Clause
// The visible part of a lamp's circle in one vertical plane, compared with rays in this plane.
#include "Lamps/LampChord.h"
#include "Reference/Shapes.h"
#include "Shared/Constants.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <utility>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

using Profile = std::vector<std::pair<double, double>>; // distance and height, starting at (0, 0)

constexpr int Rays = 20000;

/// One ray more or less at each edge of the visible parts, of which there are a few, times the
/// greatest light of a ray. The facing is at most 1.
constexpr double RayBound = 8.0 * Pi / Rays;

/// The light of the circle by rays. A ray ends at its first point of the circle.
double ByRays(double along, double up, double circle, const LampFacing& facing,
  const Profile& profile, bool shadowed)
{
  double light = 0.0;
  for (int k = 0; k < Rays; ++k)
  {
    const double e = Pi * ((k + 0.5) / Rays - 0.5);
    const double c = std::cos(e), s = std::sin(e);
    const double middle = along * c + up * s;
    const double root = middle * middle - (along * along + up * up - circle * circle);
    if (root < 0.0 || middle <= 0.0)
    {
      continue;
    }
    const double end = (middle - std::sqrt(root)) * c; // horizontal distance
    bool hidden = false;
    for (std::size_t p = 0; shadowed && p + 1 < profile.size() && !hidden; ++p)
    {
      const double s0 = profile[p].first, s1 = profile[p + 1].first;
      const double z0 = profile[p].second, z1 = profile[p + 1].second;
      if (s0 < end)
      {
        const double stop = std::min(end, s1);
        const double z = z0 + (z1 - z0) * (stop - s0) / (s1 - s0);
        hidden = z * c > stop * s || z0 * c > s0 * s;
      }
    }
    if (!hidden)
    {
      light += std::max(0.0, facing.Up * s + facing.Along * c) * c * Pi / Rays;
    }
  }
  return light;
}

/// The visible light by LampChord, which is moved along the profile.
double ByChord(LampChord& chord, const Profile& profile)
{
  chord.Start(profile[1].second / profile[1].first);
  for (std::size_t p = 0; p + 1 < profile.size(); ++p)
  {
    if (!chord.Piece(
          profile[p].first, profile[p].second, profile[p + 1].first, profile[p + 1].second))
    {
      break;
    }
  }
  return chord.Lit();
}

TEST(LampChord, SeesWhatRaysSee)
{
  shapes::Random random(7);
  int partly = 0;
  for (int trial = 0; trial < 1500; ++trial)
  {
    // Rough terrain in steps of about 1, and a circle above it, in it, around the vertical through
    // the post, or below.
    Profile profile{ { 0.0, 0.0 } };
    const double rough = std::pow(10.0, 2.0 * random() - 1.0);
    const bool cliffs = random() < 0.4;
    while (profile.back().first < 30.0)
    {
      const double width = cliffs && random() < 0.3 ? 0.01 : 0.3 + random();
      profile.emplace_back(
        profile.back().first + width, 0.9 * profile.back().second + rough * (2.0 * random() - 1.0));
    }
    const double circle = std::pow(10.0, 2.0 * random() - 1.0);
    const double along = 25.0 * random() - (random() < 0.3 ? 1.0 : 0.0) * circle;
    const double up = 10.0 * (2.0 * random() - 0.7);
    const double power = along * along + up * up - circle * circle;
    if (power <= 1e-3)
    {
      continue;
    }
    const double tilt = (random() - 0.5) * 2.0;
    const LampFacing facing{ std::cos(tilt), std::sin(tilt) };
    LampChord chord;
    const bool seen = chord.Set(along, up, circle, std::sqrt(power), facing);
    const double whole = ByRays(along, up, circle, facing, profile, false);
    const double lit = ByRays(along, up, circle, facing, profile, true);
    EXPECT_NEAR(seen ? chord.Whole() : 0.0, whole, RayBound) << trial;
    if (seen)
    {
      const double found = ByChord(chord, profile);
      EXPECT_NEAR(found, lit, RayBound)
        << trial << ": circle " << circle << " at " << along << ", " << up;
      EXPECT_LE(found, chord.Whole());
      partly += lit > 0.05 * whole && lit < 0.95 * whole ? 1 : 0;
    }
  }
  EXPECT_GT(partly, 100); // enough trials are partly in shadow
}

// A circle that touches the vertical through the post, up to rounding, from either side: its
// tangents lean forward, and no slope is divided by 0.
TEST(LampChord, TouchesTheVertical)
{
  const Profile profile{ { 0.0, 0.0 }, { 1.0, 0.4 }, { 1.5, 3.0 }, { 2.5, -2.0 }, { 9.0, -9.0 } };
  for (const double up : { -4.0, 4.0 })
  {
    for (const double beyond : { -1e-15, 0.0, 1e-15 })
    {
      const double along = 3.0 * (1.0 + beyond);
      const double tangent = 4.0 * (1.0 + 1e-14); // of a length that rounding made too large
      const LampFacing facing{ std::cos(1.2), std::copysign(std::sin(1.2), -up) };
      std::feclearexcept(FE_ALL_EXCEPT);
      LampChord chord;
      ASSERT_TRUE(chord.Set(along, up, 3.0, tangent, facing));
      const double found = ByChord(chord, profile);
      EXPECT_EQ(std::fetestexcept(FE_INVALID | FE_OVERFLOW | FE_DIVBYZERO), 0);
      EXPECT_NEAR(chord.Whole(), ByRays(along, up, 3.0, facing, profile, false), RayBound);
      EXPECT_NEAR(found, ByRays(along, up, 3.0, facing, profile, true), RayBound)
        << up << " " << beyond;
    }
  }
}

TEST(LampChord, WithoutTerrainNothingIsMissing)
{
  LampChord chord;
  ASSERT_TRUE(chord.Set(10.0, 3.0, 2.0, std::sqrt(105.0), { 1.0, 0.0 }));
  EXPECT_EQ(chord.Lit(), chord.Whole());
  chord.Piece(1.0, -1.0, 2.0, -2.0);
  EXPECT_EQ(chord.Lit(), chord.Whole());
}

TEST(LampChord, TerrainBehindAndInsideHidesNothing)
{
  LampChord chord;
  ASSERT_TRUE(chord.Set(10.0, 3.0, 2.0, std::sqrt(105.0), { 1.0, 0.0 }));
  chord.Piece(12.0, 0.0, 12.1, 1000.0); // a wall behind
  chord.Piece(10.5, 2.5, 10.6, 3.5);    // a short obstacle inside, beyond both tangents
  EXPECT_EQ(chord.Lit(), chord.Whole());
  EXPECT_TRUE(chord.Piece(5.0, 0.0, 5.1, 1.6)); // in front, half of the height
  EXPECT_LT(chord.Lit(), chord.Whole());
  EXPECT_GT(chord.Lit(), 0.0);
  EXPECT_FALSE(chord.Piece(6.0, 0.0, 6.1, 1000.0));
  EXPECT_EQ(chord.Lit(), 0.0);
}

} // namespace
} // namespace testing
} // namespace skyline
