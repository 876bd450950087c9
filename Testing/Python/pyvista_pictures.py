# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista's examples of volumes, drawn by PyVista's mappers and by ours.

As a script, prints a table of the time and the error of both: pyvista_pictures.py [FOLDER], which gets the pictures,
PyVista's on the left.
"""
import math
import pathlib
import statistics
import sys
import time

import numpy as np
import pyvista
from pyvista import examples

import vtktetmarch.pyvista
from vtktetmarch.pixels import write_png

SIZE = (160, 120)
REPEATED = 6


def tetrahedra():
    grid = examples.load_tetbeam()
    grid.point_data["wave"] = np.sin(grid.points[:, 2]) + grid.points[:, 0]
    return grid


def explicit():
    grid = examples.load_explicit_structured()
    grid.cell_data["number"] = np.arange(grid.n_cells, dtype=float)
    return grid


def curvilinear():
    angle, radius, height = np.meshgrid(np.linspace(0, math.pi, 40), np.linspace(1, 2, 16), np.linspace(0, 1, 12),
                                        indexing="ij")
    grid = pyvista.StructuredGrid(radius * np.cos(angle), radius * np.sin(angle), height)
    grid.point_data["wave"] = np.sin(3 * grid.points[:, 0]) + grid.points[:, 1] * grid.points[:, 2]
    return grid


def noise():
    return pyvista.sample_function(pyvista.perlin_noise(1, (1, 3, 5), (0, 0, 0)), bounds=(0, 3, 0, 1, 0, 1),
                                   dim=(60, 40, 40))


# Name: data, arguments of add_volume().
EXAMPLES = {
    "uniform, points": (examples.load_uniform, {"scalars": "Spatial Point Data"}),
    "uniform, cells": (examples.load_uniform, {"scalars": "Spatial Cell Data"}),
    "rectilinear, cells": (examples.load_rectilinear, {"opacity": [0.0, 0.0, 0.3]}),
    "wavelet, points": (pyvista.Wavelet, {"opacity": "sigmoid_6"}),
    "Perlin noise, points": (noise, {"opacity": [0, 0, 0.5, 0, 0, 0.5, 0]}),
    "hexahedra, points": (examples.load_hexbeam, {"scalars": "sample_point_scalars"}),
    "hexahedra, cells": (examples.load_hexbeam, {"scalars": "sample_cell_scalars"}),
    "tetrahedra, points": (tetrahedra, {"cmap": "magma", "opacity": "sigmoid_5"}),
    "explicit structured, cells": (explicit, {}),
    "curvilinear, points": (curvilinear, {"opacity": "sigmoid_8"}),
}
LARGE = {"channels, cells": (examples.load_channels, {"opacity": [0, 0.2, 0.2, 0.2, 0.2]}),
         "frog tissues, points": (examples.load_frog_tissues, {"opacity": "foreground"})}


class View:
    """A plotter with one volume. Linear interpolation, unless linear=False: PyVista's default is nearest."""

    def __init__(self, data, size=SIZE, linear=True, theme=None, **arguments):
        start = time.perf_counter()
        self.size = size
        self.plotter = pyvista.Plotter(off_screen=True, window_size=size, theme=theme)
        self.plotter.background_color = "black"
        self.actor = self.plotter.add_volume(data, **{"show_scalar_bar": False, **arguments})
        (self.volume,) = self.actor if isinstance(self.actor, list) else (self.actor,)
        self.mapper = self.volume.mapper
        if linear:
            self.volume.prop.interpolation_type = "linear"
        camera = self.plotter.camera
        self.plotter.camera_position = "iso"
        camera.azimuth, camera.elevation = 13, 9  # no ray of the middle along an edge, where VTK's caster fails
        self.plotter.reset_camera()
        camera.zoom(1.3)
        self.plotter.show(auto_close=False)
        self.first_seconds = time.perf_counter() - start

    def pixels(self):
        """(height, width, 3) of int, 0 to 255."""
        self.plotter.render()
        return self.plotter.screenshot(return_img=True)[..., :3].astype(int)

    def seconds(self):
        """Of a frame and reading its pixels, as the camera moves: the median of some."""
        found = []
        for i in range(REPEATED):
            self.plotter.camera.azimuth += (-1) ** i
            start = time.perf_counter()
            self.plotter.render()
            self.plotter.screenshot(return_img=True)
            found.append(time.perf_counter() - start)
        return statistics.median(found)

    def compare(self):
        """Of our mapper: see vtktetmarch.compare()."""
        return vtktetmarch.compare(self.volume, camera=self.plotter.camera, size=self.size, background=(0, 0, 0))

    def close(self):
        self.plotter.close()


def inside(first, second):
    """Pixels that either picture covers."""
    return (first.max(axis=2) > 0) | (second.max(axis=2) > 0)


def mean_difference(first, second):
    """Over those pixels and the channels, in units of 1/255."""
    return np.abs(first - second)[inside(first, second)].mean()


def rms(first, second):
    """Over those pixels, of the channel that differs most, 0 to 1."""
    return math.sqrt((np.abs(first - second)[inside(first, second)].max(axis=1) ** 2).mean()) / 255


def row(name, data, arguments, size, folder):
    """A row of the table. Both paths have the same unit distance; the truth is our picture of the exact data."""
    ours = View(data, size, False, mapper="tetmarch", **arguments)
    distance = ours.volume.prop.opacity_unit_distance
    times = ours.first_seconds, ours.seconds()
    error = ours.compare()["rms"]
    picture = ours.pixels()
    vtktetmarch.configure(ours.volume, accuracy_level="reference")
    truth = ours.pixels()
    ours.close()
    theirs = View(data, size, False, opacity_unit_distance=distance, **arguments)
    their_times, their_picture = (theirs.first_seconds, theirs.seconds()), theirs.pixels()
    theirs.close()
    if folder is not None:
        image = np.hstack((their_picture, picture)).astype(np.uint8)
        write_png(image, folder / f"{name.replace(', ', '_').replace(' ', '_')}.png")
    return (f"| {name} | {their_times[0]:.2f} | {their_times[1]:.3f} | {rms(their_picture, truth):.4f} | "
            f"{times[0]:.2f} | {times[1]:.3f} | {error:.5f} |")


def main(folder=None, size=(400, 300)):
    print("| example | PyVista: first picture, s | frame, s | RMS error | TetMarch: first picture, s | frame, s "
          "| RMS error |")
    print("|---|---|---|---|---|---|---|")
    for name, (make, arguments) in {**EXAMPLES, **LARGE}.items():
        print(row(name, make(), arguments, size, folder), flush=True)


if __name__ == "__main__":
    main(*map(pathlib.Path, sys.argv[1:2]))
