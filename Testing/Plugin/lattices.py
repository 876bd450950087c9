# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Grids of cubes, images and rectilinear grids, and sources of ParaView that hand them out."""
from paraview import simple
from paraview.vtk import (VTK_HEXAHEDRON, vtkCompositeDataSet, vtkDoubleArray, vtkImageData, vtkMultiBlockDataSet,
                          vtkPoints, vtkRectilinearGrid, vtkUnstructuredGrid)

ARRAY = "f"


def lattice(sizes, value, origin=(0, 0, 0), ghosts=()):
    """Hexahedra, x fastest; `value` is a function of a point. Those of `ghosts` are marked as duplicates."""
    nx, ny, nz = (n + 1 for n in sizes)
    grid = vtkUnstructuredGrid()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    values = vtkDoubleArray()
    values.SetName(ARRAY)
    for z in range(nz):
        for y in range(ny):
            for x in range(nx):
                point = [a + b for a, b in zip(origin, (x, y, z))]
                points.InsertNextPoint(point)
                values.InsertNextValue(value(*point))
    grid.SetPoints(points)
    grid.GetPointData().AddArray(values)
    corners = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
    for z in range(sizes[2]):
        for y in range(sizes[1]):
            for x in range(sizes[0]):
                ids = [(x + i) + nx * ((y + j) + ny * (z + k)) for i, j, k in corners]
                grid.InsertNextCell(VTK_HEXAHEDRON, 8, ids)
    if ghosts:
        marks = grid.AllocateCellGhostArray()
        for cell in ghosts:
            marks.SetValue(cell, 1)
    return grid


def values_of(data, values, name=ARRAY, of_cells=False):
    """The data with an array of these numbers, or of tuples of them."""
    array = vtkDoubleArray()
    array.SetName(name)
    array.SetNumberOfComponents(len(values[0]) if isinstance(values[0], tuple) else 1)
    for value in values:
        if isinstance(value, tuple):
            array.InsertNextTuple(value)
        else:
            array.InsertNextValue(value)
    (data.GetCellData() if of_cells else data.GetPointData()).AddArray(array)
    return data


def at_points(data, value):
    """With `value`, a function of a point, at each of them."""
    return values_of(data, [value(*data.GetPoint(i)) for i in range(data.GetNumberOfPoints())])


def image(sizes, value, origin=(0, 0, 0)):
    """Of unit cubes; `value` as for lattice()."""
    data = vtkImageData()
    data.SetDimensions(*(n + 1 for n in sizes))
    data.SetOrigin(*origin)
    return at_points(data, value)


def rectilinear(planes, value):
    """Between these planes, a list for each axis."""
    grid = vtkRectilinearGrid()
    grid.SetDimensions(*map(len, planes))
    setters = (grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates)
    for coordinates, set_coordinates in zip(planes, setters):
        array = vtkDoubleArray()
        for coordinate in coordinates:
            array.InsertNextValue(coordinate)
        set_coordinates(array)
    return at_points(grid, value)


def blocks(**grids):
    """Without a block in the first place, so that flat indices begin at 2."""
    tree = vtkMultiBlockDataSet()
    tree.SetNumberOfBlocks(len(grids) + 1)
    for i, (name, grid) in enumerate(grids.items(), 1):
        tree.SetBlock(i, grid)
        tree.GetMetaData(i).Set(vtkCompositeDataSet.NAME(), name)
    return tree


def source_of(data):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source
