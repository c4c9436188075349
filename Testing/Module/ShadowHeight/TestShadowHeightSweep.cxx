// SPDX-License-Identifier: BSD-3-Clause
// The published recurrence, compared with itself in double precision and with the exact shadow.
#include "ShadowHeight/ShadowHeightSweep.h"
#include "ShadowTesting.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

constexpr double Tangent = 0.3;

// The pseudo code of Lee & Kim, section 4, in double precision: the outer loop runs over z, away
// from the light, the inner one over x, in any quadrant. If the light crosses columns faster than
// rows, x and z are exchanged.
std::vector<double> Published(const oracle::OracleField& field, double azimuth, double tangent)
{
  const oracle::Direction light = oracle::DirectionOfAzimuth(azimuth);
  double along = light.North / field.SpacingY, across = light.East / field.SpacingX;
  std::ptrdiff_t depth = field.Rows, width = field.Columns;
  const bool swapped = std::abs(across) > std::abs(along);
  if (swapped)
  {
    std::swap(along, across);
    std::swap(depth, width);
  }
  const double offset = std::abs(across / along);
  const double fall = tangent / std::abs(along);
  std::vector<double> shadow(field.Heights);
  const auto post = [&](std::ptrdiff_t x, std::ptrdiff_t z)
  {
    const std::ptrdiff_t i = across > 0.0 ? width - 1 - x : x; // x and z start at the light
    const std::ptrdiff_t j = along > 0.0 ? depth - 1 - z : z;
    return swapped ? field.Index(j, i) : field.Index(i, j);
  };
  for (std::ptrdiff_t z = 1; z < depth; ++z)
  {
    for (std::ptrdiff_t x = offset > 0.0 ? 1 : 0; x < width; ++x)
    {
      const double straight = shadow[post(x, z - 1)];
      const double aside = offset > 0.0 ? shadow[post(x - 1, z - 1)] : 0.0;
      const double cast = (1.0 - offset) * straight + offset * aside - fall;
      shadow[post(x, z)] = std::max(field.Heights[post(x, z)], cast);
    }
  }
  return shadow;
}

// The heights of both shadows, at least those of the ground.
std::vector<double> Shadows(HorizonMethod& method, const oracle::OracleField& field, double azimuth)
{
  const std::vector<float> cast = Slopes(method, GridOf(field), azimuth);
  const double base = BaseOf(field);
  std::vector<double> shadows(field.Heights);
  for (std::size_t post = 0; post < cast.size(); ++post)
  {
    shadows[post] = std::max(shadows[post], cast[post] + base);
  }
  return shadows;
}

// A rounding error of 2^-24 of the relief for each line that the recurrence crosses: 1500 m, 120
// lines.
constexpr double SweepBound = 1500.0 * 6e-8 * 120.0;

TEST(ShadowHeightSweep, IsAsPublishedInAllOctants)
{
  oracle::OracleField field = shapes::Fractal(97, 111, 30.0, 1500.0, 7);
  field.SpacingY = 21.0;
  const HeightField posts = FieldOf(field);
  ShadowHeightSweep method(posts, Tangent);
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += 15.0)
  {
    const std::vector<double> expected = Published(field, azimuth, Tangent);
    const std::vector<double> found = Shadows(method, field, azimuth);
    for (std::size_t post = 0; post < found.size(); ++post)
    {
      ASSERT_NEAR(found[post], expected[post], SweepBound) << azimuth << ": " << post;
    }
  }
}

// Rays that run from post to post meet no higher edge between them: along the axes, and along the
// diagonals of the cells.
TEST(ShadowHeightSweep, IsExactFromPostToPost)
{
  const oracle::OracleField field = shapes::Fractal(97, 111, 30.0, 1500.0, 7);
  const HeightField posts = FieldOf(field);
  ShadowHeightSweep published(posts, Tangent);
  ShadowHeightExact exact(posts, Tangent, 0.0);
  for (const double azimuth : { 0.0, 45.0, 90.0, 180.0, 225.0, 270.0 })
  {
    const std::vector<double> expected = Shadows(exact, field, azimuth);
    const std::vector<double> found = Shadows(published, field, azimuth);
    for (std::size_t post = 0; post < found.size(); ++post)
    {
      ASSERT_NEAR(found[post], expected[post], SweepBound) << azimuth << ": " << post;
    }
  }
}

// In other directions the interpolation lowers edges. The amount is measured and has no guaranteed
// bound. The test checks that shadows are not lost and that few are added.
TEST(ShadowHeightSweep, MissesByInterpolation)
{
  const oracle::OracleField field = shapes::Fractal(257, 257, 30.0, 1500.0, 7);
  const HeightField posts = FieldOf(field);
  ShadowHeightSweep published(posts, Tangent);
  ShadowHeightExact exact(posts, Tangent, 0.0);
  double square = 0.0, largest = 0.0, count = 0.0, differing = 0.0;
  for (const double azimuth : { 17.0, 70.0, 117.0, 160.0, 197.0, 250.0, 297.0, 340.0 })
  {
    const std::vector<double> expected = Shadows(exact, field, azimuth);
    const std::vector<double> found = Shadows(published, field, azimuth);
    for (std::size_t post = 0; post < found.size(); ++post)
    {
      const double miss = found[post] - expected[post];
      square += miss * miss;
      largest = std::max(largest, std::abs(miss));
      differing += (found[post] > field.Heights[post]) != (expected[post] > field.Heights[post]);
      count += 1.0;
    }
  }
  RecordProperty("rmse", std::to_string(std::sqrt(square / count)));
  RecordProperty("greatest", std::to_string(largest));
  RecordProperty("posts that differ", std::to_string(differing / count));
  EXPECT_LT(std::sqrt(square / count), 15.0); // half a spacing of 30 m
  EXPECT_LT(differing / count, 0.05);
}

// A field that is turned by 180 degrees has the same shadows if the light is turned too.
TEST(ShadowHeightSweep, TurnsWithTheLight)
{
  const oracle::OracleField field = shapes::Fractal(60, 71, 10.0, 300.0, 9);
  oracle::OracleField turned(field);
  std::reverse(turned.Heights.begin(), turned.Heights.end());
  const HeightField posts = FieldOf(field), turnedPosts = FieldOf(turned);
  ShadowHeightSweep one(posts, Tangent), other(turnedPosts, Tangent);
  for (const double azimuth : { 10.0, 80.0, 135.0 })
  {
    std::vector<float> back = Slopes(other, GridOf(turned), azimuth + 180.0);
    std::reverse(back.begin(), back.end());
    const std::vector<float> shadows = Slopes(one, GridOf(field), azimuth);
    for (std::size_t post = 0; post < back.size(); ++post)
    {
      ASSERT_NEAR(shadows[post], back[post], SweepBound) << azimuth << ": " << post;
    }
  }
}

TEST(ShadowHeightSweep, PassesOverMissingPosts)
{
  oracle::OracleField field = shapes::Plane(61, 31, 1.0, 0.0, 0.0);
  for (std::ptrdiff_t row = 0; row < field.Rows; ++row)
  {
    field.At(60, row) = 10.0;
    field.At(50, row) = std::nan("");
  }
  const HeightField posts = FieldOf(field);
  ShadowHeightSweep method(posts, 0.25);
  const std::vector<float> cast = Slopes(method, GridOf(field), 90.0);
  EXPECT_NEAR(cast[field.Index(40, 15)] + 5.0, 5.0, 1e-5);
}

} // namespace
} // namespace testing
} // namespace skyline
