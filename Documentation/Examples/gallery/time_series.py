# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A time series: four moments of a ball in the deforming flow of Enright et al. (2002), side by side."""
import numpy as np
import vtktetmarch
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

N, STEP = 56, 0.05
lattice = np.meshgrid(*[np.linspace(0, 1, N)] * 3, indexing="ij")
start = [part.ravel() for part in lattice[::-1]]  # x, y, z: where each point's matter began


def velocity(x, y, z):
    (sx, s2x), (sy, s2y), (sz, s2z) = ((np.sin(np.pi * a)**2, np.sin(2 * np.pi * a)) for a in (x, y, z))
    return 2 * sx * s2y * s2z, -s2x * sy * s2z, -s2x * s2y * sz


def volume_at():
    x, y, z = start
    cube = vtkImageData()
    cube.SetDimensions(N, N, N)
    cube.SetSpacing([1 / (N - 1)] * 3)
    values = numpy_to_vtk(np.sqrt((x - 0.35)**2 + (y - 0.35)**2 + (z - 0.35)**2), deep=True)
    values.SetName("distance")
    cube.GetPointData().SetScalars(values)
    return vtktetmarch.volume(cube, range=(0, 0.18), cmap=["white", "#ffe08a", "#ff9e4f", "#e8384f"], shade=True,
                              opacity=[(0, 0.9), (0.13, 0.8), (0.17, 0)], unit_distance=0.03, ambient=0.4, diffuse=0.9)


figure = vtktetmarch.figure(volume_at(), size=(480, 360), background="#0b0d14", camera={
    "position": (1.6, -4.2, 0.1), "focal_point": (0.95, 0.5, 0.05), "view_up": (0, 0, 1), "view_angle": 19})
for place in ((1.0, 0, 0), (0, 0, -0.8), (1.0, 0, -0.8)):
    for _ in range(4):  # backwards along the flow, by the midpoint rule
        middle = [a - STEP / 2 * v for a, v in zip(start, velocity(*start))]
        start = [a - STEP * v for a, v in zip(start, velocity(*middle))]
    later = volume_at()
    later.SetPosition(place)
    figure.add(later)
figure.save("time_series.png")
