# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Curved cells become tetrahedra within a tolerance: by vtkTetMarchTessellator (in C++: TessellationTest.cxx) and by the
mapper (CurvedBlocksTest.cxx)."""
import unittest

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import vtktetmarch
from vtktetmarch.errors import VtkErrors

# The corners of a quadratic tetrahedron, then the points in the middle of its edges.
ENDS = [(0, 0), (1, 1), (2, 2), (3, 3), (0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)]
SIX = [(0, 1, 3, 7), (0, 1, 5, 7), (0, 2, 3, 7), (0, 2, 6, 7), (0, 4, 5, 7), (0, 4, 6, 7)]  # of a cube


def bent(points):
    """Of the second degree, so the cells' own shape."""
    x, y, z = points.T
    return np.stack([x + 0.2 * y * y, y - 0.2 * x * z, z + 0.15 * x * x], axis=1)


def values_of(points):
    return 4 * (points[:, 0] - 0.5) ** 2 - points[:, 1] * points[:, 2]


def curved(bend=bent):
    """A cube of six VTK_QUADRATIC_TETRA, with "s" at points and "c" in cells."""
    corners = np.array([[i & 1, i >> 1 & 1, i >> 2] for i in range(8)], float)
    places, cells = {}, []
    for six in SIX:
        middles = [tuple((corners[six[a]] + corners[six[b]]) / 2) for a, b in ENDS]
        cells.append([places.setdefault(middle, len(places)) for middle in middles])
    points = np.array(list(places))
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(vtk.vtkPoints())
    grid.GetPoints().SetData(numpy_to_vtk(bend(points), deep=True))
    for cell in cells:
        grid.InsertNextCell(vtk.VTK_QUADRATIC_TETRA, 10, cell)
    add(grid.GetPointData(), "s", values_of(points))
    grid.GetPointData().SetActiveScalars("s")
    add(grid.GetCellData(), "c", np.arange(6.0))
    return grid


WEDGE = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)]
HEXAHEDRON = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
AROUND = [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3)]
BOX = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
# Cells that no lattice in C++ has: their corners, and the corners in whose middle each other point is; the volume.
OTHER_CELLS = {
    "VTK_QUADRATIC_LINEAR_WEDGE": (WEDGE, AROUND, 1 / 2),
    "VTK_BIQUADRATIC_QUADRATIC_WEDGE": (
        WEDGE, [*AROUND, (0, 3), (1, 4), (2, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)], 1 / 2),
    "VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON": (
        HEXAHEDRON, [*BOX, (0, 3, 7, 4), (1, 2, 6, 5), (0, 1, 5, 4), (2, 3, 7, 6)], 1),
    "VTK_BEZIER_TETRAHEDRON": ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], ENDS[4:], 1 / 6),
}


def cell_of(name):
    """One cell with straight edges; "s" is the square of x."""
    corners, middles, _ = OTHER_CELLS[name]
    corners = np.array(corners, float)
    points = np.concatenate([corners, [corners[list(ends)].mean(axis=0) for ends in middles]])
    values = points[:, 0] ** 2
    if "BEZIER" in name:  # control points, which the curve doesn't pass through
        values[4:] = [2 * x ** 2 - (corners[list(ends), 0] ** 2).mean() for x, ends in zip(points[4:, 0], middles)]
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(vtk.vtkPoints())
    grid.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    grid.InsertNextCell(getattr(vtk, name), len(points), range(len(points)))
    add(grid.GetPointData(), "s", values)
    grid.GetPointData().SetActiveScalars("s")
    return grid


def add(attributes, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    attributes.AddArray(array)


def tessellated(data, geometry=1e-3, scalars=1e-3, array=None):
    made = vtktetmarch.vtkTetMarchTessellator()
    made.SetInputData(data)
    made.SetGeometryTolerance(geometry)
    made.SetScalarTolerance(scalars)
    if array:
        made.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, array)
    made.Update()
    return made.GetOutput()


SIZE = (90, 70)


class ArraysTest(unittest.TestCase):
    def test_all_are_passed_on(self):
        data = curved()
        count = data.GetNumberOfPoints()
        add(data.GetPointData(), "whole", np.full(count, 7, np.int16))
        add(data.GetPointData(), "vector", vtk_to_numpy(data.GetPoints().GetData()))
        add(data.GetPointData(), "vtkGhostType", np.zeros(count, np.uint8))
        add(data.GetFieldData(), "TimeValue", np.array([3.0]))
        mesh = tessellated(data)
        arrays = mesh.GetPointData()
        self.assertEqual([arrays.GetArrayName(i) for i in range(arrays.GetNumberOfArrays())], ["s", "whole", "vector"])
        self.assertEqual(arrays.GetScalars().GetName(), "s")
        self.assertTrue((vtk_to_numpy(arrays.GetArray("whole")) == 7).all())
        np.testing.assert_allclose(vtk_to_numpy(arrays.GetArray("vector")), vtk_to_numpy(mesh.GetPoints().GetData()),
                                   atol=1e-12)
        cells = mesh.GetCellData()
        np.testing.assert_array_equal(vtk_to_numpy(cells.GetArray("c")),
                                      vtk_to_numpy(cells.GetArray("vtkOriginalCellIds")))
        self.assertEqual(set(vtk_to_numpy(cells.GetArray("c"))), set(range(6)))
        self.assertEqual(mesh.GetFieldData().GetArray("TimeValue").GetValue(0), 3)

    def test_the_named_one_decides(self):
        data = curved(lambda points: points)
        add(data.GetPointData(), "flat", np.zeros(data.GetNumberOfPoints()))
        self.assertEqual(tessellated(data, array="flat").GetNumberOfCells(), 6)
        self.assertGreater(tessellated(data, array="s").GetNumberOfCells(), 1000)
        components = np.stack([np.zeros(data.GetNumberOfPoints()), vtk_to_numpy(data.GetPointData().GetArray("s"))], 1)
        add(data.GetPointData(), "both", components)
        self.assertEqual(tessellated(data, array="both").GetNumberOfCells(),
                         tessellated(data, array="s").GetNumberOfCells())

    def test_cells_of_scalars_of_cells_are_cut_by_their_shape(self):
        data = curved()
        data.GetPointData().RemoveArray("s")
        self.assertGreater(tessellated(data).GetNumberOfCells(), 100)


class CellsTest(unittest.TestCase):
    def test_smaller_tolerances_give_more(self):
        counts = [tessellated(curved(), tolerance, tolerance).GetNumberOfCells() for tolerance in (1, 0.03, 0.003)]
        self.assertEqual(counts[0], 6)
        self.assertGreater(counts[1], 10 * counts[0])
        self.assertGreater(counts[2], 10 * counts[1])

    def test_of_each_type(self):
        for name, (corners, _, volume) in OTHER_CELLS.items():
            with self.subTest(name):
                self.assertEqual(tessellated(cell_of(name), 1, 1).GetNumberOfCells(), {4: 1, 6: 3, 8: 6}[len(corners)])
                mesh = tessellated(cell_of(name), 1, 1e-2)
                self.assertGreater(mesh.GetNumberOfCells(), 10)
                points = vtk_to_numpy(mesh.GetPoints().GetData())
                values = vtk_to_numpy(mesh.GetPointData().GetScalars())
                np.testing.assert_allclose(values, points[:, 0] ** 2, atol=1e-12)
                tets = points[vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).reshape(-1, 4)]
                sixfold = np.linalg.det(tets[:, 1:] - tets[:, :1])
                self.assertGreater(sixfold.min(), 0)
                self.assertAlmostEqual(sixfold.sum() / 6, volume, places=12)

    def test_others_are_passed_on(self):
        data = curved()
        first = data.GetNumberOfPoints()
        for i in range(8):
            data.GetPoints().InsertNextPoint(5 + (i & 1), i >> 1 & 1, i >> 2)
        data.GetPointData().Initialize()
        data.GetCellData().Initialize()
        data.InsertNextCell(vtk.VTK_VOXEL, 8, range(first, first + 8))
        data.InsertNextCell(vtk.VTK_LINE, 2, (0, 1))
        faces = vtk.vtkIdList()
        faces.InsertNextId(4)
        for face in ((0, 1, 4), (0, 2, 4), (1, 2, 4), (0, 1, 2)):
            for value in (3, *(first + corner for corner in face)):
                faces.InsertNextId(value)
        data.InsertNextCell(vtk.VTK_POLYHEDRON, faces)
        mesh = tessellated(data)
        origins = list(vtk_to_numpy(mesh.GetCellData().GetArray("vtkOriginalCellIds")))
        for cell, kind in ((6, vtk.VTK_VOXEL), (8, vtk.VTK_POLYHEDRON)):
            self.assertEqual(origins.count(cell), 1)
            passed = origins.index(cell)
            self.assertEqual(mesh.GetCellType(passed), kind)
            np.testing.assert_allclose(mesh.GetCell(passed).GetBounds(), data.GetCell(cell).GetBounds())
        self.assertEqual(origins.count(7), 0)


class PictureTest(unittest.TestCase):
    def test_the_tolerance_is_kept_in_pictures(self):
        """Beside one that is far smaller; linear pieces between the points of the cells show what they miss."""
        pictures = {}
        for name, data in (("linear", curved()), ("default", vtktetmarch.vtkTetMarchTessellator()),
                           ("truth", tessellated(curved(), 4e-4, 4e-4))):
            if name == "default":
                data.SetInputData(curved())
            figure = vtktetmarch.figure(data, "s", range=(-1, 1), unit_distance=0.5, size=(150, 120),
                                        opacity=[(-1, 0.1), (0, 0.3), (1, 0.8)])
            pictures[name] = figure.screenshot().astype(int)
            self.assertEqual(figure.mapper.GetNumberOfLostRays(), 0)
        error = {name: np.sqrt(((picture - pictures["truth"]) ** 2).mean()) for name, picture in pictures.items()}
        self.assertGreater(np.ptp(pictures["truth"]), 100)
        self.assertLess(error["default"], 1)
        self.assertGreater(error["linear"], 10 * error["default"])


UNIT_DISTANCE = 0.5


def colour_by_brute_force(figure, column, row, steps=2000):
    """What the ray through a pixel adds up (0..1), by the curved cells' own functions: these are the place in the cube
    that bent() moves to a place in space, and values_of() there."""
    functions, world = figure.volume.GetProperty(), vtk.vtkMatrix4x4()
    vtk.vtkMatrix4x4.Invert(figure.camera.GetCompositeProjectionTransformMatrix(SIZE[0] / SIZE[1], 0, 1), world)
    ends = [world.MultiplyPoint((2 * (column + 0.5) / SIZE[0] - 1, 1 - 2 * (row + 0.5) / SIZE[1], depth, 1))
            for depth in (0, 1)]
    near, far = (np.array(end[:3]) / end[3] for end in ends)
    places = near + (far - near) * ((np.arange(steps) + 0.5) / steps)[:, None]
    inside = places
    for _ in range(80):  # bent() moves a place by less than half of what it is moved itself
        inside = np.clip(inside + places - bent(inside), -1, 2)
    scalars = values_of(inside)[((inside >= 0) & (inside <= 1)).all(axis=1)]
    opacities, colors = functions.GetScalarOpacity(), functions.GetRGBTransferFunction()
    depths = np.array([opacities.GetValue(s) for s in scalars]) * np.linalg.norm(far - near) / steps / UNIT_DISTANCE
    left = np.exp(-np.concatenate([[0], np.cumsum(depths)]))
    emitted = np.array([colors.GetColor(s) for s in scalars]).reshape(-1, 3)
    return (emitted * (left[:-1] - left[1:])[:, None]).sum(axis=0)


class MapperTest(unittest.TestCase):
    """GeometryTolerance: the mapper cuts the cells itself."""

    def figure_of(self, data, **settings):
        return vtktetmarch.figure(data, "s", range=(-1, 1), cmap="viridis", unit_distance=UNIT_DISTANCE, size=SIZE,
                                  background="black", pick_opacity_threshold=0.1, opacity=[(-1, 0.1), (0, 0.3), (1, 0.8)],
                                  **settings)

    def test_pictures_are_those_of_the_cells_own_functions(self):
        random = np.random.default_rng(1)
        pixels = np.stack([random.integers(SIZE[0], size=200), random.integers(SIZE[1], size=200)], 1)
        figure = self.figure_of(curved())
        expected = np.array([colour_by_brute_force(figure, *pixel) for pixel in pixels])
        self.assertGreater((expected.max(axis=1) > 0.3).sum(), 30)
        worst = []
        for tolerance in (0, 1e-2, 1e-3):
            figure.mapper.SetGeometryTolerance(tolerance)
            picture = figure.screenshot()[pixels[:, 1], pixels[:, 0], :3] / 255
            worst.append(np.abs(picture - expected).max() * 255)
        self.assertGreater(worst[0], 20)
        self.assertLess(worst[1], 5)
        self.assertLess(worst[2], 1)  # half of it is the rounding of the window

    def test_it_draws_what_the_filter_makes(self):
        made = self.figure_of(tessellated(curved(), 4e-3, 4e-3))
        figure = self.figure_of(curved())
        figure.renderer.GetActiveCamera().DeepCopy(made.renderer.GetActiveCamera())
        linear, expected = figure.screenshot().astype(int), made.screenshot().astype(int)
        figure.mapper.SetGeometryTolerance(4e-3)
        picture = figure.screenshot().astype(int)
        self.assertEqual(figure.mapper.GetNumberOfTetrahedra(), made.mapper.GetNumberOfTetrahedra())
        np.testing.assert_array_equal(picture, expected)
        self.assertGreater(np.abs(linear - expected).max(), 25)

    def test_picks_and_bounds_are_those_of_curved_cells(self):
        mesh = tessellated(curved(), 4e-3, 4e-3)
        made, figure = self.figure_of(mesh), self.figure_of(curved(), geometry_tolerance=4e-3)
        np.testing.assert_allclose(figure.mapper.GetBounds(), mesh.GetBounds())
        figure.renderer.GetActiveCamera().DeepCopy(made.renderer.GetActiveCamera())
        for each in (made, figure):
            each.render()
        origins, cells = mesh.GetCellData().GetArray("vtkOriginalCellIds"), set()
        for x in range(20, 70, 10):
            figures = [(each, each.mapper) for each in (made, figure)]
            hits = [mapper.Pick(each.renderer, each.volume, x, 35) for each, mapper in figures]
            self.assertEqual(*hits)
            if hits[0]:
                of_tet, of_cell = (mapper.GetPickedCellId() for _, mapper in figures)
                self.assertEqual(of_cell, origins.GetValue(of_tet))
                cells.add(of_cell)
        self.assertGreater(len(cells), 1)


class ErrorsTest(unittest.TestCase):
    def test_what_cannot_be_cut(self):
        short, unfinished, wrong = curved(), curved(), curved()
        short.GetPointData().GetArray("s").SetNumberOfTuples(3)
        unfinished.GetPoints().SetPoint(0, float("nan"), 0, 0)
        wrong.InsertNextCell(vtk.VTK_BIQUADRATIC_QUADRATIC_WEDGE, 15, range(15))
        wrong.GetCellData().Initialize()
        for data, words in ((short, "tuples"), (unfinished, "nan"), (wrong, "it must have 18")):
            with self.subTest(words=words), VtkErrors() as errors:
                self.assertEqual(tessellated(data).GetNumberOfCells(), 0)
                self.assertEqual(len(errors.texts), 1)
                self.assertIn(words, errors.texts[0])

    def test_nothing(self):
        self.assertEqual(tessellated(vtk.vtkUnstructuredGrid()).GetNumberOfCells(), 0)

    def test_tolerances_are_clamped(self):
        made = vtktetmarch.vtkTetMarchTessellator()
        for set_one, get_one in ((made.SetGeometryTolerance, made.GetGeometryTolerance),
                                 (made.SetScalarTolerance, made.GetScalarTolerance)):
            set_one(0)
            self.assertEqual(get_one(), 1e-6)


if __name__ == "__main__":
    unittest.main()
