# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Isosurfaces: an orbital of the hydrogen atom, 4f; intersected within the cells, without polygons."""
import numpy as np
import vtktetmarch
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

N, SIDE = 80, 36.0  # in Bohr radii
z, y, x = np.meshgrid(*[np.linspace(-SIDE, SIDE, N)] * 3, indexing="ij")
r = np.sqrt(x * x + y * y + z * z)
wave = z * (x * x - y * y) * np.exp(-r / 4)
wave /= abs(wave).max()

space = vtkImageData()
space.SetDimensions(N, N, N)
space.SetSpacing([2 * SIDE / (N - 1)] * 3)
space.SetOrigin([-SIDE] * 3)
values = numpy_to_vtk(wave.ravel(), deep=True)
values.SetName("wave")
space.GetPointData().SetScalars(values)
figure = vtktetmarch.figure(
    space, range=(-1, 1), cmap=[(-0.7, "#1769ff"), (-0.1, "#49c5ff"), (0.1, "#ffb454"), (0.7, "#f0441f")],
    blend_mode="isosurface", isosurface_values=[-0.7, -0.35, -0.1, 0.1, 0.35, 0.7],
    opacity=[(-0.7, 1), (-0.35, 0.45), (-0.1, 0.22), (0.1, 0.22), (0.35, 0.45), (0.7, 1)], shade=True, ambient=0.3,
    diffuse=0.8, specular=0.5, specular_power=30, size=(480, 360), background="#0a0b10",
    camera={"position": (60, -85, 42), "focal_point": (0, 0, 0), "view_up": (0, 0, 1), "view_angle": 33})
figure.save("isosurfaces.png")
