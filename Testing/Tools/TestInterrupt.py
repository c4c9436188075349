# SPDX-License-Identifier: BSD-3-Clause
"""SIGINT and SIGTERM at any time: the program must end by the signal, soon, with one line and without a
file."""
import os
import signal
import subprocess
import time

import Program
from Program import ToolTest, UTM10, hills, make

# Seconds from the signal to the end: the delay of Tools/Shared/Interrupt.h, plus time for a busy machine.
SOON = 10.0

# Number of times that are tried, from before the start of the program to after its end.
STEPS = 12

# Seconds of CPU time after which the program is in its long computation; it starts in 0.15.
STARTED = 1.0


def processor_seconds(process):
    """The CPU time of a process. On a busy machine it grows slowly."""
    with open("/proc/%d/stat" % process) as file:
        fields = file.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Interrupt(ToolTest):
    def start(self, *arguments):
        return subprocess.Popen([Program.PROGRAM, *arguments], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, cwd=self.folder)

    def test_in_the_middle_of_long_work(self):
        make(self.path("dem.tif"), hills(1600, 1500), epsg=UTM10)
        for command, options in [("sky-view", ["--azimuths", "3600"]),
                                 ("sky-view", ["--azimuths", "3600", "--method", "sweep"]),
                                 ("shade", ["--azimuths", "3600"])]:
            for number in [signal.SIGINT, signal.SIGTERM]:
                with self.subTest(command=command, options=options, signal=number):
                    running = self.start(command, "dem.tif", "-o", "out.tif", *options)
                    while running.poll() is None and processor_seconds(running.pid) < STARTED:
                        time.sleep(0.02)
                    self.assertIsNone(running.poll(), "the work was too short to interrupt")
                    sent = time.monotonic()
                    running.send_signal(number)
                    _, text = running.communicate(timeout=60)
                    self.assertLess(time.monotonic() - sent, SOON)
                    self.assertEqual(running.returncode, -number)
                    self.assertEqual(text, "skyline: interrupted\n")
                    self.assertEqual(self.files(), ["dem.tif"])

    def test_at_any_moment_there_is_a_whole_file_or_none(self):
        dem = make(self.path("dem.tif"), hills(300, 280), epsg=UTM10)
        start = time.monotonic()
        self.succeed("horizon", dem, "-o", self.path("whole.tif"), "--azimuths", "48")
        duration = time.monotonic() - start
        whole = Program.read(self.path("whole.tif"))
        ends = set()
        for step in range(STEPS):
            out = self.path("out%d.tif" % step)
            running = self.start("horizon", dem, "-o", out, "--azimuths", "48")
            time.sleep(1.2 * duration * step / STEPS)
            running.send_signal(signal.SIGINT)
            _, text = running.communicate(timeout=60)
            ends.add(running.returncode)
            if "out%d.tif" % step in self.files():
                # The program finished before the signal, or at the same time.
                self.assertIn(running.returncode, [0, -signal.SIGINT])
                self.assertTrue(
                    Program.np.array_equal(Program.read(out), whole, equal_nan=True))
            else:
                # Before main begins, the signal has its default effect.
                self.assertEqual(running.returncode, -signal.SIGINT)
                self.assertIn(text, ["skyline: interrupted\n", ""])
            self.assertEqual([name for name in self.files() if "part" in name], [])
        self.assertIn(-signal.SIGINT, ends)


if __name__ == "__main__":
    Program.main()
