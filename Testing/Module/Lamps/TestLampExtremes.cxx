// SPDX-License-Identifier: BSD-3-Clause
// Lamps below the ground, in it, far above it and around all of it: the light is defined and
// changes continuously.
#include "Reference/LampScene.h"
#include "Sun/SunAccumulator.h"

#include <gtest/gtest.h>

#include <limits>

namespace skyline
{
namespace testing
{
namespace
{

/// The error of the planes and of the bisection, relative to the irradiance without shadow.
constexpr double PlaneBound = 0.005;

oracle::OracleField Hills()
{
  return shapes::Fractal(33, 33, 10.0, 100.0, 4);
}

TEST(LampExtremes, LightIsContinuousInEveryParameter)
{
  const oracle::OracleField hills = shapes::Fractal(17, 17, 10.0, 80.0, 4);
  const LampScene scene(hills);
  const double ground = hills.At(8, 8);
  struct Way
  {
    const char* Name;
    oracle::Ball From, To;
  };
  const Way ways[] = {
    { "down into the ground", { { 83.0, 81.0, ground + 60.0 }, 12.0 },
      { { 83.0, 81.0, ground - 30.0 }, 12.0 } },
    { "over a post", { { 50.0, 80.0, ground + 25.0 }, 12.0 },
      { { 110.0, 80.0, ground + 25.0 }, 12.0 } },
    { "growing over everything", { { 83.0, 81.0, ground + 60.0 }, 1.0 },
      { { 83.0, 81.0, ground + 60.0 }, 400.0 } },
    { "through a post", { { 80.0, 80.0, ground + 20.0 }, 12.0 },
      { { 80.0, 80.0, ground - 20.0 }, 12.0 } },
  };
  for (const Way& way : ways)
  {
    const auto light = [&](double u)
    {
      return scene.Light({ (1.0 - u) * way.From.Centre + u * way.To.Centre,
        (1.0 - u) * way.From.Radius + u * way.To.Radius });
    };
    // Finds the step with the greatest change of all posts, then the greatest change of its parts.
    // A jump would keep its size; a change like a square root falls to 0.35 with each eighth.
    double begin = 0.0, end = 1.0, first = 0.0, change = 0.0;
    for (int round = 0; round < 4; ++round)
    {
      const int steps = round == 0 ? 150 : 8;
      std::vector<float> before = light(begin);
      int worst = 0;
      change = 0.0;
      for (int k = 1; k <= steps; ++k)
      {
        const std::vector<float> now = light(begin + (end - begin) * k / steps);
        for (std::size_t post = 0; post < now.size(); ++post)
        {
          ASSERT_TRUE(now[post] >= 0.0f && now[post] <= 1.0001f * static_cast<float>(Pi))
            << way.Name;
          const double difference = std::abs(now[post] - before[post]);
          if (difference > change)
          {
            change = difference;
            worst = k;
          }
        }
        before = now;
      }
      first = round == 0 ? change : first;
      const double width = (end - begin) / steps;
      begin += (worst - 1) * width;
      end = begin + width;
    }
    std::printf("%-26s greatest change by a step of 1/150: %.4f, of 1/%d: %.4f\n", way.Name, first,
      150 * 512, change);
    EXPECT_LT(change, std::max(0.1 * first, PlaneBound * Pi)) << way.Name;
  }
}

TEST(LampExtremes, BelowTheGroundIsDark)
{
  const oracle::OracleField hills = Hills();
  const LampScene scene(hills);
  const oracle::Ball ball{ { 163.0, 161.0, hills.At(16, 16) - 200.0 }, 20.0 };
  for (const float light : scene.Light(ball))
  {
    EXPECT_EQ(light, 0.0f);
  }
  // A level plain hides all light from below it, and half of a lamp at its own height.
  const LampScene plain(shapes::Plane(17, 17, 10.0, 0.0, 0.0));
  for (const double height : { -5.0, 0.0 })
  {
    const oracle::Ball sunk{ { 83.0, 84.0, height }, 4.0 };
    const std::vector<float> light = plain.Light(sunk);
    for (std::ptrdiff_t k = 0; k < 17 * 17; ++k)
    {
      const double whole = plain.Unshadowed(sunk, k % 17, k / 17);
      EXPECT_NEAR(light[static_cast<std::size_t>(k)], height < 0.0 ? 0.0 : whole, 1e-6);
    }
  }
}

TEST(LampExtremes, BehindALampTerrainDoesNotHideIt)
{
  // A wall of 200 m right behind the lamp: the posts in front see the whole lamp, those behind see
  // nothing.
  const LampScene scene(shapes::Wall(33, 33, 10.0, 200.0, 20, 3));
  const oracle::Ball ball{ { 170.0, 160.0, 15.0 }, 10.0 };
  const std::vector<float> light = scene.Light(ball, true);
  for (std::ptrdiff_t i = 0; i < 33; ++i)
  {
    const std::size_t post = scene.Heights.Index(i, 16);
    const oracle::Vector3 to = ball.Centre - oracle::PlaceOf(scene.Heights, i, 16);
    const double distance = std::sqrt(oracle::Dot(to, to));
    const double whole = DiscIrradiance(DiscOfLamp(10.0, distance), to.Z / distance);
    if (i < 19)
    {
      EXPECT_NEAR(light[post], whole, 1e-6) << i;
    }
    else if (i > 22)
    {
      EXPECT_EQ(light[post], 0.0f) << i;
    }
  }
}

TEST(LampExtremes, ReceiversInsideTheLamp)
{
  const LampScene plain(shapes::Plane(17, 17, 10.0, 0.0, 0.0));
  // Level ground through the centre. At the centre a post gets all light of the upper hemisphere,
  // pi. Elsewhere the closed form holds, because the plain is the plane of the receivers.
  const oracle::Ball ball{ { 80.0, 80.0, 0.0 }, 55.0 };
  const std::vector<float> light = plain.Light(ball);
  EXPECT_NEAR(light[plain.Heights.Index(8, 8)], Pi, 1e-6);
  for (std::ptrdiff_t k = 0; k < 17 * 17; ++k)
  {
    EXPECT_NEAR(light[static_cast<std::size_t>(k)], plain.Unshadowed(ball, k % 17, k / 17), 1e-5);
  }
  // Rough ground inside the lamp: only the facets at the post hide light, not terrain farther away.
  const LampScene hills(Hills());
  const oracle::Ball around{ { 160.0, 160.0, 50.0 }, 1000.0 };
  const std::vector<float> inside = hills.Light(around);
  for (std::ptrdiff_t k = 0; k < 33 * 33; ++k)
  {
    const double whole = hills.Unshadowed(around, k % 33, k / 33);
    EXPECT_LE(inside[static_cast<std::size_t>(k)], whole * (1.0 + 1e-6));
    EXPECT_GE(inside[static_cast<std::size_t>(k)], 0.25 * whole);
  }
}

TEST(LampExtremes, OverAPostNoAzimuthIsSpecial)
{
  // Exactly above a post: moving the lamp slightly to any side changes nothing.
  const oracle::OracleField hills = Hills();
  const LampScene scene(hills);
  const std::size_t post = hills.Index(16, 16);
  for (const double height : { 8.0, 30.0, 500.0 })
  {
    const oracle::Vector3 above{ 160.0, 160.0, hills.At(16, 16) + height };
    const double here = scene.Light({ above, 7.0 })[post];
    const double whole = scene.Unshadowed({ above, 7.0 }, 16, 16);
    EXPECT_GT(here, 0.5 * whole);
    for (const oracle::Vector3& aside : { oracle::Vector3{ 1e-7, 0.0, 0.0 },
           oracle::Vector3{ -1e-7, 0.0, 0.0 }, oracle::Vector3{ 0.0, -1e-7, 0.0 } })
    {
      EXPECT_NEAR(scene.Light({ above + aside, 7.0 })[post], here, PlaneBound * whole);
    }
  }
}

TEST(LampExtremes, RadiusTendsToZero)
{
  const LampScene scene(Hills());
  const oracle::Vector3 place{ 163.0, 161.0, 80.0 };
  EXPECT_EQ(scene.Light({ place, 0.0 }), std::vector<float>(33 * 33, 0.0f));
  // Per solid angle, the light tends to that of a point: two small radii have the same visible
  // part, except where the edge of the shadow lies between them.
  const std::vector<float> small = scene.Light({ place, 1e-3 });
  const std::vector<float> smaller = scene.Light({ place, 1e-6 });
  int differ = 0;
  for (std::size_t post = 0; post < small.size(); ++post)
  {
    differ += std::abs(small[post] - 1e6f * smaller[post]) > 1e-3f * small[post] ? 1 : 0;
  }
  EXPECT_LE(differ, 3);
}

TEST(LampExtremes, FarAwayItIsTheSun)
{
  // A lamp of one degree at increasing distance, compared with the sun accumulator over exact
  // horizons.
  const oracle::OracleField hills = Hills();
  const LampScene scene(hills);
  const double azimuth = 0.9, elevation = 0.2, radius = 0.01;
  std::vector<float> lit(33 * 33);
  PostBuffer buffer;
  buffer.Values = lit.data();
  SunAccumulator sun(33, 33, SunDisc{ azimuth, elevation, radius }, buffer);
  const auto method = MakeHorizonMethod(scene.Field, HorizonSettings());
  for (const double a : SunAzimuths(azimuth, azimuth, elevation, elevation, radius))
  {
    const std::vector<float> slopes = Slopes(*method, scene.Posts, a * DegreesPerRadian);
    sun.Begin(a, 0.0);
    for (std::ptrdiff_t row = 0; row < 33; ++row)
    {
      sun.Add(row, 0, 33, slopes.data() + row * 33);
    }
  }
  sun.Finish(0, 33);
  const oracle::Vector3 d{ std::cos(elevation) * std::sin(azimuth),
    std::cos(elevation) * std::cos(azimuth), std::sin(elevation) };
  double before = 1.0;
  for (const double distance : { 1e4, 1e6, 1e9, 1e12 })
  {
    const std::vector<float> light = scene.Light({ distance * d, distance * std::sin(radius) });
    double squares = 0.0;
    int count = 0;
    for (std::ptrdiff_t k = 0; k < 33 * 33; ++k)
    {
      const oracle::Vector3 normal = scene.Normal(k % 33, k / 33);
      const auto post = static_cast<std::size_t>(k);
      const double whole =
        DiscIrradiance({ std::sin(radius), std::cos(radius) }, oracle::Dot(normal, d));
      if (oracle::Dot(normal, d) > 0.05)
      {
        const double difference = light[post] / whole - lit[post];
        squares += difference * difference;
        ++count;
      }
    }
    const double rms = std::sqrt(squares / count);
    std::printf("lamp at %.0e m against the sun: rms %.5f of the unshadowed\n", distance, rms);
    EXPECT_LE(rms, before + 1e-6);
    before = rms;
  }
  // The azimuths of the sun have greater errors than the planes of the lamp.
  EXPECT_LT(before, 0.01);
}

TEST(LampExtremes, TheBodySinksUnderLampAndTerrain)
{
  // Seen from one post, curvature has the effect of a field and a lamp that are lowered by c d^2.
  oracle::OracleField round = Hills();
  round.CurvatureDrop = 1.0e-3; // a body of 500 m
  oracle::OracleField lowered = round;
  lowered.CurvatureDrop = 0.0;
  const std::ptrdiff_t i0 = 9, j0 = 13;
  for (std::ptrdiff_t j = 0; j < 33; ++j)
  {
    for (std::ptrdiff_t i = 0; i < 33; ++i)
    {
      const double dx = 10.0 * static_cast<double>(i - i0), dy = 10.0 * static_cast<double>(j - j0);
      lowered.At(i, j) -= round.CurvatureDrop * (dx * dx + dy * dy);
    }
  }
  const LampScene a(round), b(lowered);
  oracle::Ball ball{ { 230.0, 215.0, 95.0 }, 25.0 };
  const double found = a.Light(ball, true)[round.Index(i0, j0)];
  const double dx = 230.0 - 90.0, dy = 215.0 - 130.0;
  ball.Centre.Z -= round.CurvatureDrop * (dx * dx + dy * dy);
  const double truth = b.Light(ball, true)[round.Index(i0, j0)];
  EXPECT_GT(truth, 0.0);
  // Inside a cell the parabola lies c cell^2 / 4 = 0.025 m above its chord.
  EXPECT_NEAR(found, truth, 0.01 * truth);
}

TEST(LampExtremes, MissingPosts)
{
  oracle::OracleField holes = Hills();
  shapes::RemoveIslands(holes, 6, 3, 2);
  const LampScene scene(holes);
  const oracle::Ball ball{ { 163.0, 161.0, 90.0 }, 12.0 };
  const std::vector<float> light = scene.Light(ball);
  const LampScene full(Hills());
  const std::vector<float> before = full.Light(ball, true), after = scene.Light(ball, true);
  for (std::size_t post = 0; post < light.size(); ++post)
  {
    EXPECT_EQ(std::isnan(light[post]), !std::isfinite(holes.Heights[post])) << post;
    if (std::isfinite(holes.Heights[post]))
    {
      // With less terrain there is no more shadow, except for the rounding of floats relative to
      // two different bases.
      EXPECT_GE(after[post], before[post] * (1.0f - 0.005f) - 1e-5f) << post;
    }
  }
  // A field of missing posts only, and the smallest field.
  oracle::OracleField none(5, 4, 1.0, 1.0);
  for (double& height : none.Heights)
  {
    height = std::numeric_limits<double>::quiet_NaN();
  }
  none.At(2, 2) = 1.0; // a post without a surface is a receiver nevertheless
  const LampScene lonely(none);
  const oracle::Ball over{ { 2.0, 2.0, 4.0 }, 1.0 };
  const std::vector<float> single = lonely.Light(over, true);
  EXPECT_NEAR(single[none.Index(2, 2)], Pi / 9.0, 1e-6);
  EXPECT_TRUE(std::isnan(single[0]));
  const LampScene tiny(shapes::Plane(2, 2, 1.0, 0.0, 0.0));
  EXPECT_NEAR(tiny.Light({ { 0.0, 0.0, 3.0 }, 1.0 })[0], Pi / 9.0, 1e-6);
}

TEST(LampExtremes, ScalesAndAspects)
{
  // Scaling the spacing, the heights and the lamp together changes nothing. Here posts are 1000
  // times longer than wide.
  const oracle::OracleField hills = Hills();
  const std::vector<float> truth = LampScene(hills).Light({ { 163.0, 161.0, 90.0 }, 12.0 });
  for (const double scale : { 1e-6, 1e6 })
  {
    oracle::OracleField scaled = hills;
    scaled.SpacingX *= scale;
    scaled.SpacingY *= scale;
    for (double& height : scaled.Heights)
    {
      height *= scale;
    }
    const std::vector<float> light =
      LampScene(scaled).Light({ { 163.0 * scale, 161.0 * scale, 90.0 * scale }, 12.0 * scale });
    for (std::size_t post = 0; post < light.size(); ++post)
    {
      EXPECT_NEAR(light[post], truth[post], 1e-4 * truth[post] + 1e-6) << scale << " " << post;
    }
  }
  oracle::OracleField flat = hills;
  flat.SpacingY *= 1000.0;
  for (const float light : LampScene(flat).Light({ { 163.0, 161000.0, 90.0 }, 12.0 }))
  {
    EXPECT_TRUE(light >= 0.0f && light <= static_cast<float>(Pi));
  }
}

TEST(LampExtremes, SpikesAndCliffs)
{
  for (const oracle::OracleField& field : { shapes::Spike(33, 33, 1.0, 1e4, 16, 16),
         shapes::Cliff(33, 33, 1.0, 1e6, 16), shapes::Cliff(33, 33, 1.0, 1e-6, 16) })
  {
    const LampScene scene(field);
    for (const double height : { 0.0, 1.0, 5e3, 1e6 })
    {
      for (const double radius : { 1e-3, 1.0, 1e3, 1e7 })
      {
        for (const float light : scene.Light({ { 16.0, 15.0, height }, radius }))
        {
          ASSERT_TRUE(light >= 0.0f && light <= 1.0001f * static_cast<float>(Pi))
            << height << " " << radius;
        }
      }
    }
  }
}

} // namespace
} // namespace testing
} // namespace skyline
