# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Grids of unit cubes, and sources of ParaView that hand them out."""
from paraview import simple
from paraview.vtk import (VTK_HEXAHEDRON, vtkCompositeDataSet, vtkDoubleArray, vtkMultiBlockDataSet, vtkPoints,
                          vtkUnstructuredGrid)

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
