# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cells of four kinds in one mesh: hexahedra, pyramids, tetrahedra and wedges, with their edges."""
import numpy as np
import vtktetmarch
from vtkmodules.vtkFiltersCore import vtkExtractEdges
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

NX, NY, NZ = 8, 6, 4
lattice = np.stack(np.meshgrid(np.arange(NX + 1), np.arange(NY + 1), np.arange(NZ + 1), indexing="ij"), -1)
ids = np.arange(lattice[..., 0].size).reshape(lattice.shape[:3])
boxes = [[ids[i + a, j + b, k + c] for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
         for i in range(NX) for j in range(NY) for k in range(NZ)]
points = lattice.reshape(-1, 3).astype(float)
middles = points[boxes].mean(axis=1)

SIDES = (0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)
cells, kinds = [], []
for number, (box, (x, _, _)) in enumerate(zip(boxes, middles)):
    parts = {"hexahedron": [range(8)]}
    if x > 6:  # a box is two wedges
        parts = {"wedge": [(0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7)]}
    elif x > 4:  # or six pyramids about its middle
        parts = {"pyramid": [(*side, 8) for side in SIDES]}
    elif x > 2:  # or twelve tetrahedra
        parts = {"tetra": [(side[0], *side[n:n + 2], 8) for side in SIDES for n in (1, 2)]}
    for kind, corners in parts.items():
        cells += [[[*box, len(points) + number][corner] for corner in part] for part in corners]
        kinds += [kind] * len(corners)
points = np.concatenate([points, middles])
