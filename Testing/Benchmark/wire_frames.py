# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A wire before a wall in fog: an image whose light is harder to keep than that of scans."""
import made_images
import numpy as np
import vtkmodules.all as vtk
from made_grids import add_array
from time_frames import ENOUGH_FOR_ONE_DRAW, VIEW_DIRECTION, Frames
from vtktetmarch import vtkTetMarchSmartVolumeMapper

CELLS = 96  # along an edge of the unit cube
RADIUS = 0.02  # of the wire: 1.9 cells
WALL = 0.85  # the place of its front, along y
WIRE_POINT, WIRE_DIRECTION = np.array([0.4, 0.68, 0.65]), np.array([0.8, 0.1, 0.4])


def inside(distance):
    """1 inside of a surface, 0 outside, over two cells."""
    return np.clip(0.5 - 0.5 * CELLS * distance, 0, 1)


def wire_and_wall():
    """The image; 0 is fog."""
    axis = np.linspace(0, 1, CELLS + 1)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    places = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    along = WIRE_DIRECTION / np.linalg.norm(WIRE_DIRECTION)
    from_wire = np.linalg.norm(np.cross(places - WIRE_POINT, along), axis=1) - RADIUS
    image = made_images.lattice((CELLS, CELLS, CELLS), even=True)
    add_array(image.GetPointData(), "density", np.maximum(inside(from_wire), inside(WALL - places[:, 1])))
    image.GetPointData().SetActiveScalars("density")
    return image


class WireFrames(Frames):
    def __init__(self, size):
        mapper = vtkTetMarchSmartVolumeMapper()
        mapper.SetInputData(wire_and_wall())
        mapper.SetMaxDrawTimeInSeconds(ENOUGH_FOR_ONE_DRAW)
        self.show(mapper, size)
        colors, opacities = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
        fog, solid = (0.02, 0.8, 0.85, 0.9), (0.95, 0.9, 0.6, 0.3)
        for scalar, (opacity, *rgb) in ((0.0, fog), (0.2, fog), (1.0, solid)):
            colors.AddRGBPoint(scalar, *rgb)
            opacities.AddPoint(scalar, opacity)
        self.use_functions(colors, opacities, 0.03)
        self.volume.GetProperty().SetInterpolationTypeToLinear()
        self.camera.SetFocalPoint(0, 0, 0)
        self.camera.SetPosition(*VIEW_DIRECTION)
        self.camera.SetViewUp(0, 0, 1)
        self.renderer.ResetCamera()
        self.camera.Zoom(1.3)
        self.first_position = self.camera.GetPosition()
