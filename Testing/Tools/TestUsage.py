# SPDX-License-Identifier: BSD-3-Clause
"""Help, version and wrong usage."""
import os
import pty
import re
import subprocess

import Program
from Program import ToolTest, hills, make

COMMANDS = ["horizon", "sky-view", "sun", "shade"]


class Usage(ToolTest):
    def setUp(self):
        super().setUp()
        self.dem = make(self.path("dem.tif"), hills(5, 6))

    def test_help_tells_every_command(self):
        text = self.succeed("--help").stdout
        for command in COMMANDS:
            self.assertIn(command, text)

    def test_help_of_a_command_tells_options_units_ranges_and_defaults(self):
        options = {
            "horizon": ["--azimuths", "36", "--method", "exact", "--surface", "triangles", "--flat",
                        "--refraction", "0.13", "--tolerance", "--band", "--threads",
                        "--cloud-optimized", "--quiet", "--verbose", "degrees"],
            "sky-view": ["--azimuths", "72", "--quantity", "SkyViewFactor", "PositiveOpenness",
                         "0 to 1"],
            "sun": ["--time", "--sun", "315,45", "--sun-radius", "--limb-darkening", "UTC",
                    "-90 to 90", "clockwise"],
            "shade": ["--environment", "uniform", "cie:N", "--colors", "hypsometric", "viridis",
                      "--exposure", "auto", "--exaggeration"],
        }
        for command in COMMANDS:
            text = self.succeed(command, "--help").stdout
            for word in options[command] + ["-o", "DEM"]:
                self.assertIn(word, text, command)

    def test_version(self):
        text = self.succeed("--version").stdout
        self.assertRegex(text, re.compile(r"^skyline \d+\.\d+\.\d+\n$"))

    def test_images_are_no_part_of_the_start(self):
        # OpenImageIO loads as many libraries as everything else together. SkylineIO loads it with
        # the first image.
        linked = subprocess.run(["ldd", Program.PROGRAM], capture_output=True, text=True, check=True)
        self.assertIn("libSkylineIO", linked.stdout)
        self.assertNotIn("OpenImageIO", linked.stdout)

    def test_wrong_usage_exits_with_2(self):
        out = self.path("out.tif")
        for arguments in [
                [],
                ["frobnicate"],
                ["--frobnicate"],
                ["horizon"],
                ["horizon", self.dem],
                ["horizon", "-o", out],
                ["horizon", self.dem, "-o"],
                ["horizon", self.dem, "second.tif", "-o", out],
                ["horizon", self.dem, "-o", out, "--frobnicate"],
                ["horizon", self.dem, "-o", out, "--method", "magic"],
                ["horizon", self.dem, "-o", out, "--surface", "soup"],
                ["horizon", self.dem, "-o", out, "--azimuths", "many"],
                ["horizon", self.dem, "-o", out, "--azimuths", "1.5"],
                ["horizon", self.dem, "-o", out, "--threads", "-1"],
                ["horizon", self.dem, "-o", out, "--band", "first"],
                ["sky-view", self.dem, "-o", out, "--quantity", "Beauty"],
                ["sun", self.dem, "--sun", "12"],
                ["sun", self.dem, "--sun", "a,b"],
                ["sun", self.dem, "--sun", "1,2,3"],
                ["sun", self.dem, "--sun", "1,2", "--time", "2026-06-21T06:00Z"],
                ["sun", self.dem, "--sun-radius", "wide"],
                ["shade", self.dem, "-o", self.path("out.png"), "--colors", "rainbow"],
                ["shade", self.dem, "-o", self.path("out.png"), "--exposure", "bright"],
                ["shade", self.dem, "-o", self.path("out.png"), "--environment", "party"],
                ["shade", self.dem, "-o", self.path("out.png"), "--view", "sideways"],
        ]:
            with self.subTest(arguments=arguments):
                self.refused(2, *arguments)

    def test_quiet_says_nothing_and_verbose_tells_passes_and_times(self):
        out = self.path("out.tif")
        done = self.run_program("horizon", self.dem, "-o", out, "--quiet")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        done = self.run_program("horizon", self.dem, "-o", out, "--verbose")
        self.assertEqual((done.returncode, done.stdout), (0, ""))
        for title in ["read", "horizon", "write"]:
            self.assertRegex(done.stderr, re.compile(rf"^{title} +\d+\.\d+ s", re.MULTILINE))

    def test_progress_bar_on_a_terminal(self):
        for options, shown in [([], True), (["--quiet"], False)]:
            master, terminal = pty.openpty()
            done = subprocess.run(
                [Program.PROGRAM, "horizon", self.dem, "-o", self.path("out.tif"), *options],
                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=terminal, timeout=300)
            os.write(terminal, b"end")  # marks the end of the output
            text = ""
            while not text.endswith("end"):
                text += os.read(master, 65536).decode()
            os.close(terminal)
            os.close(master)
            self.assertEqual((done.returncode, done.stdout), (0, b""))
            self.assertEqual("horizon" in text and "%" in text, shown, text)
            self.assertNotIn("\n", text)
            # The progress bar is erased when its pass has ended.
            self.assertTrue(not shown or text.endswith("\r\x1b[Kend"), repr(text))

    def test_negative_numbers_are_values(self):
        self.succeed("sun", self.dem, "--sun", "-45,-10")
        self.succeed("sun", self.dem, "--sun=-45,-10")

    def test_names_with_spaces_and_dashes(self):
        make(self.path("my dem.tif"), hills(5, 6))
        self.succeed("horizon", "my dem.tif", "-o", "-my out.tif", "--azimuths", "4")
        self.assertIn("-my out.tif", self.files())
        self.succeed("sun", "--", "my dem.tif")


if __name__ == "__main__":
    Program.main()
