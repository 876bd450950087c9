# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A figure as a web page: in a file, as a text, in a notebook."""
import importlib.util
import json
import os
import pathlib
import re
import resource
import shutil
import sys
import tempfile
import time
import unittest
import warnings

import first_data
import vtktetmarch

WEB = pathlib.Path(__file__).resolve().parents[1] / "Web"
MISSING = [name for name in ("chromium", "chromedriver", "setpriv") if not shutil.which(name)] + \
    [name for name in ("PIL",) if not importlib.util.find_spec(name)]
COMPLETE = """const viewer = document.querySelector("canvas")?.viewer;
    return viewer?.complete && Promise.race([viewer.complete.then(() => true),
                                   new Promise(done => setTimeout(() => done(false), 500))])"""
MARKUP = "</script><img src=x onerror=alert(1)>"


def scene_of(text):
    (scene,) = re.findall(r'<script type="application/json" id="scene">(.*?)</script>', text, re.DOTALL)
    return json.loads(scene)


def figure_of(name="value", **how):
    data = first_data.one_tetrahedron()
    data.GetPointData().GetArray(0).SetName(name)
    return vtktetmarch.figure(data, size=(160, 120), **how)


class PageTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_either_kind(self):
        image = first_data.with_points(first_data.image((3, 4, 5)), "radius", first_data.radius)
        for data, name, law in ((first_data.one_tetrahedron(), "z", "unstructured"),
                                (image, "radius", "structured")):
            figure = vtktetmarch.figure(data, size=(160, 120), background=(0.5, 0, 1), camera="x")
            scene = scene_of(figure.to_html())
            self.assertEqual([volume["law"] for volume in scene["steps"][0]["volumes"]], [law])
            self.assertEqual((scene["size"], scene["background"], scene["controls"]), ([160, 120], [0.5, 0, 1], "all"))
            self.assertEqual(scene["camera"]["position"], list(figure.camera.GetPosition()))
            self.assertEqual((scene["title"], scene["omissions"]), (name, []))

    def test_files(self):
        figure = figure_of()
        text = figure.to_html(controls="none", title="one")
        for path in (self.folder / "a.html", str(self.folder / "B.HTM")):
            self.assertEqual(figure.to_html(path, "none", title="one"), path)
            self.assertEqual(pathlib.Path(path).read_text(encoding="utf-8"), text)
        self.assertEqual((scene_of(text)["title"], scene_of(text)["controls"]), ("one", "none"))

    def test_a_full_disk_leaves_the_earlier_page(self):
        """A limit of the size of files fails a write as a full disk does."""
        figure = figure_of()
        path = self.folder / "a.html"
        path.write_text("good")
        limits = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (500, limits[1]))
        try:
            with self.assertRaisesRegex(OSError, "File too large: '.*a.html'"):
                figure.to_html(path)
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        self.assertEqual((path.read_text(), os.listdir(self.folder)), ("good", ["a.html"]))

    def test_what_is_wrong_is_said(self):
        figure = figure_of()
        for how, error, words in (
                ({"path": "a.png"}, ValueError, "a page is written as HTML; path ends with .html, not as 'a.png'"),
                ({"path": 3}, TypeError, "path is the path of a file, not 3"),
                ({"path": self.folder / "none" / "a.html"}, FileNotFoundError, "none/a.html"),
                ({"controls": "some"}, ValueError, "controls is 'all' or 'none', not 'some'"),
                ({"title": 3}, TypeError, "title is a text or None, not 3")):
            with self.subTest(how=how), self.assertRaisesRegex(error, words):
                figure.to_html(**how)
        with self.assertRaisesRegex(ValueError, "height is above 0, not 0"):
            figure.page(height=0)
        self.assertEqual(os.listdir(self.folder), [])

    def test_what_the_page_lacks_is_one_warning(self):
        figure = figure_of(transparent=True).axes()
        words = ("Texts and other 2D props are not in the page: it draws a scalar bar and axes of its own. "
                 "The page has no alpha channel: it has the background of the renderer.")
        for method in (figure.to_html, figure.page):
            with warnings.catch_warnings(record=True) as said:
                warnings.simplefilter("always")
                method()
            self.assertEqual([(str(one.message), one.filename) for one in said], [(words, __file__)])


@unittest.skipIf(MISSING, f"{', '.join(MISSING)} isn't installed: apt-get install chromium-driver python3-pil")
class NotebookTest(unittest.TestCase):
    """As a notebook shows it: in a document of another origin, whose frame has the page as text."""

    @classmethod
    def setUpClass(cls):
        sys.path.append(str(WEB))
        from browsers import browser
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.browser = cls.enterClassContext(browser("chromium", "swiftshader"))

    def test_the_page_is_live_and_its_names_are_text(self):
        page = figure_of(MARKUP).page(height=500)
        self.assertRegex(repr(page), rf"^<Page: {re.escape(MARKUP)}, 0\.\d MB>$")
        self.assertIn('height="500"', page._repr_html_())
        path = self.folder / "notebook.html"
        path.write_text(f'<!DOCTYPE html><meta charset="utf-8">{page._repr_html_()}', encoding="utf-8")
        self.browser.open(path)
        self.assertEqual(self.browser.run("return document.querySelectorAll('img, script').length"), 0)
        frame = self.browser.session.call("FindElement", using="css selector", value="iframe")
        self.browser.session.call("SwitchToFrame", id=frame)
        end = time.monotonic() + 60
        while not self.browser.run(COMPLETE):
            self.assertLess(time.monotonic(), end)
            time.sleep(0.1)
        self.assertEqual(self.browser.run("return document.title"), MARKUP)
        self.assertEqual(self.browser.run("return document.images.length"), 0)
        self.assertGreater(len(set(map(tuple, self.browser.png().reshape(-1, 3)))), 100)
        self.assertEqual(self.browser.console(), [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
