# SPDX-License-Identifier: BSD-3-Clause
"""Wrong input and failing output: exit 1, one line, and no file is left."""
import os
import resource
import subprocess

import Program
from Program import UTM10, ToolTest, hills, make, np

# Commands that write a raster, with their options apart from DEM and -o.
WRITERS = {"horizon": ["--azimuths", "4"], "sky-view": ["--azimuths", "4"], "sun": [], "shade": [],
           "irradiance": ["--azimuths", "4"]}


def content(path):
    with open(path, "rb") as file:
        return file.read()


class BadInput(ToolTest):
    def setUp(self):
        super().setUp()
        self.dem = make(self.path("dem.tif"), hills(20, 30), epsg=UTM10)

    def refuse(self, dem, says=""):
        """Each command must refuse this DEM, with and without -o."""
        for command, options in WRITERS.items():
            with self.subTest(command=command):
                self.refused(1, command, dem, "-o", self.path("out.tif"), *options, says=says)
        self.refused(1, "sun", dem, says=says)

    def test_missing_file(self):
        self.refuse(self.path("nowhere.tif"), says="nowhere.tif")

    def test_not_a_raster(self):
        with open(self.path("text.tif"), "w") as text:
            text.write("these are not heights\n")
        self.refuse(self.path("text.tif"), says="text.tif")

    def test_empty_file(self):
        open(self.path("empty.tif"), "w").close()
        self.refuse(self.path("empty.tif"), says="empty.tif")

    def test_folder(self):
        self.refuse(self.folder)

    def test_empty_name(self):
        self.refused(2, "horizon", "", "-o", self.path("out.tif"), says="DEM: the value is empty")

    def test_cut_off_file(self):
        with open(self.path("cut.tif"), "wb") as cut:
            cut.write(content(self.dem)[:2000])
        self.refused(1, "horizon", self.path("cut.tif"), "-o", self.path("out.tif"))

    def test_no_such_band(self):
        for band, code in [(0, 2), (-1, 2), (2, 1), (1000000, 1)]:
            with self.subTest(band=band):
                self.refused(code, "horizon", self.dem, "-o", self.path("out.tif"), "--band", band,
                             says="band")
                self.refused(code, "sun", self.dem, "--band", band, says="band")

    def test_all_posts_missing(self):
        dem = make(self.path("empty.tif"), np.full((8, 9), np.nan), nodata=-9999.0)
        for command, options in WRITERS.items():
            self.refused(1, command, dem, "-o", self.path("out.tif"), *options)

    def test_all_posts_nan_without_nodata(self):
        dem = make(self.path("nan.tif"), np.full((8, 9), np.nan))
        self.refused(1, "horizon", dem, "-o", self.path("out.tif"))

    def test_no_surface(self):
        for shape in [(1, 1), (1, 9), (9, 1)]:
            dem = make(self.path("line.tif"), np.ones(shape))
            for command, options in WRITERS.items():
                with self.subTest(shape=shape, command=command):
                    self.refused(
                        1, command, dem, "-o", self.path("out.tif"), *options, says="2 x 2")

    def test_crs_without_a_known_unit(self):
        # A virtual raster stores the CRS as it is written; a GeoTIFF would drop it.
        with open(self.path("unit.vrt"), "w") as raster:
            raster.write('''<VRTDataset rasterXSize="30" rasterYSize="20">
  <SRS>LOCAL_CS["somewhere",UNIT["unknown",1]]</SRS>
  <GeoTransform>0, 30, 0, 600, 0, -30</GeoTransform>
  <VRTRasterBand dataType="Float64" band="1">
    <SimpleSource><SourceFilename relativeToVRT="1">dem.tif</SourceFilename></SimpleSource>
  </VRTRasterBand>
</VRTDataset>''')
        self.refuse(self.path("unit.vrt"), says="unit")

    def test_rotated_raster(self):
        raster = Program.gdal.Open(self.dem, Program.gdal.GA_Update)
        raster.SetGeoTransform((500000.0, 30.0, 5.0, 5100000.0, 5.0, -30.0))
        raster = None
        self.refuse(self.dem)

    def test_time_without_a_place(self):
        dem = make(self.path("nowhere.tif"), hills(20, 30))
        for options in [[], ["-o", self.path("out.tif")]]:
            self.refused(1, "sun", dem, "--time", "2026-06-21T06:00Z", *options, says="--sun")

    def test_missing_light_map(self):
        self.refused(1, "shade", self.dem, "-o", self.path("out.png"), "--environment", "no.hdr",
                     says="no.hdr")

    def test_output_in_no_folder(self):
        for command in WRITERS:
            self.refused(1, command, self.dem, "-o", self.path("no/such/folder/out.tif"),
                         says="out.tif")

    def test_output_is_a_folder(self):
        os.mkdir(self.path("taken.tif"))
        for command in WRITERS:
            self.refused(1, command, self.dem, "-o", self.path("taken.tif"), says="taken.tif")

    def test_output_is_the_input(self):
        before = content(self.dem)
        os.symlink(self.dem, self.path("link.tif"))
        for name in [self.dem, self.path("link.tif")]:
            self.refused(1, "horizon", self.dem, "-o", name, says="part of the input")
        self.assertEqual(content(self.dem), before)

    def test_full_disk(self):
        os.symlink("/dev/full", self.path("full.tif"))
        os.symlink("/dev/full", self.path("full.png"))
        for command, options in WRITERS.items():
            with self.subTest(command=command):
                self.refused(1, command, self.dem, "-o", self.path("full.tif"), *options,
                             says="No space left")
        self.refused(1, "shade", self.dem, "-o", self.path("full.png"), says="No space left")
        self.refused(1, "horizon", self.dem, "-o", "/dev/full", "--azimuths", "4", says="/dev/full")
        self.assertTrue(os.path.exists("/dev/full") and not os.path.isfile("/dev/full"))

    def test_disk_that_fills_up_while_writing(self):
        dem = make(self.path("large.tif"), hills(200, 300), epsg=UTM10)

        def small_files_only():
            resource.setrlimit(resource.RLIMIT_FSIZE, (3000, 3000))

        for command, options in WRITERS.items():
            for flag in [[], ["--cloud-optimized"]]:
                with self.subTest(command=command, flag=flag):
                    self.refused(1, command, dem, "-o", self.path("out.tif"), *options, *flag,
                                 preexec_fn=small_files_only)
        for name in ["out.png", "out.exr"]:
            self.refused(1, "shade", dem, "-o", self.path(name), preexec_fn=small_files_only)

    def test_failure_leaves_an_older_file_as_it_was(self):
        with open(self.path("out.tif"), "w") as older:
            older.write("precious")
        self.refused(1, "horizon", self.dem, "-o", self.path("out.tif"), "--band", "9")
        self.assertEqual(content(self.path("out.tif")), b"precious")

    def test_standard_output_that_cannot_be_written(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run([Program.PROGRAM, "sun", self.dem], stdout=full,
                                  stderr=subprocess.PIPE, text=True, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)

    def test_not_enough_memory(self):
        self.skip_if_sanitized()
        dem = make(self.path("large.tif"), hills(1000, 1000))
        # 3600 azimuths of a million posts need 14 gigabytes.
        self.refused(1, "horizon", dem, "-o", self.path("out.tif"), "--azimuths", "3600",
                     preexec_fn=Program.limit_memory(3 << 30))

    def test_errors_show_even_when_quiet(self):
        self.refused(1, "horizon", self.path("nowhere.tif"), "-o", self.path("out.tif"), "--quiet")


if __name__ == "__main__":
    Program.main()
