# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Load the plugin into pvpython, draw the golf ball, follow ParaView's own colour and opacity controls."""
import tempfile

from paraview import simple
from views import (REPRESENTATION, Watch, difference, figure_of, load_plugin, mapper_of, mean_difference, open_view,
                   parse_arguments, picture_in, picture_of, show, volume_of)

CELLS = 271607
ARRAY = "vorticity_mag"
# The wake's vorticity lies between 0.2 and 6, the wall's far above.
OPACITY = [0.2, 0.0, 0.5, 0.0, 6.0, 0.9, 0.5, 0.0]
COLOURS = [0.2, 0.1, 0.2, 0.8, 2.0, 0.9, 0.9, 0.9, 6.0, 0.8, 0.1, 0.1]
# Rays towards lights take their time.
LIT_SIZE = [160, 120]
# Share of the picture's pixels.
SEEN = 0.3
# Mean over all channels, of 255. Projected tetrahedra sort roughly: see their speckles on the ball.
STOCK_DIFFERENCE = 15.0


def check_mapper(display):
    mapper = mapper_of(display).GetClassName()
    assert mapper == "vtkTetMarchVolumeMapper", mapper


def check_volume(watch):
    """The volume is seen, and nothing else, and like ParaView's own."""
    shown = watch.picture
    watch.display.Visibility = 0
    hidden = watch.look()
    assert len(set(hidden)) == 1, "something else than the volume is in view"
    share = difference(hidden, shown)
    print(f"the volume covers {100 * share:.1f} % of the picture")
    assert share > SEEN, "the volume is not to be seen"

    watch.display.Visibility = 1
    watch.expect_same(shown)

    watch.display.SetRepresentationType("Volume")
    mean = mean_difference(shown, watch.look())
    print(f"ParaView's own volume rendering differs by {mean:.1f} of 255 in the mean")
    assert mean < STOCK_DIFFERENCE, "the colour map, the opacity or their scale isn't shared"
    watch.display.SetRepresentationType(REPRESENTATION)
    watch.expect_same(shown)


def picture_by(watch, source, array, component, expression):
    """Of that expression of the coordinates."""
    calculator = simple.Calculator(Input=source, ResultArrayName=array, Function=expression)
    display = simple.Show(calculator, watch.view, "UnstructuredGridRepresentation")
    simple.ColorBy(display, ("POINTS", array, component) if component else ("POINTS", array))
    simple.GetColorTransferFunction(array).RGBPoints = [-1.0, 1.0, 0.1, 0.0, 1.0, 0.1, 0.9, 0.3, 4.0, 0.2, 0.1, 1.0]
    simple.GetOpacityTransferFunction(array).Points = [-1.0, 0.1, 0.5, 0.0, 4.0, 0.9, 0.5, 0.0]
    display.SetRepresentationType(REPRESENTATION)
    display.ScalarOpacityUnitDistance = 1.0
    picture = picture_of(watch.view)
    simple.Delete(calculator)
    return picture


def check_vectors(watch, source):
    """Of a vector that is drawn which it is coloured by."""
    watch.display.Visibility = 0
    seen = []
    for component, expression in (("Magnitude", "mag(coords)"), ("X", "coordsX"), ("Z", "coordsZ")):
        vector = picture_by(watch, source, "vector", component, "coords")
        share = difference(vector, picture_by(watch, source, "scalar", None, expression))
        print(f"{component}: {100 * share:.1f} % of the pixels differ from those of {expression}")
        assert share < 0.001, f"{component} is not what is drawn of a vector"
        assert vector not in seen, "another component is the same"
        seen.append(vector)
    watch.display.Visibility = 1
    watch.look()


def check_light(watch):
    """On a volume whose light is that of the view's light kit: key, fill, back lights and headlight."""
    size = list(watch.view.ViewSize)
    watch.view.ViewSize = LIT_SIZE
    unlit = watch.look()
    matt = watch.expect_brightness(0.2, 0.95, unlit, Shade=1, Ambient=0, Diffuse=1, Specular=0)
    watch.expect_brightness(0.48, 0.52, matt, Diffuse=0.5)
    watch.expect_brightness(0.48, 0.52, unlit, Diffuse=0, Ambient=0.5)
    watch.expect_same(unlit, Ambient=1)
    assert all(min(pixel) == max(pixel) for pixel in watch.set(ViewMode="Illumination")), "ambient light has a colour"
    watch.set(ViewMode="Picture")
    watch.expect_brightness(0.001, 0.5, unlit, Ambient=0, Specular=1)
    watch.expect_brightness(1.5, 1000, watch.picture, SpecularPower=5)
    watch.expect_same(matt, Specular=0, Diffuse=1)

    faceted = watch.set(GradientType="Cell")
    assert difference(matt, faceted) > 0.01, "gradients of cells light like those of vertices"
    watch.expect_same(matt, GradientType="Vertex")

    shadowed = watch.expect_brightness(0.1, 0.95, matt, ShadowMethod="At Vertices")
    watch.expect_same(shadowed, ShadowMethod="Automatic")  # there are more points along rays than vertices
    watch.expect_brightness(0.9, 1.1, shadowed, ShadowMethod="Along Rays")
    # Of the light kit, only the headlight then still casts shadows: they cost nothing.
    watch.expect_brightness(0.9, 0.99, matt, ShadowMethod="At Vertices", GlobalIlluminationReach=0)
    watch.expect_brightness(1.01, 100, shadowed, GlobalIlluminationReach=0.1)
    watch.expect_same(shadowed, GlobalIlluminationReach=1)
    check_opaque_shadows(watch, shadowed)
    scattered = watch.expect_brightness(1.05, 100, shadowed, VolumetricScatteringBlending=2)
    watch.expect_same(scattered, ShadowMethod="Off")
    watch.expect_same(matt, VolumetricScatteringBlending=0)

    watch.expect_same(unlit, Ambient=1, Diffuse=0)
    occluded = watch.expect_brightness(0.2, 0.97, unlit, AmbientOcclusion=1)
    watch.expect_brightness(1.02, 100, occluded, AmbientOcclusionRadius=0.02)
    watch.expect_same(occluded, AmbientOcclusionRadius=0.1)
    assert watch.set(AmbientOcclusionDirections=1) != occluded, "one direction occludes as sixteen do"
    watch.expect_brightness(0.99, 1.01, unlit, AmbientOcclusionRadius=0)
    watch.expect_same(unlit, Shade=0, Ambient=0, Diffuse=1)
    watch.view.ViewSize = size
    watch.look()


def check_opaque_shadows(watch, shadowed):
    """Of a roof that keeps the key light off, out of sight."""
    roof = simple.Plane(Origin=[-9, -9, 4], Point1=[11, -9, 4], Point2=[-9, 11, 4])
    shown = simple.Show(roof, watch.view)
    watch.expect_brightness(0.995, 1.005, shadowed)
    dark = watch.expect_brightness(0.1, 0.9, shadowed, OpaqueShadows=1)
    for name, on, off in (("Representation", "Surface", "Wireframe"), ("Visibility", 1, 0)):
        setattr(shown, name, off)
        watch.expect_brightness(0.995, 1.005, shadowed)
        setattr(shown, name, on)
        watch.expect_brightness(0.995, 1.005, dark)
    simple.Delete(roof)
    watch.expect_brightness(0.995, 1.005, shadowed, OpaqueShadows=0)


def check_translucent_surface(watch):
    """In the middle of the wake: all but invisible it changes nothing, all but opaque it is an opaque one."""
    alone = watch.picture
    plane = simple.Plane(Origin=[-9, 0, -9], Point1=[11, 0, -9], Point2=[-9, 0, 9])
    shown = simple.Show(plane, watch.view)
    watch.expect_change("opaque surface")
    opaque = watch.picture
    for opacity, like in ((0.99, opaque), (0.01, alone)):
        shown.Opacity = opacity
        mean = mean_difference(like, watch.look())
        print(f"a surface of opacity {opacity}: the picture differs by {mean:.2f} of 255 in the mean")
        assert mean < 4, f"the volume isn't drawn before and behind a surface of opacity {opacity}"
    simple.Delete(plane)
    watch.expect_same(alone)


def check_colour_map(watch):
    simple.GetOpacityTransferFunction(ARRAY).Points = [
        0.3 * value if i % 4 == 1 else value for i, value in enumerate(OPACITY)
    ]
    watch.expect_change("opacity function")
    simple.GetColorTransferFunction(ARRAY).RGBPoints = [
        1.0 - value if i % 4 else value for i, value in enumerate(COLOURS)
    ]
    watch.expect_change("colour function")
    watch.display.ScalarOpacityUnitDistance = 0.1
    watch.expect_change("unit distance")
    watch.expect_change_by(OpacityLaw="Structured")


def check_accuracy(watch):
    watch.expect_change_by(ErrorTolerance=1.0)
    careless = watch.picture
    watch.expect_change_by(AccuracyLevel="Reference")
    exact = watch.picture
    watch.expect_same(careless, ErrorBudget=1.0)  # is kept by that tolerance
    hurried = watch.set(ErrorBudget=0.0, FrameTimeBudget=1e-6)
    watch.expect_same(exact, FrameTimeBudget=0.0)  # without a budget the level is the one that is set
    watch.expect_same(hurried, AccuracyLevel="Fast")
    assert hurried != exact, "a budget of no time is not kept by the fastest level"


def check_views(watch):
    fast = watch.picture
    watch.expect_change_by(ViewMode="Cells")
    shown = [fast, watch.picture]
    watch.expect_change_by(AutomaticViewRange=0, ViewRange=[0.0, 1e4])
    for mode in ("Gradients", "Shell Faces", "Shell Coordinates"):
        shown.append(watch.set(ViewMode=mode))
        assert shown[-1] not in shown[:-1], f"the view mode {mode} shows what another does"
    watch.expect_same(fast, ViewMode="Picture")
    watch.expect_same(fast, DrawNanCells=1)  # all values are finite


def check_rest(watch):
    """At rest each pixel has its own ray, however little time VTK allocates. Interactive frames have fewer rays."""
    still = watch.picture
    # Cullers would set the multiplier by what the volume covers.
    watch.view.GetClientSideObject().GetRenderer().GetCullers().RemoveAllItems()
    volume_of(watch.display).SetRenderTimeMultiplier(1e-30)
    watch.view.SMProxy.InteractiveRender()
    assert figure_of(watch.display, "UsedImageSampleDistance") > 1, "there is enough time"
    watch.expect_same(still)
    watch.view.SMProxy.InteractiveRender()
    with tempfile.TemporaryDirectory() as folder:
        simple.SaveScreenshot(folder + "/rest.png", watch.view, ImageResolution=list(watch.view.ViewSize))
        assert picture_in(folder + "/rest.png") == still, "a saved picture has fewer rays"
    volume_of(watch.display).SetRenderTimeMultiplier(1.0)


def main():
    arguments = parse_arguments(__doc__, "data")
    load_plugin(arguments)

    source = simple.OpenDataFile(arguments.data)
    source.UpdatePipeline()
    cells = source.GetDataInformation().GetNumberOfCells()
    assert cells == CELLS, f"{cells} cells were read instead of {CELLS}"

    view = open_view()
    view.CameraPosition = [1.5, -4.5, 1.5]
    view.CameraFocalPoint = [1.2, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    display = show(source, view, ARRAY)
    simple.GetColorTransferFunction(ARRAY).RGBPoints = COLOURS
    simple.GetOpacityTransferFunction(ARRAY).Points = OPACITY
    display.ScalarOpacityUnitDistance = 0.3
    check_mapper(display)
    watch = Watch(view, display)
    if arguments.pictures:
        simple.SaveScreenshot(arguments.pictures + "/golfball.png", view)
    check_volume(watch)
    check_translucent_surface(watch)
    check_vectors(watch, source)
    check_light(watch)
    check_colour_map(watch)
    check_accuracy(watch)
    check_views(watch)
    check_rest(watch)


main()
