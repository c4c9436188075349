# SPDX-License-Identifier: BSD-3-Clause
"""skyline sky-view."""
import os

import Program
from Program import UTM10, ToolTest, gdal, hills, make, np, read

QUANTITIES = ["SkyViewFactor", "SkyViewFactorHorizontal", "VisibleSkyFraction", "PositiveOpenness"]

# 72 azimuths over a horizon with kinks where the plane crosses the horizontal: a relative error of
# about 1 / 72^2.
FACTOR_TOLERANCE = 5e-4
ANGLE_TOLERANCE = 0.02


class SkyView(ToolTest):
    def sky_view(self, dem, *options, out="out.tif"):
        self.succeed("sky-view", dem, "-o", self.path(out), *options)
        raster = gdal.Open(self.path(out))
        names = [raster.GetRasterBand(k + 1).GetDescription() for k in range(raster.RasterCount)]
        return dict(zip(names, read(self.path(out))))

    def test_four_bands_described_by_name_and_unit(self):
        dem = make(self.path("dem.tif"), hills(9, 8), epsg=UTM10)
        self.assertEqual(list(self.sky_view(dem)), QUANTITIES)
        raster = gdal.Open(self.path("out.tif"))
        units = [raster.GetRasterBand(k + 1).GetUnitType() for k in range(4)]
        self.assertEqual(units, ["1", "1", "1", "degree"])
        before = gdal.Open(dem)
        self.assertEqual(before.GetGeoTransform(), raster.GetGeoTransform())
        self.assertTrue(before.GetSpatialRef().IsSame(raster.GetSpatialRef()))

    def test_chosen_quantities_in_the_order_asked_for(self):
        dem = make(self.path("dem.tif"), hills(9, 8))
        every = self.sky_view(dem)
        some = self.sky_view(
            dem, "--quantity", "PositiveOpenness", "--quantity", "SkyViewFactor", "--quantity",
            "PositiveOpenness")
        self.assertEqual(list(some), ["PositiveOpenness", "SkyViewFactor"])
        for name, values in some.items():
            self.assertTrue(np.array_equal(values, every[name]))

    def test_edge_trust_is_asked_for(self):
        dem = make(self.path("dem.tif"), np.full((41, 41), 99.0), epsg=UTM10)
        trust = self.sky_view(
            dem, "--quantity", "EdgeTrust", "--edge-distance", "150")["EdgeTrust"]
        raster = gdal.Open(self.path("out.tif"))
        self.assertEqual(raster.GetRasterBand(1).GetUnitType(), "1")
        for (row, column), azimuths in {(20, 20): 72, (0, 20): 37, (20, 40): 37, (40, 0): 19}.items():
            self.assertAlmostEqual(trust[row, column], azimuths / 72, places=6)
        self.assertEqual(trust[5, 20], 1.0)
        self.assertLess(trust[4, 20], 1.0)
        self.refused(2, "sky-view", dem, "-o", self.path("no.tif"), "--edge-distance", "150",
                     says="only the quantity EdgeTrust uses it")
        for wrong in ["-1", "nan", "far"]:
            self.refused(2, "sky-view", dem, "-o", self.path("no.tif"), "--quantity", "EdgeTrust",
                         "--edge-distance", wrong, says="--edge-distance")

    def test_level_ground_sees_the_whole_sky(self):
        dem = make(self.path("dem.tif"), np.full((12, 15), 99.0))
        sky = self.sky_view(dem)
        for name in QUANTITIES[:3]:
            self.assertLess(np.abs(sky[name] - 1.0).max(), FACTOR_TOLERANCE, name)
        inner = sky["PositiveOpenness"][1:-1, 1:-1]
        self.assertLess(np.abs(inner - 90.0).max(), ANGLE_TOLERANCE)

    def test_inclined_plane(self):
        # A plane with the inclination b hides a lune with the angle b of the upper hemisphere.
        slope = 0.5
        _, x = np.mgrid[0:20, 0:25] * 30.0
        sky = self.sky_view(make(self.path("dem.tif"), slope * x))
        angle = np.arctan(slope)
        expected = {
            "SkyViewFactor": 0.5 * (1.0 + np.cos(angle)),
            "SkyViewFactorHorizontal": 0.5 * (1.0 + np.cos(angle)),
            "VisibleSkyFraction": 1.0 - angle / np.pi,
        }
        for name, value in expected.items():
            inner = sky[name][1:-1, 1:-1]
            self.assertLess(np.abs(inner - value).max(), FACTOR_TOLERANCE, name)
        # Openness includes horizons below the horizontal: the upward and downward parts cancel.
        self.assertLess(
            np.abs(sky["PositiveOpenness"][1:-1, 1:-1] - 90.0).max(), ANGLE_TOLERANCE)

    def test_ranges_on_terrain(self):
        dem = os.path.join(Program.DATA, "dem", "SainteHelens.tif")
        sky = self.sky_view(dem, "--azimuths", "24")
        heights = read(dem)[0]
        for name, values in sky.items():
            self.assertTrue(np.array_equal(np.isnan(values), np.isnan(heights)), name)
            top = 180.0 if name == "PositiveOpenness" else 1.0 + 1e-6
            self.assertTrue(np.nanmin(values) > 0.0 and np.nanmax(values) <= top, name)
        # The crater sees much less of the sky than the plains.
        self.assertLess(np.nanmin(sky["SkyViewFactorHorizontal"]), 0.75)

    def test_methods(self):
        dem = make(self.path("dem.tif"), hills(60, 50))
        exact = self.sky_view(dem)["SkyViewFactor"]
        for method, typical in [("fast", 0.005), ("sweep", 0.03)]:
            other = self.sky_view(dem, "--method", method)["SkyViewFactor"]
            error = np.sqrt(np.mean((other - exact)[2:-2, 2:-2]**2))
            self.assertLess(error, typical, method)

    def test_threads_change_nothing(self):
        dem = make(self.path("dem.tif"), hills(90, 70))
        one = self.sky_view(dem, "--threads", "1")
        two = self.sky_view(dem, "--threads", "2")
        for name in QUANTITIES:
            self.assertTrue(np.array_equal(one[name], two[name]))


if __name__ == "__main__":
    Program.main()
