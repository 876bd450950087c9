# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ocean: temperature on a curvilinear grid whose layers follow the sea floor, drawn 75 times as high."""
import numpy as np
import vtktetmarch
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid

random = np.random.default_rng(7)
shape = (24, 70, 100)  # layers, north, east
layer, north, east = np.meshgrid(*(np.linspace(0, 1, n) for n in shape), indexing="ij")
x, y = 1400 * east + 60 * np.sin(3 * north), 1000 * north - 80 * np.sin(4 * east)  # km
ridge = 1.9 * np.exp(-((x - 760 - 0.25 * y) / 130) ** 2) * (1 + 0.3 * np.sin(y / 60))
floor = -(4.1 - ridge - 3.6 * np.clip(1 - (x + 0.15 * y) / 330, 0, 1) ** 1.5)  # km
z = floor * (1 - layer) ** 0.8

warmth = 26 - 15 * north + 2 * np.sin(x / 150)
deep = z / 1.1
for _ in range(16):  # eddies, each with a warm or a cold heart that reaches down
    cx, cy, size, sign = random.uniform((200, 80, 50, -1), (1350, 950, 110, 1))
    heart = np.exp(-((x - cx) ** 2 + (y - cy) ** 2) / size**2) * np.sign(sign)
    warmth += 4 * heart
    deep += 0.35 * heart
temperature = 2 + (warmth - 2) * np.exp(np.minimum(deep, 0))

grid = vtkStructuredGrid()
grid.SetDimensions(*shape[::-1])
points = vtkPoints()
points.SetData(numpy_to_vtk(np.stack([x, y, 75 * z], axis=-1).reshape(-1, 3), deep=True))
grid.SetPoints(points)
values = numpy_to_vtk(temperature.ravel(), deep=True)
values.SetName("temperature")
grid.GetPointData().SetScalars(values)
figure = vtktetmarch.figure(grid, range=(2, 26), opacity=[(2, 0.25), (8, 0.3), (26, 1)], unit_distance=45,
                            cmap=["#0b1a4a", "#1f5fa8", "#2fb3b3", "#c7e58a", "#ffd15c", "#f0703c", "#b5223a"],
                            size=(480, 360), background="#0a0f18", camera={"azimuth": -12, "elevation": 12, "zoom": 1})
figure.save("ocean.png")
