# SPDX-License-Identifier: BSD-3-Clause
"""Utilities/check-imports must find each type of violation, one at a time, and none in correct folders."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK = Path(sys.argv.pop())
HEADERS = {
    "Module/Horizon": "Horizon.h",
    "Filters": "vtkHeightFieldHorizon.h",
    "IO": "vtkHeightFieldReader.h",
    "Reference": "Oracle.h",
    "Testing/Filters": "FilterTesting.h",
    "Benchmark": "Scenes.h",
}
RULES = CHECK.read_text(encoding="utf-8")
FOLDERS = re.findall(r'^    "([A-Za-z/]+)": ', RULES, re.MULTILINE)


class TestCheckImports(unittest.TestCase):
    def check(self, folder, text, program=CHECK):
        """Exit status and output for a tree in which one source file of a folder has this text."""
        with tempfile.TemporaryDirectory() as scratch:
            root = Path(scratch)
            for name in FOLDERS:
                (root / name).mkdir(parents=True, exist_ok=True)
            for name, header in HEADERS.items():
                (root / name / header).write_text("#include <vector>\n")
            (root / folder).mkdir(parents=True, exist_ok=True)
            (root / folder / "Sample.cxx").write_text(text)
            done = subprocess.run(
                [sys.executable, program, root], capture_output=True, text=True)
            return done.returncode, done.stdout

    def assert_found(self, folder, line):
        status, output = self.check(folder, f"// first line\n{line}\n")
        self.assertEqual(status, 1, line)
        self.assertEqual(len(output.splitlines()), 1, output)
        self.assertTrue(output.startswith(f"{folder}/Sample.cxx:2: "), output)

    def assert_clean(self, folder, text):
        self.assertEqual(self.check(folder, text), (0, ""), text)

    def test_pure_folders(self):
        for folder in ("Module/Shared", "Module/Horizon", "Module/Sky"):
            for line in (
                '#include "vtkImageData.h"', "# include <GL/gl.h>", "#include <thread>",
                "#include <iostream>", "#include <mutex>", "#include <omp.h>",
                'std::printf("x");', "std::cerr << 1;", "#pragma omp parallel",
            ):
                self.assert_found(folder, line)

    def test_imports_point_down(self):
        self.assert_found("Module/Data", '#include "vtkHeightFieldHorizon.h"')
        self.assert_found("Module/Shared", '#include "Horizon.h"')
        self.assert_found("Module/HeightField", '#include "Horizon/Horizon.h"')
        self.assert_found("Filters", '#include "vtkHeightFieldReader.h"')
        self.assert_found("IO", '#include "vtkHeightFieldHorizon.h"')

    def test_nothing_shipped_knows_tests_or_reference(self):
        for folder in ("Filters", "Rendering", "Tools/Commands"):
            self.assert_found(folder, '#include "Reference/Oracle.h"')
        for folder in ("Tools/Shared", "Benchmark", "Studies", "Reference"):
            self.assert_found(folder, '#include "Testing/Filters/FilterTesting.h"')

    def test_testing_has_an_order_too(self):
        self.assert_found("Testing/Module", '#include "Testing/Filters/FilterTesting.h"')
        self.assert_found("Testing/Module", '#include "vtkHeightFieldHorizon.h"')
        self.assert_found("Testing/Filters", '#include "Scenes.h"')

    def test_a_circle_is_found(self):
        with tempfile.TemporaryDirectory() as scratch:
            copy = Path(scratch) / "check-imports"
            copy.write_text(
                RULES.replace('"Module/Shared": [],', '"Module/Shared": ["Module/Geo"],'))
            status, output = self.check("Module/Geo", "", copy)
        self.assertEqual(status, 1)
        self.assertIn("Module/Shared may not stand above Module/Geo", output)

    def test_a_folder_without_a_rule_is_found(self):
        status, output = self.check("Module/Moon", "#include <cmath>\n")
        self.assertEqual(status, 1)
        self.assertIn("Module/Moon/Sample.cxx: no rule for this folder", output)

    def test_clean(self):
        self.assert_clean("Module/Horizon", '#include "Horizon.h"\n#include <cmath>\n')
        self.assert_clean("Module/Horizon", "// no std::cout, no #include <thread>\n")
        self.assert_clean("Module/Horizon", "/* printf(1)\n#include <iostream> */\nint printfy;\n")
        self.assert_clean("Module/Sun", '#include "Horizon.h"\nstd::snprintf(a, b, "%f", c);\n')
        self.assert_clean("Module/Data", '#include "vtkFieldData.h"\n#include <iostream>\n')
        self.assert_clean("Tools/Commands", '#include "vtkHeightFieldReader.h"\n#include <cstdio>\n')
        self.assert_clean("Testing/Filters", '#include "Reference/Oracle.h"\n')
        self.assert_clean("Studies", '#include "Scenes.h"\n#include "Reference/Oracle.h"\n')

    def test_no_tree(self):
        done = subprocess.run([CHECK, "/nonexistent"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no folder Module in", done.stderr)


if __name__ == "__main__":
    unittest.main()
