# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Unstructured grids from NumPy arrays."""
import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkUnstructuredGrid

from .cell_types import POINTS, cell_type_number
from .shared_arrays import add_arrays, array_of, keep_with, numeric_array, shared_array, shared_ids, unmasked


def integers(values, what):
    """Ids as int32 or int64, without a copy if possible."""
    array = numeric_array(unmasked(values, what, "leave out the cells that have them"), what)
    if array.dtype.kind == "f":
        raise TypeError(f"{what} has values of type {array.dtype}; they are ids, which are integers")
    return array if array.dtype in (np.int32, np.int64) else array.astype(np.int64)


def connectivity_and_offsets(cells):
    """Connectivity and offsets of any of the three forms of cells that from_arrays() accepts."""
    if isinstance(cells, tuple) and len(cells) == 2 and np.ndim(cells[0]) == 1:
        connectivity, offsets = (integers(part, what) for part, what in zip(cells, ("connectivity", "offsets")))
        if offsets.ndim != 1 or len(offsets) < 1 or offsets[0] != 0 or offsets[-1] != len(connectivity) \
                or (np.diff(offsets) < 0).any():
            raise ValueError(f"offsets begin with 0, never fall, and end with the length of connectivity, "
                             f"{len(connectivity)}: one more than there are cells")
        if offsets.dtype != connectivity.dtype:
            offsets = offsets.astype(connectivity.dtype)
        return connectivity, offsets
    ids = integers(cells, "cells")
    if ids.ndim == 2:
        n, k = ids.shape
        return ids.reshape(-1), np.arange(0, n * k + 1, max(k, 1), dtype=ids.dtype)[:n + 1]
    if ids.ndim != 1:
        raise ValueError(f"cells has the shape {ids.shape}; it is (cells, points of a cell), a flat array of a count "
                         "and as many ids for each cell, or a tuple (connectivity, offsets)")
    return split_flat(ids)


def split_flat(ids):
    """Connectivity and offsets of "count, ids..., count, ids..."."""
    row = int(ids[0]) + 1 if len(ids) else 1
    if row > 0 and len(ids) % row == 0 and (ids[::row] == row - 1).all():  # all cells have the same number
        return np.ascontiguousarray(ids.reshape(-1, row)[:, 1:]).reshape(-1), \
            np.arange(len(ids) // row + 1, dtype=ids.dtype) * ids.dtype.type(row - 1)
    starts, at = [], 0
    while at < len(ids):
        starts.append(at)
        if ids[at] < 0:
            raise ValueError(f"cells, flat, has a count of {ids[at]} at {at}")
        at += int(ids[at]) + 1
    if at != len(ids):
        raise ValueError(f"cells, flat, ends within its last cell: a count of {ids[starts[-1]]}, and "
                         f"{len(ids) - starts[-1] - 1} ids behind it")
    offsets = np.append(np.asarray(starts, np.int64) - np.arange(len(starts)), len(ids) - len(starts))
    return np.delete(ids, starts), offsets.astype(ids.dtype)


def types_of(cell_types, count):
    """An array of VTK's cell types, one per cell, as bytes."""
    if isinstance(cell_types, str) or array_of(cell_types, "cell_types").ndim == 0:
        return np.full(count, cell_type_number(cell_types), np.uint8)
    types = np.asarray(unmasked(cell_types, "cell_types", "leave out the cells that have them"))
    if types.shape != (count,):
        raise ValueError(f"cell_types has the shape {types.shape}; there are {count} cells: give one type for all, or "
                         "one a cell")
    if types.dtype.kind in "US":
        types = np.array([cell_type_number(str(name)) for name in types], np.uint8)
    for number in np.unique(types).tolist():
        cell_type_number(number)
    return np.ascontiguousarray(types, np.uint8)


def check_cells(connectivity, offsets, types, number_of_points):
    """Raises ValueError, which names the first wrong cell."""
    wrong = np.flatnonzero((connectivity < 0) | (connectivity >= number_of_points))
    if len(wrong):
        cell = int(np.searchsorted(offsets, wrong[0], "right")) - 1
        raise ValueError(f"cell {cell} has the point {connectivity[wrong[0]]}; the {number_of_points} points are "
                         "counted from 0")
    sizes = np.diff(offsets)
    for number in np.unique(types):
        points = POINTS.get(int(number))
        wrong = np.flatnonzero((types == number) & (sizes != points)) if points else ()
        if len(wrong):
            raise ValueError(f"cell {wrong[0]} has {sizes[wrong[0]]} points; one of its type, {number}, has {points}")


def points_of(points):
    array = numeric_array(unmasked(points, "points", "leave out the points that have them, and their cells"), "points")
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"points has the shape {array.shape}; it has to be (points, 3)")
    if array.dtype not in (np.float32, np.float64):
        array = array.astype(np.float64)
    if not np.isfinite(array).all():
        raise ValueError("points has coordinates that are NaN or infinite")
    made = vtkPoints()
    made.SetData(shared_array(array))
    return made


def set_cells(grid, connectivity, offsets, types):
    """Gives a vtkUnstructuredGrid cells that share the memory of arrays."""
    made = vtkCellArray()
    ids = shared_ids(offsets), shared_ids(connectivity)
    made.SetData(*ids)
    keep_with(made, *ids)
    grid.SetCells(shared_array(types), made)


def from_arrays(points, cells, cell_types, point_data=None, cell_data=None):
    """A vtkUnstructuredGrid that shares the memory of NumPy arrays.

    points: (points, 3), float32 or float64.
    cells: ids of points, from 0; one of
        (cells, points of a cell), if all cells are of one type;
        a tuple (connectivity, offsets) as in vtkCellArray: all ids, and the index of each cell's first, then the end;
        flat: for each cell the number of its ids and the ids, as in VTK before 9 and in PyVista.
    cell_types: one for all cells or one per cell: VTK's numbers (VTK_TETRA is 10), or meshio's names ("tetra",
        "hexahedron", "wedge", "pyramid", "voxel", "tetra10", ...).
    point_data, cell_data: {name: array}, one value or a tuple of them for each point or cell.

    Memory is shared, not copied, of: points, if float32 or float64; cells as int32 or int64 in the first two forms;
    data of integers and floats of 8 to 64 bits; each if contiguous in C order. It lives as long as the grid needs it.
    Other arrays are copied. After a change of a shared array call Modified() of it and of the grid:
    grid.GetPointData().GetArray("t").Modified(); grid.Modified().

    Masked values become NaN, which is not drawn; points and ids must have none.

    Raises ValueError for wrong shapes and ids, TypeError for other values than numbers.
    """
    grid = vtkUnstructuredGrid()
    grid.SetPoints(points_of(points))
    connectivity, offsets = connectivity_and_offsets(cells)
    types = types_of(cell_types, len(offsets) - 1)
    check_cells(connectivity, offsets, types, grid.GetNumberOfPoints())
    set_cells(grid, connectivity, offsets, types)
    add_arrays(grid.GetPointData(), point_data, grid.GetNumberOfPoints(), "points")
    add_arrays(grid.GetCellData(), cell_data, grid.GetNumberOfCells(), "cells")
    return grid
