# SPDX-License-Identifier: BSD-3-Clause
"""Sources on the command line: the options that allow files to refer to other places, and pipes.

Testing/Python/TestUntrusted.py has the table of hostile files.
"""
import os
import signal
import struct
import subprocess
import time

import Program
from Program import UTM10, ToolTest, hills, make, np

COMMANDS = ["horizon", "sky-view", "sun", "shadow-height", "irradiance", "shade"]


class Allowed(ToolTest):
    def setUp(self):
        super().setUp()
        os.mkdir(self.path("mine"))
        make(self.path("tile.tif"), hills(12, 12), epsg=UTM10)
        self.dem = self.path("mine/dem.vrt")
        with open(self.dem, "w") as file:
            file.write("<VRTDataset rasterXSize='12' rasterYSize='12'><GeoTransform>500000,30,0,5100000,"
                       "0,-30</GeoTransform><VRTRasterBand dataType='Float64' band='1'><SimpleSource>"
                       "<SourceFilename relativeToVRT='1'>../tile.tif</SourceFilename></SimpleSource>"
                       "</VRTRasterBand></VRTDataset>")

    def test_every_command_has_the_options(self):
        for command in COMMANDS:
            with self.subTest(command=command):
                self.refused(1, command, self.dem, "-o", self.path("out.tif"),
                             says="--allow-elsewhere")
        self.succeed("sun", self.dem, "--allow-elsewhere", "-o", self.path("out.tif"), "--quiet")
        self.refused(1, "sun", "/vsicurl/http://127.0.0.1:9/dem.tif", says="--allow-network")
        self.refused(1, "sun", "PG:host=127.0.0.1 port=9", says="--driver PostGISRaster")
        self.refused(1, "sun", self.dem, "--driver", "WMS", says="--allow-network")
        self.refused(1, "sun", self.dem, "--driver", "NoSuch", says="no driver 'NoSuch'")

    def test_a_crs_that_cannot_be_read(self):
        with open(self.dem) as file:
            text = file.read()
        for name, srs in (("mistyped", "EPSG:3261000"), ("garbage", "GEOGCS[garbage"),
                          ("words", "no CRS at all")):
            with self.subTest(name=name):
                path = self.path("mine/crs.vrt")
                with open(path, "w") as file:
                    file.write(text.replace("<GeoTransform>", f"<SRS>{srs}</SRS><GeoTransform>"))
                self.refused(1, "sun", path, "--allow-elsewhere", says="cannot use")
        # Without its database, PROJ gives the CRS of a GeoTIFF another meaning.
        nowhere = dict(os.environ, PROJ_DATA="/nonexistent", PROJ_LIB="/nonexistent")
        self.refused(1, "sun", self.path("tile.tif"), says="proj.db", env=nowhere)
        # An unknown code in the GeoKeys: 32999 instead of 32610.
        with open(self.path("tile.tif"), "rb") as file:
            content = file.read()
        keys = struct.pack("<4H", 3072, 0, 1, UTM10)
        self.assertIn(keys, content)
        with open(self.path("mine/keys.tif"), "wb") as file:
            file.write(content.replace(keys, struct.pack("<4H", 3072, 0, 1, 32999)))
        self.refused(1, "sun", self.path("mine/keys.tif"), says="crs not found")
        # An .asc file takes its CRS from a .prj file, a .tif file does not.
        with open(self.path("mine/grid.asc"), "w") as file:
            file.write("ncols 2\nnrows 2\nxllcorner 7\nyllcorner 46\ncellsize 0.001\n1 2\n3 4\n")
        with open(self.path("mine/grid.prj"), "w") as file:
            file.write("garbage, not a CRS\n")
        self.refused(1, "sun", self.path("mine/grid.asc"), says="grid.prj")
        make(self.path("mine/bare.tif"), hills(12, 12))
        with open(self.path("mine/bare.prj"), "w") as file:
            file.write('GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],'
                       'PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]]\n')
        done = self.run_program("sun", self.path("mine/bare.tif"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("bare.prj' lies beside it; assuming x and y in metres", done.stderr)
        with open(self.path("mine/bare.tif.aux.xml"), "w") as file:
            file.write("<PAMDataset><SRS>EPSG:3261000</SRS></PAMDataset>")
        self.refused(1, "sun", self.path("mine/bare.tif"), says="cannot use")


class Streams(ToolTest):
    def setUp(self):
        super().setUp()
        # Larger than the megabyte of standard input that GDAL stores.
        self.dem = make(self.path("dem.tif"), hills(500, 600), epsg=UTM10)

    def test_standard_input(self):
        self.assertGreater(os.path.getsize(self.dem), 2 << 20)
        self.succeed("sun", self.dem, "-o", self.path("expected.tif"))
        expected = Program.read(self.path("expected.tif"))
        with open(self.dem, "rb") as file:
            content = file.read()
        for name in ("/vsistdin/", "/dev/stdin"):
            for way in ("pipe", "file"):
                with self.subTest(name=name, way=way), open(self.dem, "rb") as file:
                    given = {"input": content} if way == "pipe" else {"stdin": file}
                    done = subprocess.run([Program.PROGRAM, "sun", name, "-o", self.path("out.tif")],
                                          capture_output=True, timeout=120, **given)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    np.testing.assert_array_equal(Program.read(self.path("out.tif")), expected)

    def test_named_pipe(self):
        os.mkfifo(self.path("pipe.tif"))
        writer = subprocess.Popen(["sh", "-c", 'cat "$0" > "$1"', self.dem, self.path("pipe.tif")])
        self.addCleanup(writer.kill)
        self.succeed("horizon", self.path("pipe.tif"), "-o", self.path("out.tif"), "--azimuths", "1")
        self.assertEqual(writer.wait(10), 0)

    def test_a_pipe_that_nobody_writes(self):
        os.mkfifo(self.path("pipe.tif"))
        self.refused(1, "sun", self.path("pipe.tif"), says="no program wrote")
        waiting = subprocess.Popen([Program.PROGRAM, "sun", self.path("pipe.tif")],
                                   stderr=subprocess.PIPE)
        time.sleep(1.0)  # until the program waits
        waiting.send_signal(signal.SIGINT)
        begin = time.monotonic()
        waiting.communicate(timeout=60)
        self.assertLess(time.monotonic() - begin, 5.0)  # 0.1 s on an idle machine
        self.assertNotEqual(waiting.returncode, 0)
        self.refused(1, "irradiance", self.dem, "--environment", self.path("pipe.tif"), "-o",
                     self.path("out.tif"), says="pipe")

    def test_empty_input_and_devices(self):
        done = subprocess.run([Program.PROGRAM, "sun", "/vsistdin/"], input=b"",
                              capture_output=True, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"empty", done.stderr)
        self.refused(1, "sun", "/vsistdin/", says="device")  # /dev/null


if __name__ == "__main__":
    Program.main()
