# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""from_arrays(): memory is shared and lives; shapes, types and ids are checked."""
import gc
import unittest
import weakref

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtktetmarch

# A cube of 5 tetrahedra.
POINTS = np.array([(i & 1, i >> 1 & 1, i >> 2) for i in range(8)], np.float64)
TETRAHEDRA = np.array([(0, 1, 2, 4), (3, 1, 7, 2), (5, 1, 4, 7), (6, 2, 7, 4), (1, 2, 4, 7)], np.int64)
HEXAHEDRON = np.array([0, 1, 3, 2, 4, 5, 7, 6])


def cells_of(grid):
    return [[grid.GetCell(i).GetPointId(k) for k in range(grid.GetCell(i).GetNumberOfPoints())]
            for i in range(grid.GetNumberOfCells())]


class CellsTest(unittest.TestCase):
    def test_three_forms_are_the_same(self):
        flat = np.insert(TETRAHEDRA, 0, 4, axis=1).ravel()
        split = TETRAHEDRA.ravel(), np.arange(0, 21, 4)
        for cells in (TETRAHEDRA, TETRAHEDRA.astype(np.int32), TETRAHEDRA.astype(np.uint8), TETRAHEDRA.tolist(), flat,
                      split, (split[0].astype(np.int32), split[1])):
            for types in ("tetra", vtk.VTK_TETRA, [vtk.VTK_TETRA] * 5, ["tetra"] * 5, np.full(5, 10, np.uint8)):
                grid = vtktetmarch.from_arrays(POINTS, cells, types)
                self.assertEqual(cells_of(grid), TETRAHEDRA.tolist())
                self.assertEqual({grid.GetCellType(i) for i in range(5)}, {vtk.VTK_TETRA})

    def test_names_are_those_of_vtks_cells(self):
        for name, points, cell in (("tetra", 4, vtk.vtkTetra), ("voxel", 8, vtk.vtkVoxel),
                                   ("hexahedron", 8, vtk.vtkHexahedron), ("wedge", 6, vtk.vtkWedge),
                                   ("pyramid", 5, vtk.vtkPyramid), ("penta_prism", 10, vtk.vtkPentagonalPrism),
                                   ("hexa_prism", 12, vtk.vtkHexagonalPrism), ("tetra10", 10, vtk.vtkQuadraticTetra)):
            grid = vtktetmarch.from_arrays(np.zeros((points, 3)), [range(points)], name)
            with self.subTest(name=name):
                self.assertIs(type(grid.GetCell(0)), cell)

    def test_mixed_types(self):
        points = np.concatenate([POINTS, [(2.0, 0.5, 0.5)]])
        pyramid = [1, 3, 7, 5, 8]
        for cells in (([*HEXAHEDRON, *pyramid], [0, 8, 13]), [8, *HEXAHEDRON, 5, *pyramid]):
            grid = vtktetmarch.from_arrays(points, cells, ["hexahedron", "pyramid"])
            self.assertEqual(cells_of(grid), [HEXAHEDRON.tolist(), pyramid])
            self.assertEqual([grid.GetCellType(i) for i in (0, 1)], [vtk.VTK_HEXAHEDRON, vtk.VTK_PYRAMID])

    def test_no_cells(self):
        for cells in (np.empty((0, 4), int), np.empty(0, int)):
            self.assertEqual(vtktetmarch.from_arrays(POINTS, cells, "tetra").GetNumberOfCells(), 0)

    def test_what_is_wrong_is_said(self):
        for arguments, error, text in (
                ((POINTS[:, :2], TETRAHEDRA, "tetra"), ValueError, r"points has the shape \(8, 2\)"),
                ((POINTS * np.nan, TETRAHEDRA, "tetra"), ValueError, "NaN or infinite"),
                ((POINTS * 1j, TETRAHEDRA, "tetra"), TypeError, "complex128"),
                ((POINTS, TETRAHEDRA * 1.0, "tetra"), TypeError, "they are ids"),
                ((POINTS, TETRAHEDRA + 1, "tetra"), ValueError, "cell 1 has the point 8"),
                ((POINTS, TETRAHEDRA - 1, "tetra"), ValueError, "cell 0 has the point -1"),
                ((POINTS, TETRAHEDRA, "hexahedron"), ValueError, "cell 0 has 4 points; one of its type, 12, has 8"),
                ((POINTS, TETRAHEDRA, "tetrahedron"), ValueError, "there are tetra, "),
                ((POINTS, TETRAHEDRA, 300), ValueError, "1 to 255"),
                ((POINTS, TETRAHEDRA, [10, 10]), ValueError, "there are 5 cells"),
                ((POINTS, TETRAHEDRA, vtk.VTK_POLYHEDRON), ValueError, "polyhedra"),
                ((POINTS, TETRAHEDRA[None], "tetra"), ValueError, r"the shape \(1, 5, 4\)"),
                ((POINTS, [4, 0, 1, 2, 4, 4, 1, 2], "tetra"), ValueError, "within its last cell: a count of 4, and 2"),
                ((POINTS, [-3, 0, 1], "tetra"), ValueError, "count of -3 at 0"),
                ((POINTS, ([0, 1, 2, 4], [0, 3]), "tetra"), ValueError, "end with the length of connectivity, 4"),
                ((POINTS, ([0, 1, 2, 4], [0, 5, 4]), "tetra"), ValueError, "never fall")):
            with self.subTest(text=text), self.assertRaisesRegex(error, text):
                vtktetmarch.from_arrays(*arguments)


class DataTest(unittest.TestCase):
    def test_every_type_of_number(self):
        for kind in (np.int8, np.uint8, np.int16, np.uint16, np.int32, np.uint32, np.int64, np.uint64, np.float32,
                     np.float64):
            values = np.arange(8).astype(kind)
            grid = vtktetmarch.from_arrays(POINTS, TETRAHEDRA, "tetra", {"v": values})
            found = vtk_to_numpy(grid.GetPointData().GetArray("v"))
            self.assertTrue(np.shares_memory(found, values), kind)
            self.assertTrue(np.array_equal(found, values))

    def test_what_is_wrong_is_said(self):
        for point_data, cell_data, error, text in (
                ({"a": range(7)}, None, ValueError, r"array 'a' of points has the shape \(7,\); it has to be \(8,\)"),
                (None, {"b": range(8)}, ValueError, r"array 'b' of cells .* \(5,\)"),
                ({"a": np.zeros((8, 2, 2))}, None, ValueError, r"\(8, 2, 2\)")):
            with self.subTest(text=text), self.assertRaisesRegex(error, text):
                vtktetmarch.from_arrays(POINTS, TETRAHEDRA, "tetra", point_data, cell_data)


class MaskedTest(unittest.TestCase):
    """Of netCDF4 and others: a mask that hides values, over a number such as 1e20."""

    def drawn(self, values, of="point_data"):
        """What is made of values whose first one is hidden."""
        mask = np.zeros(np.shape(values), bool)
        mask.flat[0] = True
        hidden = np.ma.array(values, mask=mask, fill_value=100)
        grid = vtktetmarch.from_arrays(POINTS, TETRAHEDRA, "tetra", **{of: {"v": hidden}})
        return vtk_to_numpy((grid.GetPointData() if of == "point_data" else grid.GetCellData()).GetArray("v"))

    def test_hidden_values_are_nan(self):
        for kind, made in ((np.int8, np.float32), (np.uint16, np.float32), (np.int32, np.float64), (bool, np.float32),
                           (np.int64, np.float64), (np.float16, np.float32), (np.float32, np.float32),
                           (np.float64, np.float64), (">f4", np.float32)):
            values = np.arange(1, 9).astype(kind)
            found = self.drawn(values)
            self.assertEqual(found.dtype, made)
            self.assertTrue(np.isnan(found[0]))
            self.assertTrue(np.array_equal(found[1:], values[1:].astype(made)))
        self.assertEqual(np.isnan(self.drawn(np.ones((5, 3)), "cell_data")).tolist(),
                         [[True, False, False]] + 4 * [[False] * 3])

    def test_nothing_hidden_is_shared(self):
        for mask in (np.ma.nomask, np.zeros(8, bool)):
            values = np.arange(8)
            grid = vtktetmarch.from_arrays(np.ma.array(POINTS), np.ma.array(TETRAHEDRA), "tetra",
                                           {"v": np.ma.array(values, mask=mask, copy=False)})
            self.assertTrue(np.shares_memory(vtk_to_numpy(grid.GetPointData().GetArray("v")), values))

    def test_cells_with_hidden_values_are_not_drawn(self):
        values = np.ma.masked_values([1e20, 1, 2, 3, 4, 5, 6, 7], 1e20)
        hidden = vtktetmarch.figure(vtktetmarch.from_arrays(POINTS, TETRAHEDRA, "tetra", {"v": values}), size=(90, 70))
        low, high = vtktetmarch.auto_transfer_functions(hidden.mapper.GetInput()).range
        self.assertTrue(1 <= low < high <= 7)
        without = vtktetmarch.from_arrays(POINTS, TETRAHEDRA[1:], "tetra", {"v": np.arange(8.0)})
        volume = vtktetmarch.volume(without, range=(low, high))
        volume.SetProperty(hidden.volume.GetProperty())
        of_the_others = vtktetmarch.figure(volume, size=(90, 70), camera=hidden.camera)
        self.assertLessEqual(np.abs(hidden.screenshot().astype(int) - of_the_others.screenshot()).max(), 1)

    def test_ids_and_points_may_not_be_hidden(self):
        hidden = [np.ma.array(given, mask=np.arange(np.size(given)).reshape(np.shape(given)) == 4)
                  for given in (POINTS, TETRAHEDRA, np.full(5, 10))]
        for arguments, text in (
                ((hidden[0], TETRAHEDRA, "tetra"), "points has 1 masked numbers; leave out the points"),
                ((POINTS, hidden[1], "tetra"), "cells has 1 masked numbers; leave out the cells"),
                ((POINTS, TETRAHEDRA, hidden[2]), "cell_types has 1 masked numbers; leave out the cells")):
            with self.subTest(text=text), self.assertRaisesRegex(ValueError, text):
                vtktetmarch.from_arrays(*arguments)
        with self.assertRaisesRegex(TypeError, "complex128, and some are masked"):
            self.drawn(np.zeros(8, complex))


class MemoryTest(unittest.TestCase):
    def test_is_shared(self):
        for kind in (np.float32, np.float64):
            points, cells = POINTS.astype(kind), TETRAHEDRA.copy()
            grid = vtktetmarch.from_arrays(points, cells, "tetra")
            self.assertTrue(np.shares_memory(vtk_to_numpy(grid.GetPoints().GetData()), points))
            self.assertTrue(np.shares_memory(vtk_to_numpy(grid.GetCells().GetConnectivityArray()), cells))
        for kind in (np.int32, np.int64):
            connectivity, offsets = TETRAHEDRA.astype(kind).ravel(), np.arange(0, 21, 4, dtype=kind)
            grid = vtktetmarch.from_arrays(POINTS, (connectivity, offsets), np.full(5, 10, np.uint8))
            self.assertTrue(np.shares_memory(vtk_to_numpy(grid.GetCells().GetConnectivityArray()), connectivity))
            self.assertTrue(np.shares_memory(vtk_to_numpy(grid.GetCells().GetOffsetsArray()), offsets))

    def test_lives_as_long_as_the_grid(self):
        """Wherever the grid is: here VTK alone knows of it."""
        arrays = [POINTS.copy(), TETRAHEDRA.ravel().copy(), np.arange(0, 21, 4), np.full(5, 10, np.uint8),
                  np.arange(8.0), np.arange(5.0)]
        expected = [array.copy() for array in arrays]
        alive = [weakref.ref(array) for array in arrays]
        mapper = vtk.vtkDataSetMapper()
        points, connectivity, offsets, types, a, b = arrays
        mapper.SetInputData(vtktetmarch.from_arrays(points, (connectivity, offsets), types, {"a": a}, {"b": b}))
        del arrays, points, connectivity, offsets, types, a, b
        gc.collect()
        self.assertEqual([reference() is not None for reference in alive], [True] * 6)
        grid = mapper.GetInputDataObject(0, 0)
        found = (grid.GetPoints().GetData(), grid.GetCells().GetConnectivityArray(), grid.GetCells().GetOffsetsArray(),
                 grid.GetCellTypesArray(), grid.GetPointData().GetArray("a"), grid.GetCellData().GetArray("b"))
        for array, values in zip(found, expected):
            for i, tuple_ in enumerate(values.reshape(len(values), -1)):
                self.assertEqual([array.GetComponent(i, k) for k in range(len(tuple_))], tuple_.tolist())
        del array, grid, found
        mapper.RemoveAllInputs()
        gc.collect()
        self.assertEqual([reference() is None for reference in alive], [True] * 6)

    def test_changes_are_drawn(self):
        points, values = POINTS.copy(), np.arange(8.0)
        grid = vtktetmarch.from_arrays(points, TETRAHEDRA, "tetra", {"v": values})
        figure = vtktetmarch.figure(grid, size=(90, 70), range=(0, 7))
        first = figure.screenshot()
        values[:] = values[::-1].copy()
        grid.GetPointData().GetArray("v").Modified()
        grid.Modified()
        second = figure.screenshot()
        self.assertFalse(np.array_equal(first, second))
        points *= 0.5
        grid.GetPoints().GetData().Modified()
        grid.GetPoints().Modified()
        grid.Modified()
        third = figure.screenshot()
        self.assertFalse(np.array_equal(second, third))
        fresh = vtktetmarch.figure(vtktetmarch.from_arrays(points.copy(), TETRAHEDRA, "tetra", {"v": values.copy()}),
                                   size=(90, 70), range=(0, 7), camera=figure.camera,
                                   unit_distance=figure.volume.GetProperty().GetScalarOpacityUnitDistance())
        self.assertTrue(np.array_equal(fresh.screenshot(), third))


if __name__ == "__main__":
    unittest.main(verbosity=2)
