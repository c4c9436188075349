# SPDX-License-Identifier: BSD-3-Clause
"""skyline sun: the printed position, and the map of sun visibility."""
import os

import Program
from Program import UTM10, ToolTest, gdal, hills, make, np, read

# The positions must agree with NREL's worked example to 0.0003 degrees.
POSITION_TOLERANCE = 3e-4


class Position(ToolTest):
    def position(self, *arguments):
        """The printed lines `name: value unit` as a dictionary."""
        values = {}
        for line in self.succeed("sun", *arguments).stdout.splitlines():
            name, text = line.split(": ")
            value, unit = text.split(" ")
            if name == "time":
                self.assertEqual(unit, "UTC")
                values[name] = value
            else:
                self.assertIn(unit, ["degree", "metre"])
                values[name] = float(value)
        return values

    def test_nrel_worked_example(self):
        # Reda and Andreas, NREL/TP-560-34302, appendix A.5: 2003-10-17 12:30:30 at UTC-7, 39.742476
        # north, 105.1786 west, 1830.14 m. Azimuth 194.34024, zenith angle 50.11162 after a
        # refraction of 0.01633 degrees.
        step = 0.001
        dem = make(self.path("dem.tif"), np.full((3, 3), 1830.14), step=(step, step),
                   corner=(-105.1786 - 1.5 * step, 39.742476 - 1.5 * step), epsg=4326)
        sun = self.position(dem, "--time", "2003-10-17T12:30:30-07:00")
        self.assertAlmostEqual(sun["azimuth"], 194.34024, delta=POSITION_TOLERANCE)
        self.assertAlmostEqual(sun["elevation"], 90.0 - 50.11162 - 0.01633,
                               delta=POSITION_TOLERANCE)
        # The air of the example, 820 hPa and 11 C, has 3 % less refraction than the standard
        # atmosphere at this height.
        self.assertAlmostEqual(sun["refracted elevation"], 90.0 - 50.11162, delta=0.001)
        # At a distance of 0.99654 astronomical units.
        self.assertAlmostEqual(sun["angular radius"], 0.26645 / 0.99654, delta=1e-3)
        self.assertAlmostEqual(sun["grid azimuth"], sun["azimuth"], delta=1e-3)
        self.assertAlmostEqual(sun["longitude"], -105.1786, delta=1e-5)
        self.assertAlmostEqual(sun["latitude"], 39.742476, delta=1e-5)
        self.assertAlmostEqual(sun["height"], 1830.14, delta=0.01)
        self.assertEqual(sun["time"], "2003-10-17T19:30:30Z")

    def test_the_first_four_lines_are_the_position(self):
        dem = make(self.path("dem.tif"), hills(5, 6), epsg=UTM10)
        lines = self.succeed("sun", dem, "--time", "2026-06-21T06:00Z").stdout.splitlines()
        names = [line.split(":")[0] for line in lines[:4]]
        self.assertEqual(
            names, ["azimuth", "elevation", "refracted elevation", "angular radius"])

    def test_time_zones(self):
        dem = make(self.path("dem.tif"), hills(5, 6), epsg=UTM10)
        utc = self.position(dem, "--time", "2026-06-21T16:00Z")
        for same in ["2026-06-21 16:00:00+00:00", "2026-06-21T18:00+02:00", "2026-06-21T09:00-07:00"]:
            self.assertEqual(self.position(dem, "--time", same), utc)

    def test_grid_north_is_turned_by_the_convergence(self):
        # 2 degrees east of the central meridian of UTM at 46 degrees north: convergence 2 sin 46 =
        # 1.44 degrees.
        x, y = 654800.0, 5095500.0
        dem = make(self.path("dem.tif"), hills(21, 21), corner=(x, y), epsg=UTM10)
        sun = self.position(dem, "--time", "2026-06-21T16:00Z")
        offset = sun["longitude"] + 123.0
        self.assertAlmostEqual(offset, 2.0, delta=0.05)
        convergence = np.degrees(
            np.arctan(np.tan(np.radians(offset)) * np.sin(np.radians(sun["latitude"]))))
        self.assertAlmostEqual(
            sun["azimuth"] - sun["grid azimuth"], convergence, delta=2e-3)

    def test_direction_counts_from_grid_north(self):
        dem = make(self.path("dem.tif"), hills(21, 21), corner=(654800.0, 5095500.0), epsg=UTM10)
        sun = self.position(dem, "--sun", "100,20")
        self.assertEqual(sun["grid azimuth"], 100.0)
        self.assertAlmostEqual(sun["azimuth"], 101.44, delta=0.05)
        self.assertEqual(sun["elevation"], 20.0)
        self.assertEqual(sun["refracted elevation"], 20.0)
        self.assertEqual(sun["angular radius"], 0.26645)

    def test_defaults_without_a_crs(self):
        sun = self.position(make(self.path("dem.tif"), hills(5, 6)))
        self.assertEqual(sun["azimuth"], 315.0)
        self.assertEqual(sun["grid azimuth"], 315.0)
        self.assertEqual(sun["elevation"], 45.0)
        self.assertNotIn("longitude", sun)

    def test_azimuths_wrap(self):
        dem = make(self.path("dem.tif"), hills(5, 6))
        for azimuth, wrapped in [("-45", 315.0), ("360", 0.0), ("725", 5.0), ("-3600", 0.0)]:
            self.assertEqual(self.position(dem, "--sun", azimuth + ",10")["azimuth"], wrapped)

    def test_an_eclipse_is_told(self):
        # Burgos on 2026-08-12: total from 18:28:19 to 18:30:03 UTC.
        dem = make(self.path("dem.tif"), np.full((5, 5), 860.0), step=(0.01, 0.01),
                   corner=(-3.725, 42.315), epsg=4326)
        sun = ["sun", dem, "--time"]

        def told(time):
            return [line for line in self.succeed(*sun, time).stdout.splitlines() if "eclipse" in line]

        self.assertEqual(told("2026-08-12T18:29:10Z")[0], "eclipse obscuration: 100.00 percent")
        self.assertRegex(told("2026-08-12T18:29:10Z")[1], r"^eclipse magnitude: 1\.03\d\d diameter$")
        partial = told("2026-08-12T18:00Z")
        self.assertRegex(partial[0], r"^eclipse obscuration: 3\d\.\d\d percent$")
        self.assertRegex(partial[1], r"^eclipse magnitude: 0\.4\d\d\d diameter$")
        for none in ["2026-08-12T17:00Z", "2026-08-11T18:29Z", "2026-02-17T12:12Z"]:
            self.assertEqual(told(none), [])  # the last time: an annular eclipse over Antarctica
        # At the antipode of the total eclipse the sun has set.
        dem = make(self.path("far.tif"), np.full((5, 5), 0.0), step=(0.01, 0.01),
                   corner=(176.3, -42.3), epsg=4326)
        self.assertNotIn("eclipse", self.succeed("sun", dem, "--time", "2026-08-12T18:29Z").stdout)

    def test_other_bodies_have_no_time(self):
        moon = 'GEOGCS["Moon",DATUM["Moon",SPHEROID["Moon",1737400,0]],PRIMEM["Reference",0],' \
               'UNIT["degree",0.0174532925199433]]'
        dem = make(self.path("dem.tif"), hills(5, 6), step=(0.01, 0.01), corner=(3.0, 20.0),
                   wkt=moon)
        self.refused(1, "sun", dem, "--time", "2026-06-21T06:00Z", says="--sun")
        self.assertEqual(self.position(dem, "--sun", "10,20")["elevation"], 20.0)

    def test_only_the_middle_of_a_large_file_is_read(self):
        self.skip_if_sanitized()
        # 30000 x 30000 posts of a sparse file: reading all of them would take seconds and
        # gigabytes.
        raster = gdal.GetDriverByName("GTiff").Create(
            self.path("large.tif"), 30000, 30000, 1, gdal.GDT_Float64,
            ["SPARSE_OK=TRUE", "TILED=YES"])
        raster.SetGeoTransform((0.0, 1.0, 0.0, 30000.0, 0.0, -1.0))
        raster = None

        # The heights alone would take 7.2e9 bytes.
        done = self.run_program(
            "sun", self.path("large.tif"), preexec_fn=Program.limit_memory(4 << 30))
        self.assertEqual(done.returncode, 0, done.stderr)


class Visibility(ToolTest):
    def visibility(self, dem, *options, out="out.tif"):
        self.succeed("sun", dem, "-o", self.path(out), *options)
        return read(self.path(out))[0]

    def test_band(self):
        heights = hills(15, 14)
        heights[3, 4] = np.nan
        dem = make(self.path("dem.tif"), heights, epsg=UTM10, nodata=-9999.0)
        values = self.visibility(dem)
        raster = gdal.Open(self.path("out.tif"))
        self.assertEqual(raster.RasterCount, 1)
        band = raster.GetRasterBand(1)
        self.assertEqual(band.GetDescription(), "SunVisibility")
        self.assertEqual(band.GetUnitType(), "1")
        self.assertEqual(band.DataType, gdal.GDT_Float32)
        self.assertEqual(band.GetNoDataValue(), -9999.0)
        self.assertTrue(np.array_equal(np.isnan(values), np.isnan(heights)))
        self.assertTrue(np.nanmin(values) >= 0.0 and np.nanmax(values) <= 1.0)

    def test_shadow_of_a_wall(self):
        # A wall of 100 m in the west, and the sun in the west at 30 degrees: the shadow extends to
        # 173.2 m.
        heights = np.zeros((21, 61))
        heights[:, 0] = 100.0
        dem = make(self.path("dem.tif"), heights, step=(10.0, 10.0))
        lit = self.visibility(dem, "--sun", "270,30")[10]
        distance = 10.0 * np.arange(61)
        self.assertTrue(np.all(lit[(distance > 0) & (distance < 170.0)] == 0.0))
        self.assertTrue(np.all(lit[distance > 177.0] == 1.0))
        east = self.visibility(dem, "--sun", "90,30")[10]
        self.assertTrue(np.all(east[1:] == 1.0))

    def test_penumbra_grows_with_the_sun(self):
        heights = np.zeros((61, 201))
        heights[:, 0] = 100.0
        dem = make(self.path("dem.tif"), heights, step=(1.0, 1.0))
        widths = []
        for radius in ["0", "0.26645", "2"]:
            lit = self.visibility(dem, "--sun", "270,45", "--sun-radius", radius)[30]
            widths.append(int(np.count_nonzero((lit > 0.0) & (lit < 1.0))))
            self.assertTrue(np.all(np.diff(lit[1:]) >= 0.0))
        # d tan(elevation) = 100 m: the edge of the shadow moves by 200 m per radian, over the
        # diameter of the sun.
        self.assertLessEqual(widths[0], 1)
        self.assertAlmostEqual(widths[1], 200.0 * np.radians(2 * 0.26645), delta=1.5)
        self.assertAlmostEqual(widths[2], 200.0 * np.radians(2 * 2.0), delta=2.0)

    def test_limb_darkening_changes_penumbrae_alone(self):
        heights = np.zeros((9, 201))
        heights[:, 0] = 100.0
        dem = make(self.path("dem.tif"), heights, step=(1.0, 1.0))
        plain = self.visibility(dem, "--sun", "270,45", "--sun-radius", "3")
        dark = self.visibility(dem, "--sun", "270,45", "--sun-radius", "3", "--limb-darkening",
                               out="dark.tif")
        self.assertTrue(np.all((dark == plain) | ((plain > 0.0) & (plain < 1.0))))
        self.assertGreater(np.abs(dark - plain).max(), 0.005)
        self.assertLess(np.abs(dark - plain).max(), 0.1)

    def test_sun_under_and_over_everything(self):
        dem = make(self.path("dem.tif"), np.full((15, 14), 80.0))
        # At the edge there is no terrain beyond, so nothing hides even this sun.
        under = self.visibility(dem, "--sun", "120,-30")
        self.assertEqual(np.max(under[1:-1, 1:-1]), 0.0)
        self.assertEqual(np.min(self.visibility(dem, "--sun", "120,90")), 1.0)

    def test_an_eclipse_dims_every_post_by_its_own_share(self):
        # 5 degrees from west to east, 400 km. At both ends the values must be the positions that
        # the program prints there.
        def level(name, west, columns):
            return make(self.path(name), np.full((9, columns), 860.0), step=(0.1, 0.1),
                        corner=(west, 41.9), epsg=4326)

        dem = level("dem.tif", -6.2, 51)
        time = ["--time", "2026-08-12T18:00Z"]
        self.succeed("sun", dem, *time, "-o", self.path("out.tif"))
        lit = read(self.path("out.tif"))[0]
        for west, column in [(-6.3, 0), (-1.3, 50)]:
            line = self.succeed("sun", level("end.tif", west, 3), *time).stdout
            covered = float(line.split("obscuration: ")[1].split()[0]) / 100.0
            self.assertAlmostEqual(lit[4, column], 1.0 - covered, delta=2e-4)
        self.assertGreater(abs(lit[4, -1] - lit[4, 0]), 0.004)
        # A few minutes after first contact, the Moon covers only the limb, which is darker.
        time = ["--time", "2026-08-12T17:40Z"]
        self.succeed("sun", dem, *time, "-o", self.path("out.tif"))
        self.succeed("sun", dem, *time, "--limb-darkening", "-o", self.path("dark.tif"))
        lit, darkened = read(self.path("out.tif"))[0], read(self.path("dark.tif"))[0]
        self.assertTrue(np.all(lit < 1.0) and np.all(darkened > lit))

    def test_time_and_the_same_direction_agree(self):
        dem = os.path.join(Program.DATA, "dem", "SainteHelens.tif")
        text = self.succeed("sun", dem, "--time", "2026-06-21T14:00Z").stdout
        values = {line.split(": ")[0]: line.split(": ")[1].split(" ")[0]
                  for line in text.splitlines()}
        by_time = self.visibility(dem, "--time", "2026-06-21T14:00Z", out="time.tif")
        direction = values["grid azimuth"] + "," + values["refracted elevation"]
        by_direction = self.visibility(
            dem, "--sun", direction, "--sun-radius", values["angular radius"], out="sun.tif")
        shadow = np.nanmean(by_time < 0.5)
        self.assertTrue(0.01 < shadow < 0.9)
        # 10 by 14 km: the azimuth of the sun changes by 0.1 degrees, and a penumbra by one or two
        # posts.
        self.assertLess(np.nanmean(np.abs(by_time - by_direction)), 0.005)

    def test_threads_change_nothing(self):
        dem = make(self.path("dem.tif"), hills(90, 70))
        one = self.visibility(dem, "--sun", "200,10", "--threads", "1")
        two = self.visibility(dem, "--sun", "200,10", "--threads", "2")
        self.assertTrue(np.array_equal(one, two))


if __name__ == "__main__":
    Program.main()
