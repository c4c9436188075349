# SPDX-License-Identifier: BSD-3-Clause
"""Doubtful DEMs: the warnings, the effect of an undeclared nodata value on other posts, and --nodata."""
import math
import os

import Program
from Program import UTM10, ToolTest, gdal, hills, make, np, osr, read

FAR = 0.01  # degrees by which a post of any height may change horizons that cannot see it
FEET, SURVEY_FEET = 0.3048, 1200.0 / 3937.0
HEIGHT_AXIS = 'CS[Cartesian,3],AXIS["(E)",east,ORDER[1],LENGTHUNIT["metre",1]],' \
    'AXIS["(N)",north,ORDER[2],LENGTHUNIT["metre",1]],' \
    'AXIS["ellipsoidal height (h)",up,ORDER[3],LENGTHUNIT["foot",0.3048]]]'


def three_dimensions():
    """UTM with a vertical axis in feet, as WKT."""
    crs = osr.SpatialReference()
    crs.ImportFromEPSG(UTM10)
    wkt = crs.ExportToWkt(["FORMAT=WKT2_2019"])
    return wkt[:wkt.index("CS[Cartesian")] + HEIGHT_AXIS


class Doubts(ToolTest):
    def warned(self, *arguments):
        """The command must succeed. Returns its warnings."""
        done = self.run_program(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stderr.splitlines()
        self.assertTrue(all(line.startswith("warning: ") for line in lines), done.stderr)
        return lines

    def with_block(self, value, kind=gdal.GDT_Float32):
        heights = hills(40, 50)
        heights[10:20, 15:25] = value
        return make(self.path("block.tif"), heights, epsg=UTM10, kind=kind)

    def test_one_line_that_names_value_count_and_option(self):
        dem = self.with_block(-9999.0)
        out = self.path("out.tif")
        lines = self.warned("sky-view", dem, "-o", out, "--azimuths", 8)
        self.assertEqual(lines, [
            f"warning: 100 posts of '{dem}' have the height -9999, which often stands for a missing "
            "post; assuming these are heights; use --nodata -9999 to say otherwise"])
        self.succeed("sky-view", dem, "-o", out, "--azimuths", 8, "--quiet")

    def test_nodata_on_every_command(self):
        dem = self.with_block(-9999.0)
        declared = self.path("declared.tif")
        heights = hills(40, 50)
        heights[10:20, 15:25] = np.nan
        make(declared, heights, epsg=UTM10, nodata=-9999.0, kind=gdal.GDT_Float32)
        commands = [["horizon", "--azimuths", 8], ["sky-view", "--azimuths", 8], ["sun"],
                    ["irradiance", "--azimuths", 8], ["shadow-height"], ["shade", "--azimuths", 8]]
        for name, *options in commands:
            out, wanted = self.path(name + ".tif"), self.path(name + "-wanted.tif")
            self.succeed(name, dem, "-o", out, *options, "--nodata", -9999)
            self.succeed(name, declared, "-o", wanted, *options)
            self.assertTrue(np.array_equal(read(out), read(wanted), equal_nan=True), name)

    def test_nodata_is_any_number_and_may_be_repeated(self):
        heights = hills(20, 20)
        heights[0, 0], heights[5, 5], heights[7, 7] = -9999.0, 0.0, np.inf
        dem = make(self.path("two.tif"), heights, epsg=UTM10)
        out = self.path("out.tif")
        self.succeed("horizon", dem, "-o", out, "--azimuths", 4, "--nodata", -9999, "--nodata=0",
                     "--nodata", "inf")
        self.assertEqual(np.isnan(read(out)[0]).sum(), 3)
        self.refused(2, "horizon", dem, "-o", out, "--nodata", "none", says="--nodata")

    def test_nodata_that_no_post_has(self):
        dem = make(self.path("dem.tif"), hills(20, 20), epsg=UTM10)
        lines = self.warned("horizon", dem, "-o", self.path("out.tif"), "--azimuths", 4,
                            "--nodata", -9999)
        self.assertEqual(len(lines), 1)
        self.assertIn("has the nodata value -9999; assuming it marks no missing post", lines[0])

    def test_one_absurd_post_leaves_the_rest_its_digits(self):
        heights = hills(200, 200)
        dem, out = self.path("dem.tif"), self.path("out.tif")
        make(dem, heights, epsg=UTM10, kind=gdal.GDT_Float32)
        self.succeed("horizon", dem, "-o", out, "--azimuths", 8)
        good = read(out)
        for fill in [-9999.0, -32768.0, -99999.0, -1e10, 1e20, 9.969209968386869e36, -3.4028234e38]:
            heights[199, 199] = fill  # the north-east corner
            make(dem, heights, epsg=UTM10, kind=gdal.GDT_Float32)
            lines = self.warned("horizon", dem, "-o", out, "--azimuths", 8)
            self.assertEqual(len(lines), 1, fill)
            found = read(out)
            for azimuth in [4, 5]:  # south and south-west
                change = np.abs(found[azimuth] - good[azimuth])[:100, :100]
                self.assertLess(np.nanmax(change), FAR, fill)
            self.assertFalse(np.isnan(found[:, :150, :150]).any(), fill)

    def test_vertical_units(self):
        heights = np.zeros((11, 11))
        heights[:, 8:] = 100.0  # a plateau three posts to the east
        out = self.path("out.tif")
        cases = [({"unit": "ft"}, FEET), ({"unit": "US survey foot"}, SURVEY_FEET), ({"unit": "gpm"}, 1.0),
                 ({"unit": "cm"}, 0.01), ({"wkt": three_dimensions()}, FEET), ({}, 1.0)]
        for options, metres in cases:
            dem = make(self.path("dem.tif"), heights, **{"epsg": UTM10, **options})
            kept = gdal.Open(dem).GetSpatialRef().GetAxesCount()
            if "wkt" in options and kept != 3:
                continue  # this GeoTIFF library cannot store it; TestReaderDoubts uses a VRT
            self.succeed("horizon", dem, "-o", out, "--azimuths", 4, "--flat")
            wanted = math.degrees(math.atan(100.0 * metres / 90.0))
            self.assertAlmostEqual(read(out)[1][5, 5], wanted, delta=2e-3, msg=str(options))
        dem = make(self.path("dem.tif"), heights, epsg=UTM10, unit="m s-1")
        self.refused(1, "horizon", dem, "-o", out, says="not a known length")

    def test_other_places(self):
        dem = make(self.path("dem.tif"), hills(20, 20), epsg=UTM10)
        numbers = ["LINE_OFF", "SAMP_OFF", "LAT_OFF", "LONG_OFF", "HEIGHT_OFF", "LINE_SCALE",
                   "SAMP_SCALE", "LAT_SCALE", "LONG_SCALE", "HEIGHT_SCALE"]
        lists = ["LINE_NUM_COEFF", "LINE_DEN_COEFF", "SAMP_NUM_COEFF", "SAMP_DEN_COEFF"]
        self.place(dem, "RPC", {**{name: "1" for name in numbers},
                                **{name: " ".join(["1"] * 20) for name in lists}})
        self.refused(1, "horizon", dem, "-o", self.path("out.tif"), says="gdalwarp -rpc")
        self.place(dem, "GEOLOCATION", {"X_DATASET": "x.tif", "Y_DATASET": "y.tif", "X_BAND": "1"})
        self.refused(1, "horizon", dem, "-o", self.path("out.tif"), says="gdalwarp -geoloc")

    def place(self, dem, domain, items):
        """Replaces the geotransform by metadata."""
        values = gdal.Open(dem).ReadAsArray()
        os.remove(dem)
        raster = gdal.GetDriverByName("GTiff").Create(dem, 20, 20, 1, gdal.GDT_Float32)
        raster.GetRasterBand(1).WriteArray(values)
        raster.SetMetadata(items, domain)
        raster = None

    def test_degrees_without_a_crs(self):
        step = 1.0 / 1200.0
        dem = make(self.path("dem.tif"), hills(30, 30), step=(step, step), corner=(7.0, 46.0))
        lines = self.warned("sky-view", dem, "-o", self.path("out.tif"), "--azimuths", 8)
        self.assertEqual(len(lines), 1)
        self.assertIn("looks like degrees", lines[0])
        self.assertIn("gdal_edit.py -a_srs EPSG:4326", lines[0])

    def test_spacings_that_floats_do_not_hold(self):
        for step in [1e-40, 1e-300, 1e20]:
            dem = make(self.path("dem.tif"), hills(5, 5), step=(step, step), corner=(0.0, 0.0))
            self.refused(1, "sky-view", dem, "-o", self.path("out.tif"), says="m apart")


class CentreMissing(ToolTest):
    def height(self, heights, *arguments):
        dem = make(self.path("dem.tif"), heights, epsg=UTM10, nodata=-9999.0)
        done = self.run_program("sun", dem, "--time", "2026-06-21T16:00Z", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        line = [line for line in done.stdout.splitlines() if line.startswith("height: ")][0]
        return float(line.split()[1]), done.stderr

    def test_the_nearest_post_with_a_height(self):
        heights = np.full((101, 121), 3000.0)
        heights[50, 60 + 13] = 1234.0
        heights[50 - 13:50 + 14, 60 - 20:60 + 13] = np.nan
        heights[50, 60 + 13] = 1234.0
        for row in range(101):
            for column in range(121):
                if math.hypot(row - 50, column - 60) < 13.0:
                    heights[row, column] = np.nan
        heights[50 - 13, 60] = heights[50 + 13, 60] = heights[50, 60 - 13] = np.nan
        self.assertEqual(self.height(heights), (1234.0, ""))

    def test_far_away_and_none(self):
        heights = np.full((801, 61), np.nan)
        heights[800, 30] = heights[799, 30] = heights[800, 31] = 500.0
        self.assertEqual(self.height(heights), (500.0, ""))
        heights = np.full((1101, 41), np.nan)
        heights[:2] = 500.0
        found, warning = self.height(heights)
        self.assertEqual(found, 0.0)
        self.assertIn("no post within 512 posts of the DEM's centre has a height; assuming a height "
                      "of 0 m there", warning)

    def test_a_centre_with_a_height_is_read_alone(self):
        heights = hills(50, 60)
        found, warning = self.height(heights)
        self.assertAlmostEqual(found, heights[25, 30], delta=0.01)
        self.assertEqual(warning, "")


class Numbers(ToolTest):
    def test_a_small_file_that_claims_much(self):
        claim = self.path("claim.vrt")
        with open(claim, "w", encoding="utf-8") as file:
            file.write("<VRTDataset rasterXSize='2000000000' rasterYSize='1000000000'><GeoTransform>0, 1, 0, "
                       "0, 0, -1</GeoTransform><VRTRasterBand dataType='Float32' band='1'/></VRTDataset>")
        says = self.refused(1, "sky-view", claim, "-o", self.path("out.tif"), says="claim.vrt")
        self.assertIn("the heights of 2000000000 x 1000000000 posts take 8000000000.0 GB", says)

    def test_memory_that_the_process_may_not_take(self):
        self.skip_if_sanitized()
        dem = self.path("large.vrt")
        with open(dem, "w", encoding="utf-8") as file:
            file.write("<VRTDataset rasterXSize='20000' rasterYSize='20000'><GeoTransform>0, 1, 0, "
                       "0, 0, -1</GeoTransform><VRTRasterBand dataType='Float32' band='1'/></VRTDataset>")
        says = self.refused(1, "sky-view", dem, "-o", self.path("out.tif"), says="large.vrt",
                            preexec_fn=Program.limit_memory(1500 << 20))
        self.assertIn("take 1.6 GB", says)
        self.assertIn("gdal_translate", says)

    def test_a_rotation_of_any_size(self):
        dem = make(self.path("dem.tif"), hills(20, 20), epsg=UTM10)
        out, wanted = self.path("out.tif"), self.path("wanted.tif")
        sky = ["--environment", "cie:12", "--azimuths", 16, "--quiet"]
        for rotation in [1e20, -1e20, 1e300, 360000045.0]:
            self.succeed("irradiance", dem, "-o", out, *sky, "--rotation", rotation)
            self.succeed("irradiance", dem, "-o", wanted, *sky, "--rotation",
                         repr(math.fmod(rotation, 360.0)))
            self.assertTrue(np.array_equal(read(out), read(wanted)), rotation)

    def test_light_beyond_float(self):
        dem = make(self.path("dem.tif"), hills(20, 20), epsg=UTM10)
        self.refused(1, "irradiance", dem, "-o", self.path("out.tif"), "--sun", "315,45",
                     "--sun-irradiance", "1e39", says="more than a float holds")


if __name__ == "__main__":
    Program.main()
