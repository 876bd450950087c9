# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names that users may have from before are still there, and mean the same as the new ones."""
import unittest

import vtkmodules.all as vtk
from vtktetmarch import vtkTetMarchVolumeMapper


class DeprecatedTest(unittest.TestCase):
    def test_names_of_the_mapper(self):
        mapper = vtkTetMarchVolumeMapper()
        self.assertEqual((mapper.VIEW_SHELL_FACES, mapper.VIEW_SHELL_COORDINATES),
                         (mapper.VIEW_BOUNDARY_FACES, mapper.VIEW_BOUNDARY_COORDINATES))
        mapper.SetViewModeToShellFaces()
        self.assertEqual(mapper.GetViewMode(), mapper.VIEW_BOUNDARY_FACES)
        mapper.SetViewModeToShellCoordinates()
        self.assertEqual(mapper.GetViewMode(), mapper.VIEW_BOUNDARY_COORDINATES)
        self.assertEqual(mapper.GetNumberOfEvaluations(), mapper.GetNumberOfLookups())
        errors = []
        mapper.AddObserver("ErrorEvent", lambda *_: errors.append(True))
        self.assertIs(mapper.RenderReference(None, vtk.vtkFloatArray()), False)
        self.assertIs(mapper.CompareWithReference(None), False)
        self.assertEqual(len(errors), 2)  # there is no frame yet


if __name__ == "__main__":
    unittest.main()
