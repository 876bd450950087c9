# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Curvilinear grids, adaptive meshes and trees, and the same cells as unstructured grids."""
import math

from lattices import at_points, values_of
from paraview.vtk import (VTK_QUADRATIC_TETRA, vtkAMRBox, vtkDataSetAttributes, vtkExplicitStructuredGrid,
                          vtkHyperTreeGridNonOrientedGeometryCursor, vtkOverlappingAMR, vtkPoints, vtkStructuredData,
                          vtkStructuredGrid, vtkUniformGrid, vtkUnstructuredGrid)
from paraview.vtk.vtkFiltersCore import vtkAppendFilter
from paraview.vtk.vtkFiltersSources import vtkRandomHyperTreeGridSource

N = 6  # side of the adaptive mesh and of the trees; cubes of side 1 along each axis of other grids


def field(x, y, z):
    return x + 0.3 * y * z


def bend(x, y, z):
    """Around an axis, so that no cell is a box."""
    angle = 0.25 * x
    return ((4 + y) * math.sin(angle), (4 + y) * math.cos(angle), z + 0.1 * x * y / N)


def curvilinear(sizes, value, origin=(0, 0, 0)):
    """As lattice(), but bent."""
    grid = vtkStructuredGrid()
    grid.SetDimensions(*(n + 1 for n in sizes))
    points = vtkPoints()
    points.SetDataTypeToDouble()
    planes = [range(first, first + n + 1) for first, n in zip(origin, sizes)]
    for z in planes[2]:
        for y in planes[1]:
            for x in planes[0]:
                points.InsertNextPoint(bend(x, y, z))
    grid.SetPoints(points)
    return at_points(grid, value)


def bulging():
    """One VTK_QUADRATIC_TETRA whose edges bend out; its values are not linear either."""
    corners = [(0, 0, 0), (N, 0, 0), (0, N, 0), (0, 0, N)]
    places = corners + [tuple(0.5 * (p + q) for p, q in zip(corners[a], corners[b]))
                        for a, b in ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))]
    points = vtkPoints()
    for place in places:
        out = 1.0 if place in corners else 1.3
        points.InsertNextPoint([N / 4 + out * (x - N / 4) for x in place])
    grid = vtkUnstructuredGrid()
    grid.SetPoints(points)
    grid.InsertNextCell(VTK_QUADRATIC_TETRA, 10, range(10))
    return at_points(grid, field)


def hidden(grid):
    """Without the cells of a corner."""
    marks = grid.AllocateCellGhostArray()
    marks.Fill(0)
    for cell in range(N // 2):
        marks.SetValue(cell, vtkDataSetAttributes.HIDDENCELL)
    return grid


def unstructured(grid):
    """The same hexahedra, each with its points."""
    append = vtkAppendFilter()
    append.AddInputData(grid)
    append.Update()
    return append.GetOutput()


def explicit(grid):
    """The same hexahedra, with the points of each given."""
    copy = vtkExplicitStructuredGrid()
    copy.SetExtent(grid.GetExtent())
    copy.SetPoints(grid.GetPoints())
    copy.SetCells(unstructured(grid).GetCells())
    copy.GetPointData().ShallowCopy(grid.GetPointData())
    return copy


def cell_grid(grid):
    """The same cells as a vtkCellGrid, in whose opinion all fields are of cells."""
    from paraview.vtk.vtkFiltersCellGrid import vtkUnstructuredGridToCellGrid
    convert = vtkUnstructuredGridToCellGrid()
    convert.SetInputDataObject(grid)
    convert.Update()
    return convert.GetOutputDataObject(0).GetPartitionAsDataObject(0, 0)


def grid_of(boxes):
    """A hexahedron for each (bounds, value)."""
    append = vtkAppendFilter()
    for bounds, value in boxes:
        cell = vtkUniformGrid()
        cell.SetDimensions(2, 2, 2)
        cell.SetOrigin(bounds[::2])
        cell.SetSpacing([high - low for low, high in zip(bounds[::2], bounds[1::2])])
        append.AddInputData(values_of(cell, [value], of_cells=True))
    append.Update()
    return append.GetOutput()


def value_in(bounds):
    return field(*(0.5 * (low + high) for low, high in zip(bounds[::2], bounds[1::2])))


def block_of(width, low, count):
    """`count` cells of this width along each axis, from cell `low` on."""
    block = vtkUniformGrid()
    block.SetDimensions([count + 1] * 3)
    block.SetOrigin([width * a for a in low])
    block.SetSpacing([width] * 3)
    return block


def overlapping(widths, blocks):
    """A mesh from 0 on, each level half as wide as the one before, of (block, its first cell) on each level."""
    mesh = vtkOverlappingAMR()
    mesh.Initialize(len(widths), [len(each) for each in blocks])
    mesh.SetOrigin([0, 0, 0])
    mesh.SetGridDescription(vtkStructuredData.GetDataDescription([2, 2, 2]))
    for level, (width, each) in enumerate(zip(widths, blocks)):
        mesh.SetSpacing(level, [width] * 3)
        for number, (block, low) in enumerate(each):
            last = [a + points - 2 for a, points in zip(low, block.GetDimensions())]
            mesh.SetAMRBox(level, number, vtkAMRBox(low, last))
            mesh.SetDataSet(level, number, block)
        if level + 1 < len(widths):
            mesh.SetRefinementRatio(level, 2)
    mesh.GenerateParentChildInformation()
    return mesh


def adaptive():
    """Cubes of side 2, and of side 1 in the middle: (the mesh, its leaves)."""
    blocks, leaves = [], []
    for level, (side, low, count) in enumerate(((2, 0, 3), (1, 2, 2))):
        block = block_of(side, [low] * 3, count)
        boxes = [block.GetCell(cell).GetBounds() for cell in range(block.GetNumberOfCells())]
        values = [value_in(bounds) for bounds in boxes]
        blocks.append([(values_of(block, values, of_cells=True), [low] * 3)])
        is_leaf = [level == 1 or any(first not in (2, 3) for first in bounds[::2]) for bounds in boxes]
        leaves += [box for box, leaf in zip(zip(boxes, values), is_leaf) if leaf]
    return overlapping((2, 1), blocks), grid_of(leaves)


def leaves_below(cursor):
    """The (number, bounds) of each."""
    if cursor.IsLeaf():
        bounds = [0.0] * 6
        cursor.GetBounds(bounds)
        return [(cursor.GetGlobalNodeIndex(), bounds)]
    leaves = []
    for child in range(cursor.GetNumberOfChildren()):
        cursor.ToChild(child)
        leaves += leaves_below(cursor)
        cursor.ToParent()
    return leaves


def trees():
    """Of random depths: (the trees, their leaves)."""
    source = vtkRandomHyperTreeGridSource()
    source.SetDimensions(3, 3, 3)
    source.SetOutputBounds(0, N, 0, N, 0, N)
    source.SetMaxDepth(3)
    source.SetSeed(1)
    source.Update()
    grid = source.GetHyperTreeGridOutput()
    leaves = []
    for tree in range(grid.GetMaxNumberOfTrees()):
        cursor = vtkHyperTreeGridNonOrientedGeometryCursor()
        grid.InitializeNonOrientedGeometryCursor(cursor, tree)
        leaves += leaves_below(cursor)
    values = [0.0] * grid.GetNumberOfCells()
    for number, bounds in leaves:
        values[number] = value_in(bounds)
    return values_of(grid, values, of_cells=True), grid_of([(bounds, values[number]) for number, bounds in leaves])
