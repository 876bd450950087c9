# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Computed tomography: a bonsai; leaves, wood and pot by their density."""
import vtktetmarch

figure = vtktetmarch.figure(
    "Data/bonsai_small.vti", size=(480, 360), background="#101319", unit_distance=2,
    cmap=[(30, "#3f6b2a"), (45, "#6d9c3c"), (60, "#8a8a45"), (80, "#a0764a"), (150, "#8a5a3a"), (200, "#c77352"),
          (255, "#f0b088")],
    opacity=[(28, 0), (45, 0.12), (60, 0.35), (90, 0.6), (255, 0.9)], clipping_planes=[((0, 26, 0), (0, 1, 0))],
    shade=True, ambient=0.4, diffuse=1.1, specular=0.25, specular_power=15,
    camera={"position": (-250, 260, 520), "focal_point": (125, 118, 132), "view_up": (0, 1, 0), "view_angle": 26})
figure.save("ct.png")
