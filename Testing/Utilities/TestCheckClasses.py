# SPDX-License-Identifier: BSD-3-Clause
"""Utilities/check-classes finds each kind of offence, one at a time, and nothing in a clean class."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK = Path(sys.argv.pop())
HEADER = """\
#include "vtkSkylineABINamespace.h"
#include "SkylineFiltersModule.h"
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

class SKYLINEFILTERS_EXPORT vtkHeightFieldMoon : public vtkObject
{
public:
  static vtkHeightFieldMoon* New();
  vtkTypeMacro(vtkHeightFieldMoon, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkHeightFieldMoon() = default;
  ~vtkHeightFieldMoon() override = default;

private:
  vtkHeightFieldMoon(const vtkHeightFieldMoon&) = delete;
  void operator=(const vtkHeightFieldMoon&) = delete;
};
VTK_ABI_NAMESPACE_END
"""
SOURCE = '#include "vtkHeightFieldMoon.h"\nvtkStandardNewMacro(vtkHeightFieldMoon);\n'


class TestCheckClasses(unittest.TestCase):
    def check(self, header, source=SOURCE, name="Filters/vtkHeightFieldMoon"):
        with tempfile.TemporaryDirectory() as scratch:
            root = Path(scratch)
            for folder in ("Module", "IO", "Filters", "Rendering", "Plugins", "Tools"):
                (root / folder).mkdir()
            (root / f"{name}.h").write_text(header)
            (root / f"{name}.cxx").write_text(source)
            done = subprocess.run([CHECK, root], capture_output=True, text=True)
            return done.returncode, done.stdout

    def assert_found(self, old, new, reason, **more):
        self.assertIn(old, HEADER)
        status, output = self.check(HEADER.replace(old, new), **more)
        self.assertEqual(status, 1, output)
        self.assertEqual(len(output.splitlines()), 1, output)
        self.assertIn(reason, output)

    def test_clean(self):
        self.assertEqual(self.check(HEADER), (0, ""))

    def test_what_a_class_must_have(self):
        copy = "  vtkHeightFieldMoon(const vtkHeightFieldMoon&) = delete;\n"
        for line, reason in (
            ("  vtkTypeMacro(vtkHeightFieldMoon, vtkObject);\n", "lacks vtkTypeMacro"),
            ("  void PrintSelf(ostream& os, vtkIndent indent) override;\n", "lacks PrintSelf"),
            ("  vtkHeightFieldMoon() = default;\n", "lacks a protected constructor"),
            ("  ~vtkHeightFieldMoon() override = default;\n", "lacks a protected destructor"),
            (copy, "lacks a deleted copy constructor"),
            ("  void operator=(const vtkHeightFieldMoon&) = delete;\n", "lacks a deleted assignment"),
            ("SKYLINEFILTERS_EXPORT ", "is not exported"),
        ):
            self.assert_found(line, "", reason)

    def test_new(self):
        self.assertIn("without vtkStandardNewMacro", self.check(HEADER, SOURCE.split("\n")[0])[1])

    def test_abi_namespace(self):
        self.assert_found(
            "VTK_ABI_NAMESPACE_BEGIN\nclass vtkImageData;\n",
            "class vtkImageData;\nVTK_ABI_NAMESPACE_BEGIN\n", "'class vtkImageData;' stands outside")
        self.assert_found(
            "class vtkImageData;\n", "class vtkImageData;\nVTK_ABI_NAMESPACE_END\n",
            "vtkHeightFieldMoon stands outside")
        status, output = self.check("class vtkObject;\n", name="Tools/Moon")
        self.assertEqual(status, 1)
        self.assertIn("stands outside", output)

    def test_names(self):
        for name in ("vtkMoon", "vtkShadowMoon"):
            status, output = self.check(
                HEADER.replace("vtkHeightFieldMoon", name),
                SOURCE.replace("vtkHeightFieldMoon", name), f"Filters/{name}")
            self.assertEqual(status, 1)
            self.assertIn("outside the scheme", output)
        self.assertIn("no class of that name", self.check(
            "int Moon();\n", '#include "vtkSkylineMoon.h"\n', "IO/vtkSkylineMoon")[1])

    def test_public_headers_include_public_headers(self):
        self.assert_found(
            "#include <string>\n", '#include "HeightField/Grid.h"\n', "is not installed")

    def test_a_header_compiles_alone(self):
        self.assert_found(
            "<string>", "<vector>", "does not include it first",
            source='#include "vtkNew.h"\n' + SOURCE)


if __name__ == "__main__":
    unittest.main()
