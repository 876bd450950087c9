# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images and rectilinear grids over the unit cube, the same on every machine, and scalars for them."""
import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk

from made_grids import waves

UNSEEN = 0.2  # a scalar of its own for parts of which nothing is to be seen


def coordinates(cells, even):
    """Of the points along each axis, from 0 to 1."""
    t = np.linspace(0, 1, cells + 1)
    return t if even else t + 0.1 * np.sin(2 * np.pi * t)


def lattice(cells, even):
    """An image, or a rectilinear grid of uneven coordinates, of that many cells along x, y and z."""
    if even:
        image = vtk.vtkImageData()
        image.SetDimensions(*[n + 1 for n in cells])
        image.SetSpacing(*[1 / n for n in cells])
        return image
    grid = vtk.vtkRectilinearGrid()
    grid.SetDimensions(*[n + 1 for n in cells])
    for method, n in zip((grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates), cells):
        method(numpy_to_vtk(coordinates(n, even), deep=True))
    return grid


def values_of(cells, even, of_points, low=0.0, unseen=0.0, nans=False, components=1):
    """Waves from `low` to 1, i fastest, a column for each component; in the first share `unseen` of cells along x the scalars
    are UNSEEN, and `nans` puts some that are not finite into the rest."""
    axes = [coordinates(n, even) for n in cells]
    axes = axes if of_points else [(t[1:] + t[:-1]) / 2 for t in axes]
    z, y, x = np.meshgrid(*reversed(axes), indexing="ij")
    places = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    values = np.stack([low + (1 - low) * waves(places, 0.8 + 0.2 * k, k) for k in range(components)], axis=1)
    seen = np.tile(np.linspace(0, 1, len(axes[0])) >= unseen, len(axes[1]) * len(axes[2]))
    if nans:
        values[np.flatnonzero(seen)[5::29]] = np.nan
    values[~seen] = UNSEEN
    return values
