// SPDX-License-Identifier: BSD-3-Clause
// Lamps with shadows, compared with rays that are tested against the triangles: 1e5 rays per post,
// a few dozen posts in all.
#include "Reference/LampScene.h"

#include <gtest/gtest.h>

namespace skyline
{
namespace testing
{
namespace
{

/// 1 % of the irradiance that the post would get without terrain. The error of the rays is 0.05 %
/// (they are stratified; from 1e4 to 1e5 rays per post, the greatest difference fell from 1.6 % to
/// 0.3 %). The error of the planes is 0.2 % (32 planes with bisection).
constexpr double MonteCarloBound = 0.01;

/// The root mean square over all posts of a scene.
constexpr double MonteCarloRms = 0.002;

constexpr int RaysPerSide = 316; // 1e5 rays

struct Scene
{
  const char* Name;
  oracle::OracleField Field;
  oracle::Ball Ball;
  std::ptrdiff_t Step; ///< posts from a receiver to the next
};

std::vector<Scene> Scenes()
{
  const oracle::OracleField hills = shapes::Fractal(41, 41, 10.0, 120.0, 3);
  const oracle::OracleField houses = shapes::RandomBoxes(41, 41, 10.0, 50, 7, 80.0, 5);
  const oracle::OracleField tray = shapes::EggTray(41, 41, 10.0, 30.0, 160.0);
  const oracle::OracleField spike = shapes::Spike(41, 41, 10.0, 100.0, 20, 20);
  const oracle::OracleField wall = shapes::Wall(41, 41, 10.0, 60.0, 20, 2);
  const double ground = hills.At(17, 22);
  return {
    { "over hills", hills, { { 210.0, 190.0, 200.0 }, 25.0 }, 11 },
    { "low over hills", hills, { { 170.0, 220.0, ground + 12.0 }, 8.0 }, 8 },
    { "half in the ground", hills, { { 173.0, 222.0, ground }, 15.0 }, 8 },
    { "huge", hills, { { 203.0, 262.0, 450.0 }, 320.0 }, 11 },
    { "beside the data", hills, { { 600.0, 250.0, 60.0 }, 60.0 }, 11 },
    { "in a street", houses, { { 203.0, 211.0, 12.0 }, 10.0 }, 8 },
    { "huge over houses", houses, { { 203.0, 211.0, 150.0 }, 120.0 }, 8 },
    { "over an egg tray", tray, { { 200.0, 200.0, 40.0 }, 12.0 }, 8 },
    { "a spike through the lamp", spike, { { 202.0, 201.0, 50.0 }, 30.0 }, 11 },
    { "a wall through the lamp", wall, { { 202.0, 201.0, 40.0 }, 30.0 }, 11 },
  };
}

TEST(LampIrradiance, IsThatOfRays)
{
  int posts = 0, partly = 0;
  for (const Scene& scene : Scenes())
  {
    const LampScene kernel(scene.Field);
    const std::vector<float> light = kernel.Light(scene.Ball);
    double squares = 0.0;
    int count = 0;
    for (std::ptrdiff_t j = 2; j < scene.Field.Rows; j += scene.Step)
    {
      for (std::ptrdiff_t i = 3; i < scene.Field.Columns; i += scene.Step)
      {
        const double whole = kernel.Unshadowed(scene.Ball, i, j);
        const oracle::Vector3 to = scene.Ball.Centre - oracle::PlaceOf(scene.Field, i, j);
        if (whole <= 0.0 || oracle::Dot(to, to) <= scene.Ball.Radius * scene.Ball.Radius)
        {
          continue;
        }
        const std::size_t post = scene.Field.Index(i, j);
        const double rays = oracle::BallIrradiance(
          scene.Field, i, j, kernel.Normal(i, j), scene.Ball, RaysPerSide, true, post);
        EXPECT_NEAR(light[post] / whole, rays / whole, MonteCarloBound)
          << scene.Name << ", post " << i << " " << j;
        squares += (light[post] - rays) * (light[post] - rays) / (whole * whole);
        ++count;
        partly += rays > 0.01 * whole && rays < 0.99 * whole ? 1 : 0;
      }
    }
    ASSERT_GT(count, 0) << scene.Name;
    const double rms = std::sqrt(squares / count);
    EXPECT_LT(rms, MonteCarloRms) << scene.Name;
    std::printf("%-26s %3d posts, rms %.5f of the unshadowed\n", scene.Name, count, rms);
    posts += count;
  }
  EXPECT_GT(posts, 36);
  EXPECT_GT(partly, 24);
}

TEST(LampIrradiance, UnshadowedIsTheClosedForm)
{
  // A dome: each post sees above all others, and for many posts a part of the lamp lies below their
  // plane.
  const oracle::OracleField dome = shapes::Paraboloid(33, 33, 10.0, -0.002);
  const LampScene scene(dome);
  for (const double height : { 5.0, 40.0, 300.0 })
  {
    const oracle::Ball ball{ { 251.0, 180.0, height }, 0.8 * height };
    const std::vector<float> light = scene.Light(ball);
    // All points above the convex ground lie above the plane of each post, except for the facets at
    // the post, which differ from the plane by the curvature over one cell.
    for (std::ptrdiff_t j = 1; j < 32; ++j)
    {
      for (std::ptrdiff_t i = 1; i < 32; ++i)
      {
        const double whole = scene.Unshadowed(ball, i, j);
        EXPECT_NEAR(light[dome.Index(i, j)], whole, 0.02 * whole + 1e-6) << height << " " << i;
      }
    }
  }
  // On level ground the facets lie in the plane, and there is no difference.
  const oracle::OracleField plain = shapes::Plane(17, 17, 10.0, 0.0, 0.0);
  const LampScene level(plain);
  const oracle::Ball ball{ { 81.0, 77.0, 20.0 }, 19.0 };
  const std::vector<float> light = level.Light(ball);
  for (std::ptrdiff_t j = 0; j < 17; ++j)
  {
    for (std::ptrdiff_t i = 0; i < 17; ++i)
    {
      const double whole = level.Unshadowed(ball, i, j);
      EXPECT_NEAR(light[plain.Index(i, j)], whole, 1e-6 * whole) << i << " " << j;
    }
  }
}

/// Divides each cell of a bilinear surface into fine x fine cells of triangles.
oracle::OracleField Cut(const oracle::OracleField& coarse, std::ptrdiff_t fine)
{
  const std::ptrdiff_t columns = coarse.Columns - 1, rows = coarse.Rows - 1;
  oracle::OracleField cut(columns * fine + 1, rows * fine + 1,
    coarse.SpacingX / static_cast<double>(fine), coarse.SpacingY / static_cast<double>(fine));
  for (std::ptrdiff_t j = 0; j < cut.Rows; ++j)
  {
    for (std::ptrdiff_t i = 0; i < cut.Columns; ++i)
    {
      const std::ptrdiff_t c = std::min(i / fine, columns - 1), r = std::min(j / fine, rows - 1);
      const double f = static_cast<double>(i - c * fine) / static_cast<double>(fine);
      const double g = static_cast<double>(j - r * fine) / static_cast<double>(fine);
      cut.At(i, j) = (1.0 - g) * ((1.0 - f) * coarse.At(c, r) + f * coarse.At(c + 1, r)) +
        g * ((1.0 - f) * coarse.At(c, r + 1) + f * coarse.At(c + 1, r + 1));
    }
  }
  return cut;
}

TEST(LampIrradiance, BilinearIsTheLimitOfTriangles)
{
  // At its post, a bilinear patch curves away from the first triangle. The error is proportional to
  // the size of the triangles, so two sizes give the limit.
  oracle::OracleField coarse = shapes::Fractal(17, 17, 16.0, 60.0, 9);
  coarse.Through = Surface::Bilinear;
  const oracle::OracleField eighths = Cut(coarse, 8), sixteenths = Cut(coarse, 16);
  const LampScene patches(coarse), large(eighths), small(sixteenths);
  for (const oracle::Ball& ball : { oracle::Ball{ { 130.0, 120.0, 75.0 }, 20.0 },
         oracle::Ball{ { 100.0, 140.0, coarse.At(6, 9) }, 12.0 } })
  {
    const std::vector<float> found = patches.Light(ball, true);
    const std::vector<float> a = large.Light(ball, true), b = small.Light(ball, true);
    for (std::ptrdiff_t j = 0; j < 17; ++j)
    {
      for (std::ptrdiff_t i = 0; i < 17; ++i)
      {
        const oracle::Vector3 to = ball.Centre - oracle::PlaceOf(coarse, i, j);
        const double distance = std::sqrt(oracle::Dot(to, to));
        const double whole = DiscIrradiance(DiscOfLamp(ball.Radius, distance), to.Z / distance);
        const double limit =
          2.0 * b[sixteenths.Index(16 * i, 16 * j)] - a[eighths.Index(8 * i, 8 * j)];
        EXPECT_NEAR(found[coarse.Index(i, j)], limit, 0.015 * whole + 1e-5) << i << " " << j;
      }
    }
  }
}

TEST(LampIrradiance, RangesAndLampsAddUp)
{
  const oracle::OracleField hills = shapes::Fractal(33, 33, 10.0, 100.0, 4);
  const LampScene scene(hills);
  Lamp lamp;
  lamp.X = 120.0;
  lamp.Y = 170.0;
  lamp.Z = 60.0;
  lamp.Radius = 15.0;
  lamp.Radiance = { 1.0f, 0.5f, 0.0f };
  std::vector<float> whole(3 * 33 * 33, 2.0f), parts(3 * 33 * 33, 2.0f);
  const auto add = [&](std::ptrdiff_t begin, std::ptrdiff_t end, std::vector<float>& rgb)
  {
    AddLampIrradiance(scene.Terrain, scene.Posts, scene.East.data(), scene.North.data(), lamp,
      scene.Settings, begin, end, rgb.data());
  };
  add(0, 33, whole);
  for (std::ptrdiff_t row = 32; row >= 0; --row)
  {
    add(row, row + 1, parts);
  }
  EXPECT_EQ(whole, parts); // the same bits for any ranges
  for (std::size_t post = 0; post < 33 * 33; ++post)
  {
    EXPECT_NEAR(whole[3 * post + 1] - 2.0f, 0.5f * (whole[3 * post] - 2.0f), 1e-6);
    EXPECT_EQ(whole[3 * post + 2], 2.0f);
  }
}

TEST(LampIrradiance, OnlyTheSwathIsWalked)
{
  const oracle::OracleField hills = shapes::Fractal(33, 33, 10.0, 100.0, 4);
  const LampScene scene(hills);
  Lamp lamp;
  lamp.X = lamp.Y = 165.0; // between posts, so not over any of them
  std::vector<float> rgb(3 * 33 * 33, 0.0f);
  const auto work = [&](double z, double radius)
  {
    lamp.Z = z;
    lamp.Radius = radius;
    LampWork done;
    AddLampIrradiance(scene.Terrain, scene.Posts, scene.East.data(), scene.North.data(), lamp,
      scene.Settings, 0, 33, rgb.data(), done);
    return done;
  };
  EXPECT_EQ(work(60.0, 0.0).Posts, 0); // without light there is no work
  EXPECT_EQ(work(60.0, 0.0).Planes, 0);
  const LampWork high = work(5000.0, 4.0);
  EXPECT_GT(high.Posts, 1000);
  EXPECT_EQ(high.Planes, 0); // no terrain is that high, so no plane is searched
  const LampWork low = work(10.0, 4.0);
  EXPECT_GT(low.Planes, 0);
  EXPECT_LT(low.Posts, 33 * 33); // posts that face away are skipped
}

} // namespace
} // namespace testing
} // namespace skyline
