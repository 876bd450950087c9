# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A window that draws scenes and gives what they show as arrays of numpy."""
import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

WIDTH, HEIGHT = 96, 64
# What an older build may call the same.
OLDER_NAMES = {"GetNumberOfLookups": "GetNumberOfEvaluations", "RenderGroundTruth": "RenderReference",
               "SetViewModeToBoundaryFaces": "SetViewModeToShellFaces",
               "SetViewModeToBoundaryCoordinates": "SetViewModeToShellCoordinates"}
COUNTS = ("Rays", "CrossedCells", "Lookups", "RefusedEntries", "LostRays", "GuardHits")


def call(mapper, method, *arguments):
    """Calls a method of the mapper, by its older name if it has no other."""
    if not hasattr(mapper, method):
        method = OLDER_NAMES.get(method, method)
    return getattr(mapper, method)(*arguments)


class Refused(Exception):
    """VTK or the mapper reported an error."""


def float_picture(window, renderer, size):
    """Renders once more into a framebuffer of floats: red, green, blue and opacity."""
    frame = vtk.vtkFramebufferPass()
    frame.SetDelegatePass(vtk.vtkRenderStepsPass())
    frame.SetColorFormat(vtk.vtkTextureObject.Float32)
    frame.SetDepthFormat(vtk.vtkTextureObject.Float32)
    renderer.SetPass(frame)
    window.Render()
    width, height = size
    values = np.empty((height, width, 4), dtype=np.float32)
    frame.GetColorTexture().Download().Download2D(vtk.VTK_FLOAT, values, size, 4, (0, 0))
    renderer.SetPass(None)
    frame.ReleaseGraphicsResources(window)
    return values


class PictureWindow:
    """For a `with` statement, which ends its GL context: one scene a window bounds what a driver keeps of shaders."""

    def __init__(self, stage=""):
        self.stage = stage
        self.window = vtk.vtkRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.AlphaBitPlanesOn()
        self.window.OffScreenRenderingOn()
        self.window.SetSize(WIDTH, HEIGHT)
        self.errors = []

    def __enter__(self):
        return self

    def __exit__(self, *_error):
        self.window.Finalize()

    def show(self, scene):
        self.window.AddRenderer(scene.renderer)
        if self.stage:
            call(scene.mapper, f"SetShaderStageTo{self.stage}")
        scene.mapper.AddObserver("ErrorEvent", self.remember_error)

    def remember_error(self, _caller, _event, text="unknown error"):
        self.errors.append(text)

    remember_error.CallDataType = vtk.VTK_STRING

    def refuse_errors(self):
        if self.errors:
            raise Refused(self.errors[0].strip())

    def bytes(self):
        """Red, green and blue of each pixel of the window."""
        self.window.Render()
        self.refuse_errors()
        values = vtk.vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, WIDTH - 1, HEIGHT - 1, 0, values, 0)
        return vtk_to_numpy(values).reshape(HEIGHT, WIDTH, 3).copy()

    def floats(self, scene):
        """The same in float and with opacity, before anything is rounded to bytes."""
        values = float_picture(self.window, scene.renderer, (WIDTH, HEIGHT))
        self.refuse_errors()
        return values

    def diagnostics(self, scene):
        """The picture of the diagnostic variant, and its counts."""
        mapper = scene.mapper
        values = vtk.vtkFloatArray()
        mapper.GetDiagnosticPixels(values)
        counts = [call(mapper, "GetNumberOf" + count) for count in COUNTS]
        return vtk_to_numpy(values).reshape(HEIGHT, WIDTH, 4).copy(), np.array(counts)

    def ground_truth(self, scene):
        """The last frame by the CPU in double precision."""
        values = vtk.vtkFloatArray()
        call(scene.mapper, "RenderGroundTruth", scene.volume, values)
        self.refuse_errors()
        return vtk_to_numpy(values).reshape(HEIGHT, WIDTH, 4).copy()

    def picks(self, scene, every=12):
        """Of each 12th pixel across and up: whether the volume is hit, where, its scalar and its cell."""
        mapper = scene.mapper
        rows = []
        for y in range(every // 2, HEIGHT, every):
            for x in range(every // 2, WIDTH, every):
                hit = mapper.Pick(scene.renderer, scene.volume, x, y)
                rows.append([hit, *mapper.GetPickedPosition(), mapper.GetPickedScalar(), mapper.GetPickedCellId()])
        self.refuse_errors()
        return np.array(rows, dtype=np.float64)
