# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stress: a plate with a hole is pulled; hexahedra with a value each, by the solution of Kirsch (1898)."""
import numpy as np
import vtktetmarch

AROUND, OUTWARDS, THROUGH = 96, 28, 6
angle, share, depth = np.meshgrid(np.linspace(0, 2 * np.pi, AROUND, endpoint=False), np.linspace(0, 1, OUTWARDS + 1),
                                  np.linspace(-0.5, 0.5, THROUGH + 1), indexing="ij")
edge = 5 / np.maximum(abs(np.cos(angle)), abs(np.sin(angle)))  # from the hole, of radius 1, to the square's edge
radius = 1 + (edge - 1) * share**1.6
points = np.stack([radius * np.cos(angle), radius * np.sin(angle), depth], axis=-1).reshape(-1, 3)

ids = np.arange(len(points)).reshape(angle.shape)
near, far = ids, np.roll(ids, -1, axis=0)
layer = [near[:, :-1], near[:, 1:], far[:, 1:], far[:, :-1]]
cells = np.stack([side[:, :, :-1] for side in layer] + [side[:, :, 1:] for side in layer], axis=-1).reshape(-1, 8)

x, y, _ = points[cells].mean(axis=1).T
r2, twice = x * x + y * y, 2 * np.arctan2(y, x)
radial = (1 - 1 / r2 + (1 - 4 / r2 + 3 / r2**2) * np.cos(twice)) / 2
hoop = (1 + 1 / r2 - (1 + 3 / r2**2) * np.cos(twice)) / 2
shear = -(1 + 2 / r2 - 3 / r2**2) * np.sin(twice) / 2
mises = np.sqrt(radial**2 - radial * hoop + hoop**2 + 3 * shear**2)
plate = vtktetmarch.from_arrays(points, cells, "hexahedron", cell_data={"von Mises": mises})

figure = vtktetmarch.figure(
    plate, "von Mises", range=(0, 2.6), cmap="turbo", opacity=[(0, 0.6), (1, 0.4), (1.5, 0.9), (3, 1)],
    unit_distance=0.3, size=(480, 360), background="#0b0d12",
    camera={"position": (-5.5, -12.5, 13.5), "focal_point": (0, -0.8, 0), "view_up": (0, 0, 1), "view_angle": 36})
figure.save("stress.png")
