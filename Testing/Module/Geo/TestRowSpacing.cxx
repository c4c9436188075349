// SPDX-License-Identifier: BSD-3-Clause
#include "Geo/RowSpacing.h"

#include "Geo/GroundMetric.h"
#include "Geo/RowBands.h"

#include "Places.h"

#include <GeographicLib/Ellipsoid.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace skyline;

namespace
{

/// A geodesic between two posts is shorter than the arc of the parallel by the square of the step
/// divided by 24. The difference between arcs of meridians and their tangents is as small: 1e-7 for
/// steps up to 0.05 degrees.
constexpr double ArcTolerance = 1e-7;

double EastMetres(double latitude, double degrees)
{
  return GeographicLib::Ellipsoid::WGS84().CircleRadius(latitude) * degrees * RadiansPerDegree;
}

double NorthMetres(double latitude, double degrees)
{
  return GeographicLib::Ellipsoid::WGS84().MeridionalCurvatureRadius(latitude) * degrees *
    RadiansPerDegree;
}

void ExpectSane(const Georeference& place)
{
  for (std::size_t row = 0; row < place.RowSpacingX.size(); ++row)
  {
    ASSERT_TRUE(std::isfinite(place.RowSpacingX[row]) && place.RowSpacingX[row] > 0.0) << row;
    ASSERT_TRUE(std::isfinite(place.RowSpacingY[row]) && place.RowSpacingY[row] > 0.0) << row;
  }
}

} // namespace

TEST(RowSpacing, SixtyDegreesOfLatitudeAreRadiiOfCurvature)
{
  Georeference place = OnMap(Geographic, 5.0, 10.0, 0.05, 0.05, 201, 1201);
  const PostSpacing centre = ComputeRowSpacing(place, 0.05, 0.05, StepUnit::Degrees);
  ASSERT_EQ(place.RowSpacingX.size(), 1201u);
  ASSERT_EQ(place.RowSpacingY.size(), 1201u);
  for (std::size_t row = 0; row < 1201; ++row)
  {
    const double latitude = 10.0 + 0.05 * static_cast<double>(row);
    EXPECT_NEAR(place.RowSpacingX[row] / EastMetres(latitude, 0.05), 1.0, ArcTolerance) << row;
    EXPECT_NEAR(place.RowSpacingY[row] / NorthMetres(latitude, 0.05), 1.0, ArcTolerance) << row;
  }
  EXPECT_NEAR(centre.X / EastMetres(40.0, 0.05), 1.0, ArcTolerance);
  EXPECT_NEAR(centre.Y / NorthMetres(40.0, 0.05), 1.0, ArcTolerance);
}

TEST(RowSpacing, SmallGeographicRasterHasOneSpacing)
{
  // Ten rows of 30 m, between which the cosine changes by 4e-5.
  Georeference place = OnMap(Geographic, -122.3, 46.1, 1.0 / 3600, 1.0 / 3600, 12, 10);
  const PostSpacing centre = ComputeRowSpacing(place, 1.0 / 3600, 1.0 / 3600, StepUnit::Degrees);
  EXPECT_TRUE(place.RowSpacingX.empty());
  EXPECT_NEAR(centre.X / EastMetres(46.10125, 1.0 / 3600), 1.0, ArcTolerance);
  EXPECT_NEAR(centre.Y / NorthMetres(46.10125, 1.0 / 3600), 1.0, ArcTolerance);
}

TEST(RowSpacing, AntimeridianIsLikeAnywhereElse)
{
  Georeference here = OnMap(Geographic, 10.0, 50.0, 0.01, 0.01, 101, 101);
  Georeference there = OnMap(Geographic, 179.5, 50.0, 0.01, 0.01, 101, 101);
  ComputeRowSpacing(here, 0.01, 0.01, StepUnit::Degrees);
  ComputeRowSpacing(there, 0.01, 0.01, StepUnit::Degrees);
  ASSERT_EQ(here.RowSpacingX.size(), there.RowSpacingX.size());
  for (std::size_t row = 0; row < here.RowSpacingX.size(); ++row)
  {
    EXPECT_NEAR(here.RowSpacingX[row], there.RowSpacingX[row], 1e-6);
    EXPECT_NEAR(here.RowSpacingY[row], there.RowSpacingY[row], 1e-6);
  }
}

TEST(RowSpacing, RowsNearAndOnThePolesHaveAWidth)
{
  // First up to 89.9 degrees, then a global raster whose first and last rows are the poles.
  Georeference place = OnMap(Geographic, 0.0, 89.0, 0.01, 0.01, 101, 91);
  ComputeRowSpacing(place, 0.01, 0.01, StepUnit::Degrees);
  ASSERT_EQ(place.RowSpacingX.size(), 91u);
  ExpectSane(place);
  EXPECT_NEAR(place.RowSpacingX.back() / EastMetres(89.9, 0.01), 1.0, 1e-6);

  Georeference world = OnMap(Geographic, -180.0, -90.0, 1.0, 1.0, 361, 181);
  ComputeRowSpacing(world, 1.0, 1.0, StepUnit::Degrees);
  ASSERT_EQ(world.RowSpacingX.size(), 181u);
  ExpectSane(world);
  EXPECT_NEAR(world.RowSpacingX.front() / EastMetres(89.75, 1.0), 1.0, 1e-4);
  EXPECT_NEAR(world.RowSpacingX.back(), world.RowSpacingX.front(), 1e-6);
  EXPECT_NEAR(world.RowSpacingY.back() / NorthMetres(90.0, 1.0), 1.0, 1e-4);

  Georeference beyond = OnMap(Geographic, 0.0, 89.0, 0.1, 0.1, 11, 21);
  EXPECT_THROW(ComputeRowSpacing(beyond, 0.1, 0.1, StepUnit::Degrees), std::invalid_argument);
}

TEST(RowSpacing, MoonIsASphere)
{
  Georeference place = OnMap(Geographic, 0.0, -60.0, 0.1, 0.1, 11, 601);
  place.EquatorialRadius = 1737400.0;
  place.Flattening = 0.0;
  place.Earth = false;
  ComputeRowSpacing(place, 0.1, 0.1, StepUnit::Degrees);
  ASSERT_EQ(place.RowSpacingX.size(), 601u);
  const double degree = 1737400.0 * RadiansPerDegree;
  EXPECT_NEAR(place.RowSpacingX[600] / (0.1 * degree), 1.0, 1e-6);
  EXPECT_NEAR(place.RowSpacingX[0] / (0.1 * degree * 0.5), 1.0, 1e-6);
  EXPECT_NEAR(place.RowSpacingY[300] / (0.1 * degree), 1.0, 1e-9);
}

TEST(RowSpacing, TrueMapsAreTakenAtTheirWord)
{
  Georeference utm = OnMap(Utm(9.0), -3e5, 4e6, 600.0, 1000.0, 1001, 1001);
  PostSpacing centre = ComputeRowSpacing(utm, 600.0, 1000.0);
  EXPECT_EQ(centre.X, 600.0);
  EXPECT_EQ(centre.Y, 1000.0);
  EXPECT_TRUE(utm.RowSpacingX.empty());

  // The Albers map of the United States in California is wrong by 0.4 % and does not follow the
  // graticule. The centre has its own lengths, and those of the posts come from the lattice.
  Georeference albers = OnMap(Albers, -2033450.0, 225272.0, 30.0, 30.0, 1100, 1100);
  centre = ComputeRowSpacing(albers, 30.0, 30.0);
  EXPECT_NE(centre.X, 30.0);
  EXPECT_NEAR(centre.X, 30.0, 0.3);
  EXPECT_TRUE(albers.RowSpacingX.empty());
}

TEST(RowSpacing, WebMercatorGetsItsTrueScale)
{
  // The map of a sphere applied to the ellipsoid: the scale is a / (N cos) to the east and a / (M
  // cos) to the north.
  Georeference place = OnMap(WebMercator, 1e6, WebMercatorY(47.0), 1000.0, 1000.0, 101, 651);
  const PostSpacing centre = ComputeRowSpacing(place, 1000.0, 1000.0);
  ASSERT_EQ(place.RowSpacingX.size(), 651u);
  ExpectSane(place);
  double longitude = 0.0, latitude = 0.0;
  for (const std::size_t row : { 0u, 325u, 650u })
  {
    WebMercator(1e6, WebMercatorY(47.0) + 1000.0 * static_cast<double>(row), longitude, latitude);
    const double degrees = 1000.0 / WgsRadius * DegreesPerRadian;
    const double east = EastMetres(latitude, degrees);
    const double north = NorthMetres(latitude, degrees) * std::cos(latitude * RadiansPerDegree);
    // The quadratic interpolation of the lattice over 650 km adds 1e-6.
    EXPECT_NEAR(place.RowSpacingX[row] / east, 1.0, 1e-5);
    EXPECT_NEAR(place.RowSpacingY[row] / north, 1.0, 1e-5);
  }
  EXPECT_EQ(centre.X, place.RowSpacingX[325]);
  EXPECT_NEAR(centre.X, 1000.0 * std::cos(49.0 * RadiansPerDegree), 20.0);
}

TEST(RowSpacing, TinyAndPlacelessRastersKeepTheirMetres)
{
  Georeference none;
  none.Columns = none.Rows = 5;
  EXPECT_EQ(ComputeRowSpacing(none, 3.0, 4.0).Y, 4.0);
  EXPECT_THROW(ComputeRowSpacing(none, 3.0, 4.0, StepUnit::Degrees), std::invalid_argument);

  // Micrometres: longitudes and geodesics have no digits left.
  Georeference tiny = OnMap(Utm(9.0), 1e5, 5e6, 1e-6, 1e-6, 101, 101);
  EXPECT_EQ(ComputeRowSpacing(tiny, 1e-6, 1e-6).X, 1e-6);
  EXPECT_TRUE(tiny.RowSpacingX.empty());
  // Millimetres, over ten metres.
  Georeference fine = OnMap(Utm(9.0), 1e5, 5e6, 1e-3, 1e-3, 10001, 101);
  EXPECT_EQ(ComputeRowSpacing(fine, 1e-3, 1e-3).X, 1e-3);
  EXPECT_TRUE(fine.RowSpacingX.empty());
}

TEST(RowSpacing, RefusesSteps)
{
  Georeference place = OnMap(Geographic, 0.0, 0.0, 0.1, 0.1, 11, 11);
  for (const double step : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity() })
  {
    EXPECT_THROW(ComputeRowSpacing(place, step, 0.1, StepUnit::Degrees), std::invalid_argument);
    EXPECT_THROW(ComputeRowSpacing(place, 0.1, step, StepUnit::Degrees), std::invalid_argument);
  }
}

// Found by a fuzzer: after a full turn the distance to the next post is 0 m.
TEST(RowSpacing, RefusesStepsAroundTheBodyOrTooSmallToMeasure)
{
  for (const double step : { 200.0, 360.0, 720.0, 1e-320 })
  {
    Georeference place = OnMap(Geographic, 0.0, 0.0, step, 0.1, 3, 3);
    EXPECT_THROW(ComputeRowSpacing(place, step, 0.1, StepUnit::Degrees), std::invalid_argument)
      << step;
  }
}

TEST(RowBands, CoverAllRowsWithinTheTolerance)
{
  Georeference place = OnMap(Geographic, 5.0, 0.0, 0.05, 0.05, 11, 1201);
  const PostSpacing centre = ComputeRowSpacing(place, 0.05, 0.05, StepUnit::Degrees);
  for (const double tolerance : { RowBandTolerance, 0.05, 0.0 })
  {
    const std::vector<RowBand> bands = RowBands(GroundMetric(place, centre), tolerance);
    std::ptrdiff_t next = 0;
    for (const RowBand& band : bands)
    {
      ASSERT_EQ(band.RowBegin, next);
      ASSERT_GT(band.RowEnd, band.RowBegin);
      for (std::ptrdiff_t row = band.RowBegin; row < band.RowEnd; ++row)
      {
        const auto index = static_cast<std::size_t>(row);
        ASSERT_LE(std::abs(place.RowSpacingX[index] / band.SpacingX - 1.0), tolerance + 1e-15);
        ASSERT_LE(std::abs(place.RowSpacingY[index] / band.SpacingY - 1.0), tolerance + 1e-15);
      }
      next = band.RowEnd;
    }
    EXPECT_EQ(next, place.Rows);
    // The number of bands is as small as the ratio of the widths, 2 (0.69 as a logarithm), allows,
    // plus some bands because rows are not divided.
    if (tolerance > 0.0)
    {
      EXPECT_LE(static_cast<double>(bands.size()), 1.0 + 1.1 * std::log(2.0) / (2.0 * tolerance));
    }
  }
}

TEST(RowBands, OneBandForOneSpacing)
{
  Georeference place;
  place.Rows = 77;
  const GroundMetric metric(place, { 2.0, 3.0 });
  const std::vector<RowBand> bands = RowBands(metric);
  ASSERT_EQ(bands.size(), 1u);
  EXPECT_EQ(bands[0].RowBegin, 0);
  EXPECT_EQ(bands[0].RowEnd, 77);
  EXPECT_EQ(bands[0].SpacingX, 2.0);
  EXPECT_EQ(bands[0].SpacingY, 3.0);
  EXPECT_THROW(RowBands(metric, -1.0), std::invalid_argument);
}
