# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A time series to the frames of a movie: arrays of NumPy change in place, and the mesh is prepared once."""
import numpy as np
import vtktetmarch
from vtkmodules.util.numpy_support import vtk_to_numpy

FRAMES = 12
flow = vtktetmarch.read("Data/golfball_small.vtu")
points = vtk_to_numpy(flow.GetPoints().GetData())
slow = np.clip(1 - vtk_to_numpy(flow.GetPointData().GetArray("speed")), 0, 0.5)

cells = flow.GetCells()
connectivity, offsets = map(vtk_to_numpy, (cells.GetConnectivityArray(), cells.GetOffsetsArray()))
dye = np.zeros(len(points))
grid = vtktetmarch.from_arrays(points, (connectivity, offsets), "tetra", point_data={"dye": dye})

figure = vtktetmarch.figure(
    grid, "dye", range=(0.05, 0.45), cmap=["#10206a", "#2a7fd0", "#8ff0d8", "#fff6b0", "#ff8a3c"],
    opacity=[(0.04, 0), (0.15, 0.2), (0.5, 1)], unit_distance=0.35, size=(640, 260), background="#06070c",
    camera={"position": (-1, -8, 3), "focal_point": (3.0, 0, -0.1), "view_up": (0, 0, 1), "view_angle": 24})
for frame in range(FRAMES):
    # Dye that comes in pulses, two diameters apart, and drifts with the wake.
    dye[:] = slow * (0.55 + 0.45 * np.cos(2 * np.pi * (points[:, 0] / 2 - frame / FRAMES)))
    grid.GetPointData().GetArray("dye").Modified()
    grid.Modified()
    figure.save(f"dye_{frame:02}.png")
print("the mesh was prepared {mesh_builds} time, the values {scalars_builds} times".format(**figure.statistics()))
