# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A curvilinear grid beside other ways to draw it: measure_grids.py FOLDER [--cubes N ...] [--size WxH] [--frames N]

Draws a bent box, and a spherical shell with both poles, of N x N x N hexahedra by turns: with computed cells, as an
unstructured grid, as tetrahedra by vtkProjectedTetrahedraMapper, and resampled to 128^3 points, as ParaView does. It
writes FOLDER/grids.md: seconds to prepare and of a frame, bytes of the mapper on the GPU, and the difference from the
picture of stored cells.
"""
import time

import made_grids as grids
import numpy as np
import vtkmodules.all as vtk
from measure_pixels import picture_of
from measured_page import grid_options, row
from time_frames import ENOUGH_FOR_ONE_DRAW, Frames, functions_of_waves, median_seconds
from vtktetmarch import vtkTetMarchVolumeMapper

RESAMPLED = 128


def bent_box(x, y, z):
    return x + 0.1 * np.sin(5 * y), y + 0.1 * z * z, z


def shell(x, y, z):
    radius, longitude, colatitude = 0.3 + 0.3 * x, 2 * np.pi * y, np.pi * z
    ring = radius * np.sin(colatitude)
    return ring * np.cos(longitude), ring * np.sin(longitude), radius * np.cos(colatitude)


SHAPES = {"box": bent_box, "shell": shell}


def curvilinear(shape, cubes):
    places = np.stack(shape(*grids.lattice_points(cubes, 0.0, 1).T), axis=1)
    grid = grids.curvilinear(places, cubes)
    grids.add_array(grid.GetPointData(), "waves", grids.waves(places, 2.5))
    grid.GetPointData().SetActiveScalars("waves")
    return grid


def result_of(algorithm, grid):
    algorithm.SetInputDataObject(grid)
    algorithm.Update()
    return algorithm.GetOutput()


def tetmarch(data):
    mapper = vtkTetMarchVolumeMapper()
    mapper.SetInputDataObject(data)
    mapper.SetMaxDrawTimeInSeconds(ENOUGH_FOR_ONE_DRAW)
    mapper.AutoAdjustSampleDistancesOff()
    return mapper


def projected(grid):
    mapper = vtk.vtkProjectedTetrahedraMapper()
    mapper.SetInputData(result_of(vtk.vtkDataSetTriangleFilter(), grid))
    return mapper


def resampled(grid):
    to_image = vtk.vtkResampleToImage()
    to_image.SetSamplingDimensions(RESAMPLED, RESAMPLED, RESAMPLED)
    mapper = vtk.vtkOpenGLGPUVolumeRayCastMapper()
    mapper.SetInputData(result_of(to_image, grid))
    mapper.SetAutoAdjustSampleDistances(False)
    mapper.SetSampleDistance(grid.GetLength() / RESAMPLED)
    return mapper


WAYS = {
    "TetMarch, computed cells": tetmarch,
    "TetMarch, stored cells": lambda grid: tetmarch(result_of(vtk.vtkAppendFilter(), grid)),
    "projected tetrahedra": projected,
    f"resampled to {RESAMPLED}^3": resampled,
}


class GridFrames(Frames):
    def __init__(self, grid, make, size):
        begin = time.perf_counter()
        mapper = make(grid)
        self.converted = time.perf_counter() - begin
        self.show(mapper, size)
        colors, opacities = functions_of_waves()
        self.use_functions(colors, opacities, 0.25)
        self.volume.GetProperty().SetInterpolationTypeToLinear()
        self.camera.SetFocalPoint(*grid.GetCenter())
        self.camera.SetPosition(*(c + 2.2 * d for c, d in zip(grid.GetCenter(), (0.5, -1.0, 0.45))))
        self.camera.SetViewUp(0, 0, 1)
        self.first_position = self.camera.GetPosition()
        # Converting the grid and preparing it, without a frame.
        self.prepared = self.converted + self.seconds(0)


def measure(shape, cubes, size, rounds):
    grid = curvilinear(SHAPES[shape], cubes)
    frames = {name: GridFrames(grid, make, size) for name, make in WAYS.items()}
    medians = median_seconds(frames, rounds)
    reference = picture_of(frames["TetMarch, stored cells"].window)
    text = ""
    for name, each in frames.items():
        mapper = each.volume.GetMapper()
        ours = isinstance(mapper, vtkTetMarchVolumeMapper)
        memory = mapper.GetLastFrameStatistics().GetGPUMemoryBytes() / cubes**3 if ours else None
        difference = np.sqrt(((picture_of(each.window) - reference)**2).mean())
        text += row([f"{shape}, {cubes}^3", name, f"{each.prepared:.2f}", f"{medians[name]:.4f}",
                     f"{medians[name] / medians['TetMarch, computed cells']:.2f}",
                     f"{memory:.1f}" if ours else "", f"{difference:.1e}"])
    return text


def main():
    options = grid_options(__doc__, "--cubes", [30, 60, 120], nargs="+")
    text = row(["hexahedra", "drawn by", "first frame, s", "frame, s", "relative", "bytes a hexahedron", "RMS"])
    text += "|---|---|" + "---:|" * 5 + "\n"
    for shape in SHAPES:
        for cubes in options.cubes:
            text += measure(shape, cubes, options.size, options.frames)
    (options.folder / "grids.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
