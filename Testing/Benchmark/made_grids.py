# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lattices of tetrahedra in the unit cube, the same on every machine, and scalars for them."""
import itertools

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

TETRAHEDRON = 10  # VTK_TETRA
# Below 1/6 of the spacing no tetrahedron can turn over.
JITTER = 0.15


def lattice_points(cubes, jitter, seed):
    """Points that move by up to `jitter` times the spacing, those on the surface only along it."""
    axis = np.arange(cubes + 1)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    places = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    moves = jitter * (2 * np.random.RandomState(seed).random_sample(places.shape) - 1)
    moves[(places == 0) | (places == cubes)] = 0
    return (places + moves) / cubes


def lattice_cells(cubes):
    """Point ids of six tetrahedra a cube (Kuhn's subdivision), and the place of each one's cube."""
    row, layer = cubes + 1, (cubes + 1) ** 2
    steps = (1, row, layer)
    axis = np.arange(cubes)
    z, y, x = (a.ravel() for a in np.meshgrid(axis, axis, axis, indexing="ij"))
    first = x + row * y + layer * z
    cells = np.empty((len(first), 6, 4), dtype=np.int64)
    for k, order in enumerate(itertools.permutations(range(3))):
        corners = [first]
        for direction in order:
            corners.append(corners[-1] + steps[direction])
        # Odd permutations would have a negative volume.
        if order in ((0, 2, 1), (1, 0, 2), (2, 1, 0)):
            corners[1], corners[2] = corners[2], corners[1]
        cells[:, k] = np.stack(corners, axis=1)
    centres = (np.stack([x, y, z], axis=1) + 0.5) / cubes
    return cells.reshape(-1, 4), np.repeat(centres, 6, axis=0)


def grid_of(points, cells):
    """An unstructured grid of tetrahedra."""
    places = vtk.vtkPoints()
    places.SetData(numpy_to_vtk(points, deep=True))
    offsets = numpy_to_vtkIdTypeArray(np.arange(0, cells.size + 1, 4), deep=True)
    connectivity = numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells).ravel(), deep=True)
    array = vtk.vtkCellArray()
    array.SetData(offsets, connectivity)
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(places)
    grid.SetCells(TETRAHEDRON, array)
    return grid


def curvilinear(places, cubes):
    """A curvilinear grid of as many cubes along each dimension, whose points lattice_points() gave."""
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    grid = vtk.vtkStructuredGrid()
    grid.SetDimensions(3 * [cubes + 1])
    grid.SetPoints(points)
    return grid


def with_points_of_each_cell(grid):
    """The same tetrahedra, each with four points of its own, and for each of these its number in the grid."""
    numbers = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    return grid_of(points_of(grid)[numbers], np.arange(len(numbers))), numbers


def with_quadratic_cells(grid, bend):
    """Quadratic tetrahedra with the same corners, and the two points of the grid between which each new point is.

    New points are that far (an array of 3) from the middles of these. They have the numbers behind those of the grid.
    """
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    edges = np.sort(cells[:, [(0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)]], axis=2)
    ends, middles = np.unique(edges.reshape(-1, 2), axis=0, return_inverse=True)
    places = points_of(grid)
    quadratic = vtk.vtkUnstructuredGrid()
    quadratic.SetPoints(vtk.vtkPoints())
    moved = places[ends].mean(axis=1) + bend
    quadratic.GetPoints().SetData(numpy_to_vtk(np.concatenate([places, moved]), deep=True))
    for corners, between in zip(cells, len(places) + middles.reshape(-1, 6)):
        quadratic.InsertNextCell(vtk.VTK_QUADRATIC_TETRA, 10, [*corners, *between])
    return quadratic, ends


def lattice(cubes, keep=None, seed=1):
    """The unit cube, or those of its cubes whose centres (an array of shape n, 3) `keep` says."""
    points = lattice_points(cubes, JITTER, seed)
    cells, centres = lattice_cells(cubes)
    return grid_of(points, cells if keep is None else cells[keep(centres)])


def outside_a_hole(centres):
    """All but a ball in the middle: rays may enter twice."""
    return np.linalg.norm(centres - 0.5, axis=1) > 0.3


def outside_many_holes(centres):
    """All but 27 balls."""
    nearest = (np.floor(3 * centres) + 0.5) / 3
    return np.linalg.norm(centres - nearest, axis=1) > 0.12


def points_of(grid):
    return vtk_to_numpy(grid.GetPoints().GetData()).astype(np.float64)


def cell_centres_of(grid):
    centers = vtk.vtkCellCenters()
    centers.SetInputData(grid)
    centers.Update()
    return points_of(centers.GetOutput())


def waves(places, turns=1.5, phase=0.0):
    """A product of sines, 0..1."""
    return 0.5 + 0.5 * np.prod(np.sin(2 * np.pi * turns * places + 0.7 + phase), axis=1)


def add_array(data, name, values):
    """`values` of shape n or n, components; `data` is a grid's point or cell data."""
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    data.AddArray(array)
    return array
