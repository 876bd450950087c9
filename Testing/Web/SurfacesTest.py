# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Opaque surfaces of a page are those that VTK draws: the scenes of surface_scenes.py, pixel by pixel.

With the llvmpipe, which also drew VTK's pictures, all pixels are compared. SwiftShader rounds the corners of triangles
to another grid, so that a pixel on an edge may show the other side of it, and one on a rim a steeper part of it.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from browser_case import in_every_browser
from browsers import own_server
from compare import distances, read

TOLERANCE = 2
MOST_ON_EDGES = 0.003  # of the pixels


def contrast(picture):
    """The greatest difference between the 9 pixels around each one."""
    near = sliding_window_view(np.pad(picture.astype(int), ((1, 1), (1, 1), (0, 0)), "edge"), (3, 3), axis=(0, 1))
    return (near.max(axis=(3, 4)) - near.min(axis=(3, 4))).max(axis=2)


def setUpModule():
    global FOLDER
    FOLDER = pathlib.Path(unittest.enterModuleContext(tempfile.TemporaryDirectory()))
    scenes = pathlib.Path(__file__).with_name("surface_scenes.py")
    with own_server() as display:
        subprocess.run([sys.executable, str(scenes), str(FOLDER)], env={**os.environ, **display}, check=True)


class Surfaces:
    def test_pictures(self):
        pages = sorted(FOLDER.glob("*.html"))
        self.assertEqual(len(pages), 10)
        for page in pages:
            with self.subTest(page=page.stem):
                expected = read(page.with_suffix(".png"))
                self.browser.size(expected.shape[1], expected.shape[0])
                self.browser.open(page, "bare")
                self.browser.wait_title("ready", 60)
                apart = distances(self.browser.png(), expected).max(axis=2)
                if self.which[1] == "swiftshader":
                    self.assertLess((apart > TOLERANCE).mean(), MOST_ON_EDGES)
                    apart = apart - 2 * contrast(expected)
                self.assertLessEqual(apart.max(), TOLERANCE)
                self.assertEqual(self.browser.console(), [])


class OmissionTest(unittest.TestCase):
    def test_lines(self):
        said = {path.stem: path.read_text() for path in FOLDER.glob("*.txt")}
        self.assertEqual(said["omission"], "Lines of 1 actor are not in the page: it shows triangles.")
        self.assertEqual(said["scalars"], "")


in_every_browser(Surfaces)

if __name__ == "__main__":
    unittest.main()
