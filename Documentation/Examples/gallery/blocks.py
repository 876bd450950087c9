# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Blocks: a coiled duct in seven parts, curvilinear and of tetrahedra in turn, is drawn without seams."""
import numpy as np
import vtktetmarch
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkStructuredGrid
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersCore import vtkStructuredGridOutlineFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

duct, outlines = vtkMultiBlockDataSet(), [vtkActor() for _ in range(7)]
for part in range(7):
    along, v, u = np.meshgrid(np.linspace(part, part + 1, 20), *[np.linspace(-1, 1, 17)] * 2, indexing="ij")
    angle = along * 4 * np.pi / 7
    points = np.stack([(3 + 0.8 * u) * np.cos(angle), (3 + 0.8 * u) * np.sin(angle), 0.36 * angle + 0.8 * v], axis=-1)
    swirl = u * np.cos(2 * angle) + v * np.sin(2 * angle)
    grid = vtkStructuredGrid()
    grid.SetDimensions(17, 17, 20)
    grid.SetPoints(vtkPoints())
    grid.GetPoints().SetData(numpy_to_vtk(points.reshape(-1, 3), deep=True))
    values = numpy_to_vtk((swirl * (1 - u**2) * (1 - v**2)).ravel(), deep=True)
    values.SetName("helicity")
    grid.GetPointData().SetScalars(values)
    outline = vtkStructuredGridOutlineFilter()
    outline.SetInputData(grid)
    outlines[part].SetMapper(vtkPolyDataMapper())
    outlines[part].GetMapper().SetInputConnection(outline.GetOutputPort())
    outlines[part].GetProperty().SetColor(0.55, 0.6, 0.7)
    tetrahedra = vtkDataSetTriangleFilter()
    tetrahedra.SetInputData(grid)
    tetrahedra.Update()
    duct.SetBlock(part, tetrahedra.GetOutput() if part % 2 else grid)

figure = vtktetmarch.figure(
    duct, "helicity", range=(-0.4, 0.4), cmap=["#2bd4ff", "#2456d6", "#141a30", "#d6303c", "#ffb347"],
    opacity=[(-0.4, 1), (-0.1, 0.05), (0, 0), (0.1, 0.05), (0.4, 1)], unit_distance=0.5, size=(480, 360),
    background="#0a0b10", camera={"elevation": 15, "zoom": 0.93})
figure.add(*outlines).save("blocks.png")
