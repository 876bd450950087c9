# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A cut: an eighth of a planet is cropped; plumes rise from its core, on hexahedra that fill a ball."""
import numpy as np
import vtktetmarch

N = 49
cube = np.stack(np.meshgrid(*[np.linspace(-1, 1, N)] * 3, indexing="ij"), axis=-1)
x2, y2, z2 = np.moveaxis(cube**2, -1, 0)
ball = cube * np.sqrt(np.stack([1 - y2 / 2 - z2 / 2 + y2 * z2 / 3, 1 - z2 / 2 - x2 / 2 + z2 * x2 / 3,
                                1 - x2 / 2 - y2 / 2 + x2 * y2 / 3], axis=-1))
ids = np.arange(N**3).reshape(N, N, N)
corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
cells = np.stack([ids[i:N - 1 + i, j:N - 1 + j, k:N - 1 + k] for i, j, k in corners], axis=-1).reshape(-1, 8)

points = ball.reshape(-1, 3)
radius = np.linalg.norm(points, axis=1)
heat = 0.75 - 0.5 * radius
random = np.random.default_rng(11)
for axis in random.normal(size=(90, 3)):  # plumes that sway and are wider at the top
    axis /= np.linalg.norm(axis)
    along = points @ axis
    aside = np.sqrt(np.maximum(radius**2 - along**2, 0)) + 0.05 * np.sin(9 * radius + 10 * axis[0])
    width = 0.06 + 0.12 * np.maximum(along - 0.6, 0)
    heat += np.where(along > 0, 0.4 * np.exp(-(aside / width)**2) * np.clip(3 * (radius - 0.4), 0, 1), 0)
heat = np.minimum(heat, 0.95) + 0.6 / (1 + np.exp((radius - 0.42) / 0.015)) - 0.3 * (radius > 0.97)

planet = vtktetmarch.from_arrays(points, cells, "hexahedron", point_data={"heat": heat})
figure = vtktetmarch.figure(
    planet, "heat", range=(0, 1.2), opacity=1, unit_distance=0.03,
    cmap=["#2c7fa3", "#79c7b5", "#5b3a7e", "#b0417c", "#ef6a4e", "#fcb24c", "#fff1b8"],
    size=(480, 360), background="#07080c", shade=True, ambient=0.75, diffuse=0.4, specular=0.05,
    cropping=True, cropping_region_planes=(0, 2, -2, 0, 0, 2), cropping_region_flags=2**27 - 1 - 2**13,
    camera={"position": (2.2, -4.6, 2.5), "focal_point": (0, 0, 0), "view_up": (0, 0, 1), "view_angle": 23})
figure.save("cut.png")
