# SPDX-License-Identifier: BSD-3-Clause
"""skyline shade --view perspective: pictures drawn by OpenGL without a window system."""
import os
import shutil

import Program
from Program import ToolTest, gdal, hills, make, np

# libglvnd looks for its drivers here; the folder is empty.
NO_EGL = {"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent"}
SIZE = (120, 200)  # rows, columns


def environment(**changes):
    """The environment of the test, without a display."""
    kept = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    kept.update(changes)
    return kept


class Perspective(ToolTest):
    def draw(self, dem, *options, out="out.png"):
        done = self.run_program("shade", dem, "-o", self.path(out), "--view", "perspective",
                                "--size", "%dx%d" % SIZE[::-1], "--azimuths", "8", *options,
                                env=environment())
        if done.returncode == 1 and "no OpenGL" in done.stderr:
            self.skipTest(done.stderr.strip())
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return np.moveaxis(gdal.Open(self.path(out)).ReadAsArray(), 0, -1).astype(int)

    def terrain_of(self, picture):
        """The pixels that are not sky. Each row of the sky has one colour."""
        self.assertTrue(np.array_equal(picture[:, 0], picture[:, -1]), "sky at both sides")
        return np.any(picture != picture[:, :1], axis=-1)

    def test_the_whole_terrain_is_in_the_picture(self):
        dem = make(self.path("dem.tif"), hills(60, 50))
        for view in ["180,35", "90,10", "33,60", "0,90", "-120,0"]:
            picture = self.draw(dem, "--from", view)
            self.assertEqual(picture.shape, (*SIZE, 4))
            self.assertTrue(np.all(picture[..., 3] == 255))
            rows, columns = np.nonzero(self.terrain_of(picture))
            spans = (np.ptp(rows) + 1) / SIZE[0], (np.ptp(columns) + 1) / SIZE[1]
            self.assertGreater(max(spans), 0.90, view)
            self.assertLess(max(spans), 0.97, view)
            rim = SIZE[0] - 1 - rows.max(), rows.min(), SIZE[1] - 1 - columns.max(), columns.min()
            self.assertGreaterEqual(min(rim), 2, view)

    def test_level_ground_has_the_colour_of_the_map(self):
        dem = make(self.path("dem.tif"), np.full((20, 20), 5.0))
        picture = self.draw(dem)
        self.succeed("shade", dem, "-o", self.path("map.png"), "--azimuths", "8")
        color = gdal.Open(self.path("map.png")).ReadAsArray()[:, 10, 10].astype(int)
        self.assertLessEqual(np.abs(picture[SIZE[0] // 2, SIZE[1] // 2] - color).max(), 1)

    def test_shadows_and_sides(self):
        # A ridge seen from the south with the sun in the west: its left side is bright, its right
        # side dark.
        y, x = np.mgrid[0:41, 0:41]
        tent = make(self.path("dem.tif"), 200.0 - 10.0 * np.abs(x - 20.0) + 0.0 * y)
        picture = self.draw(tent, "--sun", "270,25", "--colors", "gray")
        middle = picture[SIZE[0] // 2, :, :3].sum(axis=-1)
        seen = np.nonzero(self.terrain_of(picture)[SIZE[0] // 2])[0]
        quarter = len(seen) // 4
        self.assertGreater(middle[seen[quarter]], 1.3 * middle[seen[-quarter]])

    def test_north_is_away_from_the_viewer(self):
        heights = np.zeros((40, 40))
        heights[30:, :15] = 200.0  # a block in the north-west
        dem = make(self.path("dem.tif"), heights)
        seen = self.terrain_of(self.draw(dem))
        top = np.argmax(seen, axis=0)  # the first row with terrain in each column
        left = top[SIZE[1] // 2 - 30]
        right = top[SIZE[1] // 2 + 30]
        self.assertLess(left, right - 3)

    def test_exaggeration_raises(self):
        dem = make(self.path("dem.tif"), hills(40, 40, relief=100.0))
        spans = [np.ptp(np.nonzero(self.terrain_of(
            self.draw(dem, "--exaggeration", f, "--from", "180,0")))[0]) for f in ["1", "4"]]
        self.assertGreater(spans[1], 1.5 * spans[0])

    def test_holes_show_the_sky(self):
        heights = np.zeros((40, 40))
        heights[10:30, 10:30] = np.nan
        dem = make(self.path("dem.tif"), heights, nodata=-9999.0)
        seen = self.terrain_of(self.draw(dem, "--from", "180,90"))
        self.assertFalse(seen[SIZE[0] // 2, SIZE[1] // 2])
        self.assertTrue(seen[SIZE[0] // 2, SIZE[1] // 2 - 50])

    def test_passes(self):
        dem = make(self.path("dem.tif"), hills(30, 40))
        self.draw(dem)
        done = self.run_program("shade", dem, "-o", self.path("out.png"), "--view", "perspective",
                                "-v", env=environment())
        passes = [line[:14].strip() for line in done.stderr.splitlines()]
        self.assertEqual(passes[-5:], ["shading", "mesh", "skirt", "draw", "write"])
        done = self.run_program("shade", dem, "-o", self.path("out.png"), "-v", env=environment())
        self.assertNotIn("draw", done.stderr)

    def test_wrong_options(self):
        dem = make(self.path("dem.tif"), hills(10, 10))
        view = ["shade", dem, "--view", "perspective", "-o"]
        for name in ["out.tif", "out.exr"]:
            self.refused(2, *view, self.path(name), says="end its name in .png")
        png = [*view, self.path("out.png")]
        for size in ["0x5", "5x9000", "-1x4"]:
            self.refused(2, *png, "--size", size, says="1x1 to 8192x8192")
        for size in ["5", "5x", "axb", "5x5x5"]:
            self.refused(2, *png, "--size", size, says="WxH")
        for place in ["10,91", "10,-1"]:
            self.refused(2, *png, "--from", place, says="is out of range")
        for place in ["10", "a,b", "nan,3", "1,2,3"]:
            self.refused(2, *png, "--from", place, says="AZ,EL")

    def test_without_opengl_there_is_a_reason_and_a_map(self):
        dem = make(self.path("dem.tif"), hills(10, 10))
        for display in [{}, {"DISPLAY": ":98765"}]:
            bare = environment(**NO_EGL, **display)
            self.refused(1, "shade", dem, "--view", "perspective", "-o", self.path("out.png"),
                         says="a perspective view needs OpenGL", env=bare)
        self.succeed("shade", dem, "-o", self.path("out.png"), env=environment(**NO_EGL))

    def test_nothing_but_holes(self):
        dem = make(self.path("dem.tif"), np.where(np.eye(9) > 0, 1.0, np.nan), nodata=-9999.0)
        done = self.run_program("shade", dem, "-o", self.path("out.png"), "--view", "perspective",
                                env=environment())
        if "no OpenGL" in done.stderr:
            self.skipTest(done.stderr.strip())
        self.assertEqual(done.returncode, 1)
        self.assertIn("nothing to see", done.stderr)

    def test_an_x_server_will_do(self):
        if not shutil.which("xvfb-run"):
            self.skipTest("xvfb-run is not installed")
        dem = make(self.path("dem.tif"), hills(40, 40))
        without = self.draw(dem)
        xvfb = ["xvfb-run", "-a", "-s", "-screen 0 640x480x24 -noreset"]
        done = Program.subprocess.run(
            [*xvfb, Program.PROGRAM, "shade", dem, "-o", self.path("x.png"), "--view",
             "perspective", "--size", "%dx%d" % SIZE[::-1], "--azimuths", "8"],
            stdin=Program.subprocess.DEVNULL, capture_output=True, text=True, timeout=300,
            env=environment(**NO_EGL), check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        drawn = np.moveaxis(gdal.Open(self.path("x.png")).ReadAsArray(), 0, -1).astype(int)
        # The same driver with another window: only rounding may differ.
        self.assertLessEqual(np.abs(drawn - without).max(), 2)


if __name__ == "__main__":
    Program.main()
