# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws scenes of which each process has a piece: mpiexec -n N draw_pieces.py OUT.npz [SCENE...]

Process 0 writes two pictures of each scene, 8-bit red, green, blue and opacity, and the figures of all processes.
"""
import json
import sys

import numpy as np
import vtkmodules.all as vtk
from mpi4py import MPI  # noqa: F401, which begins MPI, and ends it
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkParallelMPI import vtkMPIController

import made_grids
import partitions
from vtktetmarch import vtkTetMarchVolumeMapper

SIZE = (160, 120)
CUBES = 9
SCALARS = "field"
FIGURES = ("NumberOfTetrahedra", "NumberOfVisits", "SentBytes", "MarchSeconds", "ExchangeSeconds", "MergeSeconds",
           "SpreadSeconds", "SharedErrorBound")

Mapper = vtkTetMarchVolumeMapper
BLENDS = {"composite": Mapper.COMPOSITE_BLEND, "maximum": Mapper.MAXIMUM_INTENSITY_BLEND,
          "minimum": Mapper.MINIMUM_INTENSITY_BLEND, "average": Mapper.AVERAGE_INTENSITY_BLEND,
          "additive": Mapper.ADDITIVE_BLEND, "isosurface": Mapper.ISOSURFACE_BLEND}


def tetrahedra():
    grid = made_grids.lattice(CUBES, made_grids.outside_a_hole)
    set_waves(grid)
    return grid


def hexahedra():
    """Warped, so that it matters how their faces are cut."""
    points = vtk.vtkPoints()
    for z in range(CUBES + 1):
        for y in range(CUBES + 1):
            for x in range(CUBES + 1):
                place = np.array([x, y, z], dtype=float) / CUBES
                points.InsertNextPoint(place + 0.04 * np.sin(7 * place[[1, 2, 0]]))
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(points)
    row, layer = CUBES + 1, (CUBES + 1) ** 2
    for z in range(CUBES):
        for y in range(CUBES):
            for x in range(CUBES):
                a = x + row * y + layer * z
                cell = (a, a + 1, a + 1 + row, a + row)
                grid.InsertNextCell(vtk.VTK_HEXAHEDRON, 8, cell + tuple(i + layer for i in cell))
    set_waves(grid)
    return grid


def curvilinear_layers(grid, process, processes):
    """Those of hexahedra() that are a process's own, whose cells are computed from i, j, k."""
    layers = vtk.vtkExtractGrid()
    layers.SetInputData(made_grids.curvilinear(made_grids.points_of(grid), CUBES))
    layers.GetInput().GetPointData().AddArray(grid.GetPointData().GetArray(SCALARS))
    layers.SetVOI(0, CUBES, 0, CUBES, CUBES * process // processes, CUBES * (process + 1) // processes)
    layers.Update()
    return layers.GetOutput()


def with_own_points(grid, most):
    """Each cell has points of its own; from a plane on, scalars jump by up to `most` between cells."""
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    apart = made_grids.grid_of(made_grids.points_of(grid)[corners], np.arange(len(corners)).reshape(-1, 4))
    set_waves(apart)
    values = vtk_to_numpy(apart.GetPointData().GetArray(SCALARS))
    moves = most * (2 * np.random.RandomState(1).random_sample(len(values)) - 1)
    values[len(values) // 2:] += moves[len(values) // 2:]
    return apart


def set_waves(grid):
    made_grids.add_array(grid.GetPointData(), SCALARS, made_grids.waves(made_grids.points_of(grid), 1.0, 0))
    made_grids.add_array(grid.GetCellData(), "of_cells", made_grids.waves(made_grids.cell_centres_of(grid), 1.0, 0))


# name: what differs from a lattice of tetrahedra, its point scalars, composited.
SCENES = {
    "composite": {},
    "slabs": {"partition": "slabs"},
    "shells": {"partition": "shells"},
    "random": {"partition": "random_cells"},
    "metis": {"partition": "metis"},
    "last": {"partition": "only_last"},
    "ghosts": {"ghosts": True},
    "random_ghosts": {"partition": "random_cells", "ghosts": True},
    "hexahedra": {"grid": hexahedra},
    "random_hexahedra": {"grid": hexahedra, "partition": "random_cells"},
    "curvilinear": {"grid": hexahedra, "layers": curvilinear_layers},
    "own_points": {"grid": lambda: with_own_points(tetrahedra(), 0.0), "partition": "random_cells"},
    "jumps": {"grid": lambda: with_own_points(tetrahedra(), 0.2), "partition": "random_cells"},
    "jumps_isosurface": {"grid": lambda: with_own_points(tetrahedra(), 0.2), "blend": "isosurface"},
    "maximum": {"blend": "maximum"},
    "minimum": {"blend": "minimum", "partition": "random_cells"},
    "average": {"blend": "average"},
    "additive": {"blend": "additive"},
    "isosurface": {"blend": "isosurface"},
    "isosurface_random": {"blend": "isosurface", "partition": "random_cells"},
    "cells": {"scalars": "of_cells"},
    "nan": {"nan": True},
    "hidden": {"hidden": True},
    "hidden_ghosts": {"hidden": True, "ghosts": True},
    "components": {"components": True},
    "inside": {"camera": "inside"},
    "inside_ghosts": {"camera": "inside", "ghosts": True, "partition": "random_cells"},
    "parallel": {"camera": "parallel"},
    "transparent": {"transparent": True},
    "opaque": {"ball": True},
    "clipped": {"clipped": True},
    "cropped": {"cropped": True},
    "shaded": {"shaded": True},
    "shaded_cells": {"shaded": True, "scalars": "of_cells"},
    "gradient_opacity": {"gradient_opacity": True, "partition": "random_cells"},
    "accurate": {"level": "Accurate"},
    "fast": {"level": "Fast"},
    "coarse": {"distance": 2.0},
    "blocks": {"blocks": True},
    "shadows": {"shaded": True, "shadows": True, "partition": "slabs"},
    "behind_crust": {"partition": "crust", "dense": True},
    "behind_crust_turned": {"partition": "crust", "dense": True, "turn": 15.0},
    "dense_random": {"partition": "random_cells", "dense": True},
    "dense_random_turned": {"partition": "random_cells", "dense": True, "turn": 15.0},
    "dense_bands": {"partition": "random_cells", "dense": True, "visit_bytes": 20000},
    "bands": {"partition": "random_cells", "visit_bytes": 100000},
}


def change_scalars(grid, scene):
    if scene.get("nan"):
        values = vtk_to_numpy(grid.GetPointData().GetArray(SCALARS))
        values[::37] = np.nan
    if scene.get("hidden"):
        marks = np.where(np.arange(grid.GetNumberOfCells()) % 7 == 0, 32, 0).astype(np.uint8)  # HIDDENCELL
        made_grids.add_array(grid.GetCellData(), partitions.GHOSTS, marks)
    if scene.get("components"):
        places = made_grids.points_of(grid)
        values = np.stack([made_grids.waves(places, 0.8 + 0.2 * k, k) for k in range(3)], axis=1)
        grid.GetPointData().RemoveArray(SCALARS)
        made_grids.add_array(grid.GetPointData(), SCALARS, values)


def grab(window):
    """What the window shows: an array of shape height, width, 4."""
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.SetInputBufferTypeToRGBA()
    image.ReadFrontBufferOff()
    image.ShouldRerenderOff()
    image.Update()
    width, height, _ = image.GetOutput().GetDimensions()
    return vtk_to_numpy(image.GetOutput().GetPointData().GetScalars()).reshape(height, width, 4).copy()


class Picture:
    def __init__(self, scene, controller):
        self.controller = controller
        rank, processes = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
        grid = scene.get("grid", tetrahedra)()
        change_scalars(grid, scene)
        if "layers" in scene:
            piece = scene["layers"](grid, rank, processes)
        else:
            owner = partitions.PARTITIONS[scene.get("partition", "spirals")](grid, processes)
            piece = partitions.piece_of(grid, owner, rank, scene.get("ghosts", False))
        self.mapper = Mapper()
        self.mapper.SetController(controller)
        self.mapper.AutoAdjustSampleDistancesOff()
        self.mapper.SetBlendMode(BLENDS[scene.get("blend", "composite")])
        self.set_input(piece, scene)
        self.volume = vtk.vtkVolume()
        self.volume.SetMapper(self.mapper)
        self.set_functions(scene)
        self.set_cuts(scene)
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(0.2, 0.3, 0.1)
        self.renderer.AddVolume(self.volume)
        if scene.get("ball"):
            self.add_ball()
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(*SIZE)
        self.window.AddRenderer(self.renderer)
        self.mapper.ShareBounds()
        self.set_camera(scene)
        if scene.get("shadows"):
            self.add_light()

    def set_input(self, piece, scene):
        if scene.get("scalars") == "of_cells":
            self.mapper.SetScalarModeToUseCellFieldData()
            self.mapper.SelectScalarArray("of_cells")
        else:
            self.mapper.SetScalarModeToUsePointFieldData()
            self.mapper.SelectScalarArray(SCALARS)
        if not scene.get("blocks"):
            self.mapper.SetInputDataObject(piece)
            return
        blocks = vtk.vtkMultiBlockDataSet()
        halves = partitions.slabs(piece, 2) if piece.GetNumberOfCells() else np.zeros(0, dtype=int)
        for half in range(2):
            blocks.SetBlock(half, partitions.piece_of(piece, halves, half))
        self.mapper.SetInputDataObject(blocks)

    def set_functions(self, scene):
        prop = self.volume.GetProperty()
        prop.SetScalarOpacityUnitDistance(0.005 if scene.get("dense") else 0.25)
        for component in range(3 if scene.get("components") else 1):
            colors = vtk.vtkColorTransferFunction()
            for k, (scalar, *rgb) in enumerate(((0.1, 0.1, 0.2, 0.9), (0.4, 0.2, 0.9, 0.3), (0.7, 0.9, 0.8, 0.1))):
                colors.AddRGBPoint(scalar, *(rgb[(c + component) % 3] for c in range(3)))
            opacities = vtk.vtkPiecewiseFunction()
            low = 0.0 if scene.get("transparent") else 0.1
            for scalar, opacity in ((0.0, low), (0.35, low), (0.5, 0.6), (0.6, low), (0.9, 0.8)):
                opacities.AddPoint(scalar, opacity)
            prop.SetColor(component, colors)
            prop.SetScalarOpacity(component, opacities)
        if scene.get("components"):
            self.mapper.SetVectorModeToAllComponents()
        for i, value in enumerate((0.36, 0.47, 0.58)):
            prop.GetIsoSurfaceValues().SetValue(i, value)
        prop.SetShade(scene.get("shaded", False))
        self.mapper.SetShadowMethod(self.mapper.SHADOWS_AT_VERTICES if scene.get("shadows") else 0)
        if scene.get("gradient_opacity"):
            opacities = vtk.vtkPiecewiseFunction()
            opacities.AddPoint(0.0, 0.1)
            opacities.AddPoint(3.0, 1.0)
            prop.SetGradientOpacity(opacities)
        getattr(self.mapper, "SetAccuracyLevelTo" + scene.get("level", "Default"))()
        self.mapper.SetImageSampleDistance(scene.get("distance", 1.0))
        self.mapper.SetMaxVisitMemoryInBytes(scene.get("visit_bytes", 1 << 30))

    def set_cuts(self, scene):
        if scene.get("clipped"):
            plane = vtk.vtkPlane()
            plane.SetOrigin(0.4, 0.4, 0.4)
            plane.SetNormal(1.0, 0.5, 0.3)
            self.mapper.AddClippingPlane(plane)
        if scene.get("cropped"):
            self.mapper.CroppingOn()
            self.mapper.SetCroppingRegionPlanes(0.3, 0.7, 0.25, 0.7, 0.35, 0.65)
            self.mapper.SetCroppingRegionFlagsToFence()

    def add_ball(self):
        ball = vtk.vtkSphereSource()
        ball.SetCenter(0.7, 0.4, 0.5)
        ball.SetRadius(0.25)
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(ball.GetOutputPort())
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        self.renderer.AddActor(actor)

    def add_light(self):
        """From the side, across the slabs: the pieces cast shadows on each other."""
        self.renderer.AutomaticLightCreationOff()
        light = vtk.vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(5.0, 0.3, 1.0)
        light.SetFocalPoint(0.5, 0.5, 0.5)
        light.SetShadowAttenuation(1.0)
        self.renderer.AddLight(light)

    def set_camera(self, scene):
        camera = self.renderer.GetActiveCamera()
        camera.SetViewUp(0, 0, 1)
        kind = scene.get("camera")
        if kind == "inside":
            camera.SetPosition(0.35, 0.12, 0.41)
            camera.SetFocalPoint(0.7, 0.9, 0.6)
            camera.SetViewAngle(70.0)
        else:
            camera.SetPosition(1.5, -2.2, 1.6)
            camera.SetFocalPoint(0.5, 0.5, 0.45)
        if kind == "parallel":
            camera.ParallelProjectionOn()
            camera.SetParallelScale(0.8)
        self.renderer.ResetCameraClippingRange()

    def draw(self):
        self.window.Render()
        return grab(self.window)

    def figures(self):
        """Of all processes, in process 0."""
        own = vtk.vtkDoubleArray()
        own.SetNumberOfTuples(len(FIGURES))
        for i, name in enumerate(FIGURES):
            own.SetValue(i, getattr(self.mapper, "Get" + name)())
        every = vtk.vtkDoubleArray()
        self.controller.Gather(own, every, 0)
        if self.controller.GetLocalProcessId() != 0:
            return None
        table = vtk_to_numpy(every).reshape(-1, len(FIGURES))
        return {name: table[:, i].tolist() for i, name in enumerate(FIGURES)}


def main():
    controller = vtkMPIController()
    controller.Initialize()
    vtk.vtkMultiProcessController.SetGlobalController(controller)
    output, names = sys.argv[1], sys.argv[2:] or list(SCENES)
    results, figures = {}, {}
    for name in names:
        picture = Picture(SCENES[name], controller)
        frames = [picture.draw()]
        first = picture.figures()
        picture.renderer.GetActiveCamera().Azimuth(SCENES[name].get("turn", 0.0))
        frames.append(picture.draw())  # by what the first has shown to be hidden; with figures of drawing alone
        results[name] = np.stack(frames)
        figures[name] = picture.figures()
        if figures[name]:
            figures[name]["FirstVisits"] = first["NumberOfVisits"]
        picture.window.Finalize()
    if controller.GetLocalProcessId() == 0:
        np.savez(output, figures=json.dumps(figures), **results)


if __name__ == "__main__":
    main()
