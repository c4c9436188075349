// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/SunPosition.h"

#include "Shared/Constants.h"
#include "Testing/Module/NumberTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace skyline;

namespace
{

/// NREL states an uncertainty of 0.0003 degrees for its algorithm.
constexpr double NrelTolerance = 0.0003;

/// UT1 - UTC of up to 0.9 s is 0.0038 degrees. Refraction formulas differ by 0.1 arcminutes (0.0017
/// degrees). The table is rounded to 0.0001 degrees.
constexpr double JplTolerance = 0.01;

Air MakeAir(double pressure, double temperature)
{
  Air air;
  air.PressureHPa = pressure;
  air.TemperatureC = temperature;
  return air;
}

Air NoAir()
{
  Air air;
  air.Refracts = false;
  return air;
}

double Turn(double a, double b)
{
  return std::remainder(a - b, 360.0);
}

/// The second after 0h UTC of a date at which the elevation without air passes `level`, between
/// `begin` and `end`. Seconds of earlier and later days are negative or greater than a day.
double Crossing(const std::string& date, double begin, double end, double level)
{
  const auto elevation = [&](double second)
  {
    UtcTime time = ParseUtcTime(date);
    const double day = std::floor(second / 86400.0);
    const double rest = second - 86400.0 * day;
    const int whole = static_cast<int>(rest);
    time.Day += static_cast<int>(day);
    time.Hour = whole / 3600;
    time.Minute = whole / 60 % 60;
    time.Second = whole % 60 + (rest - whole);
    return ComputeSun(time, -105.1786, 39.742476, 1830.14, NoAir()).Elevation - level;
  };
  const bool rising = elevation(begin) < 0.0;
  while (end - begin > 0.01)
  {
    const double middle = 0.5 * (begin + end);
    ((elevation(middle) < 0.0) == rising ? begin : end) = middle;
  }
  return begin;
}

double Seconds(const std::string& clock)
{
  double seconds = 3600.0 * std::stod(clock.substr(0, 2)) + 60.0 * std::stod(clock.substr(3, 2));
  return clock.size() > 5 ? seconds + std::stod(clock.substr(6, 2)) : seconds;
}

} // namespace

TEST(SunPosition, NrelWorkedExample)
{
  std::map<std::string, std::string> value;
  for (const TableRow& row : ReadTable("sun/solar_spa_nrel_worked_example.csv"))
  {
    value[row.at("name")] = row.at("value");
  }
  const auto number = [&](const char* name) { return std::stod(value.at(name)); };
  const Air air = MakeAir(number("pressure_mbar"), number("temperature_C"));
  const SunDirection sun = ComputeSun(ParseUtcTime(value.at("date_utc")), number("longitude_deg"),
    number("latitude_deg"), number("elevation_m"), air);

  EXPECT_NEAR(sun.Azimuth, number("Phi"), NrelTolerance);
  EXPECT_NEAR(90.0 - sun.ApparentElevation, number("theta"), NrelTolerance);
  EXPECT_NEAR(90.0 - sun.Elevation, number("theta0"), NrelTolerance);
  EXPECT_NEAR(sun.ApparentElevation - sun.Elevation, number("de"), 1e-5);
  // The geocentric distance, within one Earth radius.
  const double radius = std::asin(SolarRadius / (number("R") * 149597870700.0)) * DegreesPerRadian;
  EXPECT_NEAR(sun.AngularRadius / radius, 1.0, 5e-5);
  RecordProperty("azimuth_error", std::to_string(sun.Azimuth - number("Phi")));
  RecordProperty("zenith_error", std::to_string(90.0 - sun.ApparentElevation - number("theta")));
}

TEST(SunPosition, PvlibExpectedValues)
{
  double worst = 0.0;
  for (const TableRow& row : ReadTable("sun/solar_pvlib_expected.csv"))
  {
    const SunDirection sun =
      ComputeSun(ParseUtcTime(row.at("utc")), Number(row, "lon_deg"), Number(row, "lat_deg"),
        Number(row, "elev_m"), MakeAir(Number(row, "pressure_mbar"), Number(row, "temp_C")));
    const double azimuth = sun.Azimuth - Number(row, "azimuth_deg_from_north_cw");
    const double elevation = sun.Elevation - Number(row, "elevation_deg_airless");
    const double apparent = sun.ApparentElevation - Number(row, "apparent_elevation_deg");
    EXPECT_NEAR(azimuth, 0.0, NrelTolerance) << row.at("note");
    EXPECT_NEAR(elevation, 0.0, NrelTolerance) << row.at("note");
    EXPECT_NEAR(apparent, 0.0, NrelTolerance) << row.at("note");
    worst = std::max({ worst, std::abs(azimuth), std::abs(elevation), std::abs(apparent) });
  }
  RecordProperty("worst_error", std::to_string(worst));
}

TEST(SunPosition, JplHorizons)
{
  double worstAzimuth = 0.0, worstOnSky = 0.0, worstAirless = 0.0, worstRefracted = 0.0;
  int airless = 0, refracted = 0;
  for (const TableRow& row : ReadTable("sun/solar_jpl_horizons.csv"))
  {
    const bool air = row.at("refraction(1=standard,0=airless)") == "1";
    const SunDirection sun = ComputeSun(ParseUtcTime(row.at("utc")), Number(row, "lon_deg_east"),
      Number(row, "lat_deg"), Number(row, "height_m"), Air());
    const double elevation = Number(row, "elevation_deg");
    // Near the zenith a tiny displacement is a large azimuth, so angles on the sky are compared.
    const double azimuth = Turn(sun.Azimuth, Number(row, "azimuth_deg_from_north_cw"));
    const double onSky = azimuth * std::cos(elevation * RadiansPerDegree);
    EXPECT_NEAR(onSky, 0.0, JplTolerance) << row.at("utc");
    worstOnSky = std::max(worstOnSky, std::abs(onSky));
    if (elevation < 80.0)
    {
      EXPECT_NEAR(azimuth, 0.0, JplTolerance) << row.at("utc");
      worstAzimuth = std::max(worstAzimuth, std::abs(azimuth));
    }
    if (!air)
    {
      EXPECT_NEAR(sun.Elevation, elevation, JplTolerance) << row.at("utc");
      worstAirless = std::max(worstAirless, std::abs(sun.Elevation - elevation));
      ++airless;
    }
    else if (elevation > 0.0)
    {
      EXPECT_NEAR(sun.ApparentElevation, elevation, JplTolerance) << row.at("utc");
      worstRefracted = std::max(worstRefracted, std::abs(sun.ApparentElevation - elevation));
      ++refracted;
    }
  }
  EXPECT_GT(airless, 100);
  EXPECT_GT(refracted, 100);
  RecordProperty("worst_on_sky", std::to_string(worstOnSky));
  RecordProperty("worst_azimuth_below_80", std::to_string(worstAzimuth));
  RecordProperty("worst_airless", std::to_string(worstAirless));
  RecordProperty("worst_refracted", std::to_string(worstRefracted));
}

TEST(SunPosition, RiseSetAndTransitInGolden)
{
  // At sunrise and sunset the centre is 50 arcminutes below the horizon. NREL computes it for the
  // centre of the Earth (9 arcseconds, 1 s) and gives whole seconds; the Observatory gives whole
  // minutes.
  const double level = -(0.26667 + 0.5667);
  const double zone = 7.0 * 3600.0;
  for (const TableRow& row : ReadTable("sun/solar_rise_set_golden_co.csv"))
  {
    const bool observatory = row.at("origin") == "USNO";
    const double tolerance = observatory ? 31.0 + 1.0 : 2.0;
    const std::string& date = row.at("date");
    const double day = 24.0 * 3600.0, noon = 12.0 * 3600.0 + zone;
    const double rise = Crossing(date, zone, noon, level);
    double set = Crossing(date, noon, noon + 0.5 * day, level);
    // NREL's calculator uses the UTC day; in summer its sunset is that of the evening before.
    if (!observatory && set > day)
    {
      set = day + Crossing(date, noon - day, noon - 0.5 * day, level);
    }
    EXPECT_NEAR(rise - zone, Seconds(row.at("sunrise_MST")), tolerance) << date;
    EXPECT_NEAR(set - zone, Seconds(row.at("sunset_MST")), tolerance) << date;

    // At the transit the sun is in the south, where its azimuth changes faster than 15 degrees per
    // hour.
    const double seconds = Seconds(row.at("transit_MST")) + zone;
    UtcTime transit = ParseUtcTime(date);
    transit.Hour = static_cast<int>(seconds) / 3600;
    transit.Minute = static_cast<int>(seconds) / 60 % 60;
    transit.Second = static_cast<int>(seconds) % 60;
    const double azimuth =
      ComputeSun(transit, -105.1786, 39.742476, 1830.14, NoAir()).Azimuth - 180.0;
    const double fastest = 3.0 * 15.0 / 3600.0; // degrees per second at an elevation of 68 degrees
    EXPECT_NEAR(azimuth, 0.0, tolerance * fastest) << date;
  }
}

TEST(SunPosition, LeapSecondIsOneSecondLong)
{
  // UT1 - UTC was -0.4086 s before and 0.5914 s after the leap second (IERS Bulletin D 131 and C
  // 52, B 348).
  const auto elevation = [](const char* text, double ut1MinusUtc)
  { return ComputeSun(ParseUtcTime(text), 90.0, 0.0, 0.0, NoAir(), ut1MinusUtc).Elevation; };
  const double before = elevation("2016-12-31T23:59:59Z", -0.4086);
  const double within = elevation("2016-12-31T23:59:60Z", -0.4086);
  const double after = elevation("2017-01-01T00:00:00Z", 0.5914);
  // Here the sun rises vertically, by 15 degrees per hour times the cosine of its declination.
  const double second = 15.0 / 3600.0 * std::cos(23.02 * RadiansPerDegree);
  EXPECT_NEAR(within - before, second, 1e-5);
  EXPECT_NEAR(after - within, second, 1e-5);
}

TEST(SunPosition, Ut1MinusUtcTurnsTheSky)
{
  const UtcTime noon = ParseUtcTime("2020-03-20T06:00Z");
  const double turn = ComputeSun(noon, 0.0, 0.0, 0.0, NoAir(), 0.9).Elevation -
    ComputeSun(noon, 0.0, 0.0, 0.0, NoAir()).Elevation;
  EXPECT_NEAR(turn, 0.9 * 15.0411 / 3600.0, 1e-5);
  EXPECT_THROW(SunEphemeris(noon, 1.5), std::out_of_range);
  EXPECT_THROW(SunEphemeris(noon, std::nan("")), std::out_of_range);
}

TEST(SunPosition, PolesAndAntimeridian)
{
  const SunEphemeris sun(ParseUtcTime("2026-06-21T06:00Z"));
  // At the poles the elevation is the declination, for any longitude.
  const double north = sun.At(0.0, 90.0, 0.0, NoAir()).Elevation;
  EXPECT_NEAR(north, 23.436, 0.003 + 0.001); // the obliquity minus the parallax
  for (double longitude = -180.0; longitude <= 540.0; longitude += 45.0)
  {
    EXPECT_NEAR(sun.At(longitude, 90.0, 0.0, NoAir()).Elevation, north, 1e-9);
    EXPECT_NEAR(sun.At(longitude, -90.0, 0.0, NoAir()).Elevation, -north, 0.006);
    EXPECT_NEAR(Turn(sun.At(longitude, 90.0, 0.0, NoAir()).Azimuth,
                  sun.At(0.0, 90.0, 0.0, NoAir()).Azimuth + longitude),
      0.0, 1e-9);
    const SunDirection once = sun.At(longitude, 40.0, 0.0, Air());
    const SunDirection again = sun.At(longitude + 360.0, 40.0, 0.0, Air());
    EXPECT_NEAR(Turn(once.Azimuth, again.Azimuth), 0.0, 1e-9);
    EXPECT_NEAR(once.ApparentElevation, again.ApparentElevation, 1e-9);
  }
}

TEST(SunPosition, AzimuthIsContinuousAcrossNorthAndWithinItsRange)
{
  // In the southern hemisphere the sun passes north at noon.
  double previous = 0.0;
  for (int minute = 0; minute < 24 * 60; ++minute)
  {
    UtcTime time = ParseUtcTime("2026-06-21");
    time.Hour = minute / 60;
    time.Minute = minute % 60;
    const SunDirection sun = ComputeSun(time, 0.0, -45.0, 0.0, Air());
    ASSERT_GE(sun.Azimuth, 0.0);
    ASSERT_LT(sun.Azimuth, 360.0);
    if (minute > 0)
    {
      ASSERT_LT(std::abs(Turn(sun.Azimuth, previous)), 1.0) << minute;
    }
    previous = sun.Azimuth;
  }
}

TEST(SunPosition, AngularRadiusFollowsTheYear)
{
  // Perihelion 0.98329 au and aphelion 1.01671 au. An Earth radius of 4e-5 au is below the
  // tolerance.
  const double perihelion =
    ComputeSun(ParseUtcTime("2026-01-03T17:00Z"), 0.0, 50.0, 0.0, Air()).AngularRadius;
  const double aphelion =
    ComputeSun(ParseUtcTime("2026-07-06T17:00Z"), 0.0, 50.0, 0.0, Air()).AngularRadius;
  EXPECT_NEAR(perihelion, MeanSunRadius / 0.98330, 3e-5);
  EXPECT_NEAR(aphelion, MeanSunRadius / 1.01664, 3e-5);
}

TEST(SunPosition, RefusesTimesAndPlacesItCannotSee)
{
  EXPECT_NO_THROW(SunEphemeris(ParseUtcTime("1900-01-02")));
  EXPECT_NO_THROW(SunEphemeris(ParseUtcTime("2099-12-31")));
  for (const char* text : { "1899-01-01", "2101-01-01", "0000-01-01", "9999-12-31" })
  {
    try
    {
      SunEphemeris sun(ParseUtcTime(text));
      ADD_FAILURE() << text;
    }
    catch (const std::out_of_range& error)
    {
      const std::string reason = error.what();
      EXPECT_NE(reason.find(text), std::string::npos) << reason;
      EXPECT_NE(reason.find("1900-01-01 to 2100-01-01"), std::string::npos) << reason;
    }
  }
  UtcTime time;
  time.Year = -5000;
  EXPECT_THROW(SunEphemeris{ time }, std::out_of_range);
  time = UtcTime();
  time.Month = 13;
  EXPECT_THROW(SunEphemeris{ time }, std::invalid_argument);
  time = UtcTime();
  time.Second = 60.0;
  EXPECT_THROW(SunEphemeris{ time }, std::invalid_argument);
  time.Second = std::nan("");
  EXPECT_THROW(SunEphemeris{ time }, std::invalid_argument);

  const SunEphemeris sun{ UtcTime() };
  EXPECT_THROW(sun.At(0.0, 90.1, 0.0, Air()), std::out_of_range);
  EXPECT_THROW(sun.At(0.0, std::nan(""), 0.0, Air()), std::out_of_range);
  EXPECT_THROW(sun.At(HUGE_VAL, 0.0, 0.0, Air()), std::out_of_range);
  EXPECT_THROW(sun.At(0.0, 0.0, std::nan(""), Air()), std::out_of_range);
  EXPECT_TRUE(std::isfinite(sun.At(0.0, 0.0, 1e7, Air()).ApparentElevation));
}
