# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Views of ParaView with the representation in them: what they show, and what its mapper says of itself."""
import argparse

from paraview import simple
from paraview.vtk import vtkRenderingVolumeOpenGL2  # noqa: F401, for methods of mappers
from paraview.vtk.vtkIOImage import vtkPNGReader

REPRESENTATION = "Tet Marching"
# Share of the picture's pixels.
CHANGED = 0.2


def parse_arguments(description, *others):
    parser = argparse.ArgumentParser(description=description)
    for name in ("plugin", *others):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--pictures", help="a folder in which to leave pictures")
    return parser.parse_args()


def load_plugin(arguments, port=None):
    """With a port: in the pvserver there, too, whose client this process becomes."""
    if port:
        simple.Connect("localhost", port)
        simple.LoadPlugin(arguments.plugin, remote=True, ns=globals())
    simple.LoadPlugin(arguments.plugin, remote=False, ns=globals())


def open_view():
    simple._DisableFirstRenderCameraReset()
    view = simple.CreateView("RenderView")
    make_plain(view)
    return view


def make_plain(view):
    """Nothing but what is shown, on black."""
    view.ViewSize = [400, 300]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.0, 0.0, 0.0]


def show(source, view, array, association="POINTS", kind="UnstructuredGridRepresentation"):
    display = simple.Show(source, view, kind)
    simple.ColorBy(display, (association, array))
    available = display.GetProperty("Representation").Available
    assert REPRESENTATION in available, f"{REPRESENTATION} is not among {available}"
    display.SetRepresentationType(REPRESENTATION)
    return display


def volume_of(display):
    return display.GetClientSideObject().GetActiveRepresentation().GetActor()


def mapper_of(display):
    return volume_of(display).GetMapper()


def figures_of(display, name):
    """What the mapper prints of itself under that name, as numbers."""
    for line in str(mapper_of(display)).splitlines():
        if line.strip().startswith(name + ": "):
            return [float(word) for word in line.split(": ")[1].split()]
    raise KeyError(name)


def figure_of(display, name):
    return figures_of(display, name)[0]


def picture_of(view):
    return pixels_of(view.SMProxy.CaptureWindow(1))


def picture_in(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    return pixels_of(reader.GetOutput())


def pixels_of(image):
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


def brightness(picture):
    """Mean over all channels, of 255."""
    return sum(sum(pixel) for pixel in picture) / (3 * len(picture))


def set_all(display, properties):
    """Properties of the representation, whose prefix is left out."""
    for name, value in properties.items():
        setattr(display, "TetMarch" + name, value)


def selected(source, view, rectangle):
    """Of the source's first port: {(block, cell), ...}, None for the block of what has none."""
    simple.ClearSelection(source)
    simple.SelectSurfaceCells(Rectangle=rectangle, View=view)
    combined = source.SMProxy.GetSelectionInput(0)
    if combined is None:
        return set()
    found = set()
    inputs = combined.GetProperty("Input")
    for i in range(inputs.GetNumberOfProxies()):
        selection = inputs.GetProxy(i)
        ids = selection.GetProperty("IDs")
        values = [ids.GetElement(k) for k in range(ids.GetNumberOfElements())]
        composite = selection.GetXMLName() == "CompositeDataIDSelectionSource"
        assert composite or selection.GetXMLName() == "IDSelectionSource", selection.GetXMLName()
        step = 3 if composite else 2
        for k in range(0, len(values), step):
            found.add((values[k] if composite else None, values[k + step - 1]))
    return found


class Watch:
    """Changes what is shown, and compares the pictures before and after."""

    def __init__(self, view, display):
        self.view = view
        self.display = display
        self.picture = picture_of(view)

    def look(self):
        self.picture = picture_of(self.view)
        return self.picture

    def set(self, **properties):
        """The picture with these properties of the display, whose prefix is left out."""
        set_all(self.display, properties)
        return self.look()

    def expect_change(self, what):
        before = self.picture
        share = difference(before, self.look())
        print(f"{what}: {100 * share:.1f} % of the pixels changed")
        assert share > CHANGED, f"{what}: the picture stayed as it was"

    def expect_change_by(self, **properties):
        before = self.picture
        self.set(**properties)
        self.picture = before
        self.expect_change(", ".join(properties))

    def expect_same(self, other, **properties):
        picture = self.set(**properties)
        assert picture == other, f"{properties} gave another picture"

    def expect_brightness(self, least, most, reference, **properties):
        """Of the picture with these properties, as a share of that of another picture."""
        share = brightness(self.set(**properties)) / brightness(reference)
        print(f"{properties}: {share:.3f} as bright")
        assert least <= share <= most, f"{properties}: {share:.3f} as bright instead of {least} to {most}"
        return self.picture
