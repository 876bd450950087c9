# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The widget of a figure: each control draws what figure() draws with that argument; changes are not queued."""
import asyncio
import importlib.util
import pathlib
import subprocess
import sys
import unittest

import numpy as np

import first_data
import vtktetmarch
from PicturesTest import pixels_of_png

INSTALLED = importlib.util.find_spec("ipywidgets") is not None
PAIRS = "0 0, 0.4 0.9, 1 0.1"
# A control, its value, and the arguments of figure() for the same picture.
CONTROLS = {
    "azimuth": (30.0, {"camera": {"azimuth": 30}}),
    "elevation": (-20.0, {"camera": {"elevation": -20}}),
    "zoom": (0.5, {"camera": {"zoom": 2**0.5}}),
    "exposure": (2.0, {"unit_distance": 0.05}),
    "tolerance": (1 / 16, {"error_tolerance": 1 / 16}),
    "shade": (True, {"shade": True}),
    "colors": ("Magma", {"cmap": "magma"}),
    "opacity": (PAIRS, {"opacity": [(0, 0), (0.4, 0.9), (1, 0.1)]}),
}
LIGHT = {
    "shadows": (True, {"shadow_method": "automatic"}),
    "ambient": (0.5, {"ambient": 0.5}),
    "diffuse": (0.2, {"diffuse": 0.2}),
    "specular": (0.9, {"specular": 0.9}),
}


def make_figure(**how):
    given = {"cmap": "viridis", "opacity": [(0, 0), (1, 0.9), (1.1, 0), (2, 1)], "unit_distance": 0.2}
    return vtktetmarch.figure(first_data.vectors(), size=(120, 90), **{**given, **how})


@unittest.skipUnless(INSTALLED, "ipywidgets isn't installed: apt-get install python3-ipywidgets")
class WidgetTest(unittest.TestCase):
    def setUp(self):
        self.figure = make_figure()
        self.widget = self.figure.widget()

    def seen(self, widget=None):
        """The pixels of the picture that the widget shows."""
        return pixels_of_png(bytes((widget or self.widget).picture.value))

    def test_it_shows_the_figure(self):
        self.assertTrue(np.array_equal(self.seen(), self.figure.screenshot()))
        self.assertEqual(self.widget.frames, 1)

    def test_each_control_is_an_argument(self):
        for table, given in ((CONTROLS, {}), (LIGHT, {"shade": True})):
            for control, (value, how) in table.items():
                with self.subTest(control):
                    widget = make_figure(**given).widget()
                    before = self.seen(widget)
                    getattr(widget, control).value = value
                    self.assertTrue(np.array_equal(self.seen(widget), make_figure(**{**given, **how}).screenshot()))
                    self.assertFalse(np.array_equal(self.seen(widget), before))

    def test_the_seconds_and_the_bound_are_those_of_the_frame(self):
        frame = self.figure.statistics()
        self.assertLessEqual(frame["error_bound"]["max"], 1 / 255)
        for number in (f"{frame['seconds']:.3f}", f"{frame['error_bound']['max']:.2g}"):
            self.assertIn(number, self.widget.info.value)
        self.assertFalse(self.figure.mapper.GetCollectDiagnostics())

    def test_the_mouse_turns_by_totals(self):
        """A message that is lost changes nothing; a page that is loaded anew counts from 0."""
        for text, azimuth, elevation, zoom in (("0.5 10 5 0", -4, 2, 0), ("0.5 30 10 -200", -12, 4, 0.5),
                                               ("0.7 10 0 0", -16, 4, 0.5), ("0.7 10 1000 9999", -16, 89, -3)):
            self.widget.mouse.field.value = text
            found = [control.value for control in (self.widget.azimuth, self.widget.elevation, self.widget.zoom)]
            np.testing.assert_allclose(found, (azimuth, elevation, zoom), err_msg=text)

    def test_a_wrong_function_is_told_and_the_picture_stays(self):
        before, frames = self.seen(), self.widget.frames
        for text in ("0 0, 1", "0 0, 1 x", "0 0, 1 1.5", ""):
            self.widget.opacity.value = text
            self.assertIn("value opacity, value opacity", self.widget.info.value)
        self.assertEqual(self.widget.frames, frames)
        self.assertTrue(np.array_equal(self.seen(), before))

    def test_changes_while_a_frame_is_drawn_share_the_next(self):
        """As in a kernel, whose event loop has the messages of the front end one after the other."""
        began = []

        def change_more(_renderer, _event):
            began.append(self.widget.azimuth.value)
            if len(began) == 1:
                for step in range(50):
                    self.widget.azimuth.value = 40.0 + step
                    self.widget.exposure.value = step / 50

        async def change():
            for step in range(50):
                self.widget.azimuth.value = float(step)
            await asyncio.sleep(0.2)
            coarse = self.widget.picture.format, bytes(self.widget.picture.value[:2])
            for _ in range(100):
                await asyncio.sleep(0.1)
                if self.widget.picture.format == "png":
                    return coarse

        frames = self.widget.frames
        self.figure.renderer.AddObserver("StartEvent", change_more)
        self.assertEqual(asyncio.run(change()), ("jpeg", b"\xff\xd8"))
        self.assertEqual(began, [49.0, 89.0, 89.0])  # two coarse frames, and the full one at rest
        self.assertEqual(self.widget.frames, frames + 3)
        self.assertTrue(np.array_equal(self.seen(), self.figure.screenshot()))


class MissingTest(unittest.TestCase):
    def test_without_ipywidgets_the_remedy_is_told(self):
        code = ("import sys; sys.modules['ipywidgets'] = None; sys.path.insert(0, sys.argv[1])\n"
                "import first_data, vtktetmarch\n"
                "vtktetmarch.figure(first_data.one_tetrahedron()).widget()")
        run = subprocess.run([sys.executable, "-c", code, str(pathlib.Path(__file__).parent)], capture_output=True,
                             text=True, timeout=300)
        self.assertRegex(run.stderr, r"ImportError: a widget needs ipywidgets .*: apt-get install python3-ipywidgets")


if __name__ == "__main__":
    unittest.main(verbosity=2)
