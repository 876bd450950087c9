# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws frames of a dataset with the vtktetmarch that Python finds: time_frames.py DATASET plain|lit|inside WIDTHxHEIGHT

compare_times.py runs this for each build. It prints "ready", then for each line of its input, the number of a view, the
seconds that a frame of that view took. Light is that of one light source of the scene, with shadows at vertices. From
inside, the camera stays and turns.
"""
import json
import pathlib
import statistics
import sys
import time

import made_grids as grids
import vtkmodules.all as vtk
from vtktetmarch import vtkTetMarchVolumeMapper

DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"
# As of tetmarch-bench: oblique, so that no face of a lattice is seen edge on.
VIEW_DIRECTION = (0.5, -1.0, 0.45)
DEGREES_PER_VIEW = 7.0
INSIDE = (0.43, 0.52, 0.47)  # as shares of the sides of the box
TOWARDS_LIGHT = (0.4, -0.7, 0.6)
DATASETS = ("golfball", "lattice1.3m", "holes")
LATTICES = {"lattice1.3k": 6, "lattice162k": 30, "lattice1.3m": 60}  # cubes along an edge
# Seconds. Without a limit on draws, they are the same in each frame.
ENOUGH_FOR_ONE_DRAW = 1e6


def read_golfball():
    """The grid, its array and the transfer functions of the demo."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(DATA / "golfball_small.vtu"))
    reader.Update()
    preset = json.loads((DATA / "golfball_wake.json").read_text())[0]
    colors, opacities = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
    colors.SetColorSpaceToLab()
    for i in range(0, len(preset["RGBPoints"]), 4):
        colors.AddRGBPoint(*preset["RGBPoints"][i:i + 4])
    for i in range(0, len(preset["Points"]), 4):
        opacities.AddPoint(*preset["Points"][i:i + 4])
    return reader.GetOutput(), "vorticity_mag", colors, opacities, 0.02


def functions_of_waves():
    """Colours and opacities that let a quarter of the light through, so that no ray ends early."""
    colors, opacities = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
    for scalar, *rgb in ((0.0, 0.1, 0.2, 0.8), (0.5, 0.9, 0.9, 0.9), (1.0, 0.8, 0.1, 0.1)):
        colors.AddRGBPoint(scalar, *rgb)
    for scalar, opacity in ((0.0, 0.6), (0.3, 0.1), (0.5, 0.4), (0.7, 0.1), (1.0, 0.8)):
        opacities.AddPoint(scalar, opacity)
    return colors, opacities


def make_lattice(cubes, keep=None):
    grid = grids.lattice(cubes, keep)
    grids.add_array(grid.GetPointData(), "waves", grids.waves(grids.points_of(grid), 2.5))
    return grid, "waves", *functions_of_waves(), 0.25


def make_dataset(name):
    if name == "golfball":
        return read_golfball()
    return make_lattice(LATTICES[name]) if name in LATTICES else make_lattice(36, grids.outside_many_holes)


class Frames:
    turns_inside = False

    def __init__(self, dataset, scene, size):
        grid, array, colors, opacities, unit_distance = make_dataset(dataset)
        mapper = vtkTetMarchVolumeMapper()
        mapper.SetInputData(grid)
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectScalarArray(array)
        mapper.SetMaxDrawTimeInSeconds(ENOUGH_FOR_ONE_DRAW)
        self.show(mapper, size)
        self.use_functions(colors, opacities, unit_distance)
        self.camera.SetFocalPoint(0, 0, 0)
        self.camera.SetPosition(*VIEW_DIRECTION)
        self.camera.SetViewUp(0, 0, 1)
        self.renderer.ResetCamera()
        self.first_position = self.camera.GetPosition()
        if scene == "lit":
            self.add_light(grid)
            mapper.SetShadowMethodToAtVertices()
        elif scene == "inside":
            self.go_inside(grid)

    def show(self, mapper, size):
        self.volume = vtk.vtkVolume()
        self.volume.SetMapper(mapper)
        self.renderer = vtk.vtkRenderer()
        self.renderer.AddVolume(self.volume)
        self.camera = self.renderer.GetActiveCamera()
        self.window = vtk.vtkRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.OffScreenRenderingOn()
        self.window.SetSize(*size)
        self.window.AddRenderer(self.renderer)

    def use_functions(self, colors, opacities, unit_distance):
        volume_property = self.volume.GetProperty()
        volume_property.SetColor(colors)
        volume_property.SetScalarOpacity(opacities)
        volume_property.SetScalarOpacityUnitDistance(unit_distance)

    def add_light(self, grid):
        center, diagonal = grid.GetCenter(), grid.GetLength()
        light = vtk.vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(*(c + diagonal * d for c, d in zip(center, TOWARDS_LIGHT)))
        light.SetFocalPoint(*center)
        self.renderer.AddLight(light)
        volume_property = self.volume.GetProperty()
        volume_property.ShadeOn()
        volume_property.SetAmbient(0.3)
        volume_property.SetDiffuse(0.7)
        volume_property.SetSpecular(0.3)
        volume_property.SetSpecularPower(20.0)

    def go_inside(self, grid):
        """Into the grid, but for holes in the middle of the datasets."""
        bounds = grid.GetBounds()
        self.first_position = [bounds[2 * k] + share * (bounds[2 * k + 1] - bounds[2 * k])
                               for k, share in enumerate(INSIDE)]
        self.camera.SetViewAngle(60.0)
        self.turns_inside = True

    def seconds(self, view):
        """From the call of Render() until the GL has finished."""
        self.camera.SetPosition(self.first_position)
        if self.turns_inside:
            self.camera.SetFocalPoint([p - d for p, d in zip(self.first_position, VIEW_DIRECTION)])
            self.camera.Yaw(DEGREES_PER_VIEW * view)
        else:
            self.camera.Azimuth(DEGREES_PER_VIEW * view)
        self.renderer.ResetCameraClippingRange()
        begin = time.perf_counter()
        self.window.Render()
        self.window.WaitForCompletion()
        return time.perf_counter() - begin


def median_seconds(frames, rounds):
    """Of a frame of each of these (Frames by name), drawn by turns."""
    seconds = {name: [] for name in frames}
    for _ in range(rounds):
        for name, each in frames.items():
            each.seconds(0)
            seconds[name].append(each.seconds(1))
    return {name: statistics.median(taken) for name, taken in seconds.items()}


def main():
    dataset, scene, size = sys.argv[1:]
    frames = Frames(dataset, scene, [int(n) for n in size.split("x")])
    print("ready", flush=True)
    for line in sys.stdin:
        print(frames.seconds(int(line)), flush=True)


if __name__ == "__main__":
    main()
