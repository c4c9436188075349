#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`skyline view` as users run it: in an X window, with synthetic keys and mouse events.

    python3 TestView.py PROGRAM DATA
"""
import ctypes
import ctypes.util
import os
import re
import shutil
import signal
import subprocess
import time
import unittest

import Program
from Program import np

PATIENCE = 90.0  # seconds until a picture is drawn on a busy machine
LEAST_CHANGE = 0.5  # codes of 255: without a change 0, after two hours of sun three times this value


class Server:
    """An Xvfb server for the duration of a test."""

    def __init__(self, size="1024x768"):
        read, write = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", size + "x24", "-nolisten", "tcp"],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as number:
            self.name = ":" + number.readline().strip()

    def stop(self):
        self.process.terminate()
        self.process.wait()


class Hands:
    """Sends keys and mouse events by the XTEST extension."""

    def __init__(self, display):
        self.x11 = ctypes.CDLL(ctypes.util.find_library("X11"))
        self.xtst = ctypes.CDLL(ctypes.util.find_library("Xtst"))
        self.x11.XOpenDisplay.restype = ctypes.c_void_p
        self.x11.XStringToKeysym.restype = ctypes.c_ulong
        self.display = ctypes.c_void_p(self.x11.XOpenDisplay(display.encode()))

    def key(self, name):
        symbol = self.x11.XStringToKeysym(name.encode())
        code = self.x11.XKeysymToKeycode(self.display, ctypes.c_ulong(symbol))
        for down in (1, 0):
            self.xtst.XTestFakeKeyEvent(self.display, code, down, ctypes.c_ulong(0))
        self.x11.XSync(self.display, 0)

    def move(self, x, y):
        self.xtst.XTestFakeMotionEvent(self.display, -1, x, y, ctypes.c_ulong(0))
        self.x11.XSync(self.display, 0)

    def button(self, number, down):
        self.xtst.XTestFakeButtonEvent(self.display, number, int(down), ctypes.c_ulong(0))
        self.x11.XSync(self.display, 0)


class View(Program.ToolTest):
    def run_without_display(self, *arguments):
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY",)}
        return subprocess.run([Program.PROGRAM, "view", *arguments], env=environment,
                              capture_output=True, text=True, timeout=PATIENCE, check=False)

    def test_without_a_display(self):
        for arguments in ([], ["nowhere.tif"]):
            done = self.run_without_display(*arguments)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn("no window can be opened", done.stderr)

    def test_help_names_the_keys(self):
        done = self.run_without_display("--help")
        self.assertEqual(done.returncode, 0)
        for word in ("drag left", "Space", "drop a file", "--environment", "--time", "--lamp"):
            self.assertIn(word, done.stdout)

    def test_wrong_usage(self):
        done = self.run_without_display("--size", "big")
        self.assertEqual(done.returncode, 2)


@unittest.skipUnless(shutil.which("Xvfb"), "Xvfb is not installed")
class Window(Program.ToolTest):
    def setUp(self):
        super().setUp()
        self.server = Server()
        self.addCleanup(self.server.stop)
        self.running = None

    def tearDown(self):
        if self.running and self.running.poll() is None:
            self.running.kill()
            self.running.wait()
        super().tearDown()

    def start(self, *arguments):
        self.log = self.path("log")
        with open(self.log, "w", encoding="utf-8") as log:
            self.running = subprocess.Popen(
                [Program.PROGRAM, "view", *arguments], stderr=log, cwd=self.folder,
                env={**os.environ, "DISPLAY": self.server.name})

    def wait(self, condition, what):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if condition():
                return
            time.sleep(0.1)
        self.fail("waited in vain for " + what)

    def text(self):
        with open(self.log, encoding="utf-8") as log:
            return log.read()

    @staticmethod
    def change(before, after):
        """The change of the codes in the middle of the window, where there is no text."""
        rows, columns = before.shape[-2] // 4, before.shape[-1] // 4
        middle = (Ellipsis, slice(rows, -rows), slice(columns, -columns))
        return np.abs(after[middle] - before[middle]).mean()

    def leave(self):
        self.running.wait(timeout=PATIENCE)
        return self.running.returncode

    def fail_early(self, *arguments):
        self.start(*arguments)
        self.assertEqual(self.leave(), 1, self.text())
        self.assertEqual(len(self.text().splitlines()), 1, self.text())
        return self.text()

    def test_terrain_that_cannot_be_seen(self):
        empty = Program.make(self.path("empty.tif"), np.full((20, 20), np.nan), epsg=Program.UTM10,
                             nodata=Program.NODATA)
        self.assertIn("posts are missing", self.fail_early(empty))
        self.assertIn("nowhere.tif", self.fail_early("nowhere.tif"))

    def test_time_without_a_place(self):
        flat = Program.make(self.path("flat.tif"), Program.hills(20, 30))
        self.assertIn("--time needs a DEM with a CRS",
                      self.fail_early(flat, "--time", "2026-06-21T12:00Z"))

    def test_an_interrupt_ends_it(self):
        self.start("--verbose", "--size", "320x240")
        self.wait(lambda: "picture 1:" in self.text(), "a picture")
        self.running.send_signal(signal.SIGINT)
        # By the signal itself, so that a loop in the shell stops too.
        self.assertEqual(self.leave(), -signal.SIGINT)
        self.assertIn("interrupted", self.text())

    def test_bundled_terrain_moved_by_hand(self):
        if not ctypes.util.find_library("Xtst"):
            self.skipTest("libXtst is not installed")
        self.start("--verbose", "--size", "640x400", "--azimuths", "16",
                   "--time", "2026-06-21T23:00Z")
        self.wait(lambda: "picture 1:" in self.text(), "a picture")
        hands = Hands(self.server.name)
        hands.move(320, 200)
        shots = []

        def shoot(name):
            hands.key("p")
            self.wait(lambda: os.path.exists(self.path(name)), name)
            time.sleep(0.5)
            shots.append(Program.read(self.path(name)))

        shoot("skyline-1.png")
        for _ in range(12):
            hands.key("Right")  # two hours later
        shoot("skyline-2.png")
        self.assertGreater(self.change(shots[0], shots[1]), LEAST_CHANGE, "the sun has moved")
        hands.button(1, True)
        hands.move(400, 180)
        hands.move(420, 170)
        hands.button(1, False)
        shoot("skyline-3.png")
        self.assertGreater(self.change(shots[1], shots[2]), LEAST_CHANGE, "the camera has moved")
        hands.key("q")
        self.assertEqual(self.leave(), 0, self.text())
        self.assertRegex(self.text(), re.compile(
            r"picture \d+: .*sun [\d.]+, shading [\d.]+, .*display [\d.]+, all [\d.]+ ms"))


if __name__ == "__main__":
    Program.main()
