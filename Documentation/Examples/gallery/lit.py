# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Light: a cloud of seeded noise in the evening sun, with shadows and scattered light."""
import numpy as np
import vtktetmarch
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkLight

N = (40, 60, 80)  # z, y, x
random = np.random.default_rng(3)
waves = np.meshgrid(*[np.fft.fftfreq(n, 1 / n) for n in N], indexing="ij")
length = np.sqrt(sum(wave**2 for wave in waves)) + 2
noise = np.fft.ifftn(np.fft.fftn(random.normal(size=N)) * length**-2.6).real
noise /= noise.std()
z, y, x = np.meshgrid(*[np.linspace(-1, 1, n) for n in N], indexing="ij")
hull = 1 - 1.1 * np.sqrt((x / 0.75)**2 + (y / 0.75)**2 + (np.where(z < -0.35, 3, 0.85) * (z + 0.35))**2)
density = np.clip(1.5 * hull + 0.35 * noise, 0, 1)

sky = vtkImageData()
sky.SetDimensions(N[::-1])
values = numpy_to_vtk(density.astype(np.float32).ravel(), deep=True)
values.SetName("density")
sky.GetPointData().SetScalars(values)
figure = vtktetmarch.figure(
    sky, range=(0, 1), cmap=["white", "white"], opacity=[(0.02, 0), (0.3, 0.25), (1, 0.8)], unit_distance=1.2,
    size=(480, 360), background="#2f5088", shade=True, ambient=0.3, diffuse=0.95, specular=0,
    shadow_method="along_rays", volumetric_scattering_blending=0.6,
    camera={"position": (12, -119, 3), "focal_point": (37, 30, 18), "view_up": (0, 0, 1), "view_angle": 26})
for kind, position, color, intensity in (("Scene", (250, -100, 100), (1.0, 0.72, 0.45), 1.5),
                                         ("Scene", (0, 0, 300), (0.5, 0.65, 1.0), 0.5)):
    light = vtkLight()
    getattr(light, f"SetLightTypeTo{kind}Light")()
    light.SetPosition(position)
    light.SetFocalPoint(40, 30, 20)
    light.SetColor(color)
    light.SetIntensity(intensity)
    figure.renderer.AddLight(light)
figure.save("lit.png")
