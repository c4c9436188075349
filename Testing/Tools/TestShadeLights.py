# SPDX-License-Identifier: BSD-3-Clause
"""skyline shade with the lights of skyline irradiance."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Tools"))

import Program  # noqa: E402
from Program import UTM10, ToolTest, gdal, hills, make, np, read  # noqa: E402


class ShadeLights(ToolTest):
    def passes(self, *options):
        done = self.run_program("shade", self.dem, "-o", self.path("out.png"), "-v", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [line.split("  ")[0] for line in done.stderr.splitlines()]

    def picture(self, *options):
        """The linear values of the sRGB bytes of a map, as (bands, rows, columns)."""
        self.succeed("shade", self.dem, "-o", self.path("out.tif"), "--exposure", "0", *options)
        return gdal.Open(self.path("out.tif")).ReadAsArray().astype(float)

    def setUp(self):
        super().setUp()
        self.dem = make(self.path("dem.tif"), hills(30, 40), epsg=UTM10)
        place = gdal.Open(self.dem).GetGeoTransform()
        self.lamp = f"{place[0] + 20.5 * place[1]},{place[3] + 15.5 * place[5]},2000,100"
        self.map = os.path.join(Program.DATA, "light-maps", "sunset_128.hdr")

    def test_passes(self):
        for options, expected in [
                (["--environment", self.map],
                 ["read", "light map", "irradiance", "shading", "write"]),
                (["--environment", "cie:12"],
                 ["read", "sun", "irradiance", "shading", "write"]),
                (["--environment", "perez:500,100", "--sun", "100,30"], ["read", "irradiance", "shading", "write"]),
                (["--lamp", self.lamp],
                 ["read", "sun", "irradiance", "sky view", "shading", "write"])]:
            self.assertEqual(self.passes(*options), expected, options)

    def test_lamps_add_light(self):
        dark = self.picture("--environment", "none", "--sun", "100,-20")
        self.assertEqual(dark[:3].max(), 0.0)
        lit = self.picture("--environment", "none", "--sun", "100,-20", "--lamp",
                           self.lamp + ",5,5,0")
        self.assertGreater(lit[0].max(), 50.0)
        self.assertEqual(lit[2].max(), 0.0)

    def test_maps_turn(self):
        straight = self.picture("--environment", self.map)
        turned = self.picture("--environment", self.map, "--rotation", "180")
        self.assertGreater(np.abs(straight - turned)[:3].mean(), 1.0)
        again = self.picture("--environment", self.map, "--rotation", "360")
        self.assertLessEqual(np.abs(straight - again)[:3].max(), 1.0)

    def test_irradiance_is_what_is_shown(self):
        # The same light makes the same picture: a clear sky makes slopes that face the sun
        # brighter.
        self.succeed("irradiance", self.dem, "-o", self.path("light.tif"), "--environment",
                     "perez:900,80", "--sun", "200,30")
        light = read(self.path("light.tif"))[1]
        self.succeed("shade", self.dem, "-o", self.path("out.tif"), "--environment",
                     "perez:900,80", "--sun", "200,30", "--colors", "gray")
        shown = gdal.Open(self.path("out.tif")).ReadAsArray().astype(float)[1][::-1]
        self.assertGreater(np.corrcoef(light.ravel(), shown.ravel())[0, 1], 0.7)


if __name__ == "__main__":
    Program.main()
