// SPDX-License-Identifier: BSD-3-Clause
// From heights to sky: shapes with closed forms, given as posts, with horizons by the oracle and
// sky by the accumulators. Long shapes are long enough that all rays, except those along the shape,
// leave them at the side.
#include "HeightField/Normals.h"
#include "Reference/Shapes.h"
#include "Testing/Module/KernelTesting.h"

#include <gtest/gtest.h>

#include <cmath>

namespace skyline
{
namespace testing
{
namespace
{

/// Azimuths, each in the middle of its swath: all rays are at least 0.5 degrees away from the axes.
constexpr int AzimuthCount = 360;

/// The length in spacings over which a ray half a degree off a wall approaches it by one spacing.
constexpr std::ptrdiff_t Reach = 116;

/// The midpoint rule has an error of w^2 / 24 / 2 pi for each kink of the integrand, with w = 2 pi
/// / 360. If a horizon with the greatest slope `steep` falls to 0 and rises again, as across the
/// line of a valley, sin h has two kinks of 2 steep. The rounding of the sums is added.
double QuadratureBound(double steep)
{
  const double w = 2.0 * Pi / AzimuthCount;
  return 1.1 * w * w / 24.0 * 4.0 * steep / (2.0 * Pi) + 2.0 * SumBound;
}

oracle::Sky SkyOf(const oracle::OracleField& field, std::ptrdiff_t column, std::ptrdiff_t row)
{
  std::vector<double> slopes;
  for (int k = 0; k < AzimuthCount; ++k)
  {
    slopes.push_back(oracle::HorizonSlope(
      field, column, row, oracle::DirectionOfAzimuth((k + 0.5) * 360.0 / AzimuthCount)));
  }
  std::vector<float> east(field.Heights.size()), north(field.Heights.size());
  const Grid grid{ field.Columns, field.Rows, field.SpacingX, field.SpacingY };
  Gradients(grid, PostView<double>{ field.Heights.data(), 1, field.Columns }, 0, field.Rows,
    east.data(), north.data());
  const std::size_t post = field.Index(column, row);
  return SumSky(slopes, east[post], north[post], 0.5);
}

TEST(DiscretisedShapes, InclinedPlane)
{
  for (const double degrees : { 0.0, 10.0, 30.0, 45.0, 60.0, 80.0 })
  {
    const double s = degrees * RadiansPerDegree;
    const oracle::OracleField field = shapes::Plane(9, 9, 10.0, 0.0, std::tan(s));
    const oracle::Sky sky = SkyOf(field, 4, 4);
    const double bound = QuadratureBound(std::tan(s));
    EXPECT_NEAR(sky.SkyViewFactor, 0.5 * (1.0 + std::cos(s)), bound) << degrees;
    EXPECT_NEAR(sky.SkyViewFactorHorizontal, 0.5 * (1.0 + std::cos(s)), bound) << degrees;
    EXPECT_NEAR(sky.VisibleSkyFraction, 1.0 - s / Pi, bound) << degrees;
  }
}

TEST(DiscretisedShapes, ValleyLine)
{
  for (const double degrees : { 10.0, 30.0, 45.0, 60.0 })
  {
    const double s = degrees * RadiansPerDegree;
    const oracle::OracleField field = shapes::Valley(5, 2 * Reach + 1, 10.0, std::tan(s));
    const oracle::Sky sky = SkyOf(field, 2, Reach);
    const double bound = QuadratureBound(std::tan(s));
    EXPECT_NEAR(sky.SkyViewFactorHorizontal, std::cos(s), bound) << degrees;
    EXPECT_NEAR(sky.VisibleSkyFraction, 1.0 - 2.0 * s / Pi, bound) << degrees;
  }
}

TEST(DiscretisedShapes, TrenchOfFourSpacings)
{
  const double sizes[][2] = { { 1.0, 1.0 }, { 1.0, 2.0 }, { 2.0, 1.0 }, { 10.0, 20.0 },
    { 30.0, 10.0 } };
  for (const auto& size : sizes)
  {
    const double height = size[0], width = size[1];
    // The upper edges are 2 spacings from the middle line, and 1 and 3 spacings from the line
    // beside it.
    const oracle::OracleField field = shapes::Trench(9, 8 * Reach + 1, 0.25 * width, height, 1);
    const double bound = QuadratureBound(4.0 * height / width);
    const auto cosine = [=](double x) { return x / std::hypot(x, height); };
    const oracle::Sky middle = SkyOf(field, 4, 4 * Reach);
    EXPECT_NEAR(middle.SkyViewFactorHorizontal, cosine(0.5 * width), bound) << width;
    EXPECT_NEAR(middle.VisibleSkyFraction, 1.0 - 2.0 * std::atan(2.0 * height / width) / Pi, bound)
      << width;
    const oracle::Sky beside = SkyOf(field, 3, 4 * Reach);
    EXPECT_NEAR(
      beside.SkyViewFactorHorizontal, 0.5 * (cosine(0.25 * width) + cosine(0.75 * width)), bound)
      << width;
  }
}

TEST(DiscretisedShapes, WallOneSpacingAway)
{
  const double sizes[][2] = { { 1.0, 1.0 }, { 10.0, 5.0 }, { 100.0, 1000.0 } };
  for (const auto& size : sizes)
  {
    const oracle::OracleField field = shapes::Wall(6, 2 * Reach + 1, size[1], size[0], 4);
    const double b = std::atan(size[0] / size[1]);
    const double bound = QuadratureBound(size[0] / size[1]);
    const oracle::Sky sky = SkyOf(field, 3, Reach);
    EXPECT_NEAR(sky.SkyViewFactorHorizontal, 0.5 * (1.0 + std::cos(b)), bound);
    EXPECT_NEAR(sky.VisibleSkyFraction, 1.0 - b / Pi, bound);
  }
}

/// A round rim made of posts lies up to one and a half spacings outside the circle.
void ExpectRoundRim(
  const oracle::OracleField& field, std::ptrdiff_t radius, double height, double spacing)
{
  const std::ptrdiff_t middle = field.Columns / 2;
  const double r = static_cast<double>(radius) * spacing;
  for (int azimuth = 0; azimuth < 360; azimuth += 10)
  {
    const double slope =
      oracle::HorizonSlope(field, middle, middle, oracle::DirectionOfAzimuth(azimuth));
    EXPECT_GE(slope, height / (r + 1.5 * spacing)) << azimuth;
    EXPECT_LE(slope, height / r * (1.0 + 1e-12)) << azimuth;
    if (azimuth % 90 == 0)
    {
      EXPECT_NEAR(slope, height / r, 1e-12) << azimuth; // the post of the rim on the axis
    }
  }
}

TEST(DiscretisedShapes, CylinderPit)
{
  const double sizes[][2] = { { 1.0, 1.0 }, { 10.0, 5.0 }, { 5.0, 20.0 } };
  for (const auto& size : sizes)
  {
    const double spacing = size[0] / 64.0;
    ExpectRoundRim(shapes::CylinderPit(139, 139, spacing, size[0], size[1]), 64, size[1], spacing);
  }
}

TEST(DiscretisedShapes, BowlSeenFromItsBottom)
{
  for (const double degrees : { 30.0, 60.0, 90.0 })
  {
    const double cap = degrees * RadiansPerDegree;
    // A sphere whose rim passes just inside the posts that are 64 columns or rows away.
    const double sphere = 64.0 / std::sin(cap) * (1.0 - 1e-13);
    const double depth = sphere * (1.0 - std::cos(cap));
    ExpectRoundRim(shapes::Bowl(139, 139, 1.0, sphere, cap), 64, depth, 1.0);
    EXPECT_NEAR(std::atan(depth / 64.0), 0.5 * cap, 1e-12);
  }
}

TEST(DiscretisedShapes, DipOfASphere)
{
  const double radius = 6371000.0;
  for (const double eye : { 10.0, 100.0, 1000.0, 3000.0 })
  {
    oracle::OracleField field = shapes::Spike(3, 801, 500.0, eye, 1, 0);
    field.CurvatureDrop = 0.5 / radius;
    const double dip =
      oracle::ElevationDegrees(oracle::HorizonSlope(field, 1, 0, oracle::DirectionOfAzimuth(0.0)));
    const double truth = -std::acos(radius / (radius + eye)) * DegreesPerRadian;
    // The parabola changes the dip by eye / 4R. Posts 500 m apart miss the point of contact by at
    // most 250 m, which raises the line of sight by CurvatureDrop * 250^2 / distance.
    const double contact = std::sqrt(2.0 * radius * eye);
    const double bound = 0.26 * eye / radius * -truth +
      field.CurvatureDrop * 250.0 * 250.0 / (contact - 250.0) * DegreesPerRadian;
    EXPECT_NEAR(dip, truth, bound) << eye;
  }
}

} // namespace
} // namespace testing
} // namespace skyline
