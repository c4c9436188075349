# SPDX-License-Identifier: BSD-3-Clause
"""skyline shadow-height: the height of the shadow of the terrain above each post."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Tools"))

import Program
from Program import UTM10, ToolTest, gdal, hills, make, np, read


class ShadowHeight(ToolTest):
    def shadow(self, dem, *options, out="out.tif"):
        self.succeed("shadow-height", dem, "-o", self.path(out), *options)
        return read(self.path(out))

    def test_band(self):
        heights = hills(15, 14)
        heights[3, 4] = np.nan
        dem = make(self.path("dem.tif"), heights, epsg=UTM10, nodata=-9999.0)
        shadow = self.shadow(dem)
        raster = gdal.Open(self.path("out.tif"))
        self.assertEqual(raster.RasterCount, 1)
        band = raster.GetRasterBand(1)
        self.assertEqual(band.GetDescription(), "ShadowHeight")
        self.assertEqual(band.GetUnitType(), "m")
        self.assertEqual(band.DataType, gdal.GDT_Float32)
        self.assertTrue(np.array_equal(np.isnan(shadow[0]), np.isnan(heights)))

    def test_shadow_of_a_wall(self):
        heights = np.zeros((21, 61))
        heights[:, 0] = 100.0
        dem = make(self.path("dem.tif"), heights, step=(10.0, 10.0))
        for method in ["exact", "sweep"]:
            shadow = self.shadow(dem, "--sun", "270,30", "--method", method)[0][10]
            expected = np.maximum(100.0 - 10.0 * np.arange(61) * np.tan(np.radians(30.0)), 0.0)
            self.assertLess(np.abs(shadow - expected).max(), 1e-3)

    def test_limbs(self):
        dem = make(self.path("dem.tif"), hills(60, 50))
        shadow = self.shadow(dem, "--sun", "200,12", "--sun-radius", "1", "--soft")
        raster = gdal.Open(self.path("out.tif"))
        self.assertEqual([raster.GetRasterBand(k).GetDescription() for k in (1, 2, 3)],
                         ["ShadowHeight", "ShadowHeightUpper", "ShadowHeightLower"])
        self.assertTrue(np.all(shadow[1] <= shadow[2]))
        self.assertTrue(np.any(shadow[1] < shadow[2]))

    def test_the_posts_in_shadow_see_no_sun(self):
        dem = os.path.join(Program.DATA, "dem", "SainteHelens.tif")
        heights = read(dem)[0]
        shadow = self.shadow(dem, "--sun", "100,20")[0]
        self.succeed("sun", dem, "--sun", "100,20", "--sun-radius", "0", "-o", self.path("sun.tif"))
        lit = read(self.path("sun.tif"))[0]
        self.assertGreater(np.count_nonzero(lit == 0.0), 1000)
        self.assertTrue(np.array_equal(shadow > heights, lit == 0.0))

    def test_a_set_sun_gives_nodata_and_says_so(self):
        dem = make(self.path("dem.tif"), hills(15, 14), epsg=UTM10)
        for elevation in ["0", "-5"]:
            done = self.run_program(
                "shadow-height", dem, "-o", self.path("out.tif"), "--sun", "120," + elevation)
            self.assertEqual(done.returncode, 0)
            self.assertRegex(done.stderr, "^warning: the sun's centre stands at " + elevation +
                             " degrees, .*; assuming .* nodata in a raster\n$")
            self.assertTrue(np.all(np.isnan(read(self.path("out.tif"))[0])))
            done = self.succeed(
                "shadow-height", dem, "-o", self.path("out.tif"), "--sun", "120," + elevation, "--quiet")
            self.assertEqual(done.stderr, "")
        done = self.succeed("shadow-height", dem, "-o", self.path("out.tif"), "--sun", "120,0.1")
        self.assertNotIn("warning", done.stderr)
        self.assertFalse(np.any(np.isnan(read(self.path("out.tif"))[0])))

    def test_refusals(self):
        dem = make(self.path("dem.tif"), hills(5, 6))
        out = ["-o", self.path("no.tif")]
        self.refused(2, "shadow-height", dem, *out, "--limb-darkening", says="--limb-darkening")
        self.refused(2, "shadow-height", dem, *out, "--method", "pyramid", says="exact,fast,sweep")
        self.refused(2, "shadow-height", dem, *out, "--surface", "bilinear", says="--surface")
        self.refused(2, "shadow-height", dem, *out, "--sun", "10,91", says="elevation 91")
        self.refused(2, "shadow-height", dem, says="--output")
        self.assertFalse(os.path.exists(self.path("no.tif")))


if __name__ == "__main__":
    Program.main()
