# SPDX-License-Identifier: BSD-3-Clause
"""skyline irradiance."""
import csv
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Tools"))

import Program  # noqa: E402
from Program import UTM10, ToolTest, gdal, hills, make, np, read  # noqa: E402

# The error of floats summed over some hundred azimuths.
SUM_TOLERANCE = 2e-5

# For an environment, the cosine is averaged over a swath of 128; for a sky view factor it is not:
# 1e-4 of pi.
SWATH_TOLERANCE = 5e-4


class Irradiance(ToolTest):
    def irradiance(self, dem, *options, out="out.tif"):
        self.succeed("irradiance", dem, "-o", self.path(out), *options)
        return read(self.path(out))

    def level(self, name="level.tif"):
        return make(self.path(name), np.full((11, 13), 100.0), step=(10.0, 10.0))

    def test_three_bands_described(self):
        dem = make(self.path("dem.tif"), hills(9, 8), epsg=UTM10)
        light = self.irradiance(dem)
        self.assertEqual(light.shape, (3, 9, 8))
        raster = gdal.Open(self.path("out.tif"))
        bands = [raster.GetRasterBand(k + 1) for k in range(3)]
        self.assertEqual([band.GetDescription() for band in bands],
                         ["Irradiance red", "Irradiance green", "Irradiance blue"])
        self.assertEqual([band.GetUnitType() for band in bands], ["W/m2"] * 3)
        self.assertEqual([band.DataType for band in bands], [gdal.GDT_Float32] * 3)
        before = gdal.Open(dem)
        self.assertEqual(before.GetGeoTransform(), raster.GetGeoTransform())
        self.assertTrue(before.GetSpatialRef().IsSame(raster.GetSpatialRef()))

    def test_default_is_a_uniform_sky(self):
        dem = make(self.path("dem.tif"), hills(30, 40), epsg=UTM10)
        light = self.irradiance(dem)
        self.assertTrue(np.array_equal(light, self.irradiance(dem, "--environment", "uniform")))
        self.succeed("sky-view", dem, "-o", self.path("sky.tif"), "--azimuths", "128")
        sky = read(self.path("sky.tif"))
        self.assertLess(np.abs(light - np.pi * sky[0]).max(), SWATH_TOLERANCE)
        level = self.irradiance(dem, "--horizontal")
        self.assertLess(np.abs(level - np.pi * sky[1]).max(), SWATH_TOLERANCE)

    def test_missing_posts_stay_missing(self):
        heights = hills(15, 14)
        heights[3, 4] = np.nan
        dem = make(self.path("dem.tif"), heights, epsg=UTM10, nodata=-9999.0)
        for method in ["table", "sh"]:
            light = self.irradiance(dem, "--method", method, "--azimuths", "16")
            for band in light:
                self.assertTrue(np.array_equal(np.isnan(band), np.isnan(heights)))

    def test_white_furnace(self):
        # Open level ground under a radiance of 1 gets pi, for any rotation and quadrature.
        for options in [[], ["--rotation", "33", "--quiet"], ["--quadrature", "blend"], ["--method", "sh"],
                        ["--quadrature", "linear", "--azimuths", "7"], ["--no-refinement", "--quiet"],
                        ["--environment", "cie:5"]]:
            light = self.irradiance(self.level(), *options)
            self.assertLess(np.abs(light - np.pi).max(), 1e-4, options)

    def test_overcast_skies(self):
        # Moon & Spencer: 7 pi / 9 times the radiance of the zenith.
        light = self.irradiance(self.level(), "--environment", "cie:16")
        self.assertLess(np.abs(light / (7.0 * np.pi / 9.0) - 1.0).max(), 5e-4)

    def test_sun(self):
        dem = make(self.path("dem.tif"), hills(30, 40), epsg=UTM10)
        light = self.irradiance(dem, "--sun", "120,20", "--horizontal")
        self.succeed("sun", dem, "-o", self.path("sun.tif"), "--sun", "120,20")
        lit = read(self.path("sun.tif"))[0]
        expected = lit * np.sin(np.radians(20.0))
        self.assertLess(np.abs(light - expected).max(), SUM_TOLERANCE)
        colored = self.irradiance(
            dem, "--sun", "120,20", "--horizontal", "--sun-irradiance", "900,600,300")
        for band, factor in zip(colored, [900.0, 600.0, 300.0]):
            self.assertLess(np.abs(band - factor * expected).max(), factor * SUM_TOLERANCE)

    def test_sun_on_a_slope(self):
        # A plane that rises to the north by one half, with the sun in the south at 30 degrees.
        y, _ = np.mgrid[0:20, 0:25] * 30.0
        light = self.irradiance(make(self.path("dem.tif"), 0.5 * y), "--sun", "180,30")
        tilt = np.arctan(0.5)
        self.assertLess(np.abs(light - np.sin(np.radians(30.0) + tilt)).max(), 1e-4)

    def test_suns_of_any_size(self):
        # The irradiance is that of a plane facing the disc.
        for radius in ["0", "2.9", "3.1", "20"]:
            light = self.irradiance(self.level(), "--sun", "100,40", "--sun-radius", radius)
            self.assertLess(
                np.abs(light / np.sin(np.radians(40.0)) - 1.0).max(), 3e-3, radius)

    def test_time(self):
        dem = make(self.path("dem.tif"), hills(20, 22), corner=(560000.0, 5110000.0), epsg=UTM10)
        light = self.irradiance(dem, "--time", "2026-06-21T20:00Z", "--horizontal")
        sun = dict(line.split(": ") for line in self.succeed(
            "sun", dem, "--time", "2026-06-21T20:00Z").stdout.splitlines())
        elevation = float(sun["refracted elevation"].split()[0])
        self.assertAlmostEqual(np.median(light), np.sin(np.radians(elevation)), delta=1e-4)
        wide = self.irradiance(
            dem, "--time", "2026-06-21T20:00Z", "--horizontal", "--sun-radius", "2")
        self.assertAlmostEqual(np.median(wide), np.sin(np.radians(elevation)), delta=1e-4)

    def test_perez_gives_direct_and_diffuse(self):
        light = self.irradiance(
            self.level(), "--environment", "perez:700,120", "--sun", "200,50")
        expected = 120.0 + 700.0 * np.sin(np.radians(50.0))
        self.assertLess(np.abs(light / expected - 1.0).max(), 1e-3)
        sky = self.irradiance(self.level(), "--environment", "perez:700,120", "--sun", "200,50",
                              "--sun-irradiance", "0")
        self.assertLess(np.abs(sky / 120.0 - 1.0).max(), 1e-3)

    def test_clear_sky_is_bright_around_the_sun(self):
        # A slope to the south and a sun in the south; only the sky counts.
        y, _ = np.mgrid[0:20, 0:25] * 30.0
        dem = make(self.path("dem.tif"), 0.8 * y)
        south = self.irradiance(dem, "--environment", "cie:12", "--sun", "180,30",
                                "--sun-irradiance", "0")
        north = self.irradiance(dem, "--environment", "cie:12", "--sun", "0,30",
                                "--sun-irradiance", "0")
        self.assertGreater(np.median(south), 1.3 * np.median(north))
        # A rotation of the sky also moves its brightest part, the sun.
        turned = self.irradiance(dem, "--environment", "cie:12", "--sun", "0,30",
                                 "--sun-irradiance", "0", "--rotation", "180")
        self.assertLess(np.abs(turned / south - 1.0).max(), 1e-3)

    def test_light_map(self):
        # Level ground: the irradiance of the upper hemisphere, by brute force over the pixels of
        # the map.
        folder = os.path.join(Program.DATA, "light-maps")
        with open(os.path.join(folder, "env_irradiance_6_normals.csv"), encoding="utf-8") as table:
            rows = list(csv.reader(line for line in table if not line.startswith("#")))
        up = {row[0]: [float(value) for value in row[2:]] for row in rows if row[1] == "+z up"}
        for name in ["sky_128.hdr", "sunset_128.hdr"]:
            light = self.irradiance(
                self.level(), "--environment", os.path.join(folder, name))
            values = light[:, 5, 5]
            # The reference used the map before 8 x 8 of its pixels were averaged. Within such a
            # block, the cosine of a sun low above the horizon changes by a third.
            reference = up["pmndrs_" + name.replace("_128", "")]
            self.assertLess(np.abs(values / reference - 1.0).max(), 6e-3, name)
            # Level open ground gets the same for any rotation and quadrature.
            for options in [["--rotation", "77.7"], ["--quadrature", "linear"],
                            ["--azimuths", "5"], ["--horizontal"]]:
                other = self.irradiance(
                    self.level(), "--environment", os.path.join(folder, name), *options)
                self.assertLess(np.abs(other[:, 5, 5] / values - 1.0).max(), 1e-4, options)

    def test_rotation_turns_the_map_clockwise(self):
        # If terrain and map are rotated by a right angle together, so is the result.
        file = os.path.join(Program.DATA, "light-maps", "sunset_128.hdr")
        heights = hills(24, 24)
        straight = self.irradiance(
            make(self.path("a.tif"), heights, step=(30.0, 30.0)), "--environment", file)
        # Clockwise: the north becomes the east. Row 0 is the southern edge.
        turned = self.irradiance(make(self.path("b.tif"), np.rot90(heights, 1), step=(30.0, 30.0)),
                                 "--environment", file, "--rotation", "90")
        back = np.stack([np.rot90(band, -1) for band in turned])
        # The diagonals of the cells do not rotate.
        self.assertLess(np.median(np.abs(back / straight - 1.0)), 2e-3)
        wrong = self.irradiance(self.path("b.tif"), "--environment", file, "--rotation", "-90")
        wrong = np.stack([np.rot90(band, -1) for band in wrong])
        self.assertGreater(np.median(np.abs(wrong / straight - 1.0)), 2e-2)

    def test_lamp(self):
        # 30 m above the middle of level ground, in the coordinates of the raster.
        corner = (560000.0, 5110000.0)
        dem = make(self.path("dem.tif"), np.full((21, 21), 500.0), step=(10.0, 10.0),
                   corner=corner, epsg=UTM10)
        x, y = corner[0] + 105.0, corner[1] + 105.0
        light = self.irradiance(dem, "--lamp", f"{x},{y},530,3,2,1,0", "--flat")
        self.assertAlmostEqual(light[0][10, 10], 2.0 * np.pi * 9.0 / 900.0, delta=1e-5)
        self.assertAlmostEqual(light[1][10, 10], np.pi * 9.0 / 900.0, delta=1e-5)
        self.assertEqual(np.abs(light[2]).max(), 0.0)
        square = 900.0 + 1600.0
        self.assertAlmostEqual(
            light[0][10, 14], 2.0 * np.pi * 9.0 / square * 30.0 / np.sqrt(square), delta=1e-5)
        self.assertTrue(np.allclose(light[0], light[0][:, ::-1], atol=1e-6))

    def test_lamps_add_up_and_shine_alone(self):
        dem = self.level()
        # --quiet, because these lamps are far from the DEM, which causes a warning.
        one = self.irradiance(dem, "--lamp", "30,30,120,2", "--quiet")
        other = self.irradiance(dem, "--lamp", "90,60,130,2,1,2,3", "--quiet")
        both = self.irradiance(
            dem, "--lamp", "30,30,120,2", "--lamp", "90,60,130,2,1,2,3", "--quiet")
        self.assertLess(np.abs(both - one - other).max(), SUM_TOLERANCE)
        self.assertLess(one.max(), 0.1)  # without a sky

    def test_verbose_counts_passes(self):
        dem = self.level()
        done = self.run_program("irradiance", dem, "-o", self.path("out.tif"), "--sun", "100,40",
                                "--verbose")
        self.assertEqual(done.returncode, 0)
        self.assertIn("0 environment, 1 sun, 0 lamp passes", done.stderr)

    def test_thread_counts(self):
        dem = make(self.path("dem.tif"), hills(40, 50), epsg=UTM10)
        sky = ["--environment", "cie:12", "--sun", "100,30"]
        one = self.irradiance(dem, *sky, "--threads", "1")
        two = self.irradiance(dem, *sky, "--threads", "2")
        self.assertTrue(np.array_equal(one, two))

    def test_a_sun_below_the_horizon_is_no_light(self):
        # Perez's sky depends on the sun: if the sun has set, it is as dark as for any sun below the
        # horizon.
        level = self.level()
        for sky in [[], ["--environment", "perez:700,120"]]:
            for elevation in ["-5", "-0.5", "-90"]:
                light = self.irradiance(level, *sky, "--sun", "100," + elevation, "--sun-radius", "0.2")
                self.assertEqual(light.max(), 0.0)

    def test_a_lamp_in_another_crs_warns_with_the_distance(self):
        dem = make(self.path("dem.tif"), hills(9, 8), epsg=UTM10)  # corner 500000, 5100000
        for where, far in [("-123.0,46.05", "5124 km"),  # the position in degrees
                           ("500120,5140005", "39.75 km")]:  # the northernmost posts are at 5100255
            done = self.run_program("irradiance", dem, "-o", self.path("out.tif"), "--lamp",
                                    where + ",1200,5")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, "^warning: lamp 1 stands " + far + " outside the height field, "
                             "too far to light it; assuming its X and Y are coordinates in the CRS")
        # A distant lamp that is as bright and as large as the sun does light the field.
        self.succeed("irradiance", dem, "-o", self.path("out.tif"), "--lamp",
                     "500120,5140000,20000,300")

    def test_refusals(self):
        dem = make(self.path("dem.tif"), hills(9, 8), epsg=UTM10)
        out = self.path("out.tif")
        for options, says in [
                (["--environment", self.path("no.hdr")], "no.hdr"),
                (["--environment", dem], "dem.tif"),
                (["--environment", self.folder], "")]:
            self.refused(1, "irradiance", dem, "-o", out, *options, says=says)
        self.refused(1, "irradiance", self.path("nowhere.tif"), "-o", out, says="nowhere.tif")
        self.refused(1, "irradiance", dem, "-o", self.path("no/such/out.tif"))
        self.refused(1, "irradiance", dem, "-o", "/dev/full")
        self.refused(1, "irradiance", dem, "-o", dem, says="part of the input")

    def test_wrong_usage(self):
        dem = make(self.path("dem.tif"), hills(9, 8), epsg=UTM10)
        out = self.path("out.tif")
        for options in [["--sun", "10,95"], ["--lamp", "0,0,0,-1"], ["--lamp", "0,0,0,1,-1,0,0"],
                        ["--azimuths", "0"], ["--azimuths", "1000000000"], ["--time", "yesterday"],
                        ["--environment", "perez:100,100"],
                        ["--environment", "cie:17"], ["--environment", "cie:2.5"],
                        ["--environment", "perez:1"], ["--environment", "perez:1,0"],
                        ["--lamp", "1,2,3"], ["--lamp", "1,2,3,4,5"], ["--lamp", "a,b,c,d"],
                        ["--method", "exact"], ["--horizon", "table"], ["--bands", "9"],
                        ["--sun-irradiance", "-1"], ["--sun-irradiance", "1,2"],
                        ["--rotation", "north"], ["--sun", "1,2", "--time", "2026-06-21T06:00Z"]]:
            self.refused(2, "irradiance", dem, "-o", out, *options)


if __name__ == "__main__":
    Program.main()
