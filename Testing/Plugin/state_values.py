# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""For each property of the representations a value that is not its default, and a scene that has them all."""
import contextlib

from paraview import simple
from views import make_plain, show

PREFIX = "TetMarch"
ARRAY = "RTData"
# Prefixes are left out. Times are so long, and errors so large, that every frame keeps them.
COMMON = {
    "AccuracyLevel": "Fast",
    "Ambient": 0.25,
    "AmbientOcclusion": 1,
    "AmbientOcclusionDirections": 5,
    "AmbientOcclusionRadius": 0.25,
    "AutoAdjustSampleDistances": 0,
    "AutomaticViewRange": 0,
    "AverageIPScalarRange": [80.0, 240.0],
    "BlendMode": "Isosurface",
    "CroppingOrigin": [0.5, 0.25, -0.5],
    "CroppingRegionFlags": "Fence",
    "CroppingScale": [0.5, 0.75, 0.875],
    "Diffuse": 0.75,
    "DrawNanCells": 1,
    "ErrorBudget": 1.0,
    "ErrorTolerance": 0.125,
    "FrameTimeBudget": 1e4,
    "GlobalIlluminationReach": 0.5,
    "GradientType": "Cell",
    "ImageSampleDistance": 2.0,
    "IsosurfaceValues": [120.0, 150.0, 200.0],
    "LightPreset": "Sun",
    "LightThroughCuts": 1,
    "LightTimeBudget": 1e4,
    "LightTolerance": 0.25,
    "MaxMemoryInBytes": 1 << 33,
    "MaximumImageSampleDistance": 5.0,
    "MinimumImageSampleDistance": 2.0,
    "OpaqueShadows": 1,
    "PickOpacityThreshold": 0.75,
    "PixelTolerance": 0.25,
    "ScalarOpacityUnitDistance": 2.5,
    "Shade": 1,
    "ShadowMethod": "Along Rays",
    "Specular": 0.5,
    "SpecularPower": 20.0,
    "UseCropping": 1,
    "ViewMode": "Cells",
    "ViewRange": [1.0, 30.0],
    "VolumetricScatteringBlending": 0.5,
}
UNSTRUCTURED = {**COMMON, "GeometryTolerance": 0.25, "OpacityLaw": "Structured", "ExactCompositing": 0,
                "UseDataPartitions": 0}
IMAGE = {**COMMON, "OpacityLaw": "Unstructured", "InterpolationType": "Nearest", "SampleDistance": 0.5,
         "UseJittering": 1}
# Set after all of them, one after the other, so that each shows in some picture.
STEPS = (
    {},
    {"ViewMode": "Picture"},
    {"BlendMode": "Composite", "ErrorBudget": 0.0, "FrameTimeBudget": 0.0},
    {"UseCropping": 0, "AccuracyLevel": "Accurate", "BlendMode": "Average Intensity"},
)
# Not values: the input once more, and a function that the colour map has.
PROXIES = ("DummyInput", "ScalarOpacityFunction")


def values_of(display):
    """What can be set of the display, without prefixes and proxies."""
    found = {}
    for name in display.ListProperties():
        short = name[len(PREFIX):]
        if name.startswith(PREFIX) and short not in PROXIES:
            if not display.GetProperty(name).SMProperty.GetInformationOnly():
                value = display.GetProperty(name).GetData()
                found[short] = list(value) if isinstance(value, (list, tuple)) else value
    return found


def make_scene(modifying=contextlib.nullcontext):
    """[(view, display, values), ...]: a mesh and an image, each in a view of its own; no value is set yet.

    `modifying`, given a proxy, makes what surrounds changes of its properties, to trace them.
    """
    simple._DisableFirstRenderCameraReset()
    wavelet = simple.Wavelet(registrationName="wavelet", WholeExtent=[-8, 8] * 3)
    mesh = simple.Tetrahedralize(registrationName="mesh", Input=wavelet)
    scene = []
    for source, kind, values in ((mesh, "UnstructuredGridRepresentation", UNSTRUCTURED),
                                 (wavelet, "UniformGridRepresentation", IMAGE)):
        view = simple.CreateView("RenderView")
        with modifying(view):
            make_plain(view)
            view.ViewSize = [200, 160]
            view.CameraPosition = [30.0, 22.0, 26.0]
            view.CameraFocalPoint = [0.0, 0.0, 0.0]
            view.CameraViewUp = [0.0, 1.0, 0.0]
        scene.append((view, show(source, view, ARRAY, kind=kind), values))
    colours = simple.GetColorTransferFunction(ARRAY)
    opacity = simple.GetOpacityTransferFunction(ARRAY)
    with modifying(colours):
        colours.RGBPoints = [40.0, 0.1, 0.2, 0.9, 150.0, 0.9, 0.9, 0.2, 280.0, 0.9, 0.1, 0.1]
    with modifying(opacity):
        opacity.Points = [40.0, 0.0, 0.5, 0.0, 150.0, 0.2, 0.5, 0.0, 280.0, 0.9, 0.5, 0.0]
    return scene


def set_values(display, values):
    for name, value in values.items():
        setattr(display, PREFIX + name, value)
