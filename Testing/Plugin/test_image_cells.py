# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which arrays, components, cells and blocks of images are drawn and selected, and what has no cells."""
import math

from lattices import ARRAY, blocks, image, lattice, rectilinear, source_of, values_of
from paraview import simple
from paraview.vtk import vtkImageData, vtkPartitionedDataSet
from views import (difference, figure_of, load_plugin, mapper_of, open_view, parse_arguments, picture_of, selected,
                   set_all, show)

N = 4  # cubes along each axis
PIXELS = 40  # along each of them
ROW = N * PIXELS
OPACITY = 0.5
UNIT_DISTANCE = 8.0
ROUNDING = 1  # of 255
KIND = "UniformGridRepresentation"
TRANSMITTANCE = (1 - OPACITY) ** (N / UNIT_DISTANCE)


def open_scene():
    """Looking down z, in parallel: N cubes fill the view."""
    view = open_view()
    view.ViewSize = [ROW] * 2
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = [N / 2] * 3
    view.CameraPosition = [N / 2, N / 2, 10 * N]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelScale = N / 2
    return view


def use_functions(array=ARRAY, opacity=(OPACITY, OPACITY)):
    """From green to red as values go from 0 to N, of this opacity there."""
    colours = simple.GetColorTransferFunction(array)
    colours.ColorSpace = "RGB"
    colours.Discretize = 0
    colours.RGBPoints = [0.0, 0.0, 1.0, 0.0, float(N), 1.0, 0.0, 0.0]
    first, last = opacity
    simple.GetOpacityTransferFunction(array).Points = [0.0, first, 0.5, 0.0, float(N), last, 0.5, 0.0]


def open_display(view, data, array=ARRAY, association="POINTS", kind=KIND):
    source = source_of(data)
    display = show(source, view, array, association, kind)
    use_functions(array)
    display.ScalarOpacityUnitDistance = UNIT_DISTANCE
    return source, display


def expect_values(view, expected, what):
    """In the middle row, at these places along x, the colour of these values."""
    picture = picture_of(view)
    row = ROW // 2 * ROW
    for place, value in expected.items():
        pixel = picture[row + int(place * PIXELS)]
        # The middle of its pixel is up to a pixel off, which is less than the rounding.
        red = value / N * 255 * (1 - TRANSMITTANCE)
        green = (1 - value / N) * 255 * (1 - TRANSMITTANCE)
        off = max(abs(pixel[0] - red), abs(pixel[1] - green), pixel[2])
        assert off <= ROUNDING, (what, place, tuple(pixel), red, green)
    print(f"{what}: {len(expected)} places have the colours of their values")


def check_association(view):
    """Values of points and of cells, trilinear and constant."""
    of_cells = values_of(image((N, N, N), lambda x, y, z: x), [float(i % N) for i in range(N**3)], "of_cells", True)
    source, display = open_display(view, of_cells)
    linear = {0.1: 0.1, 1.0: 1.0, 2.5: 2.5, 3.9: 3.9}
    expect_values(view, linear, "linear values of points")
    set_all(display, {"InterpolationType": "Nearest"})
    expect_values(view, {0.1: 0, 0.45: 0, 0.55: 1, 1.45: 1, 2.55: 3, 3.9: 4}, "constant cells around points")
    assert figure_of(display, "NumberOfLatticeCells") == (N + 1) ** 3
    simple.ColorBy(display, ("CELLS", "of_cells"))
    use_functions("of_cells")
    display.ScalarOpacityUnitDistance = UNIT_DISTANCE
    expect_values(view, {0.05: 0, 0.95: 0, 1.05: 1, 2.5: 2, 3.95: 3}, "constant cells")
    assert figure_of(display, "NumberOfLatticeCells") == N**3
    set_all(display, {"InterpolationType": "Linear"})
    # Between the middles of cells; beyond the outermost ones values stay as they are.
    expect_values(view, {0.1: 0, 0.5: 0, 1.0: 0.5, 1.5: 1, 2.25: 1.75, 3.5: 3, 3.9: 3}, "linear values of cells")
    simple.Delete(source)


def check_rectilinear(view):
    """Planes have their own places: a linear field looks like that of an image, and of hexahedra."""
    planes = [[0.0, 0.3, 2.0, 3.5, 4.0], [0.0, 1.0, 4.0], [0.0, 3.9, 4.0]]

    def field(x, y, z):
        return (x + y + 2 * z) / 4

    pictures = []
    for data, kind in ((rectilinear(planes, field), KIND), (image((N, N, N), field), KIND),
                       (lattice((N, N, N), field), "UnstructuredGridRepresentation")):
        source, display = open_display(view, data, kind=kind)
        set_all(display, {"OpacityLaw": "Structured"})
        pictures.append(picture_of(view))
        simple.Delete(source)
    for other in pictures[1:]:
        worst = max(abs(a - b) for p, q in zip(pictures[0], other) for a, b in zip(p, q))
        print(f"a linear field on a rectilinear grid and on another: {worst} of 255 at most")
        assert worst <= ROUNDING


def check_components(view):
    """Of a vector is drawn what it is coloured by."""
    data = image((N, N, N), lambda x, y, z: 0.0)
    points = [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]
    values_of(data, points, "vector")
    values_of(data, [math.sqrt(sum(c * c for c in p)) / 2 for p in points], "half")
    values_of(data, [p[0] for p in points], "X")
    values_of(data, [p[2] for p in points], "Z")
    seen = []
    for component, scalar in (("Magnitude", "half"), ("X", "X"), ("Z", "Z")):
        source, _ = open_display(view, data, scalar)
        expected = picture_of(view)
        display = show(source, view, "vector", kind=KIND)
        simple.ColorBy(display, ("POINTS", "vector", component))
        use_functions("vector")
        if component == "Magnitude":  # twice as large
            colours = simple.GetColorTransferFunction("vector")
            colours.RGBPoints = [0.0, 0.0, 1.0, 0.0, 2.0 * N, 1.0, 0.0, 0.0]
            simple.GetOpacityTransferFunction("vector").Points = [0.0, OPACITY, 0.5, 0.0, 2.0 * N, OPACITY, 0.5, 0.0]
        drawn = picture_of(view)
        assert difference(drawn, expected) == 0, f"{component} is not what is drawn of a vector"
        assert drawn not in seen, "another component is the same"
        seen.append(drawn)
        simple.Delete(source)


def expect_even(view, colour, what):
    expected = [255 * c for c in colour]
    found = set(picture_of(view))
    print(f"{what}: {sorted(map(tuple, found))} instead of {expected}")
    assert max(abs(a - b) for pixel in found for a, b in zip(pixel, expected)) <= ROUNDING, what


def check_dependent_components(view):
    """Colours as they are, and a component or an array of its own for opacity."""
    data = image((N, N, N), lambda x, y, z: 1.0)
    count = data.GetNumberOfPoints()
    values_of(data, [(0.2, 0.6, 1.0, 0.5)] * count, "direct")
    values_of(data, [(1.0, 3.0)] * count, "pair")
    values_of(data, [3.0] * count, "opacity")

    source, display = open_display(view, data, "direct")
    simple.GetOpacityTransferFunction("direct").Points = [0.0, 0.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]
    display.MapScalars = 0
    shade = 1 - 0.5 ** (N / UNIT_DISTANCE)
    expect_even(view, [c * shade for c in (0.2, 0.6, 1.0)], "red, green, blue and opacity")
    display.MapScalars = 1
    assert {tuple(pixel) for pixel in picture_of(view)} != {tuple(round(255 * c * shade) for c in (0.2, 0.6, 1.0))}
    simple.Delete(source)

    # Opacity goes from 0 to 0.8 with the second of them: of 3 it is 0.6.
    shade = 1 - 0.4 ** (N / UNIT_DISTANCE)
    expected = [c * shade for c in (1 / N, 1 - 1 / N, 0)]
    source, display = open_display(view, data, "pair")
    use_functions("pair", (0.0, 0.8))
    display.MultiComponentsMapping = 1
    expect_even(view, expected, "color and opacity")
    simple.Delete(source)

    source, display = open_display(view, data, ARRAY)
    use_functions(ARRAY, (0.0, 0.8))
    display.OpacityArrayName = ["POINTS", "opacity"]
    display.UseSeparateOpacityArray = 1
    expect_even(view, expected, "an array for opacity")
    simple.ColorBy(display, None)
    assert not any(any(pixel) for pixel in picture_of(view)), "something is drawn without an array"
    simple.Delete(source)


def check_no_cells(view):
    """One error that says why, and nothing else; what comes after is drawn."""
    for sizes in ((0, 0, N), (N, N, 0)):
        source = source_of(image(sizes, lambda x, y, z: x))
        display = show(source, view, ARRAY, kind=KIND)
        use_functions()
        errors = []

        def note(caller, event, text, errors=errors):
            errors.append(text)

        note.CallDataType = "string0"
        mapper_of(display).AddObserver("ErrorEvent", note)
        for _ in range(2):
            assert not any(any(pixel) for pixel in picture_of(view)), sizes
        points = " x ".join(str(n + 1) for n in sizes) + " points"
        assert len(errors) == 1 and points in errors[0] and "at least 2 along each axis" in errors[0], errors
        simple.Delete(source)
    source, _ = open_display(view, vtkImageData())
    assert not any(any(pixel) for pixel in picture_of(view))
    simple.Delete(source)
    source, display = open_display(view, image((N, N, N), lambda x, y, z: x))
    expect_values(view, {1.0: 1.0, 3.0: 3.0}, "an image after those without cells")
    simple.ColorBy(display, None)
    assert not any(any(pixel) for pixel in picture_of(view)), "something is drawn without an array"
    simple.Delete(source)


def cubes_across(first, last):
    """Pixels of cubes in x, all of them in y, but for their outermost pixels: left, bottom, right, top."""
    return [first * PIXELS + 2, 2, (last + 1) * PIXELS - 3, ROW - 3]


def layer(z, left=0, right=N, block=None):
    """Cells in that layer of an image that is `right - left` cubes wide."""
    width = right - left
    return {(block, cell + z * width * N) for cell in range(width * N)}


def check_selection(view):
    """Cells by the ids of the input, where rays have gathered the threshold's opacity; ghosts keep theirs."""
    data = image((N, N, N), lambda x, y, z: x)
    source, display = open_display(view, data)
    unselected = picture_of(view)
    for threshold in (0.0, 0.1, 0.2):
        set_all(display, {"PickOpacityThreshold": threshold})
        depth = math.log(1 - threshold) / math.log(1 - OPACITY) * UNIT_DISTANCE
        found = selected(source, view, cubes_across(0, N - 1))
        print(f"threshold {threshold}: {len(found)} cells at a depth of {depth:.2f}")
        assert found == layer(N - 1 - int(depth)), (threshold, sorted(found))
    simple.ClearSelection(source)
    assert picture_of(view) == unselected
    simple.Delete(source)

    ghosts = data.AllocateCellGhostArray()
    for _, cell in layer(N - 1):
        ghosts.SetValue(cell, 1)
    source, display = open_display(view, data)
    set_all(display, {"PickOpacityThreshold": 0.0})
    assert selected(source, view, cubes_across(0, N - 1)) == layer(N - 2), "ghosts are drawn, or cells renumbered"
    box = display.GetClientSideObject().GetActiveRepresentation().GetActor()
    assert box.GetBounds()[5] == N, box.GetBounds()
    simple.Delete(source)


def check_blocks(view):
    """Cut in two at x = 1 it is the same picture; blocks can be hidden, and keep their numbers."""
    def field(x, y, z):
        return x + 0.3 * y * z / N

    source, _ = open_display(view, image((N, N, N), field))
    whole = picture_of(view)
    simple.Delete(source)
    left = image((1, N, N), field)
    right = image((N - 1, N, N), field, origin=(1, 0, 0))
    parts = vtkPartitionedDataSet()
    parts.SetPartition(0, left)
    parts.SetPartition(1, right)
    for tree in (blocks(left=left, right=right), parts):
        source, display = open_display(view, tree, kind=None)
        assert display.SMProxy.GetXMLName() == KIND, display.SMProxy.GetXMLName()
        worst = max(abs(a - b) for p, q in zip(whole, picture_of(view)) for a, b in zip(p, q))
        print(f"{tree.GetClassName()}: {worst} of 255 at most between blocks and their whole")
        assert worst <= ROUNDING, "there is a seam between blocks"
        set_all(display, {"PickOpacityThreshold": 0.0})
        first = 2 if tree is not parts else 1
        found = selected(source, view, cubes_across(0, N - 1))
        assert found == layer(N - 1, 0, 1, first) | layer(N - 1, 1, N, first + 1), sorted(found)
        simple.ClearSelection(source)
        if tree is not parts:
            display.BlockSelectors = ["/Root/right"]
            part = picture_of(view)
            seen = sum(any(pixel) for pixel in part) / len(part)
            print(f"one of two blocks: {seen:.4f} of the picture")
            assert abs(seen - (N - 1) / N) < 0.01
            assert selected(source, view, cubes_across(0, N - 1)) == layer(N - 1, 1, N, first + 1)
            simple.ClearSelection(source)
            display.BlockSelectors = ["/Root"]
        simple.Delete(source)


def main():
    load_plugin(parse_arguments(__doc__))
    view = open_scene()
    check_association(view)
    check_rectilinear(view)
    check_components(view)
    check_dependent_components(view)
    check_no_cells(view)
    check_selection(view)
    check_blocks(view)


main()
