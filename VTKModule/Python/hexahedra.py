# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cells of a curvilinear grid."""
import numpy as np
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkUnstructuredGrid

from .arrays import set_cells


def dimensions_of(grid):
    """The numbers of points along the dimensions of a vtkStructuredGrid, in every version of VTK."""
    found = [0, 0, 0]
    grid.GetDimensions(found)
    return found


def as_hexahedra(grid):
    """A vtkUnstructuredGrid of the cells of a vtkStructuredGrid with at least two points along each dimension.

    Cells and points are in the same order. Points and data are shared with the grid.
    """
    nx, ny, nz = dimensions_of(grid)
    first = np.arange(nx * ny * nz).reshape(nz, ny, nx)[:-1, :-1, :-1].reshape(-1, 1)
    lower = np.array([0, 1, nx + 1, nx])
    ids = first + np.concatenate([lower, lower + nx * ny])
    made = vtkUnstructuredGrid()
    made.SetPoints(grid.GetPoints())
    set_cells(made, ids.reshape(-1), 8 * np.arange(len(ids) + 1), np.full(len(ids), VTK_HEXAHEDRON, np.uint8))
    made.GetPointData().ShallowCopy(grid.GetPointData())
    made.GetCellData().ShallowCopy(grid.GetCellData())
    return made
