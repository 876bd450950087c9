# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example of a remote view, driven as its page drives it. RemoteViewTest.py --measure [OPTIONS]: frames a second.

Options of the example follow --measure.
"""
import importlib.util
import json
import pathlib
import re
import signal
import subprocess
import sys
import threading
import time
import unittest
import urllib.error
import urllib.request

import numpy as np
import vtkmodules.all as vtk

import vtktetmarch
from PicturesTest import pixels_of, pixels_of_png

PROJECT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = PROJECT / "Documentation" / "Examples" / "remote_view.py"
SPECIFICATION = importlib.util.spec_from_file_location("remote_view", EXAMPLE)
FLOW = PROJECT / "Data" / "golfball_small.vtu"


class Browser:
    """The process of the example, and what a page asks of it."""

    def __init__(self, *options):
        self.process = subprocess.Popen([sys.executable, str(EXAMPLE), str(FLOW), *options], text=True,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.url = re.match(r"(http://127\.0\.0\.1:\d+/) ", self.process.stdout.readline())[1]
        self.number = 0
        self.frames = []  # (seconds, kind, bytes)

    def open(self, path="", **how):
        return urllib.request.urlopen(urllib.request.Request(self.url + path, **how), timeout=60)

    def frame(self):
        """The next frame: its kind and bytes."""
        with self.open(f"frame?taken={self.number}") as answer:
            self.number = int(answer.headers["X-Frame"])
            self.frames.append((time.monotonic(), answer.headers["Content-Type"], answer.read()))
        return self.frames[-1][1:]

    def frame_at_rest(self):
        while True:
            kind, picture = self.frame()
            if kind == "image/png":
                return picture

    def wish(self, x=0, y=0, wheel=0, down=False):
        self.open("wish", data=json.dumps([x, y, wheel, down]).encode()).close()

    def close(self):
        if self.process.poll() is None:
            self.end()

    def end(self):
        """Its exit status, and its errors."""
        self.process.send_signal(signal.SIGINT)
        _, errors = self.process.communicate(timeout=60)
        return self.process.returncode, errors


class RemoteViewTest(unittest.TestCase):
    def browse(self, width, height):
        browser = Browser("--width", str(width), "--height", str(height))
        self.addCleanup(browser.close)
        return browser

    def test_frames_follow_the_mouse_and_the_one_at_rest_is_the_screenshot(self):
        browser, figure = self.browse(240, 160), vtktetmarch.figure(FLOW, size=(240, 160))
        self.assertTrue(np.array_equal(pixels_of_png(browser.frame_at_rest()), figure.screenshot()))
        views = [figure.screenshot()]
        for _ in range(4):
            figure.camera.Azimuth(8)
            figure.camera.Elevation(4)
            figure.camera.OrthogonalizeViewUp()
            views.append(figure.screenshot())
        for number in range(1, 5):
            browser.wish(x=-20, y=10, down=True)
            kind, picture = browser.frame()
            self.assertEqual(kind, "image/jpeg")
            near = [np.abs(pixels_of(vtk.vtkJPEGReader(), picture).astype(float) - view).mean() for view in views]
            self.assertEqual(np.argmin(near), number, near)
        browser.wish(wheel=-200)
        figure.camera.Zoom(2**0.5)
        self.assertTrue(np.array_equal(pixels_of_png(browser.frame_at_rest()), figure.screenshot()))
        self.assertEqual(browser.end(), (0, ""))
        with self.assertRaises(urllib.error.URLError):
            browser.open()

    def test_a_full_frame_gives_way_to_the_mouse(self):
        """Which moves as the first draw of the frame has ended."""
        example = importlib.util.module_from_spec(SPECIFICATION)
        SPECIFICATION.loader.exec_module(example)
        view, shown = example.View(vtktetmarch.figure(FLOW, size=(600, 400)), 20), []
        view.figure.mapper.SetMaxDrawTimeInSeconds(1e-3)  # of many draws

        def move(_window, _event):
            if view.is_full:
                view.add([5, 0, 0, True])

        def show(writer):
            shown.append(writer.GetClassName())
            raise KeyboardInterrupt

        view.window.AddObserver("AbortCheckEvent", move)
        view.show = show
        with self.assertRaises(KeyboardInterrupt):
            view.run()
        self.assertEqual(shown, ["vtkJPEGWriter"])

    def test_only_pages_of_this_server_get_frames(self):
        browser = self.browse(24, 16)
        with browser.open() as page:
            self.assertIn(b"<img", page.read())
        with self.assertRaisesRegex(urllib.error.HTTPError, "403") as refused:
            browser.open("frame?taken=0", headers={"Host": "example.org"})
        refused.exception.close()


def measure(options):
    """Turns for five seconds, then rests: frames a second, the full frame, and how soon it gives way to the mouse."""
    browser = Browser(*options)
    browser.frame_at_rest()
    moves = threading.Event()

    def move():
        while not moves.is_set():
            browser.wish(x=3, down=True)
            time.sleep(0.01)

    mover = threading.Thread(target=move)
    mover.start()
    browser.frame()
    first = len(browser.frames)
    while browser.frames[-1][0] - browser.frames[first - 1][0] < 5:
        browser.frame()
    moves.set()
    mover.join()
    seen = browser.frames[first - 1:]
    seconds = seen[-1][0] - seen[0][0]
    size = sum(len(picture) for _, _, picture in seen[1:]) / len(seen[1:])
    print(f"{(len(seen) - 1) / seconds:.1f} frames a second of {size / 1000:.0f} kB, all {seen[-1][1]}")
    start = time.monotonic()
    browser.wish()
    size = len(browser.frame_at_rest())
    full = time.monotonic() - start
    browser.wish()
    threading.Timer(0.3 * full, browser.wish, kwargs={"x": 5, "down": True}).start()
    start = time.monotonic()
    kind, _ = browser.frame()
    print(f"the full frame after {full:.2f} s, {size / 1000:.0f} kB; moved after {0.3 * full:.2f} s, {kind} after "
          f"{time.monotonic() - start - 0.3 * full:.2f} s more")
    print(browser.end())


if __name__ == "__main__":
    if sys.argv[1:2] == ["--measure"]:
        measure(sys.argv[2:])
    else:
        unittest.main(verbosity=2)
