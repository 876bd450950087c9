# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scripts that create a mapper of VTK's get one that marches, if somebody wants it."""
import os
import subprocess
import sys
import unittest

from vtkmodules.vtkRenderingVolume import vtkProjectedTetrahedraMapper
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

import vtktetmarch

VARIABLE = "TETMARCH_REPLACE_PROJECTED_TETRAHEDRA"
SCRIPT = """
from vtkmodules.vtkRenderingVolume import vtkProjectedTetrahedraMapper
import {first}, {second}
print(vtkProjectedTetrahedraMapper().GetClassName())
"""


class ReplaceTest(unittest.TestCase):
    def test_by_a_call(self):
        factory = vtktetmarch.vtkTetMarchObjectFactory
        self.assertFalse(factory.GetReplacesProjectedTetrahedra())
        factory.SetReplacesProjectedTetrahedra(True)
        replacement = vtkProjectedTetrahedraMapper()
        factory.SetReplacesProjectedTetrahedra(False)
        self.assertIsInstance(replacement, vtktetmarch.vtkTetMarchProjectedTetrahedraMapper)
        self.assertIsInstance(replacement.GetMarchingMapper(), vtktetmarch.vtkTetMarchVolumeMapper)
        self.assertEqual(vtkProjectedTetrahedraMapper().GetClassName(), "vtkOpenGLProjectedTetrahedraMapper")
        self.assertIn("MarchingMapper:", str(replacement))

    def class_made(self, value, modules):
        environment = dict(os.environ, **{VARIABLE: value})
        script = SCRIPT.format(first=modules[0], second=modules[1])
        run = subprocess.run([sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=True)
        return run.stdout.strip()

    def test_by_the_environment(self):
        modules = ["vtktetmarch", "vtkmodules.vtkRenderingVolumeOpenGL2"]
        for order in (modules, modules[::-1]):
            self.assertEqual(self.class_made("1", order), "vtkTetMarchProjectedTetrahedraMapper")
            for off in ("", "0"):
                self.assertEqual(self.class_made(off, order), "vtkOpenGLProjectedTetrahedraMapper")


SMART_VARIABLE = "TETMARCH_REPLACE_SMART_VOLUME"
IMPORTS = {
    "as a module": "import vtkmodules.all as vtk; made = vtk.vtkSmartVolumeMapper()",
    "by its name": "from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper; made = vtkSmartVolumeMapper()",
}


def class_made_by(script, environment=None):
    run = subprocess.run([sys.executable, "-c", script + "; print(made.GetClassName())"], capture_output=True, text=True,
                         env=dict(os.environ, **(environment or {})), check=True)
    return run.stdout.strip()


class ReplaceSmartVolumeTest(unittest.TestCase):
    OURS, STOCK = "vtkTetMarchSmartVolumeMapper", "vtkSmartVolumeMapper"

    def test_by_a_call(self):
        for how, create in IMPORTS.items():
            for order in ("import vtktetmarch, vtkmodules.all", "import vtkmodules.all, vtktetmarch", "import vtktetmarch"):
                with self.subTest(how=how, order=order):
                    self.assertEqual(class_made_by(f"{order}; {create}"), self.STOCK)
                    replace = f"{order}; vtktetmarch.replace_smart_volume_mapper()"
                    self.assertEqual(class_made_by(f"{replace}; {create}"), self.OURS)
                    back = f"{replace}; vtktetmarch.replace_smart_volume_mapper(False)"
                    self.assertEqual(class_made_by(f"{back}; {create}"), self.STOCK)

    def test_by_the_environment(self):
        for value, expected in (("1", self.OURS), ("", self.STOCK), ("0", self.STOCK)):
            for create in IMPORTS.values():
                self.assertEqual(class_made_by("import vtktetmarch; " + create, {SMART_VARIABLE: value}), expected)

    def test_one_does_not_ask_for_the_other(self):
        factory = vtktetmarch.vtkTetMarchObjectFactory
        factory.SetReplacesSmartVolume(True)
        self.assertFalse(factory.GetReplacesProjectedTetrahedra())
        self.assertEqual(vtkProjectedTetrahedraMapper().GetClassName(), "vtkOpenGLProjectedTetrahedraMapper")
        factory.SetReplacesProjectedTetrahedra(True)
        factory.SetReplacesSmartVolume(False)
        self.assertIsInstance(vtkProjectedTetrahedraMapper(), vtktetmarch.vtkTetMarchProjectedTetrahedraMapper)
        factory.SetReplacesProjectedTetrahedra(False)
        self.assertFalse(factory.GetReplacesSmartVolume())


if __name__ == "__main__":
    unittest.main(verbosity=2)
