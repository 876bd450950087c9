# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A tree of blocks in place of a grid, from a script."""
import unittest

import first_data
import numpy as np
import scenes
import vtkmodules.all as vtk
import vtktetmarch
from vtktetmarch import vtkTetMarchVolumeMapper


def cut_along_x(grid):
    """The cells of either half, with points of their own."""
    halves = vtk.vtkMultiBlockDataSet()
    centres = vtk.vtkCellCenters()
    centres.SetInputData(grid)
    centres.Update()
    for half in range(2):
        cells = vtk.vtkIdList()
        for cell in range(grid.GetNumberOfCells()):
            if (centres.GetOutput().GetPoint(cell)[0] > 0.5) == bool(half):
                cells.InsertNextId(cell)
        extract = vtk.vtkExtractCells()
        extract.SetInputData(grid)
        extract.SetCellList(cells)
        extract.Update()
        halves.SetBlock(half, extract.GetOutput())
    return halves


class BlocksTest(unittest.TestCase):
    def setUp(self):
        self.grid = scenes.make_grid()
        self.mapper = vtkTetMarchVolumeMapper()
        self.mapper.SetScalarModeToUsePointFieldData()
        self.mapper.SelectScalarArray("x")
        self.view = scenes.View(self.mapper, self.grid)
        self.whole = self.view.pixels()
        self.faces = self.mapper.GetNumberOfBoundaryFaces()
        self.halves = cut_along_x(self.grid)

    def test_data_and_pipelines(self):
        group = vtk.vtkMultiBlockDataGroupFilter()
        for half in range(2):
            group.AddInputData(self.halves.GetBlock(half))
        for show in (lambda: self.mapper.SetInputDataObject(self.halves),
                     lambda: self.mapper.SetInputConnection(group.GetOutputPort())):
            show()
            self.assertEqual(self.view.pixels(), self.whole)
            self.assertEqual(self.mapper.GetNumberOfBoundaryFaces(), self.faces)
            self.assertEqual(self.mapper.GetBounds(), (0, 1, 0, 1, 0, 1))
            self.assertIsNone(self.mapper.GetInput())
        self.assertEqual(self.mapper.GetBlocksBuilds(), 1)  # a pipeline hands on the same arrays
        self.mapper.SetInputData(self.grid)
        self.assertEqual(self.view.pixels(), self.whole)

    def test_half_of_it(self):
        self.halves.SetBlock(0, None)
        self.mapper.SetInputDataObject(self.halves)
        self.assertEqual(self.mapper.GetBounds(), (0.5, 1, 0, 1, 0, 1))
        self.assertLess(scenes.covered(self.view.pixels()), scenes.covered(self.whole))
        self.assertIs(self.mapper.GetDataObjectInput(), self.halves)

    def test_trees_of_leaves(self):
        source = vtk.vtkRandomHyperTreeGridSource()
        source.SetDimensions(3, 3, 3)
        source.Update()
        trees = vtk.vtkMultiBlockDataSet()
        trees.SetBlock(0, source.GetHyperTreeGridOutput())
        pictures = [vtktetmarch.screenshot(data, size=(60, 50)) for data in (trees.GetBlock(0), trees)]
        self.assertGreater(pictures[0].max(), 40)
        np.testing.assert_array_equal(*pictures)

    def test_of_an_array_that_some_blocks_have(self):
        """These are drawn, and a warning names the others. tetmarch-render does so, too."""
        tree = first_data.blocks()
        for number in (0, 2):
            first_data.with_points(tree.GetBlock(number), "some", lambda p: p[0])
        tree.GetMetaData(1).Set(vtk.vtkCompositeDataSet.NAME(), "middle")
        how = {"size": (96, 64), "cmap": "viridis", "opacity": "linear", "range": (0, 6), "unit_distance": 0.5,
               "camera": {"position": (3, -12, 3), "focal_point": (3, 1, 1), "view_up": (0, 0, 1)}}
        with self.assertWarnsRegex(RuntimeWarning, 'Blocks without array named "some" .*are not drawn: "middle"'):
            some = vtktetmarch.screenshot(tree, "some", **how)
        tree.SetBlock(1, None)
        self.assertTrue(np.array_equal(some, vtktetmarch.screenshot(tree, "some", **how)))
        self.assertGreater(np.count_nonzero(some.max(axis=2) - some[0, 0].max() > 20), 200)


if __name__ == "__main__":
    unittest.main(verbosity=2)
