# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picking: rays from pixels hit a cloud of matter; each hit gets a ball and the value that was met."""
import numpy as np
import vtktetmarch
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkTextActor

N = 64
z, y, x = np.meshgrid(*[np.linspace(-1, 1, N)] * 3, indexing="ij")
random = np.random.default_rng(5)
matter = sum(strength * np.exp(-((x - a)**2 + (y - b)**2 + (z - c)**2) / 0.035) for strength, (a, b, c) in
             zip(np.linspace(0.5, 2, 14), random.uniform((-0.75, -0.5, -0.5), (0.75, 0.5, 0.5), (14, 3))))
cube = vtkImageData()
cube.SetDimensions(N, N, N)
values = numpy_to_vtk(matter.ravel(), deep=True)
values.SetName("matter")
cube.GetPointData().SetScalars(values)
figure = vtktetmarch.figure(
    cube, range=(0.1, 2), cmap="viridis", opacity=[(0.15, 0), (0.5, 0.15), (2, 0.9)], unit_distance=1.5, shade=True,
    ambient=0.5, diffuse=0.8, size=(480, 360), background="#0c0e14", pick_opacity_threshold=0.3, camera={"zoom": 1.12})

hits = {(u, v): figure.pick(u, v) for v in range(40, 350, 45) for u in range(40, 450, 50)}
for (u, v), hit in hits.items():
    if hit:
        source = vtkSphereSource()
        source.SetCenter(hit["position"])
        source.SetRadius(0.6)
        ball = vtkActor()
        ball.SetMapper(vtkPolyDataMapper())
        ball.GetMapper().SetInputConnection(source.GetOutputPort())
        ball.GetProperty().SetColor(1, 0.35, 0.3)
        label = vtkTextActor()
        label.SetInput(f"{hit['value']:.2f}")
        label.SetPosition(u + 6, 360 - v)
        figure.add(ball, label)
figure.save("pick.png")
