# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Light: a scan of a bonsai under a lamp, with shadows and dim corners."""
import vtktetmarch
from vtkmodules.vtkRenderingCore import vtkLight

figure = vtktetmarch.figure(
    "Data/bonsai_small.vti", size=(720, 720), background="#0d0f14", unit_distance=2,
    cmap=[(30, "#4c7a29"), (45, "#5c8f33"), (58, "#808c42"), (75, "#9e7a4f"), (155, "#996647"), (185, "#c77352"),
          (255, "#eda380")],
    opacity=[(30, 0), (45, 0.3), (60, 0.5), (80, 0.7), (255, 0.97)], clipping_planes=[((0, 26, 0), (0, 1, 0))],
    camera={"position": (400, 330, 600), "focal_point": (112, 102, 134), "view_up": (0, 1, 0), "view_angle": 29},
    shade=True, ambient=0.4, diffuse=0.9, specular=0.15, specular_power=20,
    shadow_method="automatic", ambient_occlusion=True, ambient_occlusion_radius=0.05)

lamp = vtkLight()
lamp.SetLightTypeToSceneLight()
lamp.SetPosition(-600, 900, 700)
lamp.SetFocalPoint(128, 128, 128)
lamp.SetIntensity(1.6)
headlight = vtkLight()
headlight.SetLightTypeToHeadlight()
headlight.SetIntensity(0.3)
for light in (lamp, headlight):
    figure.renderer.AddLight(light)
figure.save("light.png")
