# SPDX-License-Identifier: BSD-3-Clause
"""The examples in the docstrings of the package must give the results that they show.

Run as `python3 TestDoctests.py SOURCE`: the examples name files relative to the root of the
project.
"""

import doctest
import inspect
import os
import re
import subprocess
import sys
import tempfile
import typing
import unittest

import numpy as np
import skyline

MODULES = [skyline._functions, skyline._images, skyline._check, skyline._lights, skyline._run]
FUNCTIONS = ["horizon", "sky_view", "sun_visibility", "shadow_height", "irradiance", "sun_position",
             "read", "write", "to_image", "to_array", "update"]


class Doctests(unittest.TestCase):
    def test_examples(self):
        tried = 0
        for module in MODULES:
            names = {**vars(skyline), **vars(module), "np": np, "skyline": skyline}
            result = doctest.testmod(module, extraglobs=names, optionflags=doctest.NORMALIZE_WHITESPACE)
            self.assertEqual(result.failed, 0, module.__name__)
            tried += result.attempted
        self.assertGreaterEqual(tried, 20)

    def test_every_function_has_an_example_and_hints(self):
        for name in FUNCTIONS:
            function = getattr(skyline, name)
            self.assertIn(">>>", function.__doc__, name)
            hints = typing.get_type_hints(function)
            self.assertEqual(set(hints) - {"return"}, set(inspect.signature(function).parameters))
            self.assertIn("return", hints)
        package = os.path.dirname(skyline.__file__)
        self.assertTrue(os.path.exists(os.path.join(package, "py.typed")))

    def test_the_page(self):
        with open(os.path.join("Documentation", "python.md"), encoding="utf-8") as file:
            page = file.read()
        blocks = re.findall(r"```python\n(.*?)```", page, re.S)
        self.assertEqual(len(blocks), 2)
        testing = os.path.abspath("Testing")
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(testing, os.path.join(folder, "Testing"))
            for block in blocks:
                done = subprocess.run([sys.executable, "-c", "import skyline\n" + block], cwd=folder,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                self.assertEqual(done.returncode, 0, done.stdout)
            self.assertGreater(os.path.getsize(os.path.join(folder, "lit.tif")), 10000)

    def test_the_order_of_rows_comes_first(self):
        for name in ["horizon", "sky_view", "sun_visibility", "shadow_height", "irradiance", "to_image",
                     "to_array", "write"]:
            self.assertIn("NORTH", getattr(skyline, name).__doc__.split("\n")[0], name)


if __name__ == "__main__":
    os.chdir(sys.argv.pop(1))
    unittest.main()
