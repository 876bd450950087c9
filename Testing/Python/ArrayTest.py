# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which array is drawn, and what is said when there is none. Low values are drawn green, high ones red."""
import unittest

import scenes
import vtkmodules.all as vtk
from vtkmodules.util.misc import calldata_type
from vtktetmarch import vtkTetMarchVolumeMapper


def remember_errors(mapper):
    errors = []

    @calldata_type(vtk.VTK_STRING)
    def on_error(_mapper, _event, text):
        errors.append(text)

    mapper.AddObserver("ErrorEvent", on_error)
    return errors


class ArrayTest(unittest.TestCase):
    def setUp(self):
        self.grid = scenes.make_grid()
        self.mapper = vtkTetMarchVolumeMapper()
        self.errors = remember_errors(self.mapper)
        self.view = scenes.View(self.mapper, self.grid)

    def expect(self, colour):
        self.assertEqual(self.view.centre(), colour)
        self.assertEqual(self.errors, [])

    def test_point_arrays_by_name(self):
        self.mapper.SetScalarModeToUsePointFieldData()
        for name, colour in (("low", "green"), ("high", "red"), ("low", "green")):
            self.mapper.SelectScalarArray(name)
            self.expect(colour)

    def test_cell_arrays_by_name(self):
        self.mapper.SetScalarModeToUseCellFieldData()
        for name, colour in (("low", "green"), ("high", "red")):
            self.mapper.SelectScalarArray(name)
            self.expect(colour)

    def test_arrays_by_number(self):
        for mode, data in ((vtk.VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, self.grid.GetPointData()),
                           (vtk.VTK_SCALAR_MODE_USE_CELL_FIELD_DATA, self.grid.GetCellData())):
            self.mapper.SetScalarMode(mode)
            for name, colour in (("low", "green"), ("high", "red")):
                number = next(i for i in range(data.GetNumberOfArrays()) if data.GetArrayName(i) == name)
                self.mapper.SelectScalarArray(number)
                self.expect(colour)

    def test_active_arrays(self):
        self.grid.GetPointData().SetActiveScalars("low")
        self.grid.GetCellData().SetActiveScalars("high")
        for mode, colour in ((vtk.VTK_SCALAR_MODE_DEFAULT, "green"), (vtk.VTK_SCALAR_MODE_USE_CELL_DATA, "red"),
                             (vtk.VTK_SCALAR_MODE_USE_POINT_DATA, "green")):
            self.mapper.SetScalarMode(mode)
            self.expect(colour)
        # Without active scalars at the points the default goes on to the cells.
        self.grid.GetPointData().SetActiveScalars(None)
        self.mapper.SetScalarModeToDefault()
        self.expect("red")

    def test_a_wrong_name_is_told_once(self):
        self.mapper.SetScalarModeToUsePointFieldData()
        self.mapper.SelectScalarArray("nothing like it")
        for _ in range(2):
            self.assertEqual(self.view.centre(), "empty")
        self.assertEqual(len(self.errors), 1)
        for word in ("nothing like it", "point data", "low", "high"):
            self.assertIn(word, self.errors[0])
        # And all is well again.
        self.errors.clear()
        self.mapper.SelectScalarArray("high")
        self.expect("red")

    def test_a_wrong_number_is_told(self):
        self.mapper.SetScalarModeToUseCellFieldData()
        self.mapper.SelectScalarArray(99)
        self.assertEqual(self.view.centre(), "empty")
        self.assertEqual(len(self.errors), 1)
        self.assertIn("99", self.errors[0])

    def test_no_scalars_at_all(self):
        self.grid.GetPointData().Initialize()
        self.grid.GetCellData().Initialize()
        self.assertEqual(self.view.centre(), "empty")
        self.assertEqual(len(self.errors), 1)
        self.assertIn("no active scalars", self.errors[0])

    def test_an_empty_grid_is_no_error(self):
        self.mapper.SetInputData(vtk.vtkUnstructuredGrid())
        self.expect("empty")


if __name__ == "__main__":
    unittest.main(verbosity=2)
