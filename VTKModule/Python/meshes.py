# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Unstructured grids from meshes of meshio."""
from itertools import chain

import numpy as np
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON

from .arrays import from_arrays
from .cell_types import CELL_TYPES
from .shared_arrays import add_arrays

# The beginnings of names of cells without a volume: they are left out, as boundaries that most meshes have.
FLAT = ("empty", "vertex", "line", "triangle", "quad", "pixel", "polygon", "VTK_LAGRANGE_CURVE",
        "VTK_LAGRANGE_TRIANGLE", "VTK_LAGRANGE_QUADRILATERAL", "VTK_BEZIER_CURVE", "VTK_BEZIER_TRIANGLE",
        "VTK_BEZIER_QUADRILATERAL")


def solid_blocks(mesh):
    """(its number in the mesh, the type's name, its cells) of each block of solid cells; polyhedra come last."""
    found, kinds = [], []
    for number, block in enumerate(mesh.cells):
        kind, cells = (block.type, block.data) if hasattr(block, "type") else block
        kinds.append(kind)
        if kind in CELL_TYPES or kind.startswith("polyhedron"):
            found.append((number, kind, cells))
        elif not kind.startswith(FLAT):
            raise ValueError(f"the mesh has cells of the type {kind!r}; those that can be drawn are "
                             f"{', '.join(CELL_TYPES)} and polyhedra")
    if not found:
        raise ValueError(f"the mesh has no solid cells: {', '.join(kinds) or 'no cells at all'}")
    return sorted(found, key=lambda block: block[1].startswith("polyhedron"))


def joined(parts):
    """One array of several; a single one itself."""
    return parts[0] if len(parts) == 1 else np.ma.concatenate(parts)


def cells_of(blocks):
    """Cells and their types, as from_arrays() takes them."""
    arrays = [np.asarray(cells) for _, _, cells in blocks]
    kinds = [kind for _, kind, _ in blocks]
    if len(blocks) == 1:
        return arrays[0], kinds[0]
    sizes = np.concatenate([np.full(len(cells), cells.shape[1]) for cells in arrays] or [np.empty(0, int)])
    types = np.concatenate([np.full(len(cells), CELL_TYPES[kind][0]) for kind, cells in zip(kinds, arrays)]
                           or [np.empty(0, int)])
    connectivity = np.concatenate([cells.reshape(-1) for cells in arrays] or [np.empty(0, int)])
    return (connectivity, np.append(0, np.cumsum(sizes))), types


def add_polyhedron(grid, number, faces):
    """Adds a cell, of lists of each face's points. number: that of the cell, for errors."""
    count = grid.GetNumberOfPoints()
    stream = vtkIdList()
    stream.InsertNextId(len(faces))
    for face in faces:
        stream.InsertNextId(len(face))
        for point in face:
            if not 0 <= point < count:
                raise ValueError(f"polyhedron {number} has the point {point}; the {count} points are counted from 0")
            stream.InsertNextId(int(point))
    grid.InsertNextCell(VTK_POLYHEDRON, stream)


def from_meshio(mesh):
    """A grid of the solid cells of a meshio.Mesh; triangles, lines and vertices of its boundary are left out.

    Points, and cells and their data if all solid cells are in one block, share the memory of the mesh; else they are
    copied. Polyhedra come behind other cells.
    """
    blocks = solid_blocks(mesh)
    polyhedra = [block for block in blocks if block[1].startswith("polyhedron")]
    others = blocks[:len(blocks) - len(polyhedra)]
    grid = from_arrays(mesh.points, *cells_of(others), dict(mesh.point_data))
    for number, faces in enumerate(chain.from_iterable(cells for _, _, cells in polyhedra)):
        add_polyhedron(grid, number, faces)
    cell_data = {name: joined([parts[number] for number, _, _ in blocks]) for name, parts in mesh.cell_data.items()}
    add_arrays(grid.GetCellData(), cell_data, grid.GetNumberOfCells(), "cells")
    return grid
