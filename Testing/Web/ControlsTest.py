# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The controls of a page do what they say, by real events: the page is the one in Data."""
import pathlib
import re
import unittest

import numpy as np

from browser_case import BrowserCase

PAGE = pathlib.Path(__file__).resolve().parents[2] / "Data" / "bonsai.html"
SIZE = 1000, 420
SECONDS = 120
VIEWER = "const viewer = document.getElementById('picture').viewer; "
# When the frame at rest has been asked for: the page does this by a timer of 150 ms, after its last movement.
LATER = "return new Promise(done => setTimeout(done, 200))"
IS_COMPLETE = VIEWER + """if (!viewer?.complete || document.getElementById("loading").hidden === false) return false;
    return Promise.race([viewer.complete.then(() => true), new Promise(done => setTimeout(done, 1000))])"""
CENTER = """const element = document.querySelector(arguments[0]);
    element.scrollIntoView({ block: "center" });
    const box = element.getBoundingClientRect();
    return [box.x + box.width / 2, box.y + box.height / 2].map(Math.round)"""
CHOOSE = """const select = document.getElementById(arguments[0]);
    select.value = arguments[1];
    select.dispatchEvent(new Event("change"))"""


class Controls:
    def show(self, page=PAGE):
        self.browser.size(*SIZE)
        self.browser.open(page)
        self.rest()

    def rest(self):
        """Waits for the frame at rest; returns its picture as saved."""
        for _ in range(SECONDS):
            self.browser.run(LATER)
            if self.browser.run(IS_COMPLETE):
                return self.browser.pixels(VIEWER + "return document.getElementById('picture').toDataURL()")
        self.fail(self.browser.run("return document.getElementById('message').textContent") or "no frame")

    def setUp(self):
        self.show()

    def tearDown(self):
        self.assertEqual(self.browser.console(), [])

    def ask(self, script, *arguments):
        return self.browser.run(VIEWER + "return " + script, *arguments)

    def text(self, name):
        return self.browser.run("return document.getElementById(arguments[0]).innerText", name)

    def is_shown(self, name):
        return self.browser.run("return !document.getElementById(arguments[0]).hidden", name)

    def click(self, selector):
        self.browser.mouse(tuple(self.browser.run(CENTER, selector)))

    def assert_shown(self, expected, shown, most=0):
        self.assertLessEqual(np.abs(shown.astype(int) - expected.astype(int)).max(), most)

    def test_functions(self):
        before, written = self.rest(), self.ask("viewer.functions(0)")
        x, y = self.browser.run(CENTER, "#editor circle:nth-of-type(4)")
        self.browser.mouse((x, y), (x + 2, y + 10), (x + 4, y + 30))
        moved = self.ask("viewer.functions(0).opacity")
        self.assertGreater(moved[3][0], written["opacity"][3][0])
        self.assertLess(moved[3][1], written["opacity"][3][1] - 0.1)
        self.browser.keys("ArrowUp", "ArrowUp")
        self.assertAlmostEqual(self.ask("viewer.functions(0).opacity[3][1]"), moved[3][1] + 0.02, 9)
        self.browser.keys("Delete")
        self.assertEqual(self.ask("viewer.functions(0).opacity"), moved[:3] + moved[4:])
        self.browser.run(CHOOSE, "color-map", "Cool to Warm")
        edited = self.rest()
        self.assertEqual(len(self.ask("viewer.functions(0).color")), 22)
        self.assertGreater(np.abs(edited.astype(int) - before).max(), 50)
        self.click("#functions-reset")
        self.assert_shown(before, self.rest(), 1)

    def test_pick(self):
        places = ((x, y) for y in range(300, 500, 40) for x in range(200, 500, 30))
        place, hit = next((at, hit) for at in places if (hit := self.ask("viewer.pick(...arguments[0])", at)))
        self.browser.mouse(place)
        for _ in range(SECONDS):
            if self.is_shown("picked"):
                break
            self.browser.run(LATER)
        value, cell = re.search(r"Value\s+(\S+)\s+Cell\s+(\d+)", self.text("picked")).groups()
        self.assertEqual(int(cell), hit["cell"])
        self.assertAlmostEqual(float(value), hit["value"], 3)
        mark = self.browser.run(CENTER, "#picked-mark")
        np.testing.assert_allclose(mark, place, atol=1)
        self.browser.keys("ArrowLeft")
        self.rest()
        self.assertNotEqual(self.browser.run(CENTER, "#picked-mark"), mark)
        self.browser.keys("Escape")
        self.assertFalse(self.is_shown("picked"))

    def test_accuracy(self):
        for level in "fast", "reference":
            self.browser.run(CHOOSE, "level", level)
            self.rest()
            self.assertEqual(self.ask("viewer.level.name"), level)
            self.assertRegex(self.text("milliseconds"), r"^[\d.]+ ms a frame$")
        picture = self.rest()
        self.click("input[value=error]")
        self.assertGreater(np.abs(self.rest().astype(int) - picture).max(), 50)
        self.assertIn("Error bound", self.browser.run("return document.getElementById('scalar-bar').textContent"))

    def test_camera(self):
        before = self.rest()
        self.click("[data-axis='0'][data-sign='-1']")
        self.rest()
        self.click("#copy-command")
        position = self.ask("viewer.camera.position")
        copied = self.browser.run("return document.getElementById('copied').value")
        self.assertIn("--camera=" + ",".join(np.format_float_positional(x, trim="-") for x in position), copied)
        self.click("#reset")
        self.assert_shown(before, self.rest())

    def test_lost_context(self):
        before = self.rest()
        self.browser.run(VIEWER + "self.lost = viewer.gl.getExtension('WEBGL_lose_context'); lost.loseContext()")
        self.browser.run(LATER)
        self.assertTrue(self.is_shown("message"))
        self.browser.run(VIEWER + "viewer.complete = null; lost.restoreContext()")  # the frame before was complete
        self.assert_shown(before, self.rest())
        self.assertFalse(self.is_shown("message"))
        self.browser.console()  # Firefox warns of the loss

    def test_names_are_text(self):
        name = "<img src=x onerror=alert(1)>"
        page = self.folder / "names.html"
        title = '"title":"%s"' % name.replace("<", r"\u003c")
        page.write_text(re.sub('"title":"[^"]*"', lambda found: title, PAGE.read_text(), count=1))
        self.show(page)
        self.assertEqual(self.text("title"), name)
        self.assertEqual(self.browser.run("return document.images.length"), 0)

    def test_without_controls(self):
        page = self.folder / "none.html"
        page.write_text(PAGE.read_text().replace('"controls":"all"', '"controls":"none"'))
        self.show(page)
        self.assertEqual(self.browser.run("return document.getElementById('picture').clientWidth"), SIZE[0])
        before = self.rest()
        self.browser.mouse((300, 300), (400, 320))
        self.assertGreater(np.abs(self.rest().astype(int) - before).max(), 50)


# With one driver: what the controls do is a matter of the browser.
class ControlsInChromium(Controls, BrowserCase):
    which = "chromium", "llvmpipe"


class ControlsInFirefox(Controls, BrowserCase):
    which = "firefox", "llvmpipe"


if __name__ == "__main__":
    unittest.main()
