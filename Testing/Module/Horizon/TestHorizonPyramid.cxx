// SPDX-License-Identifier: BSD-3-Clause
#include "Horizon/HorizonPyramid.h"

#include "Reference/OracleTerrain.h"
#include "Testing/Module/HeightField/SlowPyramid.h"
#include "Testing/Module/ProcessorTargets.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

namespace skyline
{
namespace testing
{
namespace
{

const std::vector<double> Azimuths{ 0.0, 10.0, 45.0, 63.4, 90.0, 100.0, 135.0, 180.0, 203.0, 270.0,
  359.99 };

HorizonSettings Settings(const PyramidSettings& pyramid, double drop = 0.0)
{
  HorizonSettings settings;
  settings.Method = HorizonMethodKind::Pyramid;
  settings.Pyramid = pyramid;
  settings.CurvatureDrop = drop;
  return settings;
}

/// Heights and weights are floats, in up to a hundred sums in a row: 1e-6 of the relief, seen at
/// the nearest caster, plus 2e-7 of the arc.
double Bound(const oracle::OracleField& field, const PyramidSettings& settings)
{
  const double relief = *std::max_element(field.Heights.begin(), field.Heights.end(),
                          [](double a, double b) { return !(a >= b) && !std::isnan(b); }) -
    BaseOf(field);
  return 2.0e-6 + 1.0e-6 * relief / (settings.Distance * std::min(field.SpacingX, field.SpacingY));
}

void ExpectSlow(const oracle::OracleField& field, const PyramidSettings& settings)
{
  const HeightField posts = FieldOf(field);
  const auto method = MakeHorizonMethod(posts, Settings(settings, field.CurvatureDrop));
  // The slow pyramid has no base height, so it is subtracted, as the fast one does.
  oracle::OracleField lowered = field;
  for (double& height : lowered.Heights)
  {
    height -= BaseOf(field);
  }
  const std::vector<SlowPlane> full = FullLevels(lowered, settings.LevelStep);
  double worst = 0.0;
  for (const double azimuth : Azimuths)
  {
    const std::vector<float> slopes = Slopes(*method, GridOf(field), azimuth, 7);
    for (std::ptrdiff_t row = 0; row < field.Rows; row += 3)
    {
      for (std::ptrdiff_t column = 0; column < field.Columns; ++column)
      {
        if (!field.PostOccludes(column, row))
        {
          continue;
        }
        const double truth = SlowHorizon(lowered, full, settings, column, row, azimuth);
        worst = std::max(worst, std::abs(std::atan(slopes[field.Index(column, row)]) - truth));
      }
    }
  }
  EXPECT_LT(worst, Bound(field, settings));
}

TEST(HorizonPyramid, EqualsTheSlowVersion)
{
  const oracle::OracleField hills = shapes::Fractal(61, 43, 30.0, 900.0, 7);
  ForEachProcessorTarget(
    [&]()
    {
      for (const double step : { 1.0, 1.5, 4.0 })
      {
        for (const double offset : { 0.0, 0.3, 2.0, 40.0 })
        {
          PyramidSettings settings;
          settings.LevelStep = step;
          settings.LevelOffset = offset;
          settings.Distance = offset == 0.3 ? 1.6 : 1.0;
          settings.Spline = offset != 2.0;
          SCOPED_TRACE(std::to_string(step) + " " + std::to_string(offset));
          ExpectSlow(hills, settings);
        }
      }
    });
}

TEST(HorizonPyramid, EqualsTheSlowVersionEverywhere)
{
  oracle::OracleField oblong = shapes::Fractal(47, 70, 30.0, 900.0, 3);
  oblong.SpacingX = 7.0;
  oracle::OracleField round = shapes::Fractal(50, 40, 5000.0, 900.0, 3);
  round.CurvatureDrop = 0.87 / 2.0 / 6371000.0;
  oracle::OracleField holes = shapes::Fractal(61, 43, 30.0, 900.0, 7);
  shapes::RemoveIslands(holes, 12, 5, 3);
  for (const oracle::OracleField& field :
    { oblong, round, holes, shapes::Fractal(2, 40, 10.0, 100.0), shapes::Fractal(2, 2, 10.0, 100.0),
      shapes::RandomBoxes(50, 60, 1.0, 30, 9, 20.0) })
  {
    ExpectSlow(field, PyramidSettings());
  }
}

TEST(HorizonPyramid, LevelGroundHasNoHorizon)
{
  const oracle::OracleField field = shapes::Plane(64, 64, 30.0, 0.0, 0.0);
  const HeightField posts = FieldOf(field);
  const auto method = MakeHorizonMethod(posts, Settings(PyramidSettings()));
  for (const double azimuth : Azimuths)
  {
    for (const float slope : Slopes(*method, GridOf(field), azimuth))
    {
      ASSERT_EQ(slope, 0.0f);
    }
  }
}

TEST(HorizonPyramid, FindsThePlanesOwnSlope)
{
  // Far from the edges, each level of a plane has the slope of the plane, and so has the spline of
  // the levels.
  const oracle::OracleField field = shapes::Plane(128, 128, 10.0, 0.4, 0.3);
  const HeightField posts = FieldOf(field);
  for (const bool spline : { false, true })
  {
    PyramidSettings settings;
    settings.Spline = spline;
    const auto method = MakeHorizonMethod(posts, Settings(settings));
    for (const double azimuth : Azimuths)
    {
      const oracle::Direction toward = oracle::DirectionOfAzimuth(azimuth);
      const double rise = std::max(0.0, 0.4 * toward.East + 0.3 * toward.North);
      EXPECT_NEAR(Slopes(*method, GridOf(field), azimuth)[64 * 128 + 64], rise, 2.0e-3) << azimuth;
    }
  }
}

// SN08, figure 10: if k and o grow together, the horizon converges to the true one.
TEST(HorizonPyramid, ConvergesToTheTruth)
{
  const oracle::OracleField field = shapes::EggTray(128, 128, 10.0, 60.0, 400.0);
  const HeightField posts = FieldOf(field);
  double before = 90.0;
  for (const double both : { 1.0, 2.0, 4.0, 8.0 })
  {
    PyramidSettings settings;
    settings.LevelStep = settings.LevelOffset = both;
    const auto method = MakeHorizonMethod(posts, Settings(settings));
    double squares = 0.0;
    int count = 0;
    for (const double azimuth : { 0.0, 33.0, 250.0 })
    {
      const std::vector<float> slopes = Slopes(*method, GridOf(field), azimuth);
      for (std::ptrdiff_t post = 0; post < 128 * 128; post += 7, ++count)
      {
        const double truth =
          oracle::HorizonSlope(field, post % 128, post / 128, oracle::DirectionOfAzimuth(azimuth));
        const double error = Elevation(slopes[static_cast<std::size_t>(post)]) -
          std::max(0.0, oracle::ElevationDegrees(truth));
        squares += error * error;
      }
    }
    const double rmse = std::sqrt(squares / count);
    RecordProperty("rmse_k" + std::to_string(static_cast<int>(both)), std::to_string(rmse));
    EXPECT_LT(rmse, 0.9 * before) << both;
    before = rmse;
  }
  EXPECT_LT(before, 0.5); // degrees; with k = 8 the logarithmic distances miss summits by 9 %
}

TEST(HorizonPyramid, RefusesWhatItCannotDo)
{
  const HeightField field = FieldOf(shapes::Plane(8, 8, 1.0, 0.0, 0.0));
  const auto refuses = [&](const std::function<void(HorizonSettings&)>& change)
  {
    HorizonSettings settings = Settings(PyramidSettings());
    change(settings);
    EXPECT_THROW(MakeHorizonMethod(field, settings), std::invalid_argument);
  };
  refuses([](HorizonSettings& s) { s.Shape = Surface::Bilinear; });
  refuses([](HorizonSettings& s) { s.Pyramid.LevelStep = 0.0; });
  refuses([](HorizonSettings& s) { s.Pyramid.LevelOffset = -1.0; });
  refuses([](HorizonSettings& s) { s.Pyramid.LevelOffset = std::nan(""); });
  refuses([](HorizonSettings& s) { s.Pyramid.Distance = 0.0; });
}

} // namespace
} // namespace testing
} // namespace skyline
