# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Curved cells by linear pieces, by our tolerances and by VTK's: measure_curved.py FOLDER [--cells N] [--frames N]

A quarter of a ring in N x N x N VTK_QUADRATIC_HEXAHEDRON (6), which bend in two ways. It is drawn by linear pieces
between their points, and cut by vtkTetMarchTessellator and by vtkTessellatorFilter (the same error of the shape and of
the scalars, its points merged). It writes FOLDER/curved.md: tetrahedra, seconds to cut and to draw (of a first frame and
of another), and the difference from the picture for a tolerance of a fourth of the smallest one.
"""
import time

import numpy as np
import vtkmodules.all as vtk
from measure_pixels import picture_of
from measured_page import grid_options, row
from time_frames import ENOUGH_FOR_ONE_DRAW, Frames, functions_of_waves, median_seconds
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtktetmarch import vtkTetMarchTessellator, vtkTetMarchVolumeMapper

TOLERANCES = (1.6e-2, 4e-3, 1e-3)  # of the diagonal, and of the range of the scalars
TRUE = TOLERANCES[-1] / 4
# In steps of half a cell: the corners, then the middles of the edges, in the order of VTK.
NODES = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2),
         (1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
         (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)]


def ring(cells):
    """The grid, with "waves" at its points, 0..1."""
    side = 2 * cells + 1
    radius, angle, height = (place.ravel() for place in np.meshgrid(*[np.linspace(0, 1, side)] * 3, indexing="ij"))
    turn = angle * np.pi / 2
    away = 1 + radius
    points = np.stack([away * np.cos(turn), away * np.sin(turn), 2 * height + 0.2 * away * np.sin(3 * turn)], axis=1)
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(vtk.vtkPoints())
    grid.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    for i, j, k in np.ndindex(cells, cells, cells):
        ids = [((2 * i + a) * side + 2 * j + b) * side + 2 * k + c for a, b, c in NODES]
        grid.InsertNextCell(vtk.VTK_QUADRATIC_HEXAHEDRON, len(ids), ids)
    values = numpy_to_vtk(0.5 + 0.25 * (np.sin(9 * away) + np.cos(6 * height + 2 * turn)), deep=True)
    values.SetName("waves")
    grid.GetPointData().SetScalars(values)
    return grid


def cut_by_us(grid, tolerance):
    cut = vtkTetMarchTessellator()
    cut.SetInputData(grid)
    cut.SetGeometryTolerance(tolerance)
    cut.SetScalarTolerance(tolerance)
    return cut


def cut_by_vtk(grid, tolerance):
    cut = vtk.vtkTessellatorFilter()
    cut.SetInputData(grid)
    cut.SetOutputDimension(3)
    cut.SetChordError(tolerance * grid.GetLength())
    low, high = grid.GetPointData().GetScalars().GetRange()
    cut.SetFieldCriterion(0, tolerance * (high - low))
    cut.SetMaximumNumberOfSubdivisions(8)
    cut.MergePointsOn()
    return cut


class CurvedFrames(Frames):
    def __init__(self, grid, cut, size):
        self.cutting = 0.0
        if cut:
            begin = time.perf_counter()
            cut.Update()
            self.cutting = time.perf_counter() - begin
            grid = cut.GetOutput()
        begin = time.perf_counter()
        mapper = vtkTetMarchVolumeMapper()
        mapper.SetInputData(grid)
        mapper.SetMaxDrawTimeInSeconds(ENOUGH_FOR_ONE_DRAW)
        self.show(mapper, size)
        self.use_functions(*functions_of_waves(), 0.5)
        self.camera.SetFocalPoint(1, 1, 1)
        self.camera.SetPosition(4.5, -2.5, 4)
        self.camera.SetViewUp(0, 0, 1)
        self.renderer.ResetCamera()
        self.first_position = self.camera.GetPosition()
        self.seconds(0)
        self.first = time.perf_counter() - begin
        self.tetrahedra = mapper.GetNumberOfTetrahedra()


def measure(cells, size, rounds):
    grid = ring(cells)
    reference = picture_of(CurvedFrames(grid, cut_by_us(grid, TRUE), size).window)
    ways = {"linear pieces between the points": None}
    for tolerance in TOLERANCES:
        ways[f"vtkTetMarchTessellator, {tolerance:g}"] = cut_by_us(grid, tolerance)
        ways[f"vtkTessellatorFilter, {tolerance:g}"] = cut_by_vtk(grid, tolerance)
    frames = {name: CurvedFrames(grid, cut, size) for name, cut in ways.items()}
    medians = median_seconds(frames, rounds)
    text = row(["cut by", "tetrahedra", "cutting, s", "first frame, s", "frame, s", "RMS", "greatest"])
    text += "|---|" + "---:|" * 6 + "\n"
    for name, each in frames.items():
        each.seconds(0)
        apart = np.abs(picture_of(each.window) - reference)
        text += row([name, f"{each.tetrahedra:,}", f"{each.cutting:.2f}", f"{each.first:.2f}",
                     f"{medians[name]:.3f}", f"{np.sqrt((apart**2).mean()):.1e}", f"{apart.max():.3f}"])
    return f"{cells**3} cells\n\n{text}"


def main():
    options = grid_options(__doc__, "--cells", 6, frames=5)
    text = measure(options.cells, options.size, options.frames)
    (options.folder / "curved.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
