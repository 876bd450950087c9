# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""An xarray.DataArray becomes an image, a rectilinear or a curvilinear grid, by its coordinates."""
import importlib.util
import types
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtktetmarch

SIZE = (60, 45)
NZ, NY, NX = 3, 4, 5
VALUES = np.arange(60.0).reshape(NZ, NY, NX)
X, Y, Z = 10 + 0.5 * np.arange(NX), 20 + 2.0 * np.arange(NY), 30 + 3.0 * np.arange(NZ)
UNEVEN = np.array([0, 1, 3, 6, 10.0])


class LikeDataArray:
    """What is used of an xarray.DataArray; coordinates are (dims, values) or (dims, values, attrs)."""

    def __init__(self, values, coords=None, dims=(), name=None, attrs=None):
        self.values, self.dims, self.name, self.attrs = np.asarray(values), dims, name, attrs or {}
        self.shape = self.values.shape
        made = {key: each if isinstance(each, tuple) else ((key,), each) for key, each in (coords or {}).items()}
        self.coords = {key: LikeDataArray(each[1], None, each[0] if isinstance(each[0], tuple) else (each[0],), key,
                                          *each[2:]) for key, each in made.items()}

    def isel(self, chosen):
        def of(array):
            index = tuple(chosen.get(dim, slice(None)) for dim in array.dims)
            return tuple(dim for dim in array.dims if dim not in chosen), array.values[index], array.attrs

        dims, values, attrs = of(self)
        return LikeDataArray(values, {key: of(each) for key, each in self.coords.items()}, dims, self.name, attrs)


def drawn(data):
    return vtktetmarch.read(data)


def values_at(grid, x, y, z):
    """The value at a point of the world."""
    point = grid.FindPoint((x, y, z))
    np.testing.assert_allclose(grid.GetPoint(point), (x, y, z))
    return grid.GetPointData().GetScalars().GetValue(point)


class Cases:
    """For `make`: xarray.DataArray, or what looks like it."""

    def test_without_coordinates_memory_is_shared(self):
        values = VALUES.copy()
        image = drawn(self.make(values, dims=("level", "row", "column"), name="heat"))
        self.assertEqual((image.GetClassName(), image.GetDimensions()), ("vtkImageData", (NX, NY, NZ)))
        self.assertEqual(image.GetPointData().GetScalars().GetName(), "heat")
        self.assertTrue(np.shares_memory(vtk_to_numpy(image.GetPointData().GetScalars()), values))

    def test_axes_are_known_by_name_and_attribute(self):
        for dims, coords in ((("x", "y", "z"), {}), (("lon", "lat", "depth"), {}), (("i", "j", "k"), {}),
                             (("x_rho", "row", "column"), {"row": (("row",), Y, {"axis": "Y"})}),
                             (("a", "b", "c"), {"a": (("a",), X, {"standard_name": "longitude"}),
                                                "b": (("b",), Y, {"axis": "Y", "units": "km"})})):
            image = drawn(self.make(VALUES.T, coords, dims))
            self.assertEqual(image.GetDimensions(), (NX, NY, NZ), dims)
            self.assertTrue(np.array_equal(vtk_to_numpy(image.GetPointData().GetScalars()), VALUES.ravel()))

    def test_even_coordinates_are_an_image(self):
        for kind in (float, np.float32, int):
            x = (2 * X).astype(kind)
            image = drawn(self.make(VALUES, {"x": x, "y": Y, "z": Z[::-1]}, ("z", "y", "x")))
            self.assertEqual((image.GetClassName(), image.GetOrigin(), image.GetSpacing()),
                             ("vtkImageData", (20, 20, 30), (1, 2, 3)))
            self.assertEqual(values_at(image, 21, 22, 30), VALUES[2, 1, 1])  # z falls
        lon = np.linspace(0, 360, 1001, dtype=np.float32)
        self.assertEqual(drawn(self.make(np.zeros((2, 2, 1001)), {"lon": lon}, ("z", "y", "lon"))).GetClassName(),
                         "vtkImageData")

    def test_uneven_coordinates_are_a_rectilinear_grid(self):
        for x in (UNEVEN, -UNEVEN):
            grid = drawn(self.make(VALUES, {"x": x, "y": Y, "z": Z}, ("z", "y", "x")))
            self.assertEqual(grid.GetClassName(), "vtkRectilinearGrid")
            for i in range(NX):
                self.assertEqual(values_at(grid, x[i], Y[2], Z[1]), VALUES[1, 2, i])

    def test_coordinates_of_two_and_three_dimensions_are_a_curvilinear_grid(self):
        j, i = np.mgrid[:NY, :NX]
        lon, lat = 10 + i + 0.2 * j, 20 - 2 * j + 0.1 * i
        layers = Z[:, None, None] + 0.3 * lon
        names = ("s", "eta", "xi")
        for coords, z in (({"lon_rho": (names[1:], lon), "lat_rho": (names[1:], lat), "s": -Z}, None),
                          ({"nav_lon": (names[:0:-1], lon.T), "nav_lat": (names[1:], lat),
                            "z_rho": (names, layers), "s": Z, "area": (names[1:], lat)}, layers)):
            if z is None:  # `s` is z by its place, and the coordinate of its dimension
                z = np.broadcast_to(-Z[:, None, None], VALUES.shape)
            data = self.make(VALUES, coords, names, name="salt")
            grid = drawn(data)
            self.assertEqual((grid.GetClassName(), grid.GetExtent()), ("vtkStructuredGrid", (0, 4, 0, 3, 0, 2)))
            for k, row, column in ((0, 0, 0), (2, 1, 3), (1, 3, 4)):
                self.assertEqual(values_at(grid, lon[row, column], lat[row, column], z[k, row, column]),
                                 VALUES[k, row, column])
            found = vtktetmarch.volume(data).GetMapper().GetDataObjectInput()
            self.assertTrue(np.shares_memory(vtk_to_numpy(found.GetPointData().GetScalars()), data.values))
            self.assertEqual(found.GetClassName(), "vtkStructuredGrid")
            picture = vtktetmarch.screenshot(data, "salt", size=SIZE)
            self.assertGreater((picture.max(axis=2) > 40).mean(), 0.1)

    def test_dimensions_of_one_are_left_out(self):
        data = self.make(VALUES[None], {"time": [7], "z_w": (("time", "z"), Z[None])}, ("time", "z", "y", "x"))
        self.assertEqual((drawn(data).GetDimensions(), drawn(data).GetOrigin()), ((NX, NY, NZ), (0, 0, 30)))

    def test_what_is_wrong_is_said(self):
        dims = ("z", "y", "x")
        plane = np.zeros((NY, NX))
        for values, coords, names, error, text in (
                (VALUES[0], {}, dims[1:], ValueError, r"dimensions \('y', 'x'\); a volume has three"),
                (np.stack([VALUES] * 2), {}, ("time", *dims), ValueError, r"as by .isel\(time=0\)"),
                (VALUES[:1], {}, dims, ValueError, r"shape \(1, 4, 5\); a volume has at least 2"),
                (VALUES, {"x": [0, 1, 1, 2, 3]}, dims, ValueError, "coordinates of x neither rise nor fall"),
                (VALUES, {"x": np.array([0, 1, np.nan, 2, 3])}, dims, ValueError, "coordinate 'x' .* finite"),
                (VALUES, {"z": np.arange(NZ).astype("M8[D]")}, dims, ValueError,
                 r"coordinate 'z' has the type datetime64.*drop_vars\('z'\)"),
                (VALUES, {"lon": (("y", "x"), plane), "lon_u": (("y", "x"), plane)}, dims, ValueError,
                 "several coordinates of x: 'lon', 'lon_u'"),
                (VALUES.astype("M8[s]"), {}, dims, TypeError, "data has values of type datetime64")):
            with self.subTest(text=text), self.assertRaisesRegex(error, text):
                vtktetmarch.volume(self.make(values, coords, names))


class LikeDataArrayTest(Cases, unittest.TestCase):
    make = LikeDataArray


@unittest.skipUnless(importlib.util.find_spec("xarray"), "xarray isn't installed")
class DataArrayTest(Cases, unittest.TestCase):
    def make(self, *given, **named):
        import xarray

        return xarray.DataArray(*given, **named)

    def test_a_dataset_and_pandas_are_refused(self):
        import xarray

        data = xarray.DataArray(VALUES, dims=("z", "y", "x"), name="heat")
        for wrong, text in ((data.to_dataset(), "Dataset.* it has several arrays: give one of them"),
                            (data.to_series(), "Series.* table has no cells"),
                            (data.to_dataframe(), "DataFrame.* table has no cells")):
            for call in (vtktetmarch.volume, vtktetmarch.read):
                self.assertRaisesRegex(TypeError, text, call, wrong)
        self.assertEqual(drawn(data.to_series().to_xarray()).GetDimensions(), (NX, NY, NZ))


class TableTest(unittest.TestCase):
    def test_what_looks_like_pandas_is_refused(self):
        table = type("DataFrame", (), {"__module__": "pandas.core.frame"})()
        with self.assertRaisesRegex(TypeError, "data is a DataFrame, which is no volume; a table has no cells"):
            vtktetmarch.volume(table)
        with self.assertRaisesRegex(TypeError, "path is a list, which is no volume; numpy.array"):
            vtktetmarch.read(VALUES.tolist())
        dataset = types.SimpleNamespace(dims={}, coords={}, data_vars={}, attrs={})
        with self.assertRaisesRegex(TypeError, "it has several arrays"):
            vtktetmarch.volume(dataset)


if __name__ == "__main__":
    unittest.main(verbosity=2)
