// SPDX-License-Identifier: BSD-3-Clause
// The oracle, compared with closed forms and with samples of the surface along the rays.
#include "Reference/Oracle.h"
#include "Reference/Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace skyline
{
namespace testing
{
namespace
{

/// The error of a few operations in double precision, relative to slopes near 1.
constexpr double RoundingBound = 1.0e-12;

constexpr double Missing = std::numeric_limits<double>::quiet_NaN();

double Slope(
  const oracle::OracleField& field, std::ptrdiff_t column, std::ptrdiff_t row, double degrees)
{
  return oracle::HorizonSlope(field, column, row, oracle::DirectionOfAzimuth(degrees));
}

/// The height of the surface at a position, from its cell alone; NaN if the cell has no surface.
double HeightAt(const oracle::OracleField& field, double x, double y)
{
  const auto i = std::min(static_cast<std::ptrdiff_t>(x), field.Columns - 2);
  const auto j = std::min(static_cast<std::ptrdiff_t>(y), field.Rows - 2);
  if (!field.HasCell(i, j))
  {
    return Missing;
  }
  const double p = x - static_cast<double>(i), q = y - static_cast<double>(j);
  const double sw = field.At(i, j), se = field.At(i + 1, j);
  const double nw = field.At(i, j + 1), ne = field.At(i + 1, j + 1);
  if (field.Through == Surface::Bilinear)
  {
    return (1.0 - q) * ((1.0 - p) * sw + p * se) + q * ((1.0 - p) * nw + p * ne);
  }
  return p >= q ? sw + p * (se - sw) + q * (ne - se) : sw + q * (nw - sw) + p * (ne - nw);
}

/// The greatest slope of `count` samples per metre along the ray.
double SampledSlope(const oracle::OracleField& field, std::ptrdiff_t column, std::ptrdiff_t row,
  double degrees, int count)
{
  const oracle::Direction d = oracle::DirectionOfAzimuth(degrees);
  const double lastX = static_cast<double>(field.Columns - 1);
  const double lastY = static_cast<double>(field.Rows - 1);
  double best = oracle::NoTerrain;
  for (int k = 1;; ++k)
  {
    const double s = static_cast<double>(k) / count;
    const double x = static_cast<double>(column) + s * d.East / field.SpacingX;
    const double y = static_cast<double>(row) + s * d.North / field.SpacingY;
    if (x < 0.0 || y < 0.0 || x > lastX || y > lastY)
    {
      return best;
    }
    const double z = HeightAt(field, x, y) - field.CurvatureDrop * s * s;
    if (std::isfinite(z))
    {
      best = std::max(best, (z - field.At(column, row)) / s);
    }
  }
}

TEST(Oracle, EighthsOfTheCompassAreExact)
{
  const double half = std::sqrt(0.5);
  EXPECT_EQ(oracle::DirectionOfAzimuth(90.0).East, 1.0);
  EXPECT_EQ(oracle::DirectionOfAzimuth(90.0).North, 0.0);
  EXPECT_EQ(oracle::DirectionOfAzimuth(180.0).East, 0.0);
  EXPECT_EQ(oracle::DirectionOfAzimuth(-45.0).East, -half);
  EXPECT_EQ(oracle::DirectionOfAzimuth(405.0).North, half);
  EXPECT_EQ(oracle::DirectionOfAzimuth(270.0 * RadiansPerDegree * DegreesPerRadian).North, 0.0);
  EXPECT_NEAR(oracle::DirectionOfAzimuth(30.0).East, 0.5, RoundingBound);
}

TEST(Oracle, PlaneRisesByItsGradientEverywhere)
{
  oracle::OracleField field = shapes::Plane(21, 17, 10.0, 0.3, -0.7);
  for (const Surface surface : { Surface::Triangles, Surface::Bilinear })
  {
    field.Through = surface;
    for (int azimuth = 0; azimuth < 360; azimuth += 5)
    {
      const double a = azimuth * RadiansPerDegree;
      EXPECT_NEAR(
        Slope(field, 10, 8, azimuth), 0.3 * std::sin(a) - 0.7 * std::cos(a), 10.0 * RoundingBound)
        << azimuth;
    }
  }
}

TEST(Oracle, NothingLiesBeyondTheEdge)
{
  const oracle::OracleField field = shapes::Plane(5, 4, 1.0, 0.0, 0.0);
  EXPECT_EQ(Slope(field, 4, 3, 45.0), oracle::NoTerrain);
  EXPECT_EQ(Slope(field, 4, 1, 90.0), oracle::NoTerrain);
  EXPECT_EQ(Slope(field, 4, 1, 10.0), oracle::NoTerrain);
  EXPECT_EQ(oracle::ElevationDegrees(Slope(field, 2, 0, 180.0)), -90.0);
  // Along the edge of the data there is terrain.
  EXPECT_EQ(Slope(field, 4, 1, 0.0), 0.0);
  EXPECT_EQ(Slope(field, 1, 0, 90.0), 0.0);
}

TEST(Oracle, WallOnAPlane)
{
  // The upper edge of the wall, 3 spacings away. The rays must meet it inside the data.
  const oracle::OracleField field = shapes::Wall(12, 41, 2.0, 5.0, 8);
  for (int azimuth = 20; azimuth <= 160; azimuth += 5)
  {
    EXPECT_NEAR(
      Slope(field, 5, 20, azimuth), 5.0 * std::sin(azimuth * RadiansPerDegree) / 6.0, RoundingBound)
      << azimuth;
  }
  EXPECT_EQ(Slope(field, 5, 20, 270.0), 0.0);
}

TEST(Oracle, SpikesAreMetOnTheirPostExactly)
{
  for (const Surface surface : { Surface::Triangles, Surface::Bilinear })
  {
    oracle::OracleField field = shapes::Spike(15, 15, 1.0, 1.0e4, 12, 12);
    field.Through = surface;
    EXPECT_NEAR(Slope(field, 7, 7, 45.0), 1.0e4 / std::hypot(5.0, 5.0), 1.0e4 * RoundingBound);
    EXPECT_NEAR(Slope(field, 2, 12, 90.0), 1.0e3, 1.0e3 * RoundingBound);
    EXPECT_NEAR(Slope(field, 12, 14, 180.0), 5.0e3, 1.0e3 * RoundingBound);
    EXPECT_NEAR(Slope(field, 14, 10, 315.0), 1.0e4 / std::hypot(2.0, 2.0), 1.0e4 * RoundingBound);
  }
}

TEST(Oracle, DiagonalRunsFromSouthWestToNorthEast)
{
  oracle::OracleField field(2, 2, 1.0, 1.0);
  field.At(0, 1) = 1.0;
  field.At(1, 0) = -10.0;
  // From the north-western post, the ray to the south-east meets the middle of the diagonal, where
  // the height is 0.
  EXPECT_NEAR(Slope(field, 0, 1, 135.0), -1.0 / std::sqrt(0.5), RoundingBound);
  field.Through = Surface::Bilinear;
  // There the height of the patch is 1 - 2 p - 9 p^2 at the part p of the way, so its slope at the
  // receiver is the greatest.
  EXPECT_NEAR(Slope(field, 0, 1, 135.0), -2.0 / std::sqrt(2.0), RoundingBound);
  field.At(0, 0) = 4.0; // 1 + 2 p - 13 p^2
  EXPECT_NEAR(Slope(field, 0, 1, 135.0), 2.0 / std::sqrt(2.0), RoundingBound);
}

TEST(Oracle, BilinearPatchHasItsMaximumInside)
{
  // Seen from the post (0, 0) along the diagonal of the cell (1, 1): the ridge between (2, 1) and
  // (1, 2).
  oracle::OracleField field(3, 3, 1.0, 1.0);
  field.At(2, 1) = field.At(1, 2) = 8.0;
  field.Through = Surface::Bilinear;
  // At u = 1 + p the height is 16 p (1 - p), and the slope 16 p (1 - p) / (sqrt 2 (1 + p)) is
  // greatest at p = sqrt 2 - 1.
  const double p = std::sqrt(2.0) - 1.0;
  EXPECT_NEAR(Slope(field, 0, 0, 45.0), 16.0 * p * (1.0 - p) / (std::sqrt(2.0) * (1.0 + p)),
    10.0 * RoundingBound);
  field.Through = Surface::Triangles;
  EXPECT_NEAR(Slope(field, 0, 0, 45.0), 0.0, RoundingBound);
}

TEST(Oracle, AgreesWithSamplesOfTheSurface)
{
  // Rays are sampled each millimetre, crossings are at least half a metre away, and slopes are
  // below 10. Therefore the samples are lower by less than this value.
  constexpr double resolution = 0.02;
  oracle::OracleField field = shapes::Fractal(13, 11, 1.0, 8.0, 5, 0.7);
  field.SpacingY = 1.7;
  shapes::RemoveIslands(field, 4, 1, 3);
  for (const Surface surface : { Surface::Triangles, Surface::Bilinear })
  {
    field.Through = surface;
    for (const double drop : { 0.0, 1.0e-6 })
    {
      field.CurvatureDrop = drop;
      for (const double azimuth : { 3.0, 62.0, 77.7, 100.0, 143.0, 201.0, 277.0, 333.3 })
      {
        for (std::ptrdiff_t row = 0; row < field.Rows; row += 2)
        {
          for (std::ptrdiff_t column = row % 3; column < field.Columns; column += 3)
          {
            if (field.HasPost(column, row))
            {
              const double truth = Slope(field, column, row, azimuth);
              const double sampled = SampledSlope(field, column, row, azimuth, 1000);
              // Between crossings the curvature bends the surface upwards: a sample can be up to
              // 1e-6 above the crossings.
              EXPECT_LE(sampled, truth + 1.0e-5) << column << " " << row << " " << azimuth;
              EXPECT_LE(truth, sampled + resolution) << column << " " << row << " " << azimuth;
            }
          }
        }
      }
    }
  }
}

TEST(Oracle, CellsWithAMissingPostHaveNoSurface)
{
  oracle::OracleField field = shapes::Spike(9, 9, 1.0, 100.0, 4, 6);
  EXPECT_EQ(Slope(field, 4, 2, 0.0), 25.0);
  // With one of four cells left, the spike still counts at its post and on the side of this cell.
  field.At(5, 5) = field.At(5, 7) = field.At(3, 7) = Missing;
  EXPECT_EQ(Slope(field, 4, 2, 0.0), 25.0);
  EXPECT_GT(Slope(field, 2, 2, 20.0), 1.0);
  EXPECT_LT(Slope(field, 6, 2, 340.0), 1.0);
  // Without a complete cell, it hides nothing.
  field.At(3, 5) = Missing;
  EXPECT_LT(Slope(field, 4, 2, 0.0), 1.0);
  EXPECT_TRUE(std::isnan(Slope(field, 3, 5, 0.0)));
}

TEST(Oracle, TouchingACornerCounts)
{
  // Only the cell (3, 3) is complete. The ray along the diagonal to the north-west touches its
  // corner.
  oracle::OracleField field(8, 8, 1.0, 1.0);
  for (double& height : field.Heights)
  {
    height = Missing;
  }
  field.At(3, 3) = field.At(4, 4) = field.At(4, 3) = 0.0;
  field.At(3, 4) = 7.0;
  field.At(7, 0) = 0.0;
  EXPECT_NEAR(Slope(field, 7, 0, 315.0), 7.0 / std::hypot(4.0, 4.0), RoundingBound);
  field.At(5, 6) = 0.0;
  EXPECT_NEAR(Slope(field, 5, 6, 225.0), 7.0 / std::hypot(2.0, 2.0), RoundingBound);
  field.At(5, 5) = 0.0;
  EXPECT_NEAR(Slope(field, 5, 5, 225.0), 0.0, RoundingBound);
}

TEST(Oracle, GroundSinksWithTheSquareOfDistance)
{
  const double drop = 0.5 / 6371000.0;
  oracle::OracleField field = shapes::Spike(3, 301, 1000.0, 300.0, 1, 0);
  field.CurvatureDrop = drop;
  // From the plain, the horizon is the next post, not the spike 200 km away. From the spike, it is
  // the plain at d = sqrt(300 / drop) = 61.8 km, which is 62 km on the posts.
  EXPECT_NEAR(Slope(field, 1, 200, 180.0), -drop * 1000.0, 1e-15); // the next post is the horizon
  EXPECT_NEAR(Slope(field, 1, 0, 0.0), -(300.0 + drop * 62.0e3 * 62.0e3) / 62.0e3, 1e-15);
}

TEST(Oracle, SkyOfOpenLevelGround)
{
  const std::vector<double> slopes(24, 0.0);
  const oracle::Sky sky = oracle::SkyFromHorizons(slopes, 0.0, 0.0);
  // Midpoints over 4000 elevations: pi^2 / 24 / 4000^2.
  constexpr double bound = 1.0e-7;
  EXPECT_NEAR(sky.SkyViewFactor, 1.0, bound);
  EXPECT_NEAR(sky.SkyViewFactorHorizontal, 1.0, bound);
  EXPECT_NEAR(sky.VisibleSkyFraction, 1.0, bound);
  EXPECT_NEAR(sky.UniformAmbient, 1.0, bound);
  EXPECT_NEAR(sky.PositiveOpenness, 90.0, RoundingBound);
}

TEST(Oracle, DiscCutByALevelHorizon)
{
  // 480000 samples; those on the line of the cut count fully: at most 1 / 400 of the disc.
  constexpr double bound = 0.0025;
  const double radius = 0.27 * RadiansPerDegree;
  for (int k = -4; k <= 4; ++k)
  {
    const double t = 0.25 * k;
    const double truth = 0.5 - (t * std::sqrt(1.0 - t * t) + std::asin(t)) / Pi;
    const double lit = oracle::LitFraction(2.0, 0.0, radius, [=](double) { return t * radius; });
    EXPECT_NEAR(lit, truth, bound) << t;
  }
}

TEST(Oracle, HorizonCurveIsLinearAndMayClose)
{
  oracle::HorizonCurve curve;
  curve.Azimuths = { 6.0, 6.2, 6.6 };
  curve.Elevations = { 0.1, 0.3, -0.1 };
  EXPECT_NEAR(curve(6.1), 0.2, RoundingBound);
  EXPECT_NEAR(curve(6.4 - 2.0 * Pi), 0.1, RoundingBound);
  EXPECT_NEAR(curve(5.0), 0.1, RoundingBound);
  EXPECT_NEAR(curve(1.0), -0.1, RoundingBound);
  curve.Closed = true;
  EXPECT_NEAR(curve(0.5 * (6.6 + 6.0 + 2.0 * Pi)), 0.0, RoundingBound);
}

} // namespace
} // namespace testing
} // namespace skyline
