# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cameras with the visible part of the data, or other points, just in view."""
import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkImageData, vtkPointSet, vtkUnstructuredGrid

from .inputs import LATTICES, blocks_of
from .opacities import nodes_of

ANGLE, MARGIN = 30.0, 1.05  # as vtkTetMarchFirstPicture.PlaceCamera() has them
MOST = 100  # values along each dimension of an image that are looked at
SHOWN = 0.01  # of the largest opacity


def matrix_array(matrix):
    """A vtkMatrix4x4 as an array (4, 4)."""
    return np.array([[matrix.GetElement(i, k) for k in range(4)] for i in range(4)])


def transformed(points, matrix):
    """Points (points, 3) by an affine vtkMatrix4x4."""
    matrix = matrix_array(matrix)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def drawn_points(block):
    """The points of cells of a grid with points: (points, 3)."""
    points = vtk_to_numpy(block.GetPoints().GetData())
    if isinstance(block, vtkUnstructuredGrid):
        points = points[np.unique(vtk_to_numpy(block.GetCells().GetConnectivityArray()))]
    return points


def values_of(block, first):
    """The values of the chosen component of an image or rectilinear grid, (z, y, x), of points or cells; or None."""
    of_cells = first.GetChosenAssociation() == first.CELLS
    attributes = block.GetCellData() if of_cells else block.GetPointData()
    array = attributes.GetArray(first.GetChosenArray().GetName())
    if array is None:
        return None
    shape = [max(n - of_cells, 1) for n in reversed(block.GetDimensions())]
    values = vtk_to_numpy(array).reshape(*shape, array.GetNumberOfComponents())
    values = values[np.ix_(*map(some_of, shape))].astype(float)
    component = first.GetChosenComponent()
    return values[..., component] if component >= 0 else np.linalg.norm(values, axis=-1)


def some_of(count):
    """At most about MOST of the indices below a count, the first and the last among them."""
    return np.unique(np.append(np.arange(0, count, math.ceil(count / MOST)), count - 1))


def coordinates_of(block, of_cells):
    """The coordinates along x, y and z of the values_of() an image (indices) or rectilinear grid; of cells, of ends."""
    if isinstance(block, vtkImageData):
        extent = block.GetExtent()
        found = [np.arange(extent[2 * i], extent[2 * i + 1] + 1.0) for i in range(3)]
    else:
        found = [vtk_to_numpy(array).astype(float) for array in
                 (block.GetXCoordinates(), block.GetYCoordinates(), block.GetZCoordinates())]
    return [each[np.append(some_of(len(each) - 1), -1) if of_cells else some_of(len(each))] for each in found]


def cell_ends(shown, of_cells):
    """Which points are ends of cells that are shown: of cells themselves, or of points that are ends of such cells."""
    for axis in range(3):
        before, after = [(1, 0) if i == axis else (0, 0) for i in range(3)], [(0, int(i == axis)) for i in range(3)]
        if of_cells:
            shown = np.pad(shown, before) | np.pad(shown, after)
        else:
            lower, upper = [slice(None)] * 3, [slice(None)] * 3
            lower[axis], upper[axis] = slice(None, -1), slice(1, None)
            wider = shown.copy()
            wider[tuple(lower)] |= shown[tuple(upper)]
            wider[tuple(upper)] |= shown[tuple(lower)]
            shown = wider
    return shown


def shown_points(block, first, opacity):
    """The points of visible cells of an image or rectilinear grid: (points, 3). opacity: of an array of values."""
    values = values_of(block, first)
    if values is None:
        return np.empty((0, 3))
    of_cells = first.GetChosenAssociation() == first.CELLS
    opacities = np.where(np.isfinite(values), opacity(values), 0)
    index = np.nonzero(cell_ends(opacities > SHOWN * opacities.max(), of_cells))[::-1]
    points = np.stack([each[i] for each, i in zip(coordinates_of(block, of_cells), index)], axis=1)
    return transformed(points, block.GetIndexToPhysicalMatrix()) if isinstance(block, vtkImageData) else points


def corners(boxed):
    """The corners of the box of a data set or a prop: (8, 3)."""
    return np.stack(np.meshgrid(*np.reshape(boxed.GetBounds(), (3, 2))), axis=-1).reshape(-1, 3)


def visible_points(data, first, function):
    """Points of the visible part of data; if nothing is visible, the corners of all. function: a vtkPiecewiseFunction.

    first: a vtkTetMarchFirstPicture that has chosen the array.
    """
    values, opacities = np.transpose(nodes_of(function) or [(0.0, 1.0)])
    blocks = list(blocks_of(data)) if isinstance(data, vtkCompositeDataSet) else [data]
    found = [shown_points(block, first, lambda v: np.interp(v, values, opacities)) if isinstance(block, LATTICES)
             else drawn_points(block) for block in blocks if isinstance(block, (*LATTICES, vtkPointSet))]
    points = np.concatenate(found)
    return points if len(points) else np.concatenate([corners(block) for block in blocks])


def fit_view(camera, points, aspect, margin=MARGIN):
    """Moves a camera, which looks into the same direction as before, such that points just fit into the picture.

    The sides of the view touch the outermost points: with c towards the viewer, who is at the distance d over the
    centre m, a point is in the picture if |a - m| <= slope (d - c).
    """
    back = -np.array(camera.GetDirectionOfProjection())
    right = np.cross(camera.GetViewUp(), back)
    right /= np.linalg.norm(right)
    up = np.cross(back, right)
    places = [points @ axis for axis in (right, up, back)]
    slopes = [math.tan(math.radians(ANGLE / 2)) / margin * side for side in (aspect, 1.0)]
    highs = [(place + slope * places[2]).max() for place, slope in zip(places, slopes)]
    lows = [(slope * places[2] - place).max() for place, slope in zip(places, slopes)]
    a, b = [(high - low) / 2 for high, low in zip(highs, lows)]
    size = max(place.max() - place.min() for place in places) / 2 or 1.0
    distance = max(*((high + low) / 2 / slope for high, low, slope in zip(highs, lows, slopes)),
                   places[2].max() + 1e-3 * size)
    depth = (places[2].max() + places[2].min()) / 2
    camera.SetFocalPoint(*(a * right + b * up + depth * back))
    camera.SetPosition(*(a * right + b * up + distance * back))
    camera.SetViewUp(*up)
    camera.SetViewAngle(ANGLE)
    camera.SetParallelScale(margin * max(abs(places[1] - b).max(), abs(places[0] - a).max() / aspect) or 1.0)
