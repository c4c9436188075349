# SPDX-License-Identifier: BSD-3-Clause
"""skyline shade: pictures."""
import os

import Program
from Program import UTM10, ToolTest, gdal, hills, make, np, read

LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


def pixels(path):
    """Channels as (row, column, channel). Row 0 is the south for all formats."""
    return np.moveaxis(gdal.Open(path).ReadAsArray(), 0, -1)[::-1]


class Shade(ToolTest):
    def shade(self, dem, *options, out="out.png"):
        self.succeed("shade", dem, "-o", self.path(out), *options)
        return pixels(self.path(out)) if not out.endswith(".exr") else None

    def brightness(self, picture):
        return picture[..., :3].astype(float) @ LUMINANCE

    def test_saint_helens(self):
        dem = os.path.join(Program.DATA, "dem", "SainteHelens.tif")
        picture = self.shade(dem, "--azimuths", "24")
        heights = read(dem)[0]
        self.assertEqual(picture.shape, (*heights.shape, 4))
        self.assertEqual(picture.dtype, np.uint8)
        self.assertTrue(np.array_equal(picture[..., 3] == 0, np.isnan(heights)))
        shown = self.brightness(picture)[~np.isnan(heights)]
        # The picture is neither too bright nor too dark, and has contrast.
        self.assertLess(picture[..., :3].max(), 255)
        self.assertGreater(shown.min(), 10)
        self.assertTrue(90 < np.median(shown) < 200, np.median(shown))
        self.assertGreater(np.percentile(shown, 99) - np.percentile(shown, 1), 80)

    def test_nothing_burns_out_at_any_exposure(self):
        dem = make(self.path("dem.tif"), hills(40, 50))
        for colors in ["hypsometric", "gray", "viridis"]:
            for exposure in ["auto", "-3", "0", "5", "40", "1000"]:
                picture = self.shade(dem, "--exposure", exposure, "--colors", colors)
                self.assertLess(picture[..., :3].max(), 255, (colors, exposure))

    def test_exposure_brightens(self):
        dem = make(self.path("dem.tif"), hills(40, 50))
        mean = [self.brightness(self.shade(dem, "--exposure", ev)).mean()
                for ev in ["-2", "-1", "0", "1", "2"]]
        self.assertTrue(np.all(np.diff(mean) > 5.0), mean)

    def test_shadows_are_darker(self):
        # The plain beside a wall: the colour and the slope in the shadow and outside are the same.
        heights = np.zeros((21, 61))
        heights[:, 0] = 100.0
        dem = make(self.path("dem.tif"), heights, step=(10.0, 10.0))
        row = self.brightness(self.shade(dem, "--sun", "270,30", "--colors", "gray"))[10]
        self.assertLess(row[10], 0.75 * row[30])
        self.assertGreater(row[10], 20.0, "the sky lights shadows")
        dark = self.brightness(
            self.shade(dem, "--sun", "270,30", "--environment", "none"))[10]
        self.assertEqual(dark[10], 0.0)

    def test_sun_side_is_brighter_and_warmer(self):
        y, x = np.mgrid[0:41, 0:41]
        ridge = 200.0 - 10.0 * np.abs(x - 20.0) + 0.0 * y
        dem = make(self.path("dem.tif"), ridge)
        picture = self.shade(dem, "--sun", "270,25", "--colors", "gray").astype(float)
        west, east = picture[20, 10], picture[20, 30]
        self.assertGreater(west[:3] @ LUMINANCE, 1.2 * (east[:3] @ LUMINANCE))
        self.assertGreater(west[0] / west[2], 1.02 * east[0] / east[2])

    def test_overcast_sky(self):
        # In a trench, the horizon hides the darker part of an overcast sky. Relative to open
        # ground, the trench is brighter than under a uniform sky.
        heights = np.zeros((41, 41))
        heights[:, 18:23] = -60.0
        dem = make(self.path("dem.tif"), heights)
        share = {}
        for sky in ["uniform", "cie:5", "cie:16", "cie:1"]:
            picture = self.shade(dem, "--sun", "0,-30", "--colors", "gray", "--exposure", "-1",
                                 "--environment", sky)
            row = self.brightness(picture)[20]
            share[sky] = row[20] / row[5]
        self.assertEqual(share["cie:5"], share["uniform"])
        self.assertGreater(share["cie:16"], 1.01 * share["uniform"])
        self.assertGreater(share["cie:1"], 1.01 * share["uniform"])
        self.assertLess(share["cie:1"], 1.0)

    def test_pictures_of_every_kind(self):
        heights = hills(30, 40)
        heights[4:7, 8:11] = np.nan
        dem = make(self.path("dem.tif"), heights, epsg=UTM10, nodata=-9999.0)
        png = self.shade(dem)
        tif = self.shade(dem, out="out.tif")
        self.assertTrue(np.array_equal(png, tif))
        before, after = gdal.Open(dem), gdal.Open(self.path("out.tif"))
        self.assertEqual(before.GetGeoTransform(), after.GetGeoTransform())
        self.assertTrue(before.GetSpatialRef().IsSame(after.GetSpatialRef()))
        self.assertEqual(after.RasterCount, 4)
        meanings = [after.GetRasterBand(k + 1).GetColorInterpretation() for k in range(4)]
        self.assertEqual(
            meanings, [gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand, gdal.GCI_AlphaBand])
        self.shade(dem, out="out.exr")
        with open(self.path("out.exr"), "rb") as exr:
            self.assertEqual(exr.read(4), b"\x76\x2f\x31\x01")

    def test_south_up_raster_gives_the_same_picture(self):
        heights = hills(23, 19)
        up = make(self.path("up.tif"), heights, epsg=UTM10)
        down = make(self.path("down.tif"), heights, epsg=UTM10, south_up=True)
        self.assertTrue(
            np.array_equal(self.shade(up, out="a.png"), self.shade(down, out="b.png")))

    def test_exaggeration_is_that_of_a_higher_mountain(self):
        heights = hills(23, 19)
        low = self.shade(make(self.path("low.tif"), heights), "--exaggeration", "2.5")
        high = self.shade(make(self.path("high.tif"), 2.5 * heights), out="high.png")
        self.assertLessEqual(np.abs(low.astype(int) - high.astype(int)).max(), 1)

    def test_ocean_is_blue(self):
        heights = np.linspace(-1000.0, 1000.0, 50) * np.ones((30, 1))
        picture = self.shade(make(self.path("dem.tif"), heights), "--colors", "ocean")
        sea, land = picture[15, 5].astype(float), picture[15, 45].astype(float)
        self.assertGreater(sea[2], 1.2 * sea[0])
        self.assertLess(land[2], land[0])

    def test_time_and_no_sun(self):
        dem = make(self.path("dem.tif"), hills(30, 40), epsg=UTM10)
        for time in ["2026-06-21T20:00Z", "2026-06-21T08:00Z"]:  # noon and night
            picture = self.shade(dem, "--time", time)
            shown = self.brightness(picture)
            self.assertTrue(60 < np.median(shown) < 230, time)

    def test_only_what_the_lights_need_is_computed(self):
        dem = make(self.path("dem.tif"), hills(30, 40))
        for options, passes in [
                ([], ["read", "sun", "sky view", "shading", "write"]),
                (["--environment", "none"], ["read", "sun", "shading", "write"]),
                (["--sun", "0,-30"], ["read", "sky view", "shading", "write"])]:
            done = self.run_program("shade", dem, "-o", self.path("out.png"), "-v", *options)
            self.assertEqual([line[:14].strip() for line in done.stderr.splitlines()], passes)

    def test_flat_terrain_has_one_colour(self):
        picture = self.shade(make(self.path("dem.tif"), np.full((9, 9), 5.0)))
        self.assertEqual(len(np.unique(picture[..., :3].reshape(-1, 3), axis=0)), 1)
        self.assertTrue(np.all(picture[..., 3] == 255))


if __name__ == "__main__":
    Program.main()
