# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of opaque surfaces as pages, and VTK's pictures of them: surface_scenes.py FOLDER

NAME.html and NAME.png are written into the folder, and what the exporter says is left out into NAME.txt.
"""
import pathlib
import sys

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401: the window's implementation
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPiecewiseFunction
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkLineSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkCompositeDataDisplayAttributes, vtkDataSetMapper, vtkLight, vtkLightKit,
    vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkVolume, vtkWindowToImageFilter)

from vtktetmarch.vtkRenderingTetMarch import vtkTetMarchSmartVolumeMapper, vtkTetMarchWebExporter

try:
    from vtkmodules.vtkRenderingOpenGL2 import vtkCompositePolyDataMapper2 as CompositeMapper
except ImportError:  # VTK 9.6
    from vtkmodules.vtkRenderingCore import vtkCompositePolyDataMapper as CompositeMapper


def made(source):
    source.Update()
    return source.GetOutput()


def ball(**settings):
    source = vtkSphereSource()
    for name, value in {"ThetaResolution": 24, "PhiResolution": 16, **settings}.items():
        getattr(source, f"Set{name}")(value)
    return made(source)


def with_heights(data):
    heights = vtkElevationFilter()
    heights.SetInputData(data)
    heights.SetLowPoint(0, -0.5, 0)
    heights.SetHighPoint(0, 0.5, 0.1)
    return made(heights)


def cube():
    data = made(vtkCubeSource())
    numbers = vtkFloatArray()
    for i in range(6):
        numbers.InsertNextValue(i / 5)
    data.GetCellData().SetScalars(numbers)
    return data


def plane():
    source = vtkPlaneSource()
    source.SetOrigin(-1, -1.2, -1)
    source.SetPoint1(4, -1.2, -1)
    source.SetPoint2(-1, 2, -1)
    return made(source)


def add(renderer, data, position, mapper=vtkPolyDataMapper, **properties):
    actor = vtkActor()
    actor.SetMapper(mapper())
    actor.GetMapper().SetInputDataObject(data)
    actor.SetPosition(*position)
    for name, value in properties.items():
        getattr(actor.GetProperty(), f"Set{name}")(value)
    renderer.AddActor(actor)
    return actor


def add_materials(renderer):
    add(renderer, ball(), (0, 0, 0), Color=(0.8, 0.3, 0.2), Specular=0.6, SpecularPower=20, Ambient=0.1)
    squeezed = add(renderer, ball(), (0, 1.2, 0), Color=(0.2, 0.7, 0.3), Interpolation=0)
    squeezed.SetScale(1, 0.7, 0.4)
    squeezed.RotateZ(30)
    add(renderer, ball(), (1.2, 1.2, 0), Color=(0.9, 0.9, 0.2), Lighting=False, Ambient=0.2, Diffuse=0.7)
    add(renderer, ball(StartTheta=90, EndTheta=300), (2.5, 2, 0), DiffuseColor=(0.9, 0.5, 0.1), AmbientColor=(0, 0, 1),
        Ambient=0.3, Specular=0.3)
    add(renderer, ball(StartTheta=90, EndTheta=300), (3.6, 2, 0), BackfaceCulling=True)
    add(renderer, plane(), (0, 0, 0), Color=(0.5, 0.5, 0.9))


def add_scalars(renderer):
    add(renderer, with_heights(ball()), (0, 0, 0))
    interpolated = add(renderer, with_heights(ball(ThetaResolution=8)), (1.2, 0, 0)).GetMapper()
    interpolated.InterpolateScalarsBeforeMappingOn()
    interpolated.SetScalarRange(0.2, 0.9)
    add(renderer, cube(), (2.6, 0.2, 0)).RotateWXYZ(40, 1, 1, 0)
    image = vtkRTAnalyticSource()
    image.SetWholeExtent(0, 4, 0, 4, 0, 4)
    of_image = add(renderer, made(image), (0, 1, 0), vtkDataSetMapper)
    of_image.GetMapper().SetScalarRange(100, 250)
    of_image.SetScale(0.15)
    blocks = vtkMultiBlockDataSet()
    for i in range(2):
        blocks.SetBlock(i, ball(Center=(1.5 + i, 1.5, 0)))
    attributes = vtkCompositeDataDisplayAttributes()
    attributes.SetBlockColor(blocks.GetBlock(1), (1, 0, 1))
    of_blocks = add(renderer, blocks, (0, 0, 0), CompositeMapper).GetMapper()
    of_blocks.SetCompositeDataDisplayAttributes(attributes)


def add_lights(renderer):
    vtkLightKit().AddLightsToRenderer(renderer)
    red = vtkLight()
    red.SetPosition(-3, 4, 2)
    red.SetFocalPoint(0, 1, 0)
    red.SetColor(1, 0.2, 0.2)
    red.SetIntensity(0.6)
    renderer.AddLight(red)


def add_volume(renderer):
    image = vtkRTAnalyticSource()
    mapper = vtkTetMarchSmartVolumeMapper()
    mapper.SetInputData(made(image))
    colors, opacities = vtkColorTransferFunction(), vtkPiecewiseFunction()
    for value, color, opacity in (40, (0, 0, 1), 0), (270, (1, 0.5, 0), 0.4):
        colors.AddRGBPoint(value, *color)
        opacities.AddPoint(value, opacity)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.GetProperty().SetColor(colors)
    volume.GetProperty().SetScalarOpacity(opacities)
    volume.SetScale(0.08)
    volume.SetPosition(1.5, 0.5, 0.3)
    renderer.AddVolume(volume)


def add_line(renderer):
    add(renderer, made(vtkLineSource()), (9, 9, 9))


SCENES = {
    "materials": [add_materials],
    "scalars": [add_scalars],
    "lights": [add_materials, add_lights],
    "volume": [add_materials, add_volume],
    "omission": [add_scalars, add_line],
}


def write(path, parts, parallel):
    renderer = vtkRenderer()
    renderer.SetBackground(0.1, 0.2, 0.3)
    window = vtkRenderWindow()
    window.SetMultiSamples(0)
    window.SetSize(400, 300)
    window.AddRenderer(renderer)
    for part in parts:
        part(renderer)
    renderer.ResetCamera(-1, 4, -1.2, 2.5, -1, 1)
    camera = renderer.GetActiveCamera()
    camera.Azimuth(20)
    camera.Elevation(15)
    camera.SetParallelProjection(parallel)
    window.Render()
    picture, writer = vtkWindowToImageFilter(), vtkPNGWriter()
    picture.SetInput(window)
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetFileName(f"{path}.png")
    writer.Write()
    exporter = vtkTetMarchWebExporter()
    exporter.SetRenderWindow(window)
    exporter.SetFileName(f"{path}.html")
    exporter.Write()
    pathlib.Path(f"{path}.txt").write_text(exporter.GetOmissions())
    return window


if __name__ == "__main__":
    # A window that ends closes the display of the others.
    windows = [write(pathlib.Path(sys.argv[1]) / f"{name}{'_parallel' if parallel else ''}", parts, parallel)
               for name, parts in SCENES.items() for parallel in (False, True)]
