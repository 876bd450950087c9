# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each script of the gallery draws the picture that is on the page, and the page has its code."""
import os
import re
import unittest

import numpy as np

import draw_gallery
from PicturesTest import pixels_of_png

MOST_LINES = 40
MOST_BYTES = 1_500_000
CLOSE = 0.008  # RMS of a channel, 0 to 1: other drivers and versions of VTK draw texts and lines otherwise
SQUARE = 8  # pixels: in their mean, a line that is drawn a fraction of a pixel beside is the same


def squares_of(path):
    """The mean colours of squares of pixels, 0 to 1."""
    pixels = pixels_of_png(path) / 255
    height, width, channels = pixels.shape
    return pixels.reshape(height // SQUARE, SQUARE, width // SQUARE, SQUARE, channels).mean(axis=(1, 3))


class GalleryTest(unittest.TestCase):
    def test_each_script_draws_its_picture(self):
        for name in draw_gallery.ORDER:
            with self.subTest(name), draw_gallery.run(name):
                self.assertEqual(set(os.listdir()), {"Data", f"{name}.png"})
                self.assertEqual(pixels_of_png(f"{name}.png").shape, (360, 480, 3))
                drawn, shown = squares_of(f"{name}.png"), squares_of(draw_gallery.PICTURES / f"{name}.png")
                self.assertLess(np.sqrt(np.mean((drawn - shown)**2)), CLOSE)

    def test_the_page_has_each_script_and_its_measures(self):
        page = draw_gallery.PAGE.read_text(encoding="utf-8")
        self.assertEqual({script.stem for script in draw_gallery.SCRIPTS.glob("*.py")}, set(draw_gallery.ORDER))
        self.assertEqual(re.findall(r"^```python\n(.*?)^```$", page, re.MULTILINE | re.DOTALL),
                         [draw_gallery.code_of(name) for name in draw_gallery.ORDER])
        self.assertEqual(re.findall(r"!\[[^]]*\]\(Pictures/gallery/(\w+)\.png\)", page), list(draw_gallery.ORDER))
        self.assertEqual(len(re.findall(r"^[\d.e-]+ s a frame; error [\d.e-]+ RMS, [\d.e-]+ at most\.$", page,
                                        re.MULTILINE)), len(draw_gallery.ORDER))

    def test_scripts_and_pictures_are_small(self):
        for name in draw_gallery.ORDER:
            lines = (draw_gallery.SCRIPTS / f"{name}.py").read_text(encoding="utf-8").splitlines()
            self.assertLessEqual(len(lines), MOST_LINES, name)
            self.assertLessEqual(max(map(len, lines)), 120, name)
        sizes = [picture.stat().st_size for picture in draw_gallery.PICTURES.glob("*.png")]
        self.assertEqual(len(sizes), len(draw_gallery.ORDER))
        self.assertLess(sum(sizes), MOST_BYTES)


if __name__ == "__main__":
    unittest.main(verbosity=2)
