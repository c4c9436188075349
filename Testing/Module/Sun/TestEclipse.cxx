// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/Eclipse.h"

#include "Geo/Azimuth.h"
#include "Shared/Constants.h"
#include "Sun/Astronomy.h"
#include "Testing/Module/Geo/Places.h"
#include "Testing/Module/NumberTable.h"

#include <erfa.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace skyline;

namespace
{

UtcTime At(const std::string& date, double second)
{
  UtcTime time = ParseUtcTime(date);
  const int whole = static_cast<int>(second);
  time.Hour = whole / 3600;
  time.Minute = whole / 60 % 60;
  time.Second = whole % 60 + (second - whole);
  return time;
}

double Clock(int hour, int minute, double second)
{
  return 3600.0 * hour + 60.0 * minute + second;
}

struct Place
{
  double Longitude, Latitude, Height;
};

/// The distance between the rims of the discs. It is negative while the discs overlap (outer
/// contact) or while one lies within the other (inner contact).
double Rims(const std::string& date, double second, const Place& place, bool inner)
{
  const SunAndMoon seen =
    EclipseEphemeris(At(date, second)).At(place.Longitude, place.Latitude, place.Height);
  return seen.Distance() - (inner ? std::abs(seen.Cover - 1.0) : seen.Cover + 1.0);
}

/// The second at which the rims touch. It lies between a second outside the contact and a second
/// inside.
double Contact(
  const std::string& date, double outside, double inside, const Place& place, bool inner)
{
  EXPECT_GT(Rims(date, outside, place, inner), 0.0) << date;
  EXPECT_LT(Rims(date, inside, place, inner), 0.0) << date;
  while (std::abs(inside - outside) > 0.05)
  {
    const double middle = 0.5 * (inside + outside);
    (Rims(date, middle, place, inner) < 0.0 ? inside : outside) = middle;
  }
  return inside;
}

double Share(const std::string& time, const Place& place)
{
  return EclipseEphemeris(ParseUtcTime(time))
    .At(place.Longitude, place.Latitude, place.Height)
    .Obscuration();
}

/// The errors that the authors of eraMoon98 found, in arcseconds: root mean square, and the
/// greatest one.
constexpr double MoonError = 2.9;
constexpr double WorstMoonError = 18.3;

/// Arcseconds: the table is rounded to 0.00001 degrees; the rest is polar motion, and UT1 - UTC in
/// the parallax.
constexpr double TableError = 0.5;

/// Seconds. The Moon moves across the sun by 0.4 arcseconds per second: twice MoonError is 15 s.
constexpr double ContactError = 15.0;

/// The catalogue uses the radii k = 0.272281 for the Moon (for totality) and 959.63 arcseconds at 1
/// au for the sun. Skyline uses 0.2725076 and 695700 km, which is 959.22 arcseconds. The ratios of
/// the catalogue are smaller by this factor.
constexpr double RatioOfRatios = 0.2725076 / 0.272281 * 959.63 / 959.22;

/// The ratios of the catalogue have four digits, and its durations are whole seconds. Its positions
/// are rounded to 0.1 degrees and lie up to 7 km from the centre of the shadow.
constexpr double RatioError = 0.0002;
constexpr double DurationError = 1.5;

} // namespace

// In coordinates of the true equator, UT1 - UTC (up to 0.9 s, or 13 arcseconds of azimuth) has
// almost no effect.
TEST(Eclipse, TheMoonOfJplHorizons)
{
  double squares = 0.0;
  int count = 0;
  for (const TableRow& row : ReadTable("sun/lunar_jpl_horizons.csv"))
  {
    const UtcTime time = ParseUtcTime(row.at("utc"));
    const std::array<double, 3> moon = EclipseEphemeris(time).MoonFromEarthCentre();
    const std::array<double, 3> place =
      FromEarthCentre(Number(row, "lon_deg_east"), Number(row, "lat_deg"), Number(row, "height_m"));
    const double x = moon[0] - place[0], y = moon[1] - place[1], z = moon[2] - place[2];
    const AstronomicalTimes times = ConvertUtc(time, 0.0);
    const double ascension = DegreesPerRadian *
      (std::atan2(y, x) + eraGst06a(times.Ut11, times.Ut12, times.Tt1, times.Tt2));
    const double declination = DegreesPerRadian * std::atan2(z, std::hypot(x, y));
    const double table = Number(row, "dec_apparent_deg");
    const double north = 3600.0 * (declination - table);
    const double east = 3600.0 * std::cos(table * RadiansPerDegree) *
      std::remainder(ascension - Number(row, "ra_apparent_deg"), 360.0);
    EXPECT_LT(std::hypot(north, east), WorstMoonError + TableError) << row.at("utc");
    squares += north * north + east * east;
    ++count;

    // In the local sky, UT1 - UTC does have an effect (0.0038 degrees).
    const LocalVector seen =
      SeenFrom(moon, Number(row, "lon_deg_east"), Number(row, "lat_deg"), Number(row, "height_m"));
    EXPECT_NEAR(std::atan2(seen.Up, std::hypot(seen.East, seen.North)) * DegreesPerRadian,
      Number(row, "elevation_deg"), 0.009);
    EXPECT_NEAR(
      std::remainder(
        AzimuthOf(seen.East, seen.North) - Number(row, "azimuth_deg_from_north_cw"), 360.0) *
        std::cos(Number(row, "elevation_deg") * RadiansPerDegree),
      0.0, 0.009);
  }
  ASSERT_GT(count, 250);
  const double error = std::sqrt(squares / count);
  RecordProperty("rms_arcseconds", std::to_string(error));
  EXPECT_LT(error, MoonError + TableError);
}

// The total eclipse in Burgos, as published by the province of Burgos: 20:28:19 to 20:30:03 summer
// time.
TEST(Eclipse, TotalAtBurgos)
{
  const std::string date = "2026-08-12T00:00Z";
  const Place burgos{ -3.70, 42.34, 860.0 };
  const double middle = Clock(18, 29, 11.0);
  const double begin = Contact(date, Clock(18, 20, 0), middle, burgos, true);
  const double end = Contact(date, Clock(18, 40, 0), middle, burgos, true);
  EXPECT_NEAR(begin, Clock(18, 28, 19), ContactError);
  EXPECT_NEAR(end, Clock(18, 30, 3), ContactError);
  EXPECT_NEAR(end - begin, 104.0, 5.0);
  RecordProperty("begin_minus_table", std::to_string(begin - Clock(18, 28, 19)));
  RecordProperty("end_minus_table", std::to_string(end - Clock(18, 30, 3)));
  EXPECT_EQ(Share("2026-08-12T18:29:10Z", burgos), 1.0);
  EXPECT_EQ(Share("2026-08-12T16:00Z", burgos), 0.0);
  EXPECT_NEAR(Contact(date, Clock(17, 0, 0), middle, burgos, false), Clock(17, 33, 0), 300.0);
}

// Greatest eclipses from the catalogue of F. Espenak (NASA): time (TD minus TT - UTC), place, ratio
// of the diameters, duration. The centre of the Moon's disc crosses that of the sun, so the
// duration depends on the difference of the radii.
TEST(Eclipse, GreatestEclipsesOfTheCatalogue)
{
  struct Row
  {
    const char* Date;
    double Second;
    Place Where;
    double Magnitude, Duration;
  };
  const Row rows[] = {
    { "1999-08-11T00:00Z", Clock(11, 4, 9) - 64.184, { 24.3, 45.1, 0.0 }, 1.0286, 143.0 },
    { "2017-08-21T00:00Z", Clock(18, 26, 40) - 69.184, { -87.7, 37.0, 0.0 }, 1.0306, 160.0 },
    { "2023-10-14T00:00Z", Clock(18, 0, 41) - 69.184, { -83.1, 11.4, 0.0 }, 0.9520, 317.0 },
    { "2024-04-08T00:00Z", Clock(18, 18, 29) - 69.184, { -104.1, 25.3, 0.0 }, 1.0566, 268.0 },
    { "2026-08-12T00:00Z", Clock(17, 47, 6) - 69.184, { -25.2, 65.2, 0.0 }, 1.0386, 138.0 },
  };
  for (const Row& row : rows)
  {
    const SunAndMoon seen = EclipseEphemeris(At(row.Date, row.Second))
                              .At(row.Where.Longitude, row.Where.Latitude, row.Where.Height);
    const double ratio = row.Magnitude * RatioOfRatios;
    const double duration = row.Duration * (ratio - 1.0) / (row.Magnitude - 1.0);
    EXPECT_NEAR(seen.Magnitude(), ratio, RatioError) << row.Date;
    EXPECT_EQ(seen.Magnitude() > 1.0, seen.Obscuration() == 1.0) << row.Date;
    const double begin = Contact(row.Date, row.Second - 1000.0, row.Second, row.Where, true);
    const double end = Contact(row.Date, row.Second + 1000.0, row.Second, row.Where, true);
    EXPECT_NEAR(end - begin, duration, DurationError) << row.Date;
    EXPECT_NEAR(0.5 * (begin + end), row.Second, ContactError) << row.Date;
    RecordProperty(std::string("duration_") + row.Date, std::to_string(end - begin));
    RecordProperty(
      std::string("middle_") + row.Date, std::to_string(0.5 * (begin + end) - row.Second));
  }
  // An annular eclipse leaves a ring: the covered share is the square of the ratio.
  const double ratio = 0.9520 * RatioOfRatios;
  EXPECT_NEAR(Share("2023-10-14T17:59:32Z", { -83.1, 11.4, 0.0 }), ratio * ratio, 2.0 * RatioError);
}

TEST(Eclipse, NoneElsewhereOrAtOtherTimes)
{
  // A new moon whose shadow misses the Earth, and a full moon.
  EXPECT_FALSE(EclipseEphemeris(ParseUtcTime("2026-07-14T09:44Z")).Possible());
  EXPECT_FALSE(EclipseEphemeris(ParseUtcTime("2026-08-28T04:00Z")).Possible());
  EXPECT_TRUE(EclipseEphemeris(ParseUtcTime("2026-08-12T17:46Z")).Possible());
  EXPECT_EQ(Share("2026-08-12T17:46Z", { -3.7, -60.0, 0.0 }), 0.0);
}

TEST(EclipseField, IsTheEclipseOfEveryPost)
{
  struct Case
  {
    Georeference Place;
    const char* Time;
  };
  // A degree around Burgos; the North Atlantic with the whole path; the whole globe.
  const Case cases[] = {
    { OnMap(Geographic, -4.2, 41.8, 0.01, 0.01, 101, 101), "2026-08-12T18:28:20Z" },
    { OnMap(Geographic, -60.0, 30.0, 0.5, 0.5, 161, 101), "2026-08-12T17:46Z" },
    { OnMap(Geographic, -180.0, -89.5, 1.0, 1.0, 361, 180), "2024-04-08T18:17Z" },
  };
  for (const Case& one : cases)
  {
    const UtcTime time = ParseUtcTime(one.Time);
    const EclipseField field(one.Place, time, 800.0);
    ASSERT_TRUE(field.Any());
    const EclipseEphemeris ephemeris(time);
    double worst = 0.0, most = 0.0, least = 1.0;
    std::vector<float> left(static_cast<std::size_t>(one.Place.Columns));
    for (std::ptrdiff_t row = 0; row < one.Place.Rows; ++row)
    {
      field.Uncovered(row, 0, one.Place.Columns, 0.0, left.data());
      for (std::ptrdiff_t column = 0; column < one.Place.Columns; column += 3)
      {
        double longitude = 0.0, latitude = 0.0;
        one.Place.LonLatAt(
          static_cast<double>(column), static_cast<double>(row), longitude, latitude);
        const double share = 1.0 - ephemeris.At(longitude, latitude, 800.0).Obscuration();
        const double found = left[static_cast<std::size_t>(column)];
        worst = std::max(worst, std::abs(share - found));
        most = std::max(most, found);
        least = std::min(least, found);
      }
    }
    EXPECT_LT(worst, EclipseTolerance) << one.Time;
    EXPECT_EQ(least, 0.0) << one.Time;
    EXPECT_GT(most, 0.001) << one.Time;
  }
}

TEST(EclipseField, CostsNothingWhereThereIsNone)
{
  Georeference burgos = OnMap(Geographic, -4.2, 41.8, 0.01, 0.01, 101, 101);
  float left = 0.0f;
  EclipseField none(burgos, ParseUtcTime("2026-08-11T18:28Z"), 800.0);
  EXPECT_FALSE(none.Any());
  none.Uncovered(0, 0, 1, 0.0, &left);
  EXPECT_EQ(left, 1.0f);
  // The same time at another place. Eclipses are computed on the Earth only.
  EXPECT_FALSE(EclipseField(
    OnMap(Geographic, 10.0, -40.0, 0.01, 0.01, 101, 101), ParseUtcTime("2026-08-12T18:28Z"), 800.0)
                 .Any());
  burgos.Earth = false;
  EXPECT_FALSE(EclipseField(burgos, ParseUtcTime("2026-08-12T18:28Z"), 800.0).Any());
}
