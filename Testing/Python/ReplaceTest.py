# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scripts that create a vtkProjectedTetrahedraMapper get one that marches, if somebody wants it."""
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


if __name__ == "__main__":
    unittest.main(verbosity=2)
