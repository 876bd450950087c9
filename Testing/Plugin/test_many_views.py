# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Comparative views of a mesh and of an image, and two views whose cameras are linked."""
from paraview import simple
from state_values import ARRAY, make_scene
from views import load_plugin, make_plain, parse_arguments, picture_of, show

SIZE = (200, 160)
KINDS = {"mesh": "UnstructuredGridRepresentation", "wavelet": "UniformGridRepresentation"}
LOW, HIGH = 100.0, 255.0  # of the wavelet's greatest value
CAMERA = ("CameraPosition", "CameraFocalPoint", "CameraViewUp")


def copy_camera(view, source):
    for name in CAMERA:
        setattr(view, name, getattr(source, name))


class Comparison:
    """Two views side by side, which differ by a property of the source."""

    def __init__(self, name, camera):
        self.view = simple.CreateView("ComparativeRenderView")
        make_plain(self.view)
        self.view.ViewSize = [2 * SIZE[0], SIZE[1]]
        self.view.Dimensions = [2, 1]
        self.view.Spacing = [0, 0]
        copy_camera(self.view, camera)
        self.display = show(simple.FindSource(name), self.view, ARRAY, kind=KINDS[name])
        simple.Render(self.view)
        proxies = simple.servermanager.ProxyManager()
        self.cue = simple.servermanager._getPyProxy(proxies.NewProxy("animation", "ComparativeAnimationCue"))
        self.cue.AnimatedProxy = simple.FindSource("wavelet")
        self.cue.AnimatedPropertyName = "Maximum"
        self.cue.AnimatedElement = 0
        self.compare(LOW, HIGH)
        self.view.Cues = [self.cue]

    def compare(self, *values):
        for x, value in enumerate(values):
            self.cue.SMProxy.UpdateValue(x, 0, value)

    def look(self):
        """The left picture and the right one."""
        simple.Render(self.view)
        both = picture_of(self.view)
        rows = [both[i : i + 2 * SIZE[0]] for i in range(0, len(both), 2 * SIZE[0])]
        return [[pixel for row in rows for pixel in row[x : x + SIZE[0]]] for x in (0, SIZE[0])]


def check_comparison(name, view):
    """The left view is that of a view by itself; the right one, which is a pixel less wide, is compared with itself."""
    wavelet = simple.FindSource("wavelet")
    comparison = Comparison(name, view)
    left, right = comparison.look()
    comparison.compare(HIGH, HIGH)
    other_left, same_right = comparison.look()
    assert right == same_right and left != other_left
    simple.Delete(comparison.view)
    for value, shown in ((LOW, left), (HIGH, other_left)):
        wavelet.Maximum = value
        assert picture_of(view) == shown, f"{name}, {value}: the comparison shows another picture"


def check_link(first, second):
    """Where one camera goes, the other goes, and each view shows what it shows alone."""
    places = ([30.0, 22.0, 26.0], [-40.0, 10.0, 5.0], [0.0, 35.0, 20.0])
    alone = []
    for place in places:
        for view in (first, second):
            view.CameraPosition = place
        alone.append((picture_of(first), picture_of(second)))
    simple.AddCameraLink(first, second, "cameras")
    for moved, follows in ((first, second), (second, first)):
        for place, pictures in zip(places, alone):
            moved.CameraPosition = place
            moved.SMProxy.InteractiveRender()
            simple.Render(moved)
            assert list(follows.CameraPosition) == place, "the linked camera stays where it is"
            assert (picture_of(first), picture_of(second)) == pictures, "linked views show something else"
    simple.RemoveCameraLink("cameras")


def main():
    load_plugin(parse_arguments(__doc__))
    (mesh, *_), (wavelet, *_) = make_scene()
    check_comparison("mesh", mesh)
    check_comparison("wavelet", wavelet)
    check_link(mesh, wavelet)


main()
