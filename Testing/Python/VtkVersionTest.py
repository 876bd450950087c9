# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Beside another VTK than that of the build, the import is one clear exception."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

from vtkmodules.vtkCommonCore import vtkVersion

BUILT_FOR = vtkVersion.GetVTKVersion()
OTHER_VTK = """
class vtkVersion:
    @staticmethod
    def GetVTKVersion():
        return "9.99.1"
"""


class VtkVersionTest(unittest.TestCase):
    def error_of_the_import(self, vtkmodules):
        """The last line on the standard error, where a package `vtkmodules` has this text as vtkCommonCore."""
        with tempfile.TemporaryDirectory() as folder:
            package = pathlib.Path(folder, "vtkmodules")
            package.mkdir()
            (package / "__init__.py").touch()
            (package / "vtkCommonCore.py").write_text(vtkmodules, encoding="utf-8")
            script = f"import sys; sys.path.insert(0, {folder!r})\nimport vtktetmarch"
            run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 1)
        return run.stderr.splitlines()[-1]

    def test_another_version(self):
        self.assertRegex(self.error_of_the_import(OTHER_VTK),
                         f"ImportError: .* built for VTK {BUILT_FOR}, and this Python has VTK 9.99.1: install that VTK")

    def test_none(self):
        self.assertRegex(self.error_of_the_import("raise ImportError('there is none')"),
                         f"ImportError: .* built for VTK {BUILT_FOR}, and this Python has no VTK .there is none.")


if __name__ == "__main__":
    unittest.main()
