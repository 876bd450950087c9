# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clipping: half of the flow is cut away; the ball, an opaque surface, stands in what is left."""
import vtktetmarch
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

figure = vtktetmarch.figure(
    "Data/golfball_small.vtu", "p", range=(-0.3, 0.3), cmap="coolwarm",
    opacity=[(-0.3, 1), (-0.02, 0), (0.02, 0), (0.3, 1)], unit_distance=0.1,
    clipping_planes=[((0, 0, 0), (0, 1, 0))], size=(900, 520), background="#0b0d14",
    camera={"position": (-1.2, -6, 2.4), "focal_point": (0.6, 0, 0), "view_up": (0, 0, 1), "view_angle": 32})

source = vtkSphereSource()
source.SetRadius(0.5)
source.SetThetaResolution(96)
source.SetPhiResolution(96)
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(source.GetOutputPort())
ball = vtkActor()
ball.SetMapper(mapper)
ball.GetProperty().SetColor(0.9, 0.88, 0.82)
ball.GetProperty().SetSpecular(0.4)
ball.GetProperty().SetSpecularPower(40)
figure.add(ball).save("clipping.png")
