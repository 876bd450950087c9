# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes that the mapper draws in a window off the screen, with what their pages are compared by."""
import pathlib
import time

import numpy as np
import vtktetmarch
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray

DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"
GOLFBALL, SCAN = DATA / "golfball_small.vtu", DATA / "bonsai_small.vti"
LIT = {"shade": True, "ambient": 0.3, "diffuse": 0.7, "specular": 0.3, "specular_power": 20}
SCENES = {"golf ball": (GOLFBALL, {}), "golf ball, lit": (GOLFBALL, LIT),
          "scan": (SCAN, {}), "scan, lit": (SCAN, LIT)}
# Seconds. Without a limit on draws, a frame is one draw.
ENOUGH_FOR_ONE_DRAW = 1e6
TRUTH_TOLERANCE = 5e-5


class Scene:
    """The first picture of a file."""

    def __init__(self, name):
        path, properties = SCENES[name]
        self.figure = vtktetmarch.figure(path, max_draw_time_in_seconds=ENOUGH_FOR_ONE_DRAW, **properties)
        self.figure.render()
        self.window = self.figure.renderer.GetRenderWindow()

    def write_page(self, path):
        return self.figure.to_html(path, controls="none")

    def milliseconds(self, degrees):
        """Of a frame after the camera was turned, until the GL has finished."""
        self.figure.camera.Azimuth(degrees)
        self.figure.renderer.ResetCameraClippingRange()
        begin = time.perf_counter()
        self.window.Render()
        self.window.WaitForCompletion()
        return 1000 * (time.perf_counter() - begin)

    def ground_truth(self):
        """The picture of the last frame without an error, over the background: (height, width, 3), 0 to 1."""
        pixels = vtkFloatArray()
        if not self.figure.mapper.RenderGroundTruth(self.figure.volume, pixels, TRUTH_TOLERANCE):
            raise RuntimeError("there is no ground truth of the scene")
        width, height = self.figure.size
        values = vtk_to_numpy(pixels).reshape(height, width, 4)[::-1].astype(float)
        return values[..., :3] + (1 - values[..., 3:]) * np.array(self.figure.renderer.GetBackground())


def errors_of(picture, truth):
    """Of the worst channel of each pixel, 0 to 1: the RMS and the 99.9 % quantile over all pixels."""
    worst = np.abs(picture / 255 - truth).max(axis=2)
    return {"rms": float(np.sqrt(np.mean(worst ** 2))), "q999": float(np.quantile(worst, 0.999))}
