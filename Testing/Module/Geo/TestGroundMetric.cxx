// SPDX-License-Identifier: BSD-3-Clause
// Lengths and angles at the posts, the division of the raster into patches, and the conversion of
// azimuths in both directions.
#include "Geo/GroundMetric.h"
#include "Geo/RayBending.h"
#include "Geo/RayFan.h"
#include "Places.h"

#include <GeographicLib/Geodesic.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace skyline;

namespace
{

/// The sinusoidal map of a sphere with the radius WgsRadius.
void Sinusoidal(double x, double y, double& longitude, double& latitude)
{
  latitude = y / WgsRadius * DegreesPerRadian;
  longitude = x / (WgsRadius * std::cos(y / WgsRadius)) * DegreesPerRadian;
}

Georeference SinusoidalPlace(std::ptrdiff_t columns, std::ptrdiff_t rows, double step)
{
  Georeference place = OnMap(Sinusoidal, -6.0e6, 5.5e6, step, step, columns, rows, 129);
  place.Flattening = 0.0;
  return place;
}

} // namespace

// Closed form on the sphere: parallels keep their lengths, and the y axis of the image leans by t =
// lambda sin(phi), so that X = s / sqrt(1 + t^2), Shear = s t / sqrt(1 + t^2), Y = s sqrt(1 + t^2).
TEST(GroundMetric, SinusoidalInClosedForm)
{
  const double step = 1000.0;
  const Georeference place = SinusoidalPlace(301, 201, step);
  const GroundMetric metric(place, { step, step });
  ASSERT_FALSE(metric.Uniform());
  for (const double column : { 0.0, 77.5, 150.0, 300.0 })
  {
    for (const double row : { 0.0, 20.25, 100.0, 200.0 })
    {
      double longitude = 0.0, latitude = 0.0;
      Sinusoidal(-6.0e6 + column * step, 5.5e6 + row * step, longitude, latitude);
      const double t = longitude * RadiansPerDegree * std::sin(latitude * RadiansPerDegree);
      const double root = std::sqrt(1.0 + t * t);
      const PostMetric found = metric.At(column, row);
      const double tolerance = 2e-4 * step; // LatticeTolerance
      EXPECT_NEAR(found.X, step / root, tolerance);
      EXPECT_NEAR(found.Shear, step * t / root, tolerance);
      EXPECT_NEAR(found.Y, step * root, tolerance);
      // Azimuths on the image are measured in the plane of the map: columns run along parallels.
      EXPECT_NEAR(Turn(place.TrueAzimuthAt(column, row, 90.0), 90.0), 0.0, 0.01);
    }
  }
}

TEST(GroundMetric, AzimuthsThereAndBack)
{
  const Georeference places[] = { OnMap(Utm(9.0), 1e5, 5e6, 30.0, 30.0, 101, 101),
    OnMap(Albers, -2033450.0, 225272.0, 30.0, 60.0, 100, 110), SinusoidalPlace(101, 101, 900.0),
    OnMap(Geographic, 10.0, 60.0, 0.01, 0.02, 101, 101),
    OnMap(WebMercator, 1e6, WebMercatorY(47.0), 1000.0, 500.0, 101, 101) };
  for (Georeference place : places)
  {
    for (const double azimuth : { 0.0, 13.0, 90.0, 135.0, 250.0, 359.9 })
    {
      for (const double post : { 0.0, 31.5, 99.0 })
      {
        const double grid = place.GridAzimuthAt(post, post, azimuth);
        EXPECT_NEAR(Turn(place.TrueAzimuthAt(post, post, grid), azimuth), 0.0, 1e-9);
        // On the ground, measured from the +y axis of the image.
        EXPECT_NEAR(Turn(place.GroundAzimuthAt(post, post, azimuth),
                      azimuth - place.TrueAzimuthAt(post, post, 0.0)),
          0.0, 1e-9);
      }
    }
  }
}

// The conversion from image to ground by the metric equals the one by the georeference, over true
// azimuths.
TEST(GroundMetric, ImageAzimuthsToTheGround)
{
  const Georeference place = SinusoidalPlace(101, 101, 900.0);
  const GroundMetric metric(place, { 900.0, 900.0 });
  for (const double azimuth : { 0.0, 30.0, 90.0, 200.0, 315.0, 725.0 })
  {
    const double truth = place.TrueAzimuthAt(40.0, 70.0, azimuth);
    EXPECT_NEAR(Turn(metric.GroundAzimuth(metric.At(40.0, 70.0), azimuth * RadiansPerDegree) *
                    DegreesPerRadian,
                  place.GroundAzimuthAt(40.0, 70.0, truth)),
      0.0, 0.01);
  }
}

TEST(GroundMetric, TrueMapsAreTakenAtTheirWord)
{
  EXPECT_TRUE(GroundMetric(OnMap(Utm(9.0), -3e5, 4e6, 600.0, 1000.0, 1001, 1001), { 600.0, 1000.0 })
                .Uniform());
  // 10 degrees from its meridian, UTM stretches by 0.5 %.
  EXPECT_FALSE(
    GroundMetric(OnMap(Utm(9.0), 7e5, 5e6, 600.0, 600.0, 101, 101), { 600.0, 600.0 }).Uniform());
  EXPECT_TRUE(GroundMetric(Georeference(), { 3.0, 4.0 }).Uniform());
  EXPECT_TRUE(
    GroundMetric(OnMap(Utm(9.0), 1e5, 5e6, 1e-6, 1e-6, 101, 101), { 1e-6, 1e-6 }).Uniform());
}

TEST(GroundMetric, ErrorIsTheWorstOfAllDirections)
{
  const PostMetric used{ 30.0, 2.0, 25.0 }, truth{ 31.0, 3.5, 25.5 };
  const MetricError error = ErrorOf(used, truth);
  double turn = 0.0, stretch = 0.0;
  for (int k = 0; k < 3600; ++k)
  {
    const double azimuth = k * 0.1 * RadiansPerDegree;
    const double columns = std::sin(azimuth) / used.X;
    const double rows = (std::cos(azimuth) - used.Shear * columns) / used.Y;
    const double x = truth.X * columns, y = truth.Shear * columns + truth.Y * rows;
    turn = std::max(turn, std::abs(std::remainder(std::atan2(x, y) - azimuth, 2.0 * Pi)));
    stretch = std::max(stretch, std::abs(LengthOf(truth, columns, rows) - 1.0));
  }
  EXPECT_NEAR(error.Azimuth, turn, 1e-5);
  EXPECT_NEAR(error.Distance, stretch, 1e-5);
}

TEST(GroundMetric, LengthsAreThoseOfThePosts)
{
  const Georeference place = SinusoidalPlace(301, 201, 1000.0);
  const GroundMetric metric(place, { 1000.0, 1000.0 });
  std::vector<float> lengths(301);
  metric.Lengths(57, 0, 301, 0.4, -1.0, lengths.data());
  for (int column = 0; column < 301; ++column)
  {
    EXPECT_NEAR(lengths[static_cast<std::size_t>(column)],
      LengthOf(metric.At(column, 57.0), 0.4, -1.0), 0.05);
  }
}

TEST(GroundMetric, GradientsTurnWithTheMetric)
{
  const Georeference place = SinusoidalPlace(101, 101, 1000.0);
  const GroundMetric metric(place, { 1000.0, 1000.0 });
  // A plane that rises by a per metre of x and by b per metre of y, along the axes of the post.
  const PostMetric here = metric.At(50.0, 40.0);
  const double a = 0.3, b = -0.2;
  std::vector<float> x(101, static_cast<float>((a * here.X + b * here.Shear) / 1000.0));
  std::vector<float> y(101, static_cast<float>(b * here.Y / 1000.0));
  metric.TurnGradients(40, { 1000.0, 1000.0 }, 101, x.data(), y.data());
  EXPECT_NEAR(x[50], a, 1e-6);
  EXPECT_NEAR(y[50], b, 1e-6);
}

TEST(GroundMetric, RefusesMapsWithoutLengths)
{
  // A folded map: columns run to the west.
  const MapInverse folded = [](double x, double y, double& longitude, double& latitude)
  {
    longitude = -x / 1e5;
    latitude = y / 1e5 + 0.1 * std::sin(x / 1e4);
  };
  EXPECT_THROW(GroundMetric(OnMap(folded, 1e5, 1e6, 500.0, 500.0, 101, 101), { 500.0, 500.0 }),
    std::invalid_argument);
  Georeference place;
  place.Columns = place.Rows = 3;
  place.RowSpacingX = place.RowSpacingY = { 1.0, 2.0 };
  EXPECT_THROW(GroundMetric(place, { 1.0, 1.0 }), std::invalid_argument);
}

// Each post lies between two rays, and no ray deviates more from its azimuth than the tolerance.
TEST(RayFan, RaysStayBesideTheirAzimuth)
{
  const Georeference place = SinusoidalPlace(801, 601, 500.0);
  const GroundMetric metric(place, { 500.0, 500.0 });
  for (const double azimuth : { 0.0, 35.0, 90.0, 201.0, 300.0 })
  {
    const RayFan fan(metric, azimuth * RadiansPerDegree, false, true);
    EXPECT_EQ(fan.Directions.size() > 3, azimuth != 0.0); // rows follow the +y axis by definition
    std::vector<float> directions(801), lengths(801);
    for (const std::ptrdiff_t row : { 0, 77, 300, 600 })
    {
      fan.Places(row, 0, 801, directions.data(), lengths.data());
      for (const std::size_t column : { 0u, 100u, 401u, 800u })
      {
        const PostMetric post = metric.At(static_cast<double>(column), static_cast<double>(row));
        const PostMetric used = fan.MetricOf(0);
        double mean = 0.0;
        for (int k = 0; k < 2; ++k)
        {
          const float below = std::floor(directions[column]);
          const auto ray = std::min(static_cast<std::size_t>(below) + k, fan.Directions.size() - 1);
          const double angle = fan.Directions[ray];
          const double columns = std::sin(angle) / used.X;
          const double rows = (std::cos(angle) - used.Shear * columns) / used.Y;
          const double found =
            std::atan2(post.X * columns, post.Shear * columns + post.Y * rows) * DegreesPerRadian;
          const double off = Turn(found, azimuth);
          EXPECT_LT(std::abs(off), AzimuthTolerance);
          mean += off * (k ? directions[column] - below : 1.0f - (directions[column] - below));
        }
        EXPECT_NEAR(mean, 0.0, 0.005);
      }
    }
  }
}

// On a map that is not in degrees, azimuths on the image have the same direction everywhere.
TEST(RayFan, OneRayWhereOneIsEnough)
{
  const Georeference small = SinusoidalPlace(11, 11, 30.0);
  EXPECT_TRUE(RayFan(GroundMetric(small, { 30.0, 30.0 }), 0.25 * Pi, false, true).IsOne());
  const Georeference large = SinusoidalPlace(301, 201, 1000.0);
  const GroundMetric metric(large, { 1000.0, 1000.0 });
  EXPECT_FALSE(RayFan(metric, 0.25 * Pi, false, true).IsOne());
  EXPECT_TRUE(RayFan(metric, 0.25 * Pi, true, false).IsOne());
}

// A straight line that starts to the east turns away from its parallel by tan(latitude) / R per
// metre. At its end the geodesic differs by half of that, to first order. On the equator there is
// no turn.
TEST(RayBending, AlongAParallel)
{
  const double reach = 20000.0;
  const auto bend = [&](double latitude)
  {
    return MeasureRayBending(
      OnMap(Geographic, 10.0, latitude - 0.05, 0.01, 0.001, 101, 101), reach);
  };
  const double latitude = 60.0;
  const double radius = 6.378e6; // within 0.5 % of both radii of curvature
  const double expected = std::tan(latitude * RadiansPerDegree) * reach / (2.0 * radius);
  const RayBending found = bend(latitude);
  EXPECT_NEAR(found.Length, reach, 1.0);
  EXPECT_GE(found.Azimuth * RadiansPerDegree, 0.99 * expected);
  EXPECT_LE(
    found.Azimuth * RadiansPerDegree, 1.1 * expected); // oblique rays reach higher latitudes
  EXPECT_LT(bend(0.0).Azimuth, 1e-3);
  EXPECT_LT(bend(0.0).Distance, 1e-5);
  EXPECT_EQ(MeasureRayBending(Georeference(), reach).Length, 0.0);
}
