# SPDX-License-Identifier: BSD-3-Clause
"""The version of CMakeLists.txt stands in every other place too.

    TestVersion.py ROOT VERSION PROGRAM
"""

import importlib.util
import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT, VERSION, PROGRAM = sys.argv[1:4]


class TestVersion(unittest.TestCase):
    def first(self, name, pattern):
        """The first match of the pattern in a file of the checkout."""
        text = (Path(ROOT) / name).read_text(encoding="utf-8")
        return re.search(pattern, text, re.MULTILINE).group(1)

    def test_citation(self):
        self.assertEqual(self.first("CITATION.cff", r"^version: (\S+)$"), VERSION)

    def test_changelog_begins_with_it(self):
        self.assertEqual(self.first("CHANGELOG.md", r"^## (\S+) \("), VERSION)

    def test_program(self):
        done = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, f"skyline {VERSION}\n")

    def test_python(self):
        if importlib.util.find_spec("skyline") is None:
            self.skipTest("built without Python")
        import skyline
        self.assertEqual(skyline.__version__, VERSION)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
