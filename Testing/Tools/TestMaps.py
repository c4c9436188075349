# SPDX-License-Identifier: BSD-3-Clause
"""Distorted maps: conversion of azimuths, shadows at the right posts, no seams, and warnings."""
import Program
from Program import ToolTest, make, np, osr, read

RADIUS = 6371007.181  # of the sphere of MODIS
MODIS = f"+proj=sinu +R={RADIUS} +units=m +no_defs"


def wkt(text):
    crs = osr.SpatialReference()
    crs.SetFromUserInput(text)
    return crs.ExportToWkt()


def sinusoidal(longitude, latitude):
    return (RADIUS * np.radians(longitude) * np.cos(np.radians(latitude)),
            RADIUS * np.radians(latitude))


class Azimuths(ToolTest):
    def printed(self, *arguments):
        lines = self.succeed("sun", *arguments).stdout.splitlines()
        pairs = [line.split(": ") for line in lines]
        return {name: float(text.split()[0]) for name, text in pairs if "degree" in text}

    def test_true_and_grid_are_inverse_to_each_other(self):
        places = [
            (wkt(MODIS), sinusoidal(-150.0, 63.0)),
            (wkt("EPSG:3035"), (1800000.0, 950000.0)),
            (wkt("EPSG:5513"), (1040000.0, 870000.0)),
            (wkt("EPSG:2048"), (-50000.0, 3650000.0)),
            (wkt("EPSG:3413"), (2000000.0, -2000000.0)),
            (wkt("EPSG:32632"), (600000.0, 5200000.0)),
        ]
        for text, corner in places:
            dem = make(self.path("dem.tif"), np.zeros((41, 41)), step=(500.0, 500.0), corner=corner,
                       wkt=text)
            for hour in [6, 10, 15, 19]:
                sun = self.printed(dem, "--time", f"2026-06-21T{hour:02}:00Z")
                back = self.printed(dem, "--sun", f"{sun['grid azimuth']},20")
                turned = (back["azimuth"] - sun["azimuth"] + 180.0) % 360.0 - 180.0
                self.assertAlmostEqual(turned, 0.0, delta=2e-5, msg=text[:60])


class Shadows(ToolTest):
    # Alaska, 150 degrees from the meridian of the map: columns and rows meet at 113 degrees.
    STEP = 150.0
    POSTS = 61
    TOWER = 30

    def towards_tower(self):
        """Azimuth and distance from each post to the tower (great circles on the sphere)."""
        x0, y0 = sinusoidal(-150.0, 63.0)
        steps = (np.arange(self.POSTS) - self.TOWER) * self.STEP
        x, y = np.meshgrid(x0 + steps, y0 + steps)
        phi = y / RADIUS
        lam = x / (RADIUS * np.cos(phi))
        phi1, lam1 = phi[self.TOWER, self.TOWER], lam[self.TOWER, self.TOWER]
        azimuth = np.degrees(np.arctan2(
            np.sin(lam1 - lam) * np.cos(phi1),
            np.cos(phi) * np.sin(phi1) - np.sin(phi) * np.cos(phi1) * np.cos(lam1 - lam)))
        half = (np.sin((phi1 - phi) / 2) ** 2 +
                np.cos(phi) * np.cos(phi1) * np.sin((lam1 - lam) / 2) ** 2)
        return azimuth % 360.0, 2.0 * RADIUS * np.arcsin(np.sqrt(half))

    def dem(self):
        heights = np.zeros((self.POSTS, self.POSTS))
        middle = slice(self.TOWER - 2, self.TOWER + 3)
        heights[middle, middle] = 2600.0
        x0, y0 = sinusoidal(-150.0, 63.0)
        half = (self.TOWER + 0.5) * self.STEP
        return make(self.path("dem.tif"), heights, step=(self.STEP, self.STEP),
                    corner=(x0 - half, y0 - half), wkt=wkt(MODIS))

    def check(self, visibility, azimuth):
        """Posts where the middle of the tower is in front of the sun are dark; posts well beside it are
        lit."""
        towards, distance = self.towards_tower()
        off = np.radians((towards - azimuth + 180.0) % 360.0 - 180.0) * distance
        ahead = np.abs((towards - azimuth + 180.0) % 360.0 - 180.0) < 90.0
        near = (distance > 6.0 * self.STEP) & (distance < 20.0 * self.STEP)
        dark = near & ahead & (np.abs(off) < 0.7 * self.STEP)
        lit = near & (~ahead | (np.abs(off) > 9.0 * self.STEP))
        self.assertGreater(dark.sum(), 5)
        self.assertEqual(visibility[dark].max(), 0.0)
        self.assertEqual(visibility[lit].min(), 1.0)

    def test_the_sun_of_a_time_and_of_a_direction(self):
        dem = self.dem()
        time = "2026-06-21T06:00Z"  # there it is evening, and the sun is in the north-west
        printed = {name: float(text.split()[0]) for name, text in
                   (line.split(": ") for line in self.succeed("sun", dem, "--time", time)
                    .stdout.splitlines()) if "degree" in text}
        self.assertLess(printed["refracted elevation"], 25.0)
        out = self.path("sun.tif")
        self.succeed("sun", dem, "--time", time, "-o", out)
        self.check(read(out)[0], printed["azimuth"])
        direction = f"{printed['grid azimuth']},{printed['refracted elevation']}"
        self.succeed("sun", dem, "--sun", direction, "-o", out)
        self.check(read(out)[0], printed["azimuth"])

    def test_other_methods_tell_their_error(self):
        out = self.path("horizon.tif")
        arguments = ["horizon", self.dem(), "-o", out, "--azimuths", "4"]
        self.assertEqual(self.succeed(*arguments).stderr, "")
        done = self.run_program(*arguments, "--method", "sweep")
        self.assertEqual(done.returncode, 0)
        said = done.stderr
        self.assertIn("warning: the map is distorted: distances of the sweep are wrong by up to", said)
        self.assertIn("assuming the lengths of its centre everywhere; use", said)
        self.assertEqual(self.succeed(*arguments, "--method", "sweep", "--quiet").stderr, "")


class Seams(ToolTest):
    # Differences of neighbouring rows may be this many times the typical difference in a row, which
    # is the effect of a smooth ridge.
    SMOOTHNESS = 4.0

    def test_a_grazing_sun_over_a_raster_in_degrees(self):
        # 2.4 degrees of latitude, a slightly wavy ridge far in the east, and the sun in the
        # north-east just above it.
        rows, columns, step = 600, 150, 0.004
        y = np.arange(rows)
        heights = np.full((rows, columns), 300.0)  # the height 0 would cause a warning
        heights[:, 140] = 2300.0 + 60.0 * np.sin(y / 45.0)
        dem = make(self.path("dem.tif"), heights, step=(step, step), corner=(10.0, 59.0),
                   wkt=wkt("EPSG:4326"))
        out = self.path("sun.tif")
        self.succeed("sun", dem, "--sun", "58,3.15", "-o", out)
        visibility = read(out)[0][100:450, 10]
        self.assertGreater(visibility.max() - visibility.min(), 0.1)
        differences = np.abs(np.diff(visibility))
        typical = np.percentile(differences[differences > 0.0], 75)
        self.assertLess(differences.max(), self.SMOOTHNESS * typical)


if __name__ == "__main__":
    Program.main()
