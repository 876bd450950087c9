# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scan of a bonsai in ParaView: beside its own volume rendering, and beside the mapper in a window of its own."""
import pathlib

from bonsai import ARRAY, CELLS, COLOURS, OPACITY, UNIT_DISTANCE, open_stock
from paraview import simple
from paraview.vtk.vtkCommonDataModel import vtkPiecewiseFunction
from paraview.vtk.vtkRenderingCore import (vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume,
                                           vtkVolumeProperty, vtkWindowToImageFilter)
from views import (REPRESENTATION, Watch, brightness, difference, figure_of, load_plugin, mapper_of, mean_difference,
                   parse_arguments, picture_of, pixels_of)

ROUNDING = 1  # of 255
# Mean over all channels, of 255. ParaView takes samples of 8 bits, and ends rays early.
STOCK_DIFFERENCE = 1.0
SEEN = 0.2  # share of the picture's pixels


def picture_by_mapper(mapper, data, camera, size):
    """Drawn by this mapper, with functions and a window that ParaView knows nothing of."""
    mapper.SetInputData(data)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray(ARRAY)
    colours = vtkColorTransferFunction()
    for i in range(0, len(COLOURS), 4):
        colours.AddRGBPoint(*COLOURS[i : i + 4])
    opacity = vtkPiecewiseFunction()
    for i in range(0, len(OPACITY), 2):
        opacity.AddPoint(*OPACITY[i : i + 2])
    prop = vtkVolumeProperty()
    prop.SetColor(colours)
    prop.SetScalarOpacity(opacity)
    prop.SetScalarOpacityUnitDistance(UNIT_DISTANCE)
    prop.SetInterpolationTypeToLinear()
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(prop)
    renderer = vtkRenderer()
    renderer.AddVolume(volume)
    renderer.GetActiveCamera().DeepCopy(camera)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.Update()
    return pixels_of(image.GetOutput())


def check_stock(view, display, before):
    """What ParaView has of its own is as it was without the plugin, and ours is offered beside it."""
    active = display.GetClientSideObject().GetActiveRepresentation()
    assert active.GetClassName() == "vtkImageVolumeRepresentation", active.GetClassName()
    available = list(display.GetProperty("Representation").Available)
    assert available.count("Volume") == 1 and available.count(REPRESENTATION) == 1, available
    stock = picture_of(view)
    assert any(any(pixel) for pixel in stock)
    assert b"".join(stock) == before, "the plugin changes ParaView's own volume rendering"
    return stock


def check_picture(watch, reader, stock):
    """Ours, to the rounding of bytes, is the mapper's own picture, and ParaView's within the error of that."""
    shown = watch.picture
    seen = sum(any(pixel) for pixel in shown) / len(shown)
    print(f"the volume covers {100 * seen:.1f} % of the picture")
    assert seen > SEEN, "the volume is not to be seen"
    mapper = mapper_of(watch.display)
    assert mapper.GetClassName() == "vtkTetMarchSmartVolumeMapper", mapper.GetClassName()
    camera = watch.view.GetClientSideObject().GetActiveCamera()
    alone = picture_by_mapper(mapper.NewInstance(), simple.servermanager.Fetch(reader), camera, watch.view.ViewSize)
    worst = max(abs(a - b) for p, q in zip(shown, alone) for a, b in zip(p, q))
    print(f"the mapper in a window of its own differs by {worst} of 255 at most")
    assert worst <= ROUNDING, "ParaView hands other data, functions or settings to the mapper"
    mean = mean_difference(shown, stock)
    print(f"ParaView's own volume rendering differs by {mean:.2f} of 255 in the mean")
    assert mean < STOCK_DIFFERENCE, "the colour map, the opacity or their scale isn't shared"
    watch.display.Visibility = 0
    assert len(set(watch.look())) == 1, "something else than the volume is in view"
    watch.display.Visibility = 1
    watch.expect_same(shown)
    watch.display.SetRepresentationType("Volume")
    assert watch.look() == stock
    watch.display.SetRepresentationType(REPRESENTATION)
    watch.expect_same(shown)


def information(display, name):
    display.UpdatePropertyInformation()
    return display.GetPropertyValue("TetMarch" + name)


def check_information(watch):
    display = watch.display
    assert information(display, "NumberOfLatticeCells") == CELLS
    assert CELLS < information(display, "GPUMemoryBytes") < 100 * CELLS
    assert information(display, "TimeToDraw") > 0
    assert information(display, "LightComplete") == 1
    assert information(display, "UsedAccuracyLevel") == 1
    assert abs(information(display, "UsedErrorTolerance") - 1 / 255) < 1e-12
    watch.set(AccuracyLevel="Accurate")
    assert information(display, "UsedAccuracyLevel") == 2
    assert information(display, "UsedErrorTolerance") == 1 / 4096
    watch.set(AccuracyLevel="Default", FrameTimeBudget=1e-6)
    assert information(display, "UsedAccuracyLevel") == 0 and information(display, "BudgetKept") == 0
    watch.set(FrameTimeBudget=0)
    assert information(display, "BudgetKept") == 1


def check_samples(watch, stock):
    """At the level of samples the picture is nearer to ParaView's, the more so the finer they are."""
    exact = watch.picture
    adjusted = watch.set(AccuracyLevel="Sampled")
    watch.expect_same(adjusted, SampleDistance=8.0)
    errors = []
    watch.set(AutoAdjustSampleDistances=0)
    for distance in (8.0, 2.0, 0.25):
        errors.append(mean_difference(exact, watch.set(SampleDistance=distance)))
    print("samples 8, 2 and 0.25 apart differ from the integral by", errors)
    assert errors[0] > 2 * errors[1] > 4 * errors[2], errors
    rings = watch.set(SampleDistance=8.0)
    assert difference(rings, watch.set(UseJittering=1)) > 0.01, "jitter changes nothing"
    as_stock = watch.set(SampleDistance=-1.0, UseJittering=0)
    assert mean_difference(as_stock, stock) < STOCK_DIFFERENCE
    watch.expect_same(exact, AccuracyLevel="Default", AutoAdjustSampleDistances=1)


def check_light(watch):
    unlit = watch.picture
    matt = watch.expect_brightness(0.2, 0.95, unlit, Shade=1, Ambient=0, Diffuse=1, Specular=0)
    watch.expect_brightness(0.48, 0.52, matt, Diffuse=0.5)
    watch.expect_same(unlit, Diffuse=0, Ambient=1)
    occluded = watch.expect_brightness(0.2, 0.97, unlit, AmbientOcclusion=1)
    watch.expect_brightness(1.01, 100, occluded, AmbientOcclusionRadius=0.02)
    watch.expect_same(matt, AmbientOcclusion=0, AmbientOcclusionRadius=0.1, Ambient=0, Diffuse=1)
    watch.expect_brightness(1.02, 100, matt, Specular=1, SpecularPower=5)
    watch.expect_same(matt, Specular=0, SpecularPower=100)
    assert watch.set(GradientType="Cell") != matt, "gradients of cells light like those of points"
    watch.expect_same(matt, GradientType="Vertex")
    shadowed = watch.expect_brightness(0.1, 0.95, matt, ShadowMethod="At Vertices")
    watch.expect_brightness(1.01, 100, shadowed, GlobalIlluminationReach=0.05)
    watch.expect_same(shadowed, GlobalIlluminationReach=1)
    check_opaque_shadows(watch, shadowed)
    scattered = watch.expect_brightness(1.05, 100, shadowed, VolumetricScatteringBlending=2)
    watch.expect_same(scattered, ShadowMethod="Off")  # which casts shadows, too
    watch.expect_same(matt, VolumetricScatteringBlending=0)
    # What "Volume" has of these names is its own.
    for name, value, default in (("VolumetricScatteringBlending", 1.0, 0.0), ("GlobalIlluminationReach", 0.5, 0.0),
                                 ("BlendMode", "Isosurface", "Composite"), ("UseCropping", 1, 0),
                                 ("UseTransfer2D", 1, 0)):
        setattr(watch.display, name, value)
        watch.expect_same(matt)
        setattr(watch.display, name, default)
    watch.expect_same(unlit, Shade=0)


def check_opaque_shadows(watch, shadowed):
    roof = simple.Plane(Origin=[-300, 600, -300], Point1=[600, 600, -300], Point2=[-300, 600, 600])
    simple.Show(roof, watch.view)
    watch.expect_brightness(0.995, 1.005, shadowed)
    watch.expect_brightness(0.1, 0.9, shadowed, OpaqueShadows=1)
    simple.Delete(roof)
    watch.expect_same(shadowed, OpaqueShadows=0)


def check_views(watch):
    picture = watch.picture
    shown = [picture]
    for mode in ("Cells", "Error Bound", "Lookups", "Gradients"):
        shown.append(watch.set(ViewMode=mode))
        assert shown[-1] not in shown[:-1], f"the view mode {mode} shows what another does"
    # The legend, beside the volume, is of the views that draw a measure.
    watch.set(ViewMode="Cells")
    with_legend = sum(pixel != watch.picture[0] for pixel in watch.picture)
    watch.display.Visibility = 0
    assert len(set(watch.look())) == 1, "the legend of a hidden volume is in view"
    watch.display.Visibility = 1
    watch.set(ViewMode="Gradients")
    assert with_legend > sum(pixel != watch.picture[0] for pixel in watch.picture), "there is no legend"
    watch.expect_same(picture, ViewMode="Picture")


def check_place(watch):
    """A volume that is moved takes the camera with it, and looks as before."""
    before = watch.picture
    simple.ResetCamera(watch.view)
    focus = list(watch.view.CameraFocalPoint)
    unmoved = picture_of(watch.view)
    place = "Translation" if "Translation" in watch.display.ListProperties() else "Position"  # before 5.13
    setattr(watch.display, place, [100.0, 0.0, 0.0])
    simple.ResetCamera(watch.view)
    moved = [a - b for a, b in zip(watch.view.CameraFocalPoint, focus)]
    assert max(abs(a - b) for a, b in zip(moved, [100.0, 0.0, 0.0])) < 1e-6, moved
    assert mean_difference(picture_of(watch.view), unmoved) < 0.2
    setattr(watch.display, place, [0.0, 0.0, 0.0])
    assert brightness(before) > 0


def main():
    arguments = parse_arguments(__doc__, "data", "stock")
    load_plugin(arguments)
    reader, view, display = open_stock(arguments.data)
    stock = check_stock(view, display, pathlib.Path(arguments.stock).read_bytes())
    display.SetRepresentationType(REPRESENTATION)
    watch = Watch(view, display)
    if arguments.pictures:
        simple.SaveScreenshot(arguments.pictures + "/bonsai.png", view)
    check_picture(watch, reader, stock)
    check_information(watch)
    check_samples(watch, stock)
    check_light(watch)
    check_views(watch)
    linear = watch.picture
    assert difference(linear, watch.set(InterpolationType="Nearest")) > 0.05, "cells around points look trilinear"
    assert figure_of(display, "NumberOfLatticeCells") == (127 + 1) ** 3
    watch.expect_same(linear, InterpolationType="Linear")
    check_place(watch)


main()
