# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picking: what a ray meets, and where; each hit gets a small sphere."""
import vtktetmarch
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

figure = vtktetmarch.figure(
    "Data/golfball_small.vtu", "vorticity_mag", range=(1, 12), cmap="viridis", opacity=[(1.5, 0), (6, 1)],
    unit_distance=0.1, size=(900, 420), background="#0a0b10", shade=True, pick_opacity_threshold=0.3,
    camera={"position": (-0.5, -5, 1.8), "focal_point": (1.9, 0, -0.05), "view_up": (0, 0, 1), "view_angle": 26})


def marker(position):
    source = vtkSphereSource()
    source.SetCenter(position)
    source.SetRadius(0.035)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(1.0, 0.35, 0.3)
    return actor


hits = {x: figure.pick(x, 210) for x in range(60, 900, 60)}
print("  x    cell  vorticity  position")
for x, hit in hits.items():
    if hit:
        print(f"{x:3}  {hit['cell']:6}  {hit['value']:9.2f}  ({', '.join(f'{c:.2f}' for c in hit['position'])})")
        figure.add(marker(hit["position"]))
figure.save("picking.png")
