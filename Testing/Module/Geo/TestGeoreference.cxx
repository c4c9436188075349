// SPDX-License-Identifier: BSD-3-Clause
#include "Geo/Georeference.h"

#include "Geo/RowSpacing.h"
#include "Places.h"

#include <GeographicLib/Ellipsoid.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace skyline;

namespace
{

/// DefaultLatticeNodes has errors of at most 0.1 (s / 32)^3 radians in position and 0.3 (s / 32)^2
/// in direction for a side of s radians. Maps curve slightly more than spheres.
double PlaceTolerance(double side)
{
  return 0.2 * std::pow(side / WgsRadius / 32.0, 3) * DegreesPerRadian + 1e-12;
}
double DirectionTolerance(double side)
{
  return 0.6 * std::pow(side / WgsRadius / 32.0, 2) * DegreesPerRadian + 1e-9;
}

/// Converts longitude and latitude to map coordinates.
using MapForward = std::function<void(double longitude, double latitude, double& x, double& y)>;

/// The azimuth on the map of a walk of ten metres in a true azimuth, from the geodesic and the map.
double WalkedAzimuth(
  const MapForward& forward, double longitude, double latitude, double trueAzimuth)
{
  double x[2], y[2];
  for (const int side : { 0, 1 })
  {
    double latitude1 = 0.0, longitude1 = 0.0;
    GeographicLib::Geodesic::WGS84().Direct(
      latitude, longitude, trueAzimuth, side == 0 ? -10.0 : 10.0, latitude1, longitude1);
    forward(longitude1, latitude1, x[side], y[side]);
  }
  return std::atan2(x[1] - x[0], y[1] - y[0]) * DegreesPerRadian;
}
/// Maps and geodesics have errors of nanometres, 1e-9 / 10 radians over ten metres. The walk is
/// also curved.
constexpr double WalkTolerance = 1e-6;

} // namespace

TEST(Georeference, GeographicLatticeIsExact)
{
  // Sixty degrees, across the antimeridian, with two nodes and with many.
  for (const int nodes : { 2, 3, DefaultLatticeNodes })
  {
    const Georeference place = OnMap(Geographic, 150.0, -30.0, 0.01, 0.02, 6001, 3001, nodes);
    for (const double column : { 0.0, 17.0, 2999.5, 5990.25, 6000.0 })
    {
      for (const double row : { 0.0, 0.5, 1234.0, 3000.0 })
      {
        double longitude = 0.0, latitude = 0.0;
        place.LonLatAt(column, row, longitude, latitude);
        EXPECT_NEAR(longitude, 150.0 + 0.01 * column, 1e-11);
        EXPECT_NEAR(latitude, -30.0 + 0.02 * row, 1e-11);
        EXPECT_NEAR(place.ConvergenceAt(column, row), 0.0, 1e-9);
        EXPECT_NEAR(Turn(place.GridAzimuthAt(column, row, 123.0), 123.0), 0.0, 1e-9);
      }
    }
  }
}

TEST(Georeference, UtmAgreesWithGeographicLib)
{
  // 100 km and 600 km wide (the width of the zone at 60 degrees south).
  for (const double side : { 1e5, 6e5 })
  {
    const double step = side / 1000.0, x0 = -0.4 * side, y0 = -6.6e6;
    const Georeference place = OnMap(Utm(147.0), x0, y0, step, step, 1001, 1001);
    double worstPlace = 0.0, worstTurn = 0.0;
    for (double column = 3.0; column < 1001.0; column += 61.7)
    {
      for (double row = 0.0; row < 1001.0; row += 47.3)
      {
        double longitude0 = 0.0, latitude0 = 0.0, convergence = 0.0, scale = 0.0;
        GeographicLib::TransverseMercator::UTM().Reverse(
          147.0, x0 + step * column, y0 + step * row, latitude0, longitude0, convergence, scale);
        double longitude = 0.0, latitude = 0.0;
        place.LonLatAt(column, row, longitude, latitude);
        worstPlace = std::max({ worstPlace, std::abs(latitude - latitude0),
          std::abs(longitude - longitude0) * std::cos(latitude * RadiansPerDegree) });
        worstTurn = std::max(worstTurn, std::abs(place.ConvergenceAt(column, row) - convergence));
        EXPECT_NEAR(Turn(place.GridAzimuthAt(column, row, 77.0), 77.0 - convergence), 0.0,
          DirectionTolerance(side));
      }
    }
    EXPECT_LT(worstPlace, PlaceTolerance(side));
    EXPECT_LT(worstTurn, DirectionTolerance(side));
  }
}

TEST(Georeference, ConvergenceIsPositiveWhereGridNorthPointsEast)
{
  // East of the central meridian in the northern hemisphere, meridians lean to the left on the map,
  // so its +y axis points east of true north: by sin(latitude) times the degrees from the meridian.
  const Georeference place = OnMap(Utm(9.0), 150000.0, 5.5e6, 30.0, 30.0, 301, 301);
  double longitude = 0.0, latitude = 0.0;
  place.LonLatAt(150.0, 150.0, longitude, latitude);
  ASSERT_GT(longitude, 9.0);
  const double simple = (longitude - 9.0) * std::sin(latitude * RadiansPerDegree);
  EXPECT_NEAR(place.ConvergenceAt(150.0, 150.0), simple, 1e-3);
  EXPECT_GT(simple, 1.0);
  // A walk to true north turns to the west on the map.
  EXPECT_NEAR(Turn(place.GridAzimuthAt(150.0, 150.0, 0.0), 360.0 - simple), 0.0, 1e-3);
}

TEST(Georeference, SierraAlbersTurnsFourteenDegrees)
{
  // The raster dem/sierra_albers_30m.tif of the test data: its south-western post and its steps.
  const double x0 = -2033450.108137637842447 + 15.0;
  const double y0 = 258257.169109451933764 - 1099.5 * 30.0;
  const Georeference place = OnMap(Albers, x0, y0, 30.0, 30.0, 1100, 1100);
  double longitude = 0.0, latitude = 0.0;
  place.LonLatAt(549.5, 549.5, longitude, latitude);
  EXPECT_NEAR(longitude, -(119.0 + 14.0 / 60.0 + 46.52 / 3600.0), 0.01 / 3600.0); // gdalinfo
  EXPECT_NEAR(latitude, 37.0 + 26.0 / 60.0 + 41.95 / 3600.0, 0.01 / 3600.0);

  // On a conic map the angle between meridians and the +y axis is n (longitude - longitude0).
  double unused1 = 0.0, unused2 = 0.0, meridian = 0.0, scale = 0.0;
  Conus().Forward(-96.0, latitude, longitude, unused1, unused2, meridian, scale);
  EXPECT_NEAR(meridian, -14.0, 0.1);
  EXPECT_NEAR(Turn(place.GridAzimuthAt(549.5, 549.5, 0.0), -meridian), 0.0, 1e-6);
  // Albers stretches by `scale` to the east and shrinks by it to the north. The nearest rotation
  // fits all azimuths except for this distortion, asin((k - 1/k) / (k + 1/k)).
  const double distortion =
    std::asin(std::abs(scale * scale - 1.0) / (scale * scale + 1.0)) * DegreesPerRadian;
  const double convergence = place.ConvergenceAt(549.5, 549.5);
  EXPECT_NEAR(convergence, meridian, 1e-6); // the distortion follows the graticule

  const auto forward = [](double lon, double lat, double& x, double& y)
  { Conus().Forward(-96.0, lat, lon, x, y); };
  double worst = 0.0;
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += 7.0)
  {
    const double grid = place.GridAzimuthAt(549.5, 549.5, azimuth);
    EXPECT_NEAR(
      Turn(grid, WalkedAzimuth(forward, longitude, latitude, azimuth)), 0.0, WalkTolerance);
    worst = std::max(worst, std::abs(Turn(grid + convergence, azimuth)));
  }
  EXPECT_LT(worst, distortion + 1e-6);
  EXPECT_GT(worst, 0.9 * distortion); // no rotation fits better
}

TEST(Georeference, NonSquareStepsKeepAzimuths)
{
  const Georeference square = OnMap(Utm(9.0), 150000.0, 5.5e6, 30.0, 30.0, 301, 301);
  const Georeference flat = OnMap(Utm(9.0), 150000.0, 5.5e6, 30.0, 0.03, 301, 300001);
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += 30.0)
  {
    EXPECT_NEAR(Turn(square.GridAzimuthAt(100.0, 100.0, azimuth),
                  flat.GridAzimuthAt(100.0, 100000.0, azimuth)),
      0.0, 1e-6);
  }
}

TEST(Georeference, PolarMapHoldsThePole)
{
  // 400 km around the north pole, where grid azimuth = true azimuth - longitude of the meridian.
  const Georeference place = OnMap(NorthPolar, -2e5, -2e5, 400.0, 400.0, 1001, 1001);
  const MapForward forward = [](double lon, double lat, double& x, double& y)
  { GeographicLib::PolarStereographic::UPS().Forward(true, lat, lon, x, y); };
  for (const double column : { 0.0, 480.0, 499.9, 500.1, 730.0 })
  {
    for (const double row : { 100.0, 499.9, 500.2, 1000.0 })
    {
      double longitude0 = 0.0, latitude0 = 0.0, longitude = 0.0, latitude = 0.0;
      NorthPolar(400.0 * column - 2e5, 400.0 * row - 2e5, longitude0, latitude0);
      place.LonLatAt(column, row, longitude, latitude);
      const double fromPole = 90.0 - latitude0;
      EXPECT_NEAR(latitude, latitude0, PlaceTolerance(4e5)) << column << ' ' << row;
      EXPECT_NEAR(
        Turn(longitude, longitude0) * fromPole * RadiansPerDegree, 0.0, PlaceTolerance(4e5))
        << column << ' ' << row;
      EXPECT_NEAR(Turn(place.GridAzimuthAt(column, row, 30.0),
                    WalkedAzimuth(forward, longitude, latitude, 30.0)),
        0.0, 0.01 + 1e-4 / fromPole)
        << column << ' ' << row; // ten metres are curved near the pole
    }
  }
  double longitude = 0.0, latitude = 0.0;
  place.LonLatAt(500.0, 500.0, longitude, latitude);
  EXPECT_NEAR(latitude, 90.0, 1e-7);
  EXPECT_TRUE(std::isfinite(longitude));
  EXPECT_TRUE(std::isfinite(place.ConvergenceAt(500.0, 500.0)));
  EXPECT_TRUE(std::isfinite(place.GridAzimuthAt(500.0, 500.0, 10.0)));
}

TEST(Georeference, GeographicRowsAtThePole)
{
  const Georeference place = OnMap(Geographic, -180.0, 80.0, 0.1, 0.1, 3601, 101);
  for (const double row : { 0.0, 99.0, 100.0 })
  {
    EXPECT_NEAR(place.ConvergenceAt(1800.0, row), 0.0, 1e-9);
    EXPECT_NEAR(place.GridAzimuthAt(1800.0, row, 250.0), 250.0, 1e-9);
  }
}

TEST(Georeference, LocalRadius)
{
  Georeference place;
  EXPECT_THROW(place.LocalRadius(0.0), std::invalid_argument);
  place.EquatorialRadius = 1737400.0; // the Moon, a sphere
  EXPECT_EQ(place.LocalRadius(63.0), 1737400.0);

  const struct
  {
    double Radius, Flattening;
  } bodies[] = { { WgsRadius, WgsFlattening }, { 3396190.0, 1.0 / 169.89444722 } }; // Earth, Mars
  for (const auto& body : bodies)
  {
    place.EquatorialRadius = body.Radius;
    place.Flattening = body.Flattening;
    const GeographicLib::Ellipsoid ellipsoid(body.Radius, body.Flattening);
    for (double latitude = -90.0; latitude <= 90.0; latitude += 15.0)
    {
      const double m = ellipsoid.MeridionalCurvatureRadius(latitude);
      const double n = ellipsoid.TransverseCurvatureRadius(latitude);
      EXPECT_NEAR(place.LocalRadius(latitude), std::sqrt(m * n), 1e-6);
    }
  }
}

TEST(Georeference, RefusesWithoutPlaceOrWithABrokenLattice)
{
  double longitude = 0.0, latitude = 0.0;
  Georeference place;
  EXPECT_THROW(place.LonLatAt(0.0, 0.0, longitude, latitude), std::invalid_argument);
  EXPECT_THROW(place.ConvergenceAt(0.0, 0.0), std::invalid_argument);
  EXPECT_THROW(place.GridAzimuthAt(0.0, 0.0, 0.0), std::invalid_argument);
  place = OnMap(Geographic, 10.0, 10.0, 0.1, 0.1, 11, 11);
  place.Latitude.pop_back();
  EXPECT_THROW(place.LonLatAt(0.0, 0.0, longitude, latitude), std::invalid_argument);
  place = OnMap(Geographic, 10.0, 10.0, 0.1, 0.1, 11, 11);
  place.Columns = 1;
  EXPECT_THROW(place.LonLatAt(0.0, 0.0, longitude, latitude), std::invalid_argument);
  place = OnMap(Geographic, 10.0, 10.0, 0.1, 0.1, 11, 11);
  place.Latitude[0] = HUGE_VAL; // the result of a map's inverse outside its domain
  EXPECT_THROW(place.LonLatAt(0.0, 0.0, longitude, latitude), std::invalid_argument);
  EXPECT_NO_THROW(place.LonLatAt(10.0, 10.0, longitude, latitude));
}
