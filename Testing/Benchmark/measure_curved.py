# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the accuracy of curved cells costs: measure_curved.py FOLDER [--cells N] [--frames N]

A quarter of a ring in N x N x N VTK_QUADRATIC_HEXAHEDRON (6), which bend in two ways, drawn by linear pieces between
their points, within tolerances of the mapper, also with points of each cell's own, and cut by vtkTessellatorFilter:
within the same tolerances (its points merged), and evenly, as often as ParaView's Nonlinear Subdivision Level says (0
to 4). It writes FOLDER/curved.md and curved.png: tetrahedra, bytes on the GPU, seconds of the first frame, with
cutting, and of another, the difference from the picture for a tolerance of a fourth of the smallest one, and the mean
error bound where the mapper cuts cells.
"""
import time

import numpy as np
import vtkmodules.all as vtk
from accuracy_charts import add_legend, plt, save
from measure_pixels import picture_of
from measured_page import grid_options, row
from time_frames import ENOUGH_FOR_ONE_DRAW, Frames, functions_of_waves, median_seconds
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtktetmarch import vtkTetMarchFrameStatistics, vtkTetMarchVolumeMapper

TOLERANCES = (1.6e-2, 4e-3, 1e-3)  # of the diagonal, and of the range of the scalars
TRUE = TOLERANCES[-1] / 4
LEVELS = range(5)
LINEAR = "linear pieces between the points"
OURS, VTKS, EVEN = "GeometryTolerance", "vtkTessellatorFilter, error", "vtkTessellatorFilter, subdivisions"
OWN = "the same, each cell with points of its own,"
STYLES = {LINEAR: ("#7f7f7f", "D"), OURS: ("#d62728", "o"), OWN: ("#ff7f0e", "x"), VTKS: ("#1f77b4", "s"),
          EVEN: ("#2ca02c", "^")}
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


def with_own_points(grid):
    """As deal.II and MFEM write cells."""
    ids = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    separate = vtk.vtkUnstructuredGrid()
    separate.SetPoints(vtk.vtkPoints())
    separate.GetPoints().SetData(numpy_to_vtk(vtk_to_numpy(grid.GetPoints().GetData())[ids], deep=True))
    for cell in range(grid.GetNumberOfCells()):
        separate.InsertNextCell(vtk.VTK_QUADRATIC_HEXAHEDRON, len(NODES),
                                range(len(NODES) * cell, len(NODES) * (cell + 1)))
    values = numpy_to_vtk(vtk_to_numpy(grid.GetPointData().GetScalars())[ids], deep=True)
    values.SetName("waves")
    separate.GetPointData().SetScalars(values)
    return separate


def cut_by_vtk(grid, tolerance, most):
    cut = vtk.vtkTessellatorFilter()
    cut.SetInputData(grid)
    cut.SetOutputDimension(3)
    cut.SetChordError(tolerance * grid.GetLength())
    low, high = grid.GetPointData().GetScalars().GetRange()
    cut.SetFieldCriterion(0, tolerance * (high - low))
    cut.SetMaximumNumberOfSubdivisions(most)
    cut.MergePointsOn()
    return cut


class CurvedFrames(Frames):
    def __init__(self, grid, size, tolerance=0.0, cut=None):
        begin = time.perf_counter()
        mapper = vtkTetMarchVolumeMapper()
        mapper.SetMaxDrawTimeInSeconds(ENOUGH_FOR_ONE_DRAW)
        mapper.SetGeometryTolerance(tolerance)
        if cut:
            mapper.SetInputConnection(cut.GetOutputPort())
        else:
            mapper.SetInputData(grid)
        self.show(mapper, size)
        self.use_functions(*functions_of_waves(), 0.5)
        self.camera.SetFocalPoint(1, 1, 1)
        self.camera.SetPosition(4.5, -2.5, 4)
        self.camera.SetViewUp(0, 0, 1)
        # The box of the whole ring, whatever cuts it.
        self.renderer.ResetCamera(0, 2, 0, 2, -0.4, 2.4)
        self.first_position = self.camera.GetPosition()
        self.seconds(0)
        self.first = time.perf_counter() - begin
        self.tetrahedra = mapper.GetNumberOfTetrahedra()
        self.bytes = mapper.GetGPUMemoryBytes()


def ways_of(grid, size):
    """{(family, what of it): Frames}."""
    ways = {(LINEAR, ""): CurvedFrames(grid, size)}
    for tolerance in TOLERANCES:
        ways[OURS, f"{tolerance:g}"] = CurvedFrames(grid, size, tolerance)
        ways[OWN, f"{tolerance:g}"] = CurvedFrames(with_own_points(grid), size, tolerance)
        ways[VTKS, f"{tolerance:g}"] = CurvedFrames(grid, size, cut=cut_by_vtk(grid, tolerance, 8))
    for level in LEVELS:
        ways[EVEN, f"{level}"] = CurvedFrames(grid, size, cut=cut_by_vtk(grid, 1e-9, level))
    return ways


def mean_bound(frames):
    """Of the pixels that rays reach. Cells are cut again, since their departure is measured."""
    mapper = frames.volume.GetMapper()
    mapper.CollectDiagnosticsOn()
    frames.seconds(0)
    return mapper.GetLastFrameStatistics().GetMean(vtkTetMarchFrameStatistics.ERROR_BOUND)


def measure(cells, size, rounds):
    """Of each way: tetrahedra, bytes, seconds of the first frame and of another, RMS and greatest error, mean bound."""
    grid = ring(cells)
    reference = picture_of(CurvedFrames(grid, size, TRUE).window)
    ways = ways_of(grid, size)
    medians = median_seconds(ways, rounds)
    found = {}
    for name, each in ways.items():
        each.seconds(0)
        apart = np.abs(picture_of(each.window) - reference)
        bound = mean_bound(each) if name[0] in (OURS, OWN) else None
        found[name] = (each.tetrahedra, each.bytes, each.first, medians[name], np.sqrt((apart**2).mean()), apart.max(),
                       bound)
    return found


def table_of(found):
    text = row(["cut by", "tetrahedra", "GPU, MB", "first frame, s", "frame, s", "RMS", "greatest", "mean bound"])
    text += "|---|" + "---:|" * 7 + "\n"
    for (family, which), (tetrahedra, size, first, frame, rms, greatest, bound) in found.items():
        text += row([f"{family} {which}".strip(), f"{tetrahedra:,}", f"{size / 1e6:.1f}", f"{first:.2f}",
                     f"{frame:.3f}", f"{rms:.1e}", f"{greatest:.3f}", f"{bound:.2f}" if bound is not None else ""])
    return text


def draw(found, folder):
    figure, both = plt.subplots(1, 2, figsize=(8.5, 3.6), sharey=True)
    for axes, column, label in zip(both, (2, 1), ("first frame, s", "bytes on the GPU")):
        for family, (color, marker) in STYLES.items():
            points = [(values[column], values[4]) for (of, _), values in found.items() if of == family]
            axes.plot(*zip(*points), label=family.rstrip(","), color=color, marker=marker)
        axes.set(xscale="log", yscale="log", xlabel=label)
    both[0].set_ylabel("RMS error")
    add_legend(figure, both[0], 2)
    figure.tight_layout()
    save(figure, folder, "curved")


def main():
    options = grid_options(__doc__, "--cells", 6, frames=5)
    found = measure(options.cells, options.size, options.frames)
    text = f"{options.cells**3} cells\n\n{table_of(found)}"
    (options.folder / "curved.md").write_text(text)
    draw(found, options.folder)
    print(text)


if __name__ == "__main__":
    main()
