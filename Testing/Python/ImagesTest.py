# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""NumPy arrays of three dimensions are images; arrays of every kind are right, or refused with a reason."""
import gc
import os
import tempfile
import unittest
import weakref

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtktetmarch

SIZE = (60, 45)
# 0 to 119, each once: exact in every type below.
VALUES = np.arange(120.0).reshape(4, 5, 6)
CUBE = np.array([(i & 1, i >> 1 & 1, i >> 2) for i in range(8)], float)
TETRAHEDRA = np.array([(0, 1, 2, 4), (3, 1, 7, 2), (5, 1, 4, 7), (6, 2, 7, 4), (1, 2, 4, 7)])


def read_only(array):
    array = array.copy(order="K")
    array.flags.writeable = False
    return array


def unaligned(array):
    return np.frombuffer(b"?" + array.tobytes(), array.dtype, offset=1).reshape(array.shape)


def memory_mapped(array):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "values")
        array.tofile(path)
        return np.memmap(path, array.dtype, "r", shape=array.shape)  # stays mapped without the file


# An array of the same numbers as another, and the type in which VTK has them. Nothing is changed in the first.
KINDS = {
    "in C order": (lambda a: a.copy(), "f8"),
    "in Fortran order": (np.asfortranarray, "f8"),
    "every second one": (lambda a: np.repeat(a, 2, axis=-1)[..., ::2], "f8"),
    "backwards": (lambda a: np.flip(a).copy()[(slice(None, None, -1),) * a.ndim], "f8"),
    "axes exchanged": (lambda a: np.swapaxes(np.swapaxes(a, 0, -1).copy(), 0, -1), "f8"),
    "a part of a record": (lambda a: np.rec.fromarrays([a, a + 1]).f0, "f8"),
    "big-endian floats": (lambda a: a.astype(">f8"), "f8"),
    "big-endian integers": (lambda a: a.astype(">i2"), "i2"),
    "half precision": (lambda a: a.astype("f2"), "f4"),
    "big-endian half precision": (lambda a: a.astype(">f2"), "f4"),
    "read-only": (read_only, "f8"),
    "memory-mapped, read-only": (memory_mapped, "f8"),
    "not aligned": (unaligned, "f8"),
    "a matrix of objects that are numbers": (lambda a: a.astype(object), TypeError),
    "truths": (lambda a: a > 1, "u1"),
    "complex": (lambda a: a + 0j, TypeError),
    "longer than 64 bits": (lambda a: a.astype(np.longdouble), TypeError),
    "texts": (lambda a: a.astype(str), TypeError),
    "dates": (lambda a: a.astype("M8[s]"), TypeError),
    "nested lists": (lambda a: a.tolist(), "f8"),
}


class KindsTest(unittest.TestCase):
    def check(self, values, make_data, found_of, argument):
        for kind, (convert, expected) in KINDS.items():
            with self.subTest(kind=kind, argument=argument):
                given = convert(values)
                before = np.array(given)
                if not isinstance(expected, str):
                    self.assertRaisesRegex(expected, f"{argument} has values of type .*; VTK has", make_data, given)
                    continue
                data = make_data(given)
                self.assertTrue(np.array_equal(given, before))
                del given
                gc.collect()
                np.ones((64, *values.shape))  # takes memory that was freed
                found = found_of(data)
                self.assertEqual(found.dtype, np.dtype(expected))
                self.assertTrue(np.array_equal(found, before.astype(float)))

    def test_of_images(self):
        self.check(VALUES, vtktetmarch.from_image, lambda image: vtk_to_numpy(
            image.GetPointData().GetScalars()).reshape(VALUES.shape[::-1]).T, "array")

    def test_of_points_data(self):
        self.check(np.arange(24.0).reshape(8, 3),
                   lambda given: vtktetmarch.from_arrays(CUBE, TETRAHEDRA, "tetra", {"v": given}),
                   lambda grid: vtk_to_numpy(grid.GetPointData().GetArray("v")), "the array 'v' of points")

    def test_of_cells_data(self):
        self.check(np.arange(5.0), lambda given: vtktetmarch.from_arrays(CUBE, TETRAHEDRA, "tetra", None, {"v": given}),
                   lambda grid: vtk_to_numpy(grid.GetCellData().GetArray("v")), "the array 'v' of cells")

    def test_of_points_and_ids(self):
        for kind, (convert, expected) in KINDS.items():
            with self.subTest(kind=kind):
                if not isinstance(expected, str):
                    with self.assertRaisesRegex(expected, "points has values of type"):
                        vtktetmarch.from_arrays(convert(CUBE), TETRAHEDRA, "tetra")
                    continue
                made = vtktetmarch.from_arrays(convert(CUBE), TETRAHEDRA, "tetra")
                expected = np.array(convert(CUBE), float)
                self.assertTrue(np.array_equal(vtk_to_numpy(made.GetPoints().GetData()), expected))
        for convert in (np.asfortranarray, lambda ids: ids.astype(">i4"), read_only, unaligned,
                        lambda ids: np.flip(ids).copy()[::-1, ::-1]):
            made = vtktetmarch.from_arrays(CUBE, convert(TETRAHEDRA), "tetra")
            self.assertTrue(np.array_equal(vtk_to_numpy(made.GetCells().GetConnectivityArray()), TETRAHEDRA.ravel()))

    def test_pictures_are_the_same(self):
        expected = vtktetmarch.screenshot(VALUES, size=SIZE)
        self.assertGreater(expected.max(), 40)
        for kind in ("in Fortran order", "backwards", "big-endian integers", "half precision",
                     "memory-mapped, read-only", "not aligned"):
            self.assertTrue(np.array_equal(vtktetmarch.screenshot(KINDS[kind][0](VALUES), size=SIZE), expected), kind)

    def test_arrays_without_values(self):
        empty = vtktetmarch.from_arrays(np.empty((0, 3)), np.empty((0, 4), int), "tetra", {"v": np.empty(0)},
                                        {"w": np.empty((0, 2))})
        self.assertEqual((empty.GetNumberOfPoints(), empty.GetNumberOfCells()), (0, 0))
        with self.assertRaisesRegex(ValueError, "no cells to draw"):
            vtktetmarch.volume(empty)
        with self.assertRaisesRegex(ValueError, r"data has the shape \(0, 3, 3\)"):
            vtktetmarch.volume(np.empty((0, 3, 3)))


class ImageTest(unittest.TestCase):
    def test_the_first_index_is_x(self):
        image = vtktetmarch.from_image(VALUES, (1, 2, 3), (10, 20, 30), name="heat")
        self.assertEqual((image.GetDimensions(), image.GetSpacing(), image.GetOrigin()),
                         ((4, 5, 6), (1, 2, 3), (10, 20, 30)))
        scalars = image.GetPointData().GetScalars()
        self.assertEqual(scalars.GetName(), "heat")
        for index in ((0, 0, 0), (3, 1, 2), (1, 4, 5)):
            self.assertEqual(scalars.GetValue(image.ComputePointId(index)), VALUES[index])

    def test_other_orders_of_axes(self):
        expected = vtk_to_numpy(vtktetmarch.from_image(VALUES).GetPointData().GetScalars())
        for axes, order in (("zyx", (2, 1, 0)), ("yxz", (1, 0, 2)), ("zxy", (2, 0, 1))):
            image = vtktetmarch.from_image(VALUES.transpose(order), axes=axes)
            self.assertEqual(image.GetDimensions(), (4, 5, 6))
            self.assertTrue(np.array_equal(vtk_to_numpy(image.GetPointData().GetScalars()), expected), axes)

    def test_components(self):
        vectors = np.stack([VALUES, -VALUES], axis=-1)
        image = vtktetmarch.from_image(vectors)
        found = vtk_to_numpy(image.GetPointData().GetScalars())
        self.assertTrue(np.array_equal(found, np.stack([VALUES.T.ravel(), -VALUES.T.ravel()], axis=1)))
        mapper = vtktetmarch.volume(vectors, component=1).GetMapper()
        self.assertEqual((mapper.GetVectorMode(), mapper.GetVectorComponent()), (mapper.COMPONENT, 1))

    def test_voxels(self):
        image = vtktetmarch.from_image(VALUES, association="cells")
        self.assertEqual((image.GetDimensions(), image.GetNumberOfCells()), ((5, 6, 7), 120))
        self.assertEqual(image.GetCellData().GetScalars().GetValue(1), VALUES[1, 0, 0])

    def test_masked_values_are_nan(self):
        image = vtktetmarch.from_image(np.ma.masked_less(VALUES, 2))
        self.assertEqual(np.isnan(vtk_to_numpy(image.GetPointData().GetScalars())).sum(), 2)

    def test_memory_is_shared_and_lives(self):
        for make, axes in ((lambda: VALUES.copy("F"), "xyz"), (VALUES.copy, "zyx"),
                           (lambda: read_only(np.asfortranarray(VALUES)), "xyz"),
                           (lambda: np.ones((4, 5, 6, 3), "f4"), "zyx")):
            values = make()
            image = vtktetmarch.from_image(values, axes=axes)
            self.assertTrue(np.shares_memory(vtk_to_numpy(image.GetPointData().GetScalars()), values))
            values, alive = None, weakref.ref(values)
            gc.collect()
            self.assertIsNotNone(alive())
            image = None
            gc.collect()
            self.assertIsNone(alive())

    def test_arrays_are_drawn_and_read(self):
        image = vtktetmarch.from_image(VALUES)
        self.assertEqual(vtktetmarch.read(VALUES).GetDimensions(), (4, 5, 6))
        self.assertTrue(np.array_equal(vtktetmarch.screenshot(VALUES, "values", size=SIZE),
                                       vtktetmarch.screenshot(image, size=SIZE)))


if __name__ == "__main__":
    unittest.main(verbosity=2)
