# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A tree of blocks in place of a grid, from a script."""
import unittest

import scenes
import vtkmodules.all as vtk
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


if __name__ == "__main__":
    unittest.main(verbosity=2)
