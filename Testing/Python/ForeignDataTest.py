# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data as other packages have it is drawn as it is."""
import importlib.util
import types
import unittest

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import vtk_to_numpy

import first_data
import vtktetmarch
from vtktetmarch.cell_types import CELL_TYPES

POINTS = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1), (2, 2, 2)], float)
TETRAHEDRA = np.array([(0, 1, 2, 3), (1, 2, 3, 4)])
TRIANGLES = np.array([(0, 1, 2)])
PYRAMIDS = np.array([(0, 1, 4, 2, 5)])
HEAT, STRESS = np.arange(6.0), [np.array([9.0]), np.array([1.0, 2.0]), np.array([3.0])]
CELLS = [("triangle", TRIANGLES), ("tetra", TETRAHEDRA), ("pyramid", PYRAMIDS)]


def like_meshio(cells, points=POINTS):
    """An object with what is used of a meshio.Mesh."""
    blocks = [types.SimpleNamespace(type=kind, data=ids) for kind, ids in cells]
    return types.SimpleNamespace(points=points, cells=blocks, point_data={"heat": HEAT}, cell_data={"stress": STRESS})


CUBE = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], float)
FACES = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
UNSUPPORTED = ("hexahedron24", "wedge12", "wedge18")


def points_of(kind):
    """The points of a cell of a type of meshio: linear ones of types with any number of points."""
    number, count = CELL_TYPES[kind]
    if count == 0:
        number = {"TETRAHEDRON": vtk.VTK_TETRA, "HEXAHEDRON": vtk.VTK_HEXAHEDRON,
                  "WEDGE": vtk.VTK_WEDGE}[kind.rpartition("_")[2]]
    cell = vtk.vtkGenericCell.InstantiateCell(number)
    if count == 0 and number != vtk.VTK_WEDGE:
        return CUBE if number == vtk.VTK_HEXAHEDRON else POINTS[:4]
    coordinates = cell.GetParametricCoords()
    return np.reshape([coordinates[i] for i in range(3 * cell.GetNumberOfPoints())], (-1, 3))


def grid_of(data, array):
    return vtktetmarch.volume(data, array).GetMapper().GetDataObjectInput()


class MeshioTest(unittest.TestCase):
    def check(self, mesh):
        for array in ("heat", "stress"):
            grid = grid_of(mesh, array)
            self.assertEqual([grid.GetCellType(i) for i in range(3)], [vtk.VTK_TETRA, vtk.VTK_TETRA, vtk.VTK_PYRAMID])
            self.assertEqual([grid.GetCell(2).GetPointId(i) for i in range(5)], PYRAMIDS[0].tolist())
            self.assertEqual([grid.GetCellData().GetArray("stress").GetValue(i) for i in range(3)], [1, 2, 3])
            self.assertEqual([grid.GetPointData().GetArray("heat").GetValue(i) for i in range(6)], HEAT.tolist())
        self.assertGreater(vtktetmarch.screenshot(mesh, "heat", size=(60, 50)).max(), 40)

    def test_one_that_looks_like_it(self):
        self.check(like_meshio(CELLS))

    def test_a_real_one(self):
        if not importlib.util.find_spec("meshio"):
            self.skipTest("meshio isn't installed")
        import meshio

        self.check(meshio.Mesh(POINTS, CELLS, point_data={"heat": HEAT}, cell_data={"stress": STRESS}))

    def test_cells_of_every_type_are_drawn(self):
        for kind in CELL_TYPES:
            points = points_of(kind)
            mesh = types.SimpleNamespace(points=points, cells=[(kind, np.arange(len(points))[None])], cell_data={},
                                         point_data={"v": points[:, 0] + points[:, 2]})
            with self.subTest(kind=kind):
                if kind in UNSUPPORTED:
                    with self.assertWarnsRegex(RuntimeWarning, "1 cells of types that can't be cut"):
                        vtktetmarch.screenshot(mesh, size=(40, 30))
                else:
                    picture = vtktetmarch.screenshot(mesh, size=(40, 30))
                    self.assertGreater((picture.max(axis=2) > 30).mean(), 0.1)

    def check_polyhedra(self, make):
        cells = [("polyhedron8", [FACES]), ("tetra", TETRAHEDRA[:1]), ("line", [[0, 1]])]
        mesh = make(CUBE, cells, {"v": CUBE[:, 0]}, {"w": [np.array([1.0]), np.array([2.0]), np.array([3.0])]})
        grid = grid_of(mesh, "v")
        self.assertEqual([grid.GetCellType(i) for i in (0, 1)], [vtk.VTK_TETRA, vtk.VTK_POLYHEDRON])
        self.assertEqual([grid.GetCellData().GetArray("w").GetValue(i) for i in (0, 1)], [2, 1])
        pictures = [vtktetmarch.screenshot(make(CUBE, cell, {"v": CUBE[:, 0]}, {}), size=(60, 50)).astype(int)
                    for cell in (cells[:1], [("hexahedron", np.arange(8)[None])])]
        self.assertGreater(pictures[0].max(), 40)
        self.assertLessEqual(np.abs(pictures[0] - pictures[1]).max(), 2)

    def test_polyhedra(self):
        self.check_polyhedra(lambda points, cells, point_data, cell_data: types.SimpleNamespace(
            points=points, cells=cells, point_data=point_data, cell_data=cell_data))

    def test_real_polyhedra(self):
        if not importlib.util.find_spec("meshio"):
            self.skipTest("meshio isn't installed")
        import meshio

        self.check_polyhedra(meshio.Mesh)

    def test_memory_of_one_block_is_shared(self):
        mesh = types.SimpleNamespace(points=POINTS, cells=CELLS[:2], point_data={"heat": HEAT},
                                     cell_data={"stress": STRESS[:2]})
        grid = grid_of(mesh, "heat")
        for found, given in ((grid.GetPoints().GetData(), POINTS), (grid.GetCells().GetConnectivityArray(), TETRAHEDRA),
                             (grid.GetPointData().GetArray("heat"), HEAT),
                             (grid.GetCellData().GetArray("stress"), STRESS[1])):
            self.assertTrue(np.shares_memory(vtk_to_numpy(found), given))

    def test_masked_values_are_nan(self):
        mesh = like_meshio(CELLS)
        mesh.cell_data["stress"] = [np.ma.masked_equal(block, 2.0) for block in STRESS]
        mesh.point_data["heat"] = np.ma.masked_equal(HEAT, 5.0)
        grid = grid_of(mesh, "heat")
        for array, values in ((grid.GetPointData().GetArray("heat"), [0, 1, 2, 3, 4, np.nan]),
                              (grid.GetCellData().GetArray("stress"), [1, np.nan, 3])):
            np.testing.assert_equal(vtk_to_numpy(array), values)
        with self.assertRaisesRegex(ValueError, "points has 3 masked numbers"):
            vtktetmarch.volume(like_meshio(CELLS, np.ma.masked_equal(POINTS, 2.0)))

    def test_what_is_wrong_is_said(self):
        with self.assertRaisesRegex(ValueError, "no solid cells: triangle"):
            vtktetmarch.volume(like_meshio(CELLS[:1]))
        with self.assertRaisesRegex(ValueError, "no solid cells: no cells at all"):
            vtktetmarch.volume(like_meshio([]))
        with self.assertRaisesRegex(ValueError, "polyhedron 0 has the point 6; the 6 points are counted from 0"):
            vtktetmarch.volume(like_meshio([("polyhedron8", [FACES])]))
        with self.assertRaisesRegex(ValueError, "cells of the type 'tetra20'; those that can be drawn are tetra, "):
            vtktetmarch.volume(like_meshio([*CELLS, ("tetra20", np.arange(20)[None])]))
        with self.assertRaisesRegex(ValueError, r"points has the shape \(6, 2\)"):
            vtktetmarch.volume(like_meshio(CELLS, POINTS[:, :2]))


class OfVtksClassesTest(unittest.TestCase):
    def test_subclasses_as_pyvista_has_them(self):
        class UnstructuredGrid(vtk.vtkUnstructuredGrid):
            points = cells = point_data = cell_data = None  # PyVista's have these names, too

        class StructuredGrid(vtk.vtkStructuredGrid):
            pass

        grid = UnstructuredGrid()
        grid.ShallowCopy(first_data.one_tetrahedron())
        self.assertIs(grid_of(grid, "z"), grid)
        curvilinear = StructuredGrid()
        curvilinear.SetDimensions(2, 2, 2)
        points = vtk.vtkPoints()
        for i in range(8):
            points.InsertNextPoint(i & 1, i >> 1 & 1, i >> 2)
        curvilinear.SetPoints(points)
        first_data.with_points(curvilinear, "x", lambda p: p[0])
        self.assertEqual(grid_of(curvilinear, "x").GetNumberOfCells(), 1)

    def test_wrapped_for_numpy(self):
        grid = first_data.one_tetrahedron()
        self.assertIs(grid_of(dataset_adapter.WrapDataObject(grid), "z"), grid)


if __name__ == "__main__":
    unittest.main(verbosity=2)
