# SPDX-License-Identifier: BSD-3-Clause
"""Code that the tests of the command line share: it runs the program, and makes and reads rasters.

Each test file is run as `python3 TestX.py PROGRAM DATA`: the built program and Testing/Data.
"""
import os
import resource
import shutil
import subprocess
import sys
import tempfile
import unittest

SKIPPED = 77  # the exit code that ctest counts as skipped

try:
    import numpy as np
    from osgeo import gdal, osr
except ImportError as missing:
    print("skipped:", missing, "(install python3-gdal)")
    sys.exit(SKIPPED)

gdal.UseExceptions()
osr.UseExceptions()

PROGRAM = ""
DATA = ""
UTM10 = 32610  # WGS 84 / UTM zone 10N
NODATA = -9999.0


def make(path, heights, step=(30.0, 30.0), corner=(500000.0, 5100000.0), epsg=None, wkt=None,
         nodata=None, south_up=False, kind=gdal.GDT_Float64, unit=None):
    """Writes heights (row 0 is the southern edge) as a GeoTIFF. `corner` is the outer south-western
    corner."""
    rows, columns = heights.shape
    driver = gdal.GetDriverByName("GTiff")
    raster = driver.Create(path, columns, rows, 1, kind)
    if south_up:
        raster.SetGeoTransform((corner[0], step[0], 0.0, corner[1], 0.0, step[1]))
    else:
        raster.SetGeoTransform(
            (corner[0], step[0], 0.0, corner[1] + rows * step[1], 0.0, -step[1]))
    if epsg:
        crs = osr.SpatialReference()
        crs.ImportFromEPSG(epsg)
        raster.SetProjection(crs.ExportToWkt())
    if wkt:
        raster.SetProjection(wkt)
    band = raster.GetRasterBand(1)
    if nodata is not None:
        band.SetNoDataValue(nodata)
        heights = np.where(np.isnan(heights), nodata, heights)
    if unit:
        band.SetUnitType(unit)
    band.WriteArray(heights if south_up else heights[::-1])
    raster = None
    return path


def read(path):
    """Values as (bands, rows, columns) of doubles. Row 0 is the southern edge; nodata values are NaN."""
    raster = gdal.Open(path)
    values = raster.ReadAsArray().astype(float)
    values = values.reshape(-1, raster.RasterYSize, raster.RasterXSize)
    nodata = raster.GetRasterBand(1).GetNoDataValue()
    if nodata is not None:
        values[values == nodata] = np.nan
    return values if raster.GetGeoTransform()[5] > 0 else values[:, ::-1]


def hills(rows, columns, seed=1, relief=300.0):
    """Terrain of a few waves. The same seed gives the same terrain."""
    random = np.random.default_rng(seed)
    y, x = np.mgrid[0:rows, 0:columns]
    heights = np.zeros((rows, columns))
    for k in range(1, 7):
        angle, phase = random.uniform(0.0, 2.0 * np.pi, 2)
        wave = 0.04 * k * (x * np.cos(angle) + y * np.sin(angle)) + phase
        heights += relief / k * np.sin(wave)
    return heights + 1000.0


def limit_memory(size):
    """A function for preexec_fn that limits the address space of the program to `size` bytes."""
    return lambda: resource.setrlimit(resource.RLIMIT_AS, (size, size))


class ToolTest(unittest.TestCase):
    """Runs the program in a folder of its own."""

    def skip_if_sanitized(self):
        """AddressSanitizer needs terabytes of address space, whatever the program does."""
        with open(PROGRAM, "rb") as program:
            if b"__asan_init" in program.read():
                self.skipTest("the address space of a sanitized program cannot be limited")

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="skyline-tools-")
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def path(self, name):
        return os.path.join(self.folder, name)

    def files(self):
        return sorted(os.listdir(self.folder))

    def run_program(self, *arguments, **options):
        """Returns the finished process, with its output as text. A hanging program is an error."""
        return subprocess.run([PROGRAM, *map(str, arguments)], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=300, cwd=self.folder,
                              **options)

    def succeed(self, *arguments, **options):
        done = self.run_program(*arguments, **options)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "", "a command that succeeds without a terminal is silent")
        return done

    def refused(self, code, *arguments, says="", **options):
        """The command must exit with `code`, print one line to standard error, and leave no new file."""
        before = self.files()
        done = self.run_program(*arguments, **options)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(done.stdout, "")
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 1, done.stderr)
        self.assertTrue(lines[0].startswith("skyline: "), lines[0])
        self.assertIn(says, lines[0])
        self.assertEqual(self.files(), before)
        return lines[0]


def main():
    """Reads the two arguments that each test file has, then runs its tests."""
    global PROGRAM, DATA
    if len(sys.argv) < 3:
        sys.exit("usage: " + sys.argv[0] + " PROGRAM DATA [unittest options]")
    PROGRAM, DATA = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    unittest.main(module="__main__", argv=[sys.argv[0]] + sys.argv[3:])
