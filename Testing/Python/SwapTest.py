# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A script that used vtkProjectedTetrahedraMapper gets about the same picture from this mapper."""
import unittest

import scenes
import vtkmodules.all as vtk
from vtktetmarch import vtkTetMarchVolumeMapper

# Mean difference inside the silhouette, of 255. Projected tetrahedra interpolate 8-bit colours across a cell and
# sort roughly; on cells as small as these 0.2 is left of it. On a coarse grid (8 cubes) they lose whole cells.
CUBES = 20
ALLOWED = 1.0


def picture(mapper_class, law=None):
    mapper = mapper_class()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("x")
    if law is not None:
        mapper.SetOpacityLaw(law)
    return scenes.View(mapper, scenes.make_grid(CUBES)).pixels()


class SwapTest(unittest.TestCase):
    def test_the_picture_stays(self):
        theirs = picture(vtk.vtkProjectedTetrahedraMapper)
        ours = picture(vtkTetMarchVolumeMapper)
        self.assertGreater(scenes.covered(theirs), 0.2)
        self.assertAlmostEqual(scenes.covered(ours), scenes.covered(theirs), delta=0.01)
        difference = scenes.mean_difference(ours, theirs)
        print(f"mean difference: {difference:.2f} of 255")
        self.assertLess(difference, ALLOWED)

    def test_that_the_comparison_would_notice(self):
        """The other opacity law is another picture."""
        theirs = picture(vtk.vtkProjectedTetrahedraMapper)
        ours = picture(vtkTetMarchVolumeMapper, vtkTetMarchVolumeMapper.STRUCTURED)
        self.assertGreater(scenes.mean_difference(ours, theirs), 10 * ALLOWED)


if __name__ == "__main__":
    unittest.main(verbosity=2)
