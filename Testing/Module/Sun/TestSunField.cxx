// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/SunField.h"

#include "Sun/SunPosition.h"
#include "Testing/Module/Geo/Places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

using namespace skyline;

namespace
{

/// Unit vectors are floats: 6e-8 radians per component.
constexpr double FloatTolerance = 1.5e-5; // degrees

struct Direction
{
  double X, Y, Z;
};

Direction FromAngles(double azimuth, double elevation)
{
  const double a = azimuth * RadiansPerDegree, e = elevation * RadiansPerDegree;
  return { std::cos(e) * std::sin(a), std::cos(e) * std::cos(a), std::sin(e) };
}

double Angle(const Direction& a, const Direction& b)
{
  const double chord = std::hypot(std::hypot(a.X - b.X, a.Y - b.Y), a.Z - b.Z);
  return 2.0 * std::asin(0.5 * chord) * DegreesPerRadian;
}

/// The sun at a post, computed without a field.
Direction Direct(
  const Georeference& place, const UtcTime& time, double height, double column, double row)
{
  double longitude = 0.0, latitude = 0.0;
  place.LonLatAt(column, row, longitude, latitude);
  const SunDirection sun = ComputeSun(time, longitude, latitude, height, StandardAir(height));
  return FromAngles(place.GridAzimuthAt(column, row, sun.Azimuth), sun.ApparentElevation);
}

/// The greatest angle between the field and the direct computation, at some hundred posts.
double WorstError(const Georeference& place, const std::string& text)
{
  const UtcTime time = ParseUtcTime(text);
  const SunField field(place, time, 1000.0);
  double worst = 0.0;
  const double lastColumn = static_cast<double>(place.Columns - 1);
  const double lastRow = static_cast<double>(place.Rows - 1);
  for (double u = 0.0; u <= 1.0; u += 0.0617)
  {
    for (double v = 0.0; v <= 1.0; v += 0.0431)
    {
      const GridSun sun = field.At(u * lastColumn, v * lastRow);
      worst = std::max(worst,
        Angle(FromAngles(sun.Azimuth, sun.Elevation),
          Direct(place, time, 1000.0, u * lastColumn, v * lastRow)));
    }
  }
  // At the transition between two quadratics, the lattice of the place adds 1e-6.
  EXPECT_LE(worst, field.InterpolationError() + 1e-6) << text;
  return worst;
}

} // namespace

TEST(SunField, FiveDegreesAtMidLatitude)
{
  const Georeference place = OnMap(Geographic, -124.0, 43.0, 5.0 / 6000, 5.0 / 6000, 6001, 6001);
  // Morning, noon, sunset, the sun at the greatest refraction, and night.
  double worst = 0.0;
  for (const char* time : { "2026-06-21T14:00Z", "2026-06-21T20:10Z", "2026-06-22T03:55Z",
         "2026-06-22T04:15Z", "2026-12-21T08:00Z" })
  {
    const double error = WorstError(place, time);
    EXPECT_LT(error, SunFieldTolerance) << time;
    worst = std::max(worst, error);
  }
  RecordProperty("worst", std::to_string(worst));
}

TEST(SunField, MapsOfEveryKind)
{
  const struct
  {
    const char* Name;
    Georeference Place;
  } places[] = {
    { "UTM", OnMap(Utm(-123.0), -3e5, 4.9e6, 600.0, 600.0, 1001, 1001) },
    { "Albers", OnMap(Albers, -2033435.0, 225272.0, 30.0, 30.0, 1100, 1100) },
    { "polar", OnMap(NorthPolar, -2e5, -2.1e5, 400.0, 400.0, 1001, 1001) },
    { "antimeridian", OnMap(Geographic, 178.0, -20.0, 0.01, 0.01, 501, 501) },
    { "pole", OnMap(Geographic, -30.0, 88.0, 0.01, 0.01, 6001, 201) },
    { "2 x 2", OnMap(Utm(-123.0), 1e5, 4.9e6, 30.0, 30.0, 2, 2) },
    { "60 degrees", OnMap(Geographic, -120.0, 10.0, 0.1, 0.1, 601, 601) },
  };
  double worst = 0.0;
  for (const auto& entry : places)
  {
    for (const char* time : { "2026-06-21T06:00Z", "2026-06-21T15:00Z", "2026-06-21T20:00Z" })
    {
      const double error = WorstError(entry.Place, time);
      EXPECT_LT(error, SunFieldTolerance) << entry.Name << ' ' << time;
      worst = std::max(worst, error);
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

TEST(SunField, AzimuthsCountFromGridNorth)
{
  const Georeference place = OnMap(Albers, -2033435.0, 225272.0, 30.0, 30.0, 1100, 1100);
  const UtcTime time = ParseUtcTime("2026-06-21T14:00Z");
  double longitude = 0.0, latitude = 0.0;
  place.LonLatAt(549.5, 549.5, longitude, latitude);
  const SunDirection sun = ComputeSun(time, longitude, latitude, 2000.0, StandardAir(2000.0));
  const GridSun grid = SunField(place, time, 2000.0).At(549.5, 549.5);
  EXPECT_NEAR(grid.Elevation, sun.ApparentElevation, SunFieldTolerance);
  EXPECT_EQ(grid.Radius, sun.AngularRadius);
  // Grid north points 14 degrees west of true north. Albers distorts angles by up to half a degree.
  EXPECT_NEAR(grid.Azimuth, sun.Azimuth + 14.0, 0.6);
}

TEST(SunField, RowsAreTheSameSun)
{
  const Georeference place = OnMap(Geographic, 178.0, -20.0, 0.01, 0.01, 501, 301);
  const SunField field(place, ParseUtcTime("2026-03-21T20:00Z"), 0.0);
  for (const std::ptrdiff_t row : { 0, 1, 150, 299, 300 })
  {
    const std::ptrdiff_t begin = row == 150 ? 77 : 0, count = 501 - begin;
    std::vector<float> x(501), y(501), z(501);
    field.Row(row, begin, count, x.data(), y.data(), z.data());
    for (std::ptrdiff_t i = 0; i < count; ++i)
    {
      const GridSun sun = field.At(static_cast<double>(begin + i), static_cast<double>(row));
      const auto k = static_cast<std::size_t>(i);
      ASSERT_NEAR(
        Angle({ x[k], y[k], z[k] }, FromAngles(sun.Azimuth, sun.Elevation)), 0.0, FloatTolerance);
    }
  }
}

TEST(SunField, ConstantIsWhatWasAskedFor)
{
  const SunField field = SunField::Constant(315.0, 45.0, 0.26645);
  const GridSun sun = field.At(1234.5, -7.0);
  EXPECT_NEAR(sun.Azimuth, 315.0, 1e-12);
  EXPECT_NEAR(sun.Elevation, 45.0, 1e-12);
  EXPECT_EQ(sun.Radius, 0.26645);
  EXPECT_EQ(field.InterpolationError(), 0.0);
  EXPECT_NEAR(SunField::Constant(-45.0, 10.0, 0.0).At(0.0, 0.0).Azimuth, 315.0, 1e-12);
  EXPECT_NEAR(SunField::Constant(725.0, 10.0, 0.0).At(0.0, 0.0).Azimuth, 5.0, 1e-12);
  EXPECT_NEAR(SunField::Constant(10.0, 90.0, 0.0).At(0.0, 0.0).Elevation, 90.0, 1e-12);
  float x = 0.0f, y = 0.0f, z = 0.0f;
  SunField::Constant(90.0, 0.0, 0.0).Row(5, 5, 1, &x, &y, &z);
  EXPECT_FLOAT_EQ(x, 1.0f);

  double first = 0.0, last = 0.0;
  field.AzimuthBounds(first, last);
  EXPECT_NEAR(first, 315.0, 1e-12);
  EXPECT_EQ(first, last);
  field.ElevationBounds(first, last);
  EXPECT_NEAR(first, 45.0, 1e-12);
  EXPECT_NEAR(last, 45.0, 1e-12);

  EXPECT_THROW(SunField::Constant(std::nan(""), 45.0, 0.3), std::out_of_range);
  EXPECT_THROW(SunField::Constant(0.0, 90.1, 0.3), std::out_of_range);
  EXPECT_THROW(SunField::Constant(0.0, std::nan(""), 0.3), std::out_of_range);
  EXPECT_THROW(SunField::Constant(0.0, 45.0, -0.1), std::out_of_range);
  EXPECT_THROW(SunField::Constant(0.0, 45.0, 90.0), std::out_of_range);
}

TEST(SunField, BoundsHoldEveryAzimuth)
{
  const struct
  {
    const char* Name;
    Georeference Place;
    const char* Time;
    double Narrowest, Widest;
  } cases[] = {
    { "morning", OnMap(Geographic, -124.0, 43.0, 0.01, 0.01, 501, 501), "2026-06-21T14:00Z", 1, 6 },
    // In the southern hemisphere the sun is north at noon, so the arc crosses 360 degrees.
    { "north", OnMap(Geographic, -2.5, -45.0, 0.01, 0.01, 501, 501), "2026-06-21T12:00Z", 4, 7 },
    // The sun at the zenith of a post: all azimuths.
    { "zenith", OnMap(Geographic, -2.5, -2.5, 0.01, 0.01, 501, 501), "2026-03-20T12:08Z", 360,
      360 },
    // The sun at the zenith just outside, seen from up to 4 degrees of longitude to the west and as
    // far south.
    { "beside", OnMap(Geographic, -4.6, -2.0, 0.01, 0.01, 401, 401), "2026-03-20T12:08Z", 90, 180 },
  };
  for (const auto& entry : cases)
  {
    const SunField field(entry.Place, ParseUtcTime(entry.Time), 0.0);
    double first = 0.0, last = 0.0, least = 0.0, greatest = 0.0;
    field.AzimuthBounds(first, last);
    field.ElevationBounds(least, greatest);
    EXPECT_GE(first, 0.0) << entry.Name;
    EXPECT_LE(first, 360.0) << entry.Name;
    EXPECT_GE(last - first, entry.Narrowest) << entry.Name;
    EXPECT_LE(last - first, entry.Widest) << entry.Name;
    for (double column = 0.0; column <= 400.0; column += 3.7)
    {
      for (double row = 0.0; row <= 400.0; row += 4.1)
      {
        const GridSun sun = field.At(column, row);
        const double past = sun.Azimuth - first + (sun.Azimuth < first ? 360.0 : 0.0);
        ASSERT_LE(past, last - first + 1e-9) << entry.Name << ' ' << column << ' ' << row;
        ASSERT_GE(sun.Elevation, least - SunFieldTolerance) << entry.Name;
      }
    }
  }
}

TEST(SunField, RefusesOtherBodiesAndNoPlace)
{
  Georeference moon = OnMap(Geographic, 0.0, 0.0, 0.01, 0.01, 11, 11);
  moon.EquatorialRadius = 1737400.0;
  moon.Flattening = 0.0;
  moon.Earth = false;
  const UtcTime time = ParseUtcTime("2026-06-21T06:00Z");
  EXPECT_THROW(SunField(moon, time, 0.0), std::invalid_argument);
  EXPECT_THROW(SunField(Georeference(), time, 0.0), std::invalid_argument);
  const Georeference place = OnMap(Geographic, 0.0, 0.0, 0.01, 0.01, 11, 11);
  EXPECT_THROW(SunField(place, time, std::nan("")), std::invalid_argument);
  EXPECT_THROW(SunField(place, ParseUtcTime("2150-01-01"), 0.0), std::out_of_range);
}
