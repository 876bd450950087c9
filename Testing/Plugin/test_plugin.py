# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Load the plugin into pvpython, draw the golf ball, follow ParaView's own colour and opacity controls."""
import argparse

from paraview import simple

REPRESENTATION = "Tet Marching"
CELLS = 271607
ARRAY = "vorticity_mag"
# The wake's vorticity lies between 0.2 and 6, the wall's far above.
OPACITY = [0.2, 0.0, 0.5, 0.0, 6.0, 0.9, 0.5, 0.0]
COLOURS = [0.2, 0.1, 0.2, 0.8, 2.0, 0.9, 0.9, 0.9, 6.0, 0.8, 0.1, 0.1]
# Shares of the picture's pixels.
SEEN = 0.3
CHANGED = 0.2
# Mean over all channels, of 255. Projected tetrahedra sort roughly: see their speckles on the ball.
STOCK_DIFFERENCE = 15.0


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--plugin", required=True)
    parser.add_argument("--data", required=True)
    parser.add_argument("--picture", help="where to leave the picture")
    return parser.parse_args()


def open_view():
    simple._DisableFirstRenderCameraReset()
    view = simple.CreateView("RenderView")
    view.ViewSize = [400, 300]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.0, 0.0, 0.0]
    view.CameraPosition = [1.5, -4.5, 1.5]
    view.CameraFocalPoint = [1.2, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    return view


def show(source, view):
    display = simple.Show(source, view, "UnstructuredGridRepresentation")
    simple.ColorBy(display, ("POINTS", ARRAY))
    simple.GetColorTransferFunction(ARRAY).RGBPoints = COLOURS
    simple.GetOpacityTransferFunction(ARRAY).Points = OPACITY
    available = display.GetProperty("Representation").Available
    assert REPRESENTATION in available, f"{REPRESENTATION} is not among {available}"
    display.SetRepresentationType(REPRESENTATION)
    display.ScalarOpacityUnitDistance = 0.3
    return display


def picture_of(view):
    image = view.SMProxy.CaptureWindow(1)
    values = memoryview(image.GetPointData().GetScalars()).tobytes()
    channels = image.GetPointData().GetScalars().GetNumberOfComponents()
    return [values[i : i + 3] for i in range(0, len(values), channels)]


def difference(first, second):
    """Share of pixels that differ by more than 4 of 255 in some channel."""
    assert len(first) == len(second)
    differs = (any(abs(a - b) > 4 for a, b in zip(p, q)) for p, q in zip(first, second))
    return sum(differs) / len(first)


def mean_difference(first, second):
    total = sum(abs(a - b) for p, q in zip(first, second) for a, b in zip(p, q))
    return total / (3 * len(first))


def check_mapper(display):
    representation = display.GetClientSideObject().GetActiveRepresentation()
    mapper = representation.GetActiveVolumeMapper().GetClassName()
    assert mapper == "vtkTetMarchVolumeMapper", mapper


def expect_change(what, before, after):
    share = difference(before, after)
    print(f"{what}: {100 * share:.1f} % of the pixels changed")
    assert share > CHANGED, f"{what}: the picture stayed as it was"


def main():
    arguments = parse_arguments()
    simple.LoadPlugin(arguments.plugin, remote=False, ns=globals())

    source = simple.OpenDataFile(arguments.data)
    source.UpdatePipeline()
    cells = source.GetDataInformation().GetNumberOfCells()
    assert cells == CELLS, f"{cells} cells were read instead of {CELLS}"

    view = open_view()
    display = show(source, view)
    check_mapper(display)
    shown = picture_of(view)
    if arguments.picture:
        simple.SaveScreenshot(arguments.picture, view)

    display.Visibility = 0
    hidden = picture_of(view)
    assert len(set(hidden)) == 1, "something else than the volume is in view"
    share = difference(hidden, shown)
    print(f"the volume covers {100 * share:.1f} % of the picture")
    assert share > SEEN, "the volume is not to be seen"

    display.Visibility = 1
    assert difference(shown, picture_of(view)) == 0, "the same view gave another picture"

    display.SetRepresentationType("Volume")
    mean = mean_difference(shown, picture_of(view))
    print(f"ParaView's own volume rendering differs by {mean:.1f} of 255 in the mean")
    assert mean < STOCK_DIFFERENCE, "the colour map, the opacity or their scale isn't shared"
    display.SetRepresentationType(REPRESENTATION)

    simple.GetOpacityTransferFunction(ARRAY).Points = [
        0.3 * value if i % 4 == 1 else value for i, value in enumerate(OPACITY)
    ]
    thinner = picture_of(view)
    expect_change("opacity function", shown, thinner)

    simple.GetColorTransferFunction(ARRAY).RGBPoints = [
        1.0 - value if i % 4 else value for i, value in enumerate(COLOURS)
    ]
    recoloured = picture_of(view)
    expect_change("colour function", thinner, recoloured)

    display.ScalarOpacityUnitDistance = 0.1
    denser = picture_of(view)
    expect_change("unit distance", recoloured, denser)

    display.TetMarchOpacityLaw = "Structured"
    structured = picture_of(view)
    expect_change("opacity law", denser, structured)

    display.TetMarchErrorTolerance = 1.0
    careless = picture_of(view)
    expect_change("error tolerance", structured, careless)
    display.TetMarchAccuracyLevel = "Reference"
    exact = picture_of(view)
    expect_change("accuracy level", careless, exact)

    display.TetMarchErrorBudget = 1.0
    assert careless == picture_of(view), "an error budget is not kept by that tolerance"
    display.TetMarchErrorBudget = 0.0
    display.TetMarchFrameTimeBudget = 1e-6
    hurried = picture_of(view)
    display.TetMarchFrameTimeBudget = 0.0
    assert exact == picture_of(view), "without a budget the level is not the one that is set"
    display.TetMarchAccuracyLevel = "Fast"
    assert hurried == picture_of(view) != exact, "a budget of no time is not kept by the fastest level"

    fast = picture_of(view)
    display.TetMarchViewMode = "Cells"
    counted = picture_of(view)
    expect_change("view mode", fast, counted)
    display.TetMarchAutomaticViewRange = 0
    display.TetMarchViewRange = [0.0, 1e4]
    expect_change("view range", counted, picture_of(view))
    shown = [fast, counted]
    for mode in ("Gradients", "Shell Faces", "Shell Coordinates"):
        display.TetMarchViewMode = mode
        shown.append(picture_of(view))
        assert shown[-1] not in shown[:-1], f"the view mode {mode} shows what another does"
    display.TetMarchViewMode = "Picture"
    assert fast == picture_of(view), "something of a view mode is left in the picture"


main()
