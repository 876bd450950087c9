# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flow: the vorticity in the wake of a dimpled ball, on the tetrahedra of the simulation."""
import vtktetmarch

figure = vtktetmarch.figure(
    "Data/golfball_small.vtu", "vorticity_mag", range=(0.5, 9), size=(480, 360), background="#05070d",
    cmap=["#173a6e", "#2f8fc4", "#bfe6d6", "#ffd166", "#ef6f3c"], opacity=[(0.6, 0), (2, 0.12), (5, 0.5), (9, 1)],
    unit_distance=0.09,
    camera={"position": (-1.3, -3.0, 2.0), "focal_point": (1.0, 0.1, -0.1), "view_up": (0, 0, 1), "view_angle": 40})
figure.save("flow.png")
