# SPDX-License-Identifier: BSD-3-Clause
"""Utilities/check-exports finds what a library exports without being asked to."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

COMPILER = sys.argv.pop()
CHECK = sys.argv.pop()
HEADER = """\
#pragma once
#define MOON_EXPORT __attribute__((visibility("default")))
namespace skyline
{
class MOON_EXPORT Moon
{
public:
  virtual ~Moon();
  template <int N>
  int Phase(int (*of)(int)) const { return of(N); }
  struct Crater { void Fill(); };
};
MOON_EXPORT int Rise(const Moon& moon);
int Set(const Moon& moon);
struct Stars { void Shine(); };
}
"""
SOURCE = """\
#include "Moon.h"
#include <vector>
namespace skyline
{
Moon::~Moon() = default;
int Rise(const Moon& moon) { return moon.Phase<3>([](int n) { return n; }); }
int Set(const Moon&) { std::vector<int> list; list.push_back(1); return list[0]; }
void Stars::Shine() {}
}
"""


class TestCheckExports(unittest.TestCase):
    def check(self, *flags):
        with tempfile.TemporaryDirectory() as scratch:
            root = Path(scratch)
            (root / "Moon.h").write_text(HEADER)
            (root / "Moon.cxx").write_text(SOURCE)
            library = root / "libMoon.so"
            subprocess.run(
                [COMPILER, "-shared", "-fPIC", "-std=c++17", *flags, root / "Moon.cxx", "-o", library],
                check=True)
            done = subprocess.run(
                [CHECK, library, "MOON_EXPORT", root], capture_output=True, text=True)
            return done.returncode, done.stdout

    def test_hidden_by_default(self):
        status, output = self.check("-O1", "-fvisibility=hidden", "-fvisibility-inlines-hidden")
        # What is left of the C++ library's templates is found, and nothing else is.
        for line in output.splitlines()[:-1]:
            self.assertRegex(line, r"exports .*std::.*, which no MOON_EXPORT marks")
        self.assertEqual(status, 1 if len(output.splitlines()) > 1 else 0)

    def test_visible_by_default(self):
        status, output = self.check("-O0")
        self.assertEqual(status, 1)
        self.assertIn("exports skyline::Set(skyline::Moon const&), which", output)
        self.assertIn("exports skyline::Stars::Shine(), which", output)
        self.assertIn("exports std::vector<int", output)
        for marked in ("skyline::Rise", "skyline::Moon::~Moon", "vtable for skyline::Moon", "Phase<3>"):
            self.assertNotRegex(output, rf"exports (int )?{marked}")

    def test_no_library(self):
        done = subprocess.run([CHECK, "/nonexistent", "MOON_EXPORT", "/tmp"], capture_output=True)
        self.assertNotEqual(done.returncode, 0)


if __name__ == "__main__":
    unittest.main()
