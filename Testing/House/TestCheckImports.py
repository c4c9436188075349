# SPDX-License-Identifier: BSD-3-Clause
"""Utilities/check-imports finds each kind of offence, one at a time, and nothing in clean rooms."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK = sys.argv.pop()
ROOMS = [
    "Module/Shared", "Module/Kernels", "Module/Geo", "Module/Data",
    "IO", "Filters", "Rendering", "Benchmark", "Tools", "Plugins",
]
HEADERS = {
    "Module/Kernels": "Horizon.h",
    "Filters": "vtkHeightFieldHorizon.h",
    "IO": "vtkHeightFieldReader.h",
}


class TestCheckImports(unittest.TestCase):
    def check(self, room, text):
        """Exit status and output for a tree where one source of a room has this text."""
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for name in ROOMS:
                (root / name).mkdir(parents=True)
            for name, header in HEADERS.items():
                (root / name / header).write_text("#include <vector>\n")
            (root / room / "Sample.cxx").write_text(text)
            done = subprocess.run([CHECK, root], capture_output=True, text=True)
            return done.returncode, done.stdout

    def assert_found(self, room, line):
        status, output = self.check(room, f"// first line\n{line}\n")
        self.assertEqual(status, 1, line)
        self.assertEqual(len(output.splitlines()), 1, output)
        self.assertTrue(output.startswith(f"{room}/Sample.cxx:2: "), output)

    def assert_clean(self, room, text):
        self.assertEqual(self.check(room, text), (0, ""), text)

    def test_pure_rooms(self):
        for room in ("Module/Shared", "Module/Kernels", "Module/Geo"):
            for line in (
                '#include "vtkImageData.h"', "# include <GL/gl.h>", "#include <thread>",
                "#include <iostream>", "#include <mutex>", "#include <omp.h>",
                'std::printf("x");', "std::cerr << 1;", "#pragma omp parallel",
            ):
                self.assert_found(room, line)

    def test_imports_point_down(self):
        self.assert_found("Module/Data", '#include "vtkHeightFieldHorizon.h"')
        self.assert_found("Module/Shared", '#include "Horizon.h"')
        self.assert_found("Filters", '#include "vtkHeightFieldReader.h"')
        self.assert_found("IO", '#include "vtkHeightFieldHorizon.h"')

    def test_clean(self):
        self.assert_clean("Module/Kernels", '#include "Horizon.h"\n#include <cmath>\n')
        self.assert_clean("Module/Kernels", "// no std::cout, no #include <thread>\n")
        self.assert_clean("Module/Kernels", "/* printf(1)\n#include <iostream> */\nint printfy;\n")
        self.assert_clean("Module/Geo", '#include "Horizon.h"\nstd::snprintf(a, b, "%f", c);\n')
        self.assert_clean("Module/Data", '#include "vtkFieldData.h"\n#include <iostream>\n')
        self.assert_clean("Tools", '#include "vtkHeightFieldReader.h"\n#include <cstdio>\n')

    def test_no_tree(self):
        done = subprocess.run([CHECK, "/nonexistent"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no folder Module/Shared", done.stderr)


if __name__ == "__main__":
    unittest.main()
