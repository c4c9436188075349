// SPDX-License-Identifier: BSD-3-Clause
// All methods, compared with the oracle, which evaluates each crossing in double precision by
// simple loops.
#include "Reference/OracleTerrain.h"

#include "hwy/targets.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace skyline
{
namespace testing
{
namespace
{

// Axes, diagonals, the direction of a knight's move, and both sides of each octant and of north.
const std::vector<double> Azimuths{ 0.0, 10.0, 26.565051177, 45.0, 50.0, 63.4, 90.0, 100.0, 135.0,
  140.0, 180.0, 200.0, 225.0, 250.0, 270.0, 290.0, 315.0, 333.0, 359.99 };

struct Scene
{
  const char* Name;
  std::function<oracle::OracleField()> Make;
};

oracle::OracleField Hills()
{
  return shapes::Fractal(97, 131, 30.0, 1500.0, 7);
}

oracle::OracleField WithHoles(
  oracle::OracleField field, std::ptrdiff_t count, std::ptrdiff_t radius)
{
  shapes::RemoveIslands(field, count, radius, 3);
  return field;
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
    { "TinySpacing", [] { return With(shapes::Fractal(40, 50, 1e-6, 1e-4, 2), [](auto&) {}); } },
    { "HugeSpacing", [] { return shapes::Fractal(40, 50, 1e6, 9000.0, 2); } },
    { "RoundBody",
      [] { return With(Hills(), [](auto& f) { f.CurvatureDrop = 0.87 / 2.0 / 6371000.0; }); } },
    { "SmallBody", [] { return With(Hills(), [](auto& f) { f.CurvatureDrop = 1.0e-6; }); } },
    { "Walls", [] { return shapes::RandomBoxes(120, 110, 1.0, 60, 9, 30.0, 3); } },
    { "Plane", [] { return shapes::Plane(90, 70, 1.0, 0.3, 0.2); } },
    { "Flat", [] { return shapes::Plane(64, 64, 30.0, 0.0, 0.0); } },
    { "Holes", [] { return WithHoles(Hills(), 12, 5); } },
    // Most walks are those of a whole field. Some begin or end beside the missing corners.
    { "RaggedEdge",
      []
      {
        return With(shapes::Fractal(131, 120, 30.0, 1500.0, 6),
          [](auto& f)
          {
            for (std::ptrdiff_t j = 0; j < f.Rows; ++j)
            {
              for (std::ptrdiff_t i = 0; i < f.Columns; ++i)
              {
                if (i + 2 * j < 50 || 2 * i + j > 330 || (i == 70 && j == 65))
                {
                  f.At(i, j) = std::nan("");
                }
              }
            }
          });
      } },
    { "SaltAndPepper", [] { return WithHoles(Hills(), 3000, 0); } },
    { "Prime", [] { return shapes::Fractal(53, 61, 10.0, 300.0, 5); } },
    { "TwoByTwo", [] { return shapes::Fractal(2, 2, 30.0, 100.0, 4); } },
    { "TwoByMany", [] { return shapes::Fractal(2, 150, 30.0, 400.0, 4); } },
    { "ManyByTwo", [] { return shapes::Fractal(150, 2, 30.0, 400.0, 4); } },
    { "Spike",
      [] {
        return With(shapes::Plane(70, 80, 1.0, 0.0, 0.0), [](auto& f) { f.At(33, 41) = 1.0e4; });
      } },
    { "Cliff",
      []
      {
        return With(shapes::Fractal(70, 80, 1.0, 3.0, 2),
          [](auto& f)
          {
            for (std::ptrdiff_t j = 0; j < f.Rows; ++j)
            {
              for (std::ptrdiff_t i = 40; i < f.Columns; ++i)
              {
                f.At(i, j) += 1.0e6;
              }
            }
          });
      } },
    { "Peak",
      []
      {
        return shapes::FromFunction(
          90, 90, 10.0, 10.0, 45, 45, [](double x, double y) { return -0.4 * std::hypot(x, y); });
      } },
  };
  return scenes;
}

class HorizonOfScene : public ::testing::TestWithParam<std::tuple<std::size_t, Surface>>
{
};

std::string SceneName(const ::testing::TestParamInfo<std::tuple<std::size_t, Surface>>& info)
{
  return std::string(Scenes()[std::get<0>(info.param)].Name) +
    (std::get<1>(info.param) == Surface::Bilinear ? "Bilinear" : "Triangles");
}

TEST_P(HorizonOfScene, ExactEqualsTheOracleAndFastIsCertified)
{
  oracle::OracleField field = Scenes()[std::get<0>(GetParam())].Make();
  field.Through = std::get<1>(GetParam());
  const HeightField posts = FieldOf(field);
  HorizonSettings settings;
  settings.Shape = field.Through;
  settings.CurvatureDrop = field.CurvatureDrop;
  const auto exact = MakeHorizonMethod(posts, settings);
  settings.Method = HorizonMethodKind::Fast;
  const auto fast = MakeHorizonMethod(posts, settings);
  const double rounding = RoundingBound(field);
  const double certified = FastTolerance * DegreesPerRadian + rounding;
  for (const double azimuth : Azimuths)
  {
    const std::vector<double> truth = oracle::HorizonSlopes(field, azimuth);
    const std::vector<float> found = Slopes(*exact, GridOf(field), azimuth);
    const std::vector<float> quick = Slopes(*fast, GridOf(field), azimuth);
    double worst = 0.0;
    for (std::size_t post = 0; post < truth.size(); ++post)
    {
      if (std::isnan(truth[post]))
      {
        continue;
      }
      const double right = oracle::ElevationDegrees(truth[post]);
      worst = std::max(worst, std::abs(Elevation(found[post]) - right));
      ASSERT_LE(Elevation(quick[post]), right + rounding) << "azimuth " << azimuth;
      ASSERT_GE(Elevation(quick[post]), right - certified) << "azimuth " << azimuth;
    }
    EXPECT_LE(worst, rounding) << "azimuth " << azimuth;
  }
}

INSTANTIATE_TEST_SUITE_P(All, HorizonOfScene,
  ::testing::Combine(
    ::testing::Range<std::size_t>(0, 20), ::testing::Values(Surface::Triangles, Surface::Bilinear)),
  SceneName);

TEST(HorizonScenes, AreAllRun)
{
  EXPECT_EQ(Scenes().size(), 20u);
}

// All instruction sets of this processor find the same horizons, except for the fused multiply-add,
// which the oldest ones lack.
TEST(HorizonTargets, Agree)
{
  const oracle::OracleField field = WithHoles(Hills(), 4, 3);
  const oracle::OracleField whole = Hills();
  const std::int64_t supported = hwy::SupportedTargets();
  ASSERT_NE(supported, 0);
  for (const oracle::OracleField* scene : { &field, &whole })
  {
    const HeightField posts = FieldOf(*scene);
    const auto method = MakeHorizonMethod(posts, HorizonSettings());
    std::vector<float> first;
    for (std::int64_t rest = supported; rest != 0; rest &= rest - 1)
    {
      hwy::SetSupportedTargetsForTest(rest & -rest);
      hwy::GetChosenTarget().Update(hwy::SupportedTargets());
      const std::vector<float> slopes = Slopes(*method, GridOf(*scene), 37.0);
      if (first.empty())
      {
        first = slopes;
      }
      for (std::size_t post = 0; post < slopes.size(); ++post)
      {
        ASSERT_NEAR(Elevation(slopes[post]), Elevation(first[post]), RoundingBound(*scene))
          << hwy::TargetName(rest & -rest);
      }
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
}

// Blocks of receivers are as wide as the vectors, so a tolerance does not skip the same terrain in
// all of them.
TEST(HorizonTargets, DifferByTheToleranceOfFast)
{
  constexpr double FastTolerance = 0.25; // degrees
  const oracle::OracleField field = shapes::Fractal(129, 129, 30.0, 1500.0, 11, 0.5);
  const HeightField posts = FieldOf(field);
  HorizonSettings settings;
  settings.Method = HorizonMethodKind::Fast;
  const auto method = MakeHorizonMethod(posts, settings);
  std::vector<float> first;
  double worst = 0.0;
  for (std::int64_t rest = hwy::SupportedTargets(); rest != 0; rest &= rest - 1)
  {
    hwy::SetSupportedTargetsForTest(rest & -rest);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    const std::vector<float> slopes = Slopes(*method, GridOf(field), 37.0);
    hwy::SetSupportedTargetsForTest(0);
    if (first.empty())
    {
      first = slopes;
    }
    for (std::size_t post = 0; post < slopes.size(); ++post)
    {
      worst = std::max(
        worst, static_cast<double>(std::abs(Elevation(slopes[post]) - Elevation(first[post]))));
    }
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  RecordProperty("worst_degrees", std::to_string(worst));
  EXPECT_LE(worst, FastTolerance + RoundingBound(field));
}

TEST(HorizonTolerance, CertifiesEveryError)
{
  const oracle::OracleField field = Hills();
  const HeightField posts = FieldOf(field);
  for (const double degrees : { 0.01, 0.1, 1.0, 10.0 })
  {
    HorizonSettings settings;
    settings.Tolerance = degrees * RadiansPerDegree;
    const auto method = MakeHorizonMethod(posts, settings);
    for (const double azimuth : { 20.0, 110.0, 225.0 })
    {
      const std::vector<double> truth = oracle::HorizonSlopes(field, azimuth);
      const std::vector<float> found = Slopes(*method, GridOf(field), azimuth);
      for (std::size_t post = 0; post < truth.size(); ++post)
      {
        const double error = Elevation(found[post]) - oracle::ElevationDegrees(truth[post]);
        ASSERT_LE(error, RoundingBound(field));
        ASSERT_GE(error, -degrees - RoundingBound(field));
      }
    }
  }
}

// The bounds of the method on terrain.
TEST(HorizonFast, KeepsItsStatedErrorOnTerrain)
{
  constexpr double rmseBound = 0.03;
  constexpr double percentileBound = 0.3;
  for (const double roughness : { 0.45, 0.5, 0.55, 0.6 })
  {
    const oracle::OracleField field = shapes::Fractal(257, 257, 30.0, 1500.0, 11, roughness);
    const HeightField posts = FieldOf(field);
    HorizonSettings settings;
    const auto exact = MakeHorizonMethod(posts, settings);
    settings.Method = HorizonMethodKind::Fast;
    const auto fast = MakeHorizonMethod(posts, settings);
    std::vector<double> errors;
    double squares = 0.0;
    for (const double azimuth : { 15.0, 75.0, 160.0, 215.0, 300.0 })
    {
      const std::vector<float> truth = Slopes(*exact, GridOf(field), azimuth);
      const std::vector<float> found = Slopes(*fast, GridOf(field), azimuth);
      for (std::size_t post = 0; post < truth.size(); ++post)
      {
        errors.push_back(std::abs(Elevation(found[post]) - Elevation(truth[post])));
        squares += errors.back() * errors.back();
      }
    }
    const auto rank = static_cast<std::ptrdiff_t>(0.999 * static_cast<double>(errors.size()));
    std::nth_element(errors.begin(), errors.begin() + rank, errors.end());
    EXPECT_LT(std::sqrt(squares / static_cast<double>(errors.size())), rmseBound);
    EXPECT_LT(errors[static_cast<std::size_t>(rank)], percentileBound);
  }
}

// Along the axes the samples of the sweep are the posts, so the result is exact for any spacing.
TEST(HorizonSweep, IsExactAlongTheAxes)
{
  for (const double aspect : { 1.0, 0.3, 1000.0 })
  {
    oracle::OracleField field = shapes::Fractal(53, 61, 30.0, 1200.0, 21);
    field.SpacingX *= aspect;
    field.CurvatureDrop = aspect == 1.0 ? 0.0 : 1.0e-6;
    const HeightField posts = FieldOf(field);
    HorizonSettings settings;
    settings.Method = HorizonMethodKind::Sweep;
    settings.CurvatureDrop = field.CurvatureDrop;
    const auto sweep = MakeHorizonMethod(posts, settings);
    for (const double azimuth : { 0.0, 90.0, 180.0, 270.0 })
    {
      const std::vector<double> truth = oracle::HorizonSlopes(field, azimuth);
      const std::vector<float> found = Slopes(*sweep, GridOf(field), azimuth);
      for (std::size_t post = 0; post < truth.size(); ++post)
      {
        ASSERT_NEAR(
          Elevation(found[post]), oracle::ElevationDegrees(truth[post]), RoundingBound(field));
      }
    }
  }
}

// Posts that are 1000 times longer than wide need as many samples as square ones, not a million
// times as many.
TEST(HorizonSweep, SamplesDoNotGrowWithTheAspect)
{
  oracle::OracleField field = Hills();
  field.SpacingY *= 1000.0;
  const HeightField posts = FieldOf(field);
  HorizonSettings settings;
  settings.Method = HorizonMethodKind::Sweep;
  const auto sweep = MakeHorizonMethod(posts, settings);
  for (const double azimuth : { 0.0, 45.0, 89.97, 90.0 })
  {
    sweep->SetAzimuth(GridOf(field), azimuth * RadiansPerDegree);
    EXPECT_LE(sweep->PrepareCount(), field.Columns + field.Rows) << azimuth;
  }
}

// On a plane the horizon of each sample is the slope of the plane, and resampling keeps it, in any
// azimuth.
TEST(HorizonSweep, KeepsAPlane)
{
  const oracle::OracleField field = shapes::Plane(60, 80, 5.0, 0.3, -0.2);
  const HeightField posts = FieldOf(field);
  HorizonSettings settings;
  settings.Method = HorizonMethodKind::Sweep;
  const auto sweep = MakeHorizonMethod(posts, settings);
  for (const double azimuth : { 20.0, 77.0, 140.0, 290.0 })
  {
    const Direction direction = DirectionOfAzimuth(azimuth * RadiansPerDegree);
    const double slope = 0.3 * direction.East - 0.2 * direction.North;
    const std::vector<float> found = Slopes(*sweep, GridOf(field), azimuth);
    for (std::ptrdiff_t row = 2; row < field.Rows - 2; ++row)
    {
      for (std::ptrdiff_t column = 2; column < field.Columns - 2; ++column)
      {
        ASSERT_NEAR(found[static_cast<std::size_t>(row * field.Columns + column)], slope, 1e-4);
      }
    }
  }
}

TEST(HorizonSettingsCheck, RefusesWhatAMethodDoesNotKnow)
{
  const HeightField posts = FieldOf(Hills());
  HorizonSettings settings;
  settings.Tolerance = -1.0;
  EXPECT_THROW(MakeHorizonMethod(posts, settings), std::invalid_argument);
  settings.Tolerance = 0.0;
  settings.Shape = Surface::Bilinear;
  settings.Method = HorizonMethodKind::Sweep;
  EXPECT_THROW(MakeHorizonMethod(posts, settings), std::invalid_argument);
}

} // namespace
} // namespace testing
} // namespace skyline
