# SPDX-License-Identifier: BSD-3-Clause
"""mypy --strict accepts the package and correct programs that use it, and rejects wrong ones.

Run as `python3 TestHints.py`; skipped where mypy is not installed.
"""

import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest

import skyline

if importlib.util.find_spec("mypy") is None:
    print("skipped: no module named mypy")
    sys.exit(77)

PACKAGES = os.path.dirname(os.path.dirname(skyline.__file__))
GOOD = """
import numpy as np
from numpy.typing import NDArray
import skyline

Floats = NDArray[np.float32]
z = np.zeros((3, 4))
seen: Floats = skyline.horizon(z, 10.0, 8, row0="south")
several: dict[str, Floats] = skyline.sky_view([[1, 2], [3, 4]], (1.0, 2.0), quantity=["SkyViewFactor"])
lit: Floats = skyline.sun_visibility("dem.tif", time=np.datetime64("2026-06-21"), method="fast")
light: Floats = skyline.irradiance(z, 10.0, "cie:3", sun=(1, 2), lamps=[(1.0, 2.0, 3.0, 4.0)])
shade: Floats = skyline.shadow_height(z, 10.0, sun=(1, 2))
place: tuple[float, float, float] = skyline.sun_position("dem.tif", "2026-06-21")
skyline.write("out.tif", seen, like="dem.tif")
skyline.update(skyline.vtkHeightFieldHorizon())
version: str = skyline.__version__


def my_sky(z: Floats, **options: object) -> Floats:
    try:
        return skyline.sky_view(z, 30.0)
    except skyline.Error:
        raise
"""
BAD = """
import skyline
skyline.horizon([[1, 2], [3, 4]], 10.0, row0="up")
skyline.horizon([[1, 2], [3, 4]], 10.0, rows=3)
skyline.horizon([[1, 2], [3, 4]], 10.0, azimuths="8")
skyline.sky_view([[1, 2], [3, 4]], 10.0, method="best")
skyline.shadow_height([[1, 2], [3, 4]], 10.0)
version: int = skyline.__version__
"""


def check(*arguments):
    """The lines of mypy that are errors."""
    command = [sys.executable, "-m", "mypy", "--strict", "--enable-incomplete-feature=Unpack",
               "--ignore-missing-imports", "--cache-dir", FOLDER, "--no-error-summary", *arguments]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=FOLDER,
                          env=dict(os.environ, MYPYPATH=PACKAGES))
    return [line for line in done.stdout.splitlines() if ": error:" in line or "Traceback" in line]


class Hints(unittest.TestCase):
    def file(self, text):
        name = os.path.join(FOLDER, "user.py")
        with open(name, "w", encoding="utf-8") as file:
            file.write(text)
        return name

    def test_the_package(self):
        self.assertEqual(check("-p", "skyline"), [])

    def test_users(self):
        self.assertEqual(check(self.file(GOOD)), [])
        wrong = check(self.file(BAD))
        lines = {int(line.split(":")[1]) for line in wrong}
        self.assertEqual(lines, {3, 4, 5, 6, 7, 8}, wrong)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as FOLDER:
        unittest.main()
