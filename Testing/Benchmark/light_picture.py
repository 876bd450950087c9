# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of LightAccuracy.md: shadows at vertices, by tolerance 2/255, and the ground truth, side by side."""
import numpy as np
import vtkmodules.all as vtk
from light_effects import AT_VERTICES, EFFECTS
from light_scenes import LightScene
from vtkmodules.util.numpy_support import numpy_to_vtk

SCENE, EFFECT = "wire", "scattering"
SHOWN = (AT_VERTICES, "tolerance 2/255")
SIZE = (240, 240)
ZOOM = 1.5
TRUTH_TOLERANCE = 1e-4
GAP = 4  # pixels, white


def side_by_side(pictures):
    gap = np.ones((SIZE[1], GAP, 3))
    return np.hstack([part for picture in pictures for part in (gap, picture)][1:])


def write_png(file, picture):
    pixels = np.rint(255 * np.clip(picture, 0, 1)).astype(np.uint8)
    image = vtk.vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3), deep=True))
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(str(file))
    writer.SetInputData(image)
    writer.Write()


def write_picture(file):
    scene = LightScene(SCENE, SIZE, SIZE)
    scene.camera.Zoom(ZOOM)
    pictures = []
    for way in SHOWN:
        scene.apply(EFFECTS[EFFECT], way)
        pictures.append(scene.picture())
    pictures.append(scene.ground_truth(TRUTH_TOLERANCE)[..., :3])
    write_png(file, side_by_side(pictures))
    print(f"wrote {file}")
