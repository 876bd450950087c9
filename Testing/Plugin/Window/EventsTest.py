# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window by real events: EventsTest.py PROJECT PLUGIN ROOT PVPYTHON WATCH MESH [TEST...]

`./tetmarch paraview FILE` opens it; mouse and keyboard choose the representation, edit the opacity function, crop, set
a light and save the state. What the view shows then must be what pvpython draws of that state. ROOT is the folder in
which ParaView was unpacked, WATCH the library of WidgetWatch.cxx. Wants a display of its own.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import numpy as np
from paraview_window import LIGHT, SIZE, Window, command, part, screen
from pictures import read_png  # after paraview_window, which knows where it is

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = PLUGIN = ROOT = PVPYTHON = WATCH = MESH = None
CLOSE = 2  # of 255
CHANGED = 0.05  # share of the view's pixels
START = (0.5, 0.5)  # of the drag, in the editor of the opacity function


def image():
    return os.path.join(PROJECT, "Data", "bonsai_small.vti")


def draw(state, picture):
    """By pvpython, in another process."""
    library_path = next(word for word in command(PROJECT, PLUGIN, ROOT, state) if word.startswith("LD_LIBRARY_PATH="))
    name, value = library_path.split("=", 1)
    subprocess.run([PVPYTHON, str(HERE / "draw_state.py"), PLUGIN, state, picture], check=True,
                   env={**os.environ, name: value}, stdout=subprocess.DEVNULL)
    return read_png(picture)[::-1]


def apart(first, second):
    """For each pixel the largest difference of a channel, of 255."""
    return np.abs(first.astype(int) - second.astype(int)).max(axis=2)


def opacity_points(state, array):
    """(value, opacity) of each point of the array's opacity function in a state."""
    root = xml.etree.ElementTree.parse(state).getroot()
    functions = next(group for group in root.iter("ProxyCollection") if group.get("name") == "piecewise_functions")
    name = array + ".PiecewiseFunction"
    number = next(item.get("id") for item in functions.iter("Item") if item.get("name") == name)
    function = next(proxy for proxy in root.iter("Proxy") if proxy.get("id") == number)
    points = next(entry for entry in function.iter("Property") if entry.get("name") == "Points")
    values = [float(element.get("value")) for element in points.iter("Element")]
    return [(values[i], values[i + 1]) for i in range(0, len(values), 4)]


class Session:
    """A file in the window, as our volume."""

    def __init__(self, file, array, folder):
        self.folder = folder
        self.window = Window(command(PROJECT, PLUGIN, ROOT, file), WATCH, folder)
        try:
            self.window.resize(*SIZE)
            self.window.show_as_volume(array)
            self.window.click(self.window.find("/variableToolbar/", text="Show Color Legend"))
        except BaseException:
            self.window.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.window.close()

    def view(self):
        return part(screen(), self.window.view()["place"])

    def open_editor(self):
        self.window.click(self.window.find("/variableToolbar/", text="Edit Color Map"))

    def edit_opacity(self, end):
        """A click beside the points adds one, which follows the mouse."""
        self.window.drag(self.window.find("/OpacityEditor/1QVTKWidget0"), START, end)

    def save_state(self):
        path = os.path.join(self.folder, "session.pvsm")
        self.window.click(self.window.find("/MainControlsToolbar/", text="Save State"))
        self.window.click(self.window.find("/EntityName"))
        self.window.write(path)
        self.window.press("Return")
        self.window.wait(lambda: os.path.exists(path) and not self.window.seen("/EntityName"), "a saved state")
        return path


class EventsTest(unittest.TestCase):
    def compare(self, session, before):
        """What the view shows is what pvpython draws of the saved state, and not what it showed before."""
        after = session.view()
        state = session.save_state()
        with open(session.window.output, encoding="utf-8") as output:
            self.assertNotIn("ERR|", output.read())
        drawn = draw(state, os.path.join(session.folder, "state.png"))
        self.assertEqual(drawn.shape, after.shape)
        difference = apart(drawn, after).max()
        share = (apart(drawn, before) > CLOSE).mean()
        print(f"{self.id()}: at most {difference}/255 off, {100 * share:.1f} % of the pixels changed")
        self.assertLessEqual(difference, CLOSE)
        self.assertGreater(share, CHANGED)
        return state

    def check(self, file, array, end):
        with tempfile.TemporaryDirectory() as folder, Session(file, array, folder) as session:
            session.open_editor()
            before = session.view()
            session.edit_opacity(end)
            points = opacity_points(self.compare(session, before), array)
        self.assertEqual(3, len(points), "a point was added")
        low, high = points[0][0], points[-1][0]
        self.assertAlmostEqual(end[0], (points[1][0] - low) / (high - low), delta=0.05)
        self.assertAlmostEqual(1 - end[1], points[1][1], delta=0.05)

    def test_image(self):
        self.check(image(), "density", (0.35, 0.85))

    def test_mesh(self):
        self.check(MESH, "vorticity_mag", (0.1, 0.3))

    def test_box_in_the_view(self):
        with tempfile.TemporaryDirectory() as folder, Session(image(), "density", folder) as session:
            before = session.view()
            session.window.tick("TetMarchUseCropping")
            session.window.drag_crop_face(1)  # to the middle
            session.window.click(session.window.reveal("/show3DWidget"), at=(0.02, 0.5))  # the box itself is no picture
            self.compare(session, before)
            right = session.view()[:, session.view().shape[1] * 6 // 10 :]
            self.assertEqual(0, apart(right, np.broadcast_to(right[0, 0], right.shape)).max(), "half of it is cut off")

    def test_light_in_the_view(self):
        with tempfile.TemporaryDirectory() as folder, Session(image(), "density", folder) as session:
            session.window.tick("TetMarchShade")
            before = session.view()
            session.window.add_light(LIGHT)
            session.window.hide_light()
            self.compare(session, before)


if __name__ == "__main__":
    PROJECT, PLUGIN, ROOT, PVPYTHON, WATCH, MESH = sys.argv[1:7]
    unittest.main(argv=sys.argv[:1] + sys.argv[7:])
