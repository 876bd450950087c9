# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkTetMarchDualGrid: values of an adaptive mesh's leaves become a continuous function."""
import random
import unittest

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import vtktetmarch
from vtktetmarch.errors import VtkErrors

ROOTS = 5


def linear(points):
    return 1 + 2 * points[..., 0] - 3 * points[..., 1] + 0.5 * points[..., 2]


def tree(levels, value=linear, seed=1, masked=0.0, dimensions=(ROOTS + 1,) * 3):
    """A vtkHyperTreeGrid whose roots have the width 1, each divided at random; values "v" of the middles of leaves."""
    grid = vtk.vtkHyperTreeGrid()
    grid.SetDimensions(dimensions)
    grid.SetBranchFactor(2)
    for axis, count in zip("XYZ", dimensions):
        getattr(grid, f"Set{axis}Coordinates")(numpy_to_vtk(np.arange(float(count)), deep=True))
    chosen = random.Random(seed)
    values, mask = vtk.vtkDoubleArray(), vtk.vtkBitArray()
    values.SetName("v")
    cursor = vtk.vtkHyperTreeGridNonOrientedGeometryCursor()

    def visit(level):
        bounds = [0.0] * 6
        cursor.GetBounds(bounds)
        node = cursor.GetGlobalNodeIndex()
        values.InsertValue(node, value(np.array(bounds).reshape(3, 2).mean(axis=1)))
        divided = level + 1 < levels and chosen.random() < 0.3
        mask.InsertValue(node, int(not divided and chosen.random() < masked))
        if divided:
            cursor.SubdivideLeaf()
            for child in range(2 ** grid.GetDimension()):
                cursor.ToChild(child)
                visit(level + 1)
                cursor.ToParent()

    first = 0
    for root in range(grid.GetMaxNumberOfTrees()):
        grid.InitializeNonOrientedGeometryCursor(cursor, root, True)
        cursor.SetGlobalIndexStart(first)
        visit(0)
        first += cursor.GetTree().GetNumberOfVertices()
    if masked:
        grid.SetMask(mask)
    grid.GetCellData().SetScalars(values)
    return grid


def blocks(fine_low=(1, 1, 1), spacing=0.5):
    """A vtkOverlappingAMR: 4^3 cells of the width 1, and in one place cells of half of it."""
    mesh = vtk.vtkOverlappingAMR()
    mesh.Initialize(2, [1, 1])
    mesh.SetOrigin((0, 0, 0))
    mesh.SetGridDescription(vtk.VTK_XYZ_GRID)
    for level, (low, width, cells) in enumerate((((0, 0, 0), 1.0, 4), (fine_low, spacing, 4))):
        block = vtk.vtkUniformGrid()
        block.SetOrigin(low)
        block.SetSpacing(width, width, width)
        block.SetDimensions(cells + 1, cells + 1, cells + 1)
        at = np.stack(np.meshgrid(*[low[a] + width * (np.arange(cells) + 0.5) for a in (2, 1, 0)], indexing="ij"),
                      axis=-1)[..., ::-1].reshape(-1, 3)
        values = numpy_to_vtk(linear(at), deep=True)
        values.SetName("v")
        block.GetCellData().SetScalars(values)
        mesh.SetSpacing(level, block.GetSpacing())
        first = [int(low[a] / width) for a in range(3)]
        mesh.SetAMRBox(level, 0, vtk.vtkAMRBox(first, [i + cells - 1 for i in first]))
        mesh.SetDataSet(level, 0, block)
    return mesh


def dual(data):
    made = vtktetmarch.vtkTetMarchDualGrid()
    made.SetInputData(data)
    made.Update()
    return made.GetOutput()


def points_and_values(grid):
    return vtk_to_numpy(grid.GetPoints().GetData()), vtk_to_numpy(grid.GetPointData().GetArray("v"))


def volume_of(data):
    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputData(data)
    sizes.Update()
    return vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray("Volume")).sum()


def leaves_of(data):
    leaves = vtk.vtkHyperTreeGridToUnstructuredGrid()
    leaves.SetInputData(data)
    leaves.Update()
    return leaves.GetOutput()


def probed(source, points):
    places = vtk.vtkPolyData()
    places.SetPoints(vtk.vtkPoints())
    places.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    probe = vtk.vtkProbeFilter()
    # The default of VTK 9.6 finds no cell at one place of 500, which is well within one.
    strategy = vtk.vtkCellLocatorStrategy()
    strategy.SetCellLocator(vtk.vtkStaticCellLocator())
    probe.SetFindCellStrategy(strategy)
    probe.SetSourceData(source)
    probe.SetInputData(places)
    probe.Update()
    return vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("v"))


class CellsTest(unittest.TestCase):
    def test_of_blocks(self):
        mesh = dual(blocks())
        self.assertEqual(mesh.GetPointData().GetScalars().GetName(), "v")
        points, values = points_and_values(mesh)
        leaves = 4 ** 3 - 2 ** 3 + 4 ** 3
        np.testing.assert_allclose(values[:leaves], linear(points[:leaves]), atol=1e-12)
        self.assertAlmostEqual(volume_of(mesh), 64, places=9)
        inside = ((points > 0.9) & (points < 3.1)).all(axis=1)
        self.assertGreater(inside.sum(), 300)
        np.testing.assert_allclose(values[inside], linear(points[inside]), atol=1e-7)

    def test_of_trees(self):
        for levels, masked in ((1, 0.0), (4, 0.0), (4, 0.2)):
            with self.subTest(levels=levels, masked=masked):
                data = tree(levels, masked=masked)
                mesh, leaves = dual(data), leaves_of(data)
                self.assertEqual(mesh.GetPointData().GetScalars().GetName(), "v")
                points, values = points_and_values(mesh)
                count = leaves.GetNumberOfCells()
                np.testing.assert_allclose(values[:count], linear(points[:count]), atol=1e-12)
                self.assertAlmostEqual(volume_of(mesh) / volume_of(leaves), 1, places=9)
                self.assertLessEqual(values.max(), values[:count].max())
                self.assertGreaterEqual(values.min(), values[:count].min())

    def test_is_linear_between_the_points_of_vtk(self):
        """VTK makes a voxel of each cell, which is wrong where levels differ, and moves points at the border."""
        data = tree(2, value=lambda p: np.sin(p).sum())
        reference = vtk.vtkHyperTreeGridToDualGrid()
        reference.SetInputData(data)
        reference.Update()
        expected, expected_values = points_and_values(reference.GetOutput())
        points, values = points_and_values(dual(data))
        inner = (np.abs(expected - ROOTS / 2) < ROOTS / 2 - 1).all(axis=1)
        self.assertGreater(inner.sum(), 30)
        np.testing.assert_allclose(probed(dual(data), expected[inner]), expected_values[inner], atol=1e-9)
        places = {tuple(point): value for point, value in zip(points, values)}
        for point, value in zip(expected[inner], expected_values[inner]):
            self.assertEqual(places[tuple(point)], value)

    def test_linear_functions(self):
        points = np.random.default_rng(1).uniform(1, ROOTS - 1, (500, 3))
        np.testing.assert_allclose(probed(dual(tree(2)), points), linear(points), atol=1e-8)

    def test_all_arrays_keep_their_types(self):
        data = tree(2)
        count = data.GetCellData().GetArray("v").GetNumberOfTuples()
        for name, array in (("whole", np.arange(count, dtype=np.int16)), ("vector", np.ones((count, 3), np.float32))):
            made = numpy_to_vtk(array, deep=True)
            made.SetName(name)
            data.GetCellData().AddArray(made)
        arrays = dual(data).GetPointData()
        self.assertEqual([arrays.GetArray(i).GetName() for i in range(arrays.GetNumberOfArrays())],
                         ["v", "whole", "vector"])
        self.assertTrue(arrays.GetArray("whole").IsA("vtkShortArray"))
        np.testing.assert_allclose(vtk_to_numpy(arrays.GetArray("vector")), 1, atol=1e-6)


class PictureTest(unittest.TestCase):
    def test_no_edge_of_a_leaf_is_seen(self):
        """The picture of a linear function equals that of one cell."""
        cube = vtk.vtkUnstructuredGrid()
        corners = np.array([[x, y, z] for z in (0, ROOTS) for y in (0, ROOTS) for x in (0, ROOTS)], float)
        cube.SetPoints(vtk.vtkPoints())
        cube.GetPoints().SetData(numpy_to_vtk(corners, deep=True))
        cube.InsertNextCell(vtk.VTK_VOXEL, 8, range(8))
        values = numpy_to_vtk(linear(corners), deep=True)
        values.SetName("v")
        cube.GetPointData().SetScalars(values)
        made = vtktetmarch.vtkTetMarchDualGrid()
        made.SetInputData(tree(2))
        planes = [(tuple(1.0 if a == axis else 2.0 for a in range(3)), tuple(float(a == axis) for a in range(3)))
                  for axis in range(3)]
        planes += [(tuple(ROOTS - 1.0 if a == axis else 2.0 for a in range(3)), tuple(-float(a == axis) for a in range(3)))
                   for axis in range(3)]
        pictures = []
        for data in (cube, made):
            figure = vtktetmarch.figure(data, "v", range=(-10, 10), unit_distance=1, size=(150, 120), clipping_planes=planes,
                                        opacity=[(-10, 0), (0, 0.2), (1, 0), (2, 0.4), (10, 0)])
            pictures.append(figure.screenshot().astype(int))
            self.assertEqual(figure.mapper.GetNumberOfLostRays(), 0)
        self.assertGreater(np.ptp(pictures[0]), 100)
        self.assertLessEqual(np.abs(pictures[0] - pictures[1]).max(), 1)

    def test_follows_its_input(self):
        data = tree(2)
        made = vtktetmarch.vtkTetMarchDualGrid()
        made.SetInputData(data)
        figure = vtktetmarch.figure(made, "v", range=(0, 10), size=(60, 50))
        before = figure.screenshot()
        values = data.GetCellData().GetArray("v")
        vtk_to_numpy(values)[:] = 5
        values.Modified()
        data.Modified()
        self.assertGreater(np.abs(figure.screenshot().astype(int) - before).max(), 20)


class ErrorsTest(unittest.TestCase):
    def test_what_cannot_be_converted(self):
        flat, turned = tree(2, dimensions=(4, 4, 1)), tree(2)
        turned.SetYCoordinates(numpy_to_vtk(np.arange(ROOTS + 1.0)[::-1], deep=True))
        half, short = tree(2), tree(2)
        half.SetMask(vtk.vtkBitArray())
        half.GetMask().InsertNextValue(0)
        short.GetCellData().GetArray("v").SetNumberOfTuples(3)
        for data, words in ((flat, "2 dimension"), (vtk.vtkHyperTreeGrid(), "dimension"), (turned, "ascend"),
                            (half, "mask has 1 values"), (short, "3 tuples"),
                            (vtk.vtkOverlappingAMR(), "no block"),
                            (blocks(fine_low=(1.1, 1, 1)), "multiples"), (blocks(spacing=0.4), "multiples")):
            with self.subTest(words=words), VtkErrors() as errors:
                self.assertEqual(dual(data).GetNumberOfCells(), 0)
                self.assertEqual(len(errors.texts), 1)
                self.assertIn(words, errors.texts[0])


if __name__ == "__main__":
    unittest.main()
