# SPDX-License-Identifier: BSD-3-Clause
"""Hostile files and names are refused, or read without their hostile part: there must be no connection, no
access to other folders, no execution of code, no hang, and no use of all memory."""
import os
import random
import subprocess
import threading
import time

from Faults import LIBRARY, MANY_RUNS, RUNS, SEED, sanitized
import Program
import ReadFiles
from HostileFiles import LIGHTS, NAMES, RASTERS, REFUSED, SAFE, UNMENDED
from Program import UTM10, gdal, hills, limit_memory, make, np, read

# Seconds for one file, including a pipe without a writer.
PATIENCE = 60.0

# MB of the process; the program needs 200 for a small raster.
MOST_MEGABYTES = 1024

# The limit of its address space, so that large claims are refused on machines with much memory too.
ADDRESS_SPACE = 8 << 30

SECRET = b"these 256 bytes are nobody's heights. " * 7


class Ended:
    """A finished run of the program: its exit status, its messages, and its use of memory."""

    def __init__(self, code, said, seconds, megabytes):
        self.code, self.said, self.seconds, self.megabytes = code, said, seconds, megabytes


class HostileFiles(Program.ToolTest):
    def setUp(self):
        super().setUp()
        os.mkdir(self.path("private"))
        with open(self.path("private/secret.bin"), "wb") as file:
            file.write(SECRET)
        self.open = self.path("open")
        self.log = self.path("calls")
        self.reset()

    def some(self, table):
        """The whole table, or as much as there is time for. The readers alone always run the whole
        table."""
        return table if RUNS >= MANY_RUNS else random.Random(SEED).sample(table, min(RUNS, len(table)))

    def reset(self):
        """Makes a folder with one valid raster, and an empty log."""
        subprocess.run(["rm", "-rf", self.open, self.log], check=True)
        os.mkdir(self.open)
        make(os.path.join(self.open, "heights.tif"), hills(16, 16), epsg=UTM10,
             kind=gdal.GDT_Float32)

    def attempt(self, *arguments):
        """Runs the program in the folder of the hostile file, and logs all calls."""
        environment = dict(os.environ, SKYLINE_CALL_LOG=self.log, HOME=self.folder)
        for name in list(environment):
            if name.lower().endswith("_proxy"):
                del environment[name]  # so that the log shows the addresses themselves
        if LIBRARY and not sanitized(Program.PROGRAM):
            environment["LD_PRELOAD"] = LIBRARY
        start = time.monotonic()
        running = subprocess.Popen([Program.PROGRAM, *arguments], stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                                   cwd=self.open, env=environment,
                                   preexec_fn=None if sanitized(Program.PROGRAM)
                                   else limit_memory(ADDRESS_SPACE))
        late = threading.Timer(PATIENCE, running.kill)
        late.start()
        said = running.stderr.read()
        running.stderr.close()
        _, status, used = os.wait4(running.pid, 0)
        late.cancel()
        running.returncode = os.waitstatus_to_exitcode(status)
        return Ended(running.returncode, said, time.monotonic() - start, used.ru_maxrss / 1024)

    def check_calls(self):
        """Checks that the program did not connect, and opened only files that it needs."""
        if not os.path.exists(self.log):
            return
        with open(self.log, errors="replace") as file:
            for line in map(str.strip, file):
                self.assertTrue(line.startswith("open "), "reached for the network: " + line)
                path = os.path.join(self.open, line[len("open "):])
                self.assertNotRegex(os.path.realpath(path), "^/etc/passwd$|^/dev/zero$|/private/")

    def check(self, expected, ended, out, good):
        self.assertLess(ended.seconds, PATIENCE, "hung")
        self.check_calls()
        self.assertFalse(os.path.exists(os.path.join(self.open, "was-here")), "ran code of a file")
        self.assertFalse(os.path.exists(os.path.join(self.open, "gdalwmscache")), "made a cache")
        if not sanitized(Program.PROGRAM):
            self.assertLess(ended.megabytes, MOST_MEGABYTES, ended.said)
        if expected == SAFE and ended.code == 0:
            self.assertTrue(np.array_equal(read(out), good, equal_nan=True), "wrong heights")
            return
        self.assertIn(ended.code, [1, 2], ended.said)
        self.assertIn("skyline: ", ended.said)
        self.assertFalse(os.path.exists(out))

    def test_rasters(self):
        good = os.path.join(self.folder, "good.tif")
        self.attempt("horizon", "heights.tif", "-o", good, "--azimuths", "4")
        good = read(good)
        for what, expected, write in self.some(RASTERS):
            with self.subTest(what):
                if what in UNMENDED:
                    self.skipTest(UNMENDED[what])
                self.reset()
                out = os.path.join(self.open, "out.tif")
                ended = self.attempt("horizon", write(self.open), "-o", out, "--azimuths", "4")
                self.check(expected, ended, out, good)

    def test_names(self):
        for name in self.some(NAMES):
            with self.subTest(name):
                self.reset()
                out = os.path.join(self.open, "out.tif")
                self.check(REFUSED, self.attempt("horizon", name, "-o", out, "--azimuths", "4"), out,
                           None)

    def test_light_maps(self):
        for what, expected, write in self.some(LIGHTS):
            with self.subTest(what):
                self.reset()
                out = os.path.join(self.open, "out.tif")
                ended = self.attempt("irradiance", "heights.tif", "--environment", write(self.open),
                                     "-o", out, "--azimuths", "8")
                self.check(expected, ended, out, None)

    def test_in_one_process(self):
        """The same with the readers alone, under the sanitizers."""
        if not ReadFiles.PROGRAM:
            self.skipTest("SKYLINE_READ_FILES names no program")
        files = [("raster", name) for name in NAMES if "\n" not in name]
        for kind, table in [("raster", RASTERS), ("light", LIGHTS)]:
            for what, expected, write in table:
                if "pipe" in what or expected == SAFE:
                    continue
                folder = self.path("row%d" % len(files))
                os.mkdir(folder)
                make(os.path.join(folder, "heights.tif"), hills(16, 16), epsg=UTM10)
                files.append((kind, write(folder)))
        for (kind, path), verdict in zip(files, ReadFiles.read_files(files, self.log)):
            with self.subTest(path):
                self.assertEqual(verdict.word, "refused", verdict)
        self.check_calls()


if __name__ == "__main__":
    Program.main()
