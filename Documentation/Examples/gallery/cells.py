# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cells of four kinds in one twisted beam: hexahedra, tetrahedra, pyramids and wedges, with their edges."""
import numpy as np
import vtktetmarch
from vtkmodules.vtkRenderingCore import vtkActor, vtkDataSetMapper

NX, NY, NZ = 12, 4, 4
lattice = np.stack(np.meshgrid(*[np.arange(n + 1) for n in (NX, NY, NZ)], indexing="ij"), axis=-1)
ids = np.arange(lattice[..., 0].size).reshape(lattice.shape[:3])
boxes = [[ids[i + a, j + b, k + c] for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
         for i in range(NX) for j in range(NY) for k in range(NZ)]
points = lattice.reshape(-1, 3) - (NX / 2, NY / 2, NZ / 2)
points = np.concatenate([points, points[boxes].mean(axis=1)])  # the last: the boxes' middles

SIDES = (0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (3, 2, 6, 7), (0, 3, 7, 4)
KINDS: dict[str, list] = {
    "hexahedron": [range(8)], "tetra": [(a, *side, 8) for a, b, c, d in SIDES for side in ((b, c), (c, d))],
    "pyramid": [(*side, 8) for side in SIDES], "wedge": [(0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7)]}
flat, kinds = [], []
for number, box in enumerate(boxes):
    kind = list(KINDS)[4 * number // len(boxes)]
    for part in KINDS[kind]:
        flat += [len(part), *([*box, ids.size + number][corner] for corner in part)]
        kinds.append(kind)
x, y, z = points.T
field, turn = np.cos(0.8 * x) * np.cos(1.1 * y) + 0.6 * np.sin(0.5 * x + z), 0.14 * x
points = np.stack([x, y * np.cos(turn) - z * np.sin(turn), y * np.sin(turn) + z * np.cos(turn)], axis=-1)
beam = vtktetmarch.from_arrays(points, np.array(flat), kinds, point_data={"field": field})

figure = vtktetmarch.figure(
    beam, cmap=["#25b8ff", "#2a4fd0", "#e6e0da", "#c9304a", "#ffab40"], opacity=[(-1.6, 1), (0, 0.15), (1.6, 1)],
    unit_distance=0.9, size=(480, 360), background="#0b0d12", camera={"azimuth": -8, "elevation": 8})
lines = vtkActor()
lines.SetMapper(vtkDataSetMapper())
lines.GetMapper().SetInputData(beam)
lines.GetMapper().ScalarVisibilityOff()
lines.GetProperty().SetRepresentationToWireframe()
lines.GetProperty().BackfaceCullingOn()
figure.add(lines).save("cells.png")
