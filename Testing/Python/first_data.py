# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data of every kind, as users bring them."""
import math
import os
import random

import vtkmodules.all as vtk

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")


def array(name, values, kind=vtk.vtkFloatArray, components=1):
    made = kind()
    made.SetName(name)
    made.SetNumberOfComponents(components)
    for value in values:
        made.InsertNextTuple((value,) if components == 1 else value)
    return made


def image(dimensions, spacing=(1.0, 1.0, 1.0), origin=(0.0, 0.0, 0.0)):
    made = vtk.vtkImageData()
    made.SetDimensions(dimensions)
    made.SetSpacing(spacing)
    made.SetOrigin(origin)
    return made


def unstructured(data):
    """The same cells as an unstructured grid."""
    append = vtk.vtkAppendFilter()
    append.SetOutputPointsPrecision(append.DOUBLE_PRECISION)
    append.AddInputData(data)
    append.Update()
    return append.GetOutput()


def points_of(data):
    return (data.GetPoint(i) for i in range(data.GetNumberOfPoints()))


def with_points(data, name, function, kind=vtk.vtkFloatArray):
    data.GetPointData().AddArray(array(name, [function(p) for p in points_of(data)], kind))
    return data


def read(reader, name):
    reader.SetFileName(os.path.join(DATA, name))
    reader.Update()
    return reader.GetOutput()


def radius(p):
    return math.sqrt(sum(x * x for x in p))


def flow():
    return read(vtk.vtkXMLUnstructuredGridReader(), "golfball_small.vtu")


def scan():
    return read(vtk.vtkXMLImageDataReader(), "bonsai_small.vti")


def hexahedra_with_cell_scalars():
    grid = unstructured(image((17, 13, 9), (0.1, 0.1, 0.2)))
    values = []
    for i in range(grid.GetNumberOfCells()):
        bounds = grid.GetCell(i).GetBounds()
        values.append(math.sin(3 * bounds[0]) * math.cos(2 * bounds[2]) + bounds[4])
    grid.GetCellData().AddArray(array("stress", values))
    grid.GetCellData().AddArray(array("vtkOriginalCellIds", range(grid.GetNumberOfCells()), vtk.vtkIdTypeArray))
    return grid


def quadratic_cells():
    source = vtk.vtkCellTypeSource()
    source.SetCellType(vtk.VTK_QUADRATIC_TETRA)
    source.SetBlocksDimensions(3, 3, 3)
    source.Update()
    grid = vtk.vtkUnstructuredGrid()
    grid.ShallowCopy(source.GetOutput())
    grid.GetPointData().Initialize()
    grid.GetCellData().Initialize()
    return with_points(grid, "distance", lambda p: radius([x - 1.5 for x in p]))


def thin_plate():
    """A hundredth as thick as it is wide; along no axis of the world."""
    plate = with_points(unstructured(image((41, 31, 2), (0.1, 0.1, 0.04))), "heat",
                        lambda p: math.exp(-2 * ((p[0] - 1) ** 2 + (p[1] - 1.5) ** 2)))
    transform = vtk.vtkTransform()
    transform.RotateX(35)
    transform.RotateY(50)
    filtered = vtk.vtkTransformFilter()
    filtered.SetInputData(plate)
    filtered.SetTransform(transform)
    filtered.Update()
    return filtered.GetOutput()


def values_over_many_sizes():
    """As concentrations are: from 4e-6 to 1."""
    return with_points(unstructured(image((25, 25, 25), (0.1, 0.1, 0.1), (-1.2, -1.2, -1.2))), "concentration",
                       lambda p: math.exp(-6 * radius(p)))


def constant():
    return with_points(unstructured(image((5, 5, 5))), "one", lambda p: 1.0)


def far_and_small():
    return with_points(unstructured(image((21, 21, 21), (1e-3, 1e-3, 1e-3), (1e6, -1e6, 1e6))), "p",
                       lambda p: math.sin(300 * (p[0] - 1e6)) + 200 * (p[2] - 1e6))


def outliers():
    randoms = random.Random(1)
    return with_points(unstructured(image((25, 25, 25))), "q",
                       lambda p: 1e6 if randoms.random() < 1e-3 else math.sin(p[0] / 4) + math.sin(p[1] / 5))


def with_nan():
    return with_points(unstructured(image((21, 21, 21))), "t", lambda p: math.nan if p[0] < 4 else p[1] + p[2])


def vectors():
    grid = unstructured(image((17, 17, 17), (0.2, 0.2, 0.2), (-1.6, -1.6, -1.6)))
    grid.GetPointData().AddArray(array("velocity", [(-p[1], p[0], 0.1) for p in points_of(grid)], components=3))
    return grid


def integers_with_air():
    """Like a scan: noise around nothing, and a shell of something."""
    randoms = random.Random(2)
    return with_points(image((48, 48, 48), origin=(-23.5, -23.5, -23.5)), "density",
                       lambda p: (1200 if 14 < radius(p) < 17 else 0) + randoms.randrange(60), vtk.vtkShortArray)


def rectilinear():
    grid = vtk.vtkRectilinearGrid()
    edges = [0.02 * i * i for i in range(20)]
    grid.SetDimensions(20, 20, 10)
    grid.SetXCoordinates(array("x", edges))
    grid.SetYCoordinates(array("y", edges))
    grid.SetZCoordinates(array("z", edges[:10]))
    return with_points(grid, "pressure", lambda p: math.cos(p[0]) * math.sin(p[1]) + 0.1 * p[2])


def curvilinear():
    grid = vtk.vtkStructuredGrid()
    grid.SetDimensions(20, 12, 8)
    points = vtk.vtkPoints()
    for k in range(8):
        for j in range(12):
            for i in range(20):
                angle, r = 0.2 * i, 1 + 0.1 * j
                points.InsertNextPoint(r * math.cos(angle), r * math.sin(angle), 0.15 * k)
    grid.SetPoints(points)
    return unstructured(with_points(grid, "swirl", lambda p: radius(p[:2]) + 0.3 * math.sin(4 * p[2])))


def blocks():
    tree = vtk.vtkMultiBlockDataSet()
    for i in range(3):
        part = with_points(unstructured(image((9, 9, 9), (0.25, 0.25, 0.25), (2.0 * i, 0.0, 0.0))), "head",
                           lambda p: p[0] + p[2])
        part.GetPointData().AddArray(array("material", [i] * part.GetNumberOfPoints(), vtk.vtkIntArray))
        tree.SetBlock(i, part)
    return tree


def a_collapse():
    """As of a forming star in waves of gas: each level is half as wide as the last, and values grow to 20,000."""
    def density(p):
        return 2 + math.sin(9 * p[0]) * math.cos(7 * p[1]) + (0.15 / radius(p))**2

    levels, cells = 7, 8
    mesh = vtk.vtkOverlappingAMR()
    mesh.Initialize(levels, [1] * levels)
    mesh.SetOrigin([0, 0, 0])
    mesh.SetGridDescription(vtk.VTK_XYZ_GRID)
    for level in range(levels):
        width, low = 2**-level / cells, cells // 2 * (2**level - 1)
        block = vtk.vtkUniformGrid()
        block.SetDimensions([cells + 1] * 3)
        block.SetOrigin([low * width] * 3)
        block.SetSpacing([width] * 3)
        centers = ([(low + n // cells**k % cells + 0.5) * width - 0.5 for k in range(3)] for n in range(cells**3))
        block.GetCellData().AddArray(array("density", [density(p) for p in centers]))
        mesh.SetSpacing(level, [width] * 3)
        mesh.SetAMRBox(level, 0, vtk.vtkAMRBox([low] * 3, [low + cells - 1] * 3))
        mesh.SetDataSet(level, 0, block)
    vtk.vtkAMRUtilities.BlankCells(mesh)
    return mesh


def one_tetrahedron():
    grid = vtk.vtkUnstructuredGrid()
    points = vtk.vtkPoints()
    for point in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)):
        points.InsertNextPoint(point)
    grid.SetPoints(points)
    grid.InsertNextCell(vtk.VTK_TETRA, 4, (0, 1, 2, 3))
    return with_points(grid, "z", lambda p: p[2])


ALL = (flow, scan, hexahedra_with_cell_scalars, quadratic_cells, thin_plate, values_over_many_sizes, constant,
       far_and_small, outliers, with_nan, vectors, integers_with_air, rectilinear, curvilinear, blocks,
       a_collapse, one_tetrahedron)
