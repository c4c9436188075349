// SPDX-License-Identifier: BSD-3-Clause
// Shadow heights compared with the oracle, with all instruction sets of the processor.
#include "ShadowTesting.h"
#include "Testing/Module/ProcessorTargets.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

// Axes and diagonals, and both sides of them in all octants.
const std::vector<double> Azimuths{ 0.0, 17.0, 45.0, 62.0, 90.0, 101.0, 135.0, 158.0, 180.0, 203.0,
  225.0, 250.0, 270.0, 284.0, 315.0, 341.0 };

struct Scene
{
  const char* Name;
  std::function<oracle::OracleField()> Make;
};

oracle::OracleField Hills()
{
  return shapes::Fractal(67, 83, 30.0, 900.0, 7);
}

oracle::OracleField With(
  oracle::OracleField field, const std::function<void(oracle::OracleField&)>& change)
{
  change(field);
  return field;
}

const std::vector<Scene>& Scenes()
{
  static const std::vector<Scene> scenes{
    { "Hills", Hills },
    { "Anisotropic", [] { return With(Hills(), [](auto& f) { f.SpacingX = 7.0; }); } },
    { "ThousandToOne", [] { return With(Hills(), [](auto& f) { f.SpacingY = 30000.0; }); } },
    { "TinySpacing", [] { return shapes::Fractal(40, 50, 1e-6, 1e-4, 2); } },
    { "HugeSpacing", [] { return shapes::Fractal(40, 50, 1e6, 9000.0, 2); } },
    { "RoundBody",
      [] { return With(Hills(), [](auto& f) { f.CurvatureDrop = 0.87 / 2.0 / 6371000.0; }); } },
    { "SmallBody", [] { return With(Hills(), [](auto& f) { f.CurvatureDrop = 1.0e-5; }); } },
    { "Walls", [] { return shapes::RandomBoxes(70, 60, 1.0, 20, 9, 30.0, 3); } },
    { "Plane", [] { return shapes::Plane(60, 50, 1.0, 0.3, 0.2); } },
    { "Flat", [] { return shapes::Plane(64, 64, 30.0, 0.0, 0.0); } },
    { "Spike", [] { return shapes::Spike(61, 61, 1.0, 1.0e4, 30, 28); } },
    { "Cliff", [] { return shapes::Cliff(50, 40, 1.0, 1.0e6, 25); } },
    { "FarUp",
      []
      {
        return With(Hills(),
          [](auto& f)
          {
            for (double& height : f.Heights)
            {
              height += 1.0e7;
            }
          });
      } },
    { "Holes", [] { return With(Hills(), [](auto& f) { shapes::RemoveIslands(f, 12, 5, 3); }); } },
    { "ManyHoles",
      [] { return With(Hills(), [](auto& f) { shapes::RemoveIslands(f, 700, 1, 4); }); } },
    { "TwoByTwo", [] { return shapes::Plane(2, 2, 1.0, 0.5, 0.2); } },
    { "TwoByMany", [] { return shapes::Fractal(2, 301, 10.0, 200.0, 5); } },
    { "ManyByTwo", [] { return shapes::Fractal(301, 2, 10.0, 200.0, 5); } },
  };
  return scenes;
}

class ShadowHeightOfScene : public ::testing::TestWithParam<Scene>
{
};

struct Sample
{
  double Elevation, Azimuth; // degrees
  std::size_t Post;
  double Expected; // metres
};

// 67 posts for each direction, other ones each time. Elevations from the horizontal plane to the
// zenith.
std::vector<Sample> SamplesOf(oracle::OracleField& field)
{
  std::vector<Sample> samples;
  std::size_t next = 0;
  for (const double elevation : { 0.0, 1.0, 15.0, 60.0, 89.0 })
  {
    for (const double azimuth : Azimuths)
    {
      for (int k = 0; k < 67; ++k, next += 8191)
      {
        const std::size_t post = next % field.Heights.size();
        const auto column = static_cast<std::ptrdiff_t>(post) % field.Columns;
        const auto row = static_cast<std::ptrdiff_t>(post) / field.Columns;
        if (field.HasPost(column, row))
        {
          const double slope = ShadowSlope(elevation * RadiansPerDegree);
          samples.push_back(
            { elevation, azimuth, post, ShadowHeightOf(field, column, row, azimuth, slope) });
        }
      }
    }
  }
  return samples;
}

TEST_P(ShadowHeightOfScene, IsThatOfTheOracle)
{
  oracle::OracleField field = GetParam().Make();
  const HeightField posts = FieldOf(field);
  const double base = BaseOf(field);
  const std::vector<Sample> samples = SamplesOf(field);
  ForEachProcessorTarget(
    [&]()
    {
      double elevation = -1.0, azimuth = -1.0;
      std::vector<float> shadows;
      for (const Sample& sample : samples)
      {
        if (sample.Elevation != elevation || sample.Azimuth != azimuth)
        {
          elevation = sample.Elevation;
          azimuth = sample.Azimuth;
          ShadowHeightExact method(
            posts, ShadowSlope(elevation * RadiansPerDegree), field.CurvatureDrop);
          shadows = Slopes(method, GridOf(field), azimuth);
        }
        const float shadow = shadows[sample.Post];
        if (std::isinf(sample.Expected))
        {
          ASSERT_EQ(shadow, NoShadow) << azimuth << ": " << sample.Post;
          continue;
        }
        ASSERT_NEAR(shadow + base, sample.Expected, HeightBound(field, sample.Expected))
          << azimuth << ", " << elevation << ": " << sample.Post;
      }
    });
}

INSTANTIATE_TEST_SUITE_P(Every, ShadowHeightOfScene, ::testing::ValuesIn(Scenes()),
  [](const auto& scene) { return std::string(scene.param.Name); });

// The bits are the same for all ranges of lines and lanes.
TEST(ShadowHeight, DoesNotDependOnTheRange)
{
  const oracle::OracleField field = shapes::Fractal(150, 140, 30.0, 1500.0, 3);
  const HeightField posts = FieldOf(field);
  ShadowHeightExact method(posts, 0.2, 0.0);
  for (const double azimuth : { 20.0, 200.0, 290.0 })
  {
    EXPECT_EQ(
      Slopes(method, GridOf(field), azimuth, 64), Slopes(method, GridOf(field), azimuth, 7));
  }
}

TEST(ShadowHeight, SlopeOfTheLight)
{
  EXPECT_EQ(ShadowSlope(-1.0), 0.0);
  EXPECT_EQ(ShadowSlope(0.0), 0.0);
  EXPECT_DOUBLE_EQ(ShadowSlope(0.25 * Pi), std::tan(0.25 * Pi));
  EXPECT_EQ(ShadowSlope(0.5 * Pi), ShadowSlope(HighestShadowLight));
}

// The shadow of a ridge with the height H, straight across the light, on a level plain: H - d
// tan(e).
TEST(ShadowHeight, OfARidge)
{
  oracle::OracleField field = shapes::Plane(301, 31, 2.0, 0.0, 0.0);
  for (std::ptrdiff_t row = 0; row < field.Rows; ++row)
  {
    field.At(300, row) = 100.0;
  }
  const HeightField posts = FieldOf(field);
  const double slope = ShadowSlope(20.0 * RadiansPerDegree);
  ShadowHeightExact method(posts, slope, 0.0);
  const std::vector<float> shadows = Slopes(method, GridOf(field), 90.0);
  for (std::ptrdiff_t column = 0; column < 300; ++column)
  {
    // Otherwise the plain beside the post casts the shadow, whose height is then negative.
    const double expected =
      std::max(100.0 - 2.0 * slope * static_cast<double>(300 - column), -2.0 * slope);
    EXPECT_NEAR(shadows[field.Index(column, 15)] + 50.0, expected, 1e-4) << column;
  }
  EXPECT_EQ(shadows[field.Index(300, 15)], NoShadow);
}

} // namespace
} // namespace testing
} // namespace skyline
