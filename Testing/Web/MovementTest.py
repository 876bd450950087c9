# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Real events of mouse, touch, wheel and keys move the camera of a page, and nothing else.

Which numbers a movement gives is the subject of camera.test.mjs; here the same functions tell what to expect.
"""
import pathlib
import unittest

import numpy as np

from browser_case import in_every_browser

WEB = pathlib.Path(__file__).resolve().parents[2] / "Web"
SIZE = 400, 300
PAGE = """<!DOCTYPE html><meta charset="utf-8"><title>loading</title>
<style>body { margin: 0; height: 3000px } canvas { display: block; width: %dpx; height: %dpx }</style>
<canvas width="%d" height="%d"></canvas><script type="module">%s
const start = { position: [1, 2, 20], focalPoint: [1, 2, 0], viewUp: [0, 1, 0], viewAngle: 30, parallelScale: 5,
  parallelProjection: false, clippingRange: [1, 100] };
const viewer = { camera: new Camera(start), bounds: [-3, 5, -1, 4, -2, 3], moves: 0, moved() { ++this.moves; } };
const picks = [];
const canvas = document.querySelector("canvas");
new Pointer(canvas, viewer, (x, y) => picks.push([x, y]));
new Keys(canvas, viewer);
Object.assign(window, { viewer, picks, drag, dragTwo, moveByKey, wheelFactor,
  expected(change) { const camera = new Camera(start); change(camera); return camera.toObject(); } });
document.title = "ready";
</script>"""


def module(name):
    lines = (WEB / name).read_text().splitlines()
    return "\n".join(line.removeprefix("export ") for line in lines if not line.startswith("import "))


class Movement:
    def setUp(self):
        path = self.folder / "page.html"
        script = "\n".join(map(module, ["vectors.js", "camera.js", "pointer.js", "keys.js"]))
        path.write_text(PAGE % (*SIZE, 2 * SIZE[0], 2 * SIZE[1], script))  # two device pixels to a pixel
        self.browser.open(path)
        self.browser.wait_title("ready", 20)

    def tearDown(self):
        self.assertEqual(self.browser.run("return window.scrollY"), 0)
        self.assertEqual(self.browser.console(), [])

    def assert_camera(self, change, decimals=9):
        """The camera is where a function of JavaScript moves the one of the start."""
        found = self.browser.run("return viewer.camera.toObject()")
        expected = self.browser.run(f"return expected(camera => {{ {change} }})")
        for name, value in expected.items():
            np.testing.assert_almost_equal(found[name], value, decimals, err_msg=f"{change}: {name}")

    def test_mouse(self):
        drags = ((0, [], "rotate"), (1, [], "pan"), (0, ["Shift"], "pan"), (2, [], "zoom"), (0, ["Control"], "roll"))
        for button, keys, movement in drags:
            with self.subTest(button=button, keys=keys):
                self.setUp()
                self.browser.mouse((100, 80), (200, 80), (300, 80), button=button, keys=keys)
                self.assert_camera(f'drag(camera, "{movement}", [100, 220], [300, 220], {list(SIZE)})')
                self.browser.mouse((300, 80), (300, 200), button=button, keys=keys)
                self.assert_camera(f'drag(camera, "{movement}", [100, 220], [300, 220], {list(SIZE)});'
                                   f'drag(camera, "{movement}", [300, 220], [300, 100], {list(SIZE)})')
                self.assertGreaterEqual(self.browser.run("return viewer.moves"), 2)
                self.assertEqual(self.browser.run("return picks"), [])

    def test_drag_over_the_edge(self):
        self.browser.mouse((300, 80), (500, 80))
        self.assert_camera(f'drag(camera, "rotate", [300, 220], [500, 220], {list(SIZE)})')
        self.browser.mouse((500, 80), (300, 80))  # begun outside
        self.assert_camera(f'drag(camera, "rotate", [300, 220], [500, 220], {list(SIZE)})')

    def test_click(self):
        self.browser.mouse((100, 80), (102, 81))
        self.assertEqual(self.browser.run("return picks"), [[204, 162]])
        self.browser.touch([(30, 40), (33, 42)])
        np.testing.assert_almost_equal(self.browser.run("return picks")[1:], [[66, 84]])
        self.browser.mouse((100, 80), (100, 80), button=2)
        self.browser.mouse((100, 80), (180, 80), (100, 80))
        self.assertEqual(len(self.browser.run("return picks")), 2)
        self.assert_camera("")

    def test_wheel(self):
        for pixels in -120, 240:
            self.browser.wheel(50, 60, pixels)
        self.assertEqual(self.browser.run("return viewer.moves"), 2)
        # 1.21 for 100 pixels
        self.assertAlmostEqual(self.browser.run("return viewer.camera.distance"), 20 * 1.21 ** 1.2, 9)

    def test_one_finger(self):
        self.browser.touch([(100, 80), (250, 80)])
        self.assert_camera(f'drag(camera, "rotate", [100, 220], [250, 220], {list(SIZE)})')

    def test_pinch_and_twist(self):
        self.browser.touch([(180, 150), (140, 150)], [(220, 150), (260, 150)])
        self.assertAlmostEqual(self.browser.run("return viewer.camera.distance"), 20 / 3, 9)
        self.setUp()
        self.browser.touch([(150, 150), (200, 200)], [(250, 150), (200, 100)])
        self.assertAlmostEqual(self.browser.run("return viewer.camera.distance"), 20, 9)
        up = self.browser.run("return viewer.camera.viewUp")
        np.testing.assert_almost_equal(up, [1, 0, 0], 9)  # the scene turns against the clock

    def test_two_fingers_pan(self):
        self.browser.touch([(100, 100), (150, 120)], [(200, 100), (250, 120)])
        self.assert_camera(f"camera.pan(50, -20, {list(SIZE)})")

    def test_keys(self):
        self.browser.mouse((100, 80), (100, 80))  # takes the focus
        pressed = ""
        for key in "ArrowLeft", "ArrowUp", "+", "-", "z", "y", "r":
            self.browser.keys(key)
            pressed += f'moveByKey(camera, "{key}", false, viewer.bounds, {SIZE[0] / SIZE[1]});'
            self.assert_camera(pressed)
        self.browser.keys("q")
        self.assertEqual(self.browser.run("return viewer.moves"), 7)


in_every_browser(Movement)

if __name__ == "__main__":
    unittest.main()
