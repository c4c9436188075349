# SPDX-License-Identifier: BSD-3-Clause
"""Signals that end Python while it writes leave no temporary file; source files are not overwritten."""
import os
import signal
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import skyline

# Prints a line when the temporary file exists, then waits for the signal while it is writing.
WRITING = """
import os, signal, sys, time
import numpy as np, skyline
folder, = sys.argv[1:]
writer = skyline.vtkHeightFieldWriter()
writer.SetInputData(skyline.to_image(np.random.default_rng(1).random((900, 900)), 1.0))
writer.SetFileName(folder + "/out.tif")
def wait(caller, event):
    if os.listdir(folder):
        print("writing", flush=True)
        time.sleep(60)
writer.AddObserver("ProgressEvent", wait)
writer.Write()
"""


class Signals(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def test_a_killed_python_leaves_nothing(self):
        for number in [signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT]:
            with self.subTest(signal=number):
                program = subprocess.Popen([sys.executable, "-c", WRITING, self.folder],
                                           stdout=subprocess.PIPE, text=True)
                self.addCleanup(program.kill)
                self.assertEqual(program.stdout.readline(), "writing\n")
                self.assertEqual(len(os.listdir(self.folder)), 1)
                program.send_signal(number)
                program.communicate(timeout=60)
                self.assertEqual(program.returncode, -number)
                self.assertEqual(os.listdir(self.folder), [])

    def test_an_image_is_not_written_over_its_file(self):
        dem = self.folder + "/dem.tif"
        skyline.write(dem, np.random.default_rng(1).random((20, 30)), spacing=30.0)
        with open(dem, "rb") as file:
            before = file.read()
        os.link(dem, self.folder + "/hard.tif")
        image = skyline.read(dem)
        for name in [dem, self.folder + "/hard.tif"]:
            with self.assertRaisesRegex(skyline.Error, "part of the input"):
                skyline.write(name, image)
        with open(dem, "rb") as file:
            self.assertEqual(file.read(), before)
        skyline.write(self.folder + "/other.tif", image)
        self.assertEqual(sorted(os.listdir(self.folder)), ["dem.tif", "hard.tif", "other.tif"])


if __name__ == "__main__":
    unittest.main()
