# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The README's Python example, word for word, and the links of all pages: ReadmeTest.py PROJECT_FOLDER."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import vtkmodules.all as vtk

PROJECT = None
MOST_LINES = 15


def read_pixels(path):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    values = image.GetPointData().GetScalars()
    assert values.GetNumberOfComponents() == 3
    flat = memoryview(values).tobytes()
    return [tuple(flat[i:i + 3]) for i in range(0, len(flat), 3)]


def share(pixels, condition):
    return sum(condition(*pixel) for pixel in pixels) / len(pixels)


class ReadmeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.text = (PROJECT / "README.md").read_text(encoding="utf-8")

    def example(self):
        blocks = re.findall(r"^```python\n(.*?)^```$", self.text, re.MULTILINE | re.DOTALL)
        self.assertEqual(len(blocks), 2, "the README has an example, and one that goes on from it")
        return blocks[0]

    def test_the_example_is_short(self):
        self.assertLessEqual(len([line for line in self.example().splitlines() if line.strip()]), MOST_LINES)

    def test_the_example_draws_the_volume(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "Data").symlink_to(PROJECT / "Data")
            (folder / "example.py").write_text(self.example(), encoding="utf-8")
            result = subprocess.run([sys.executable, "example.py"], cwd=folder, text=True, capture_output=True,
                                    timeout=300)
            self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
            pictures = list(folder.glob("*.png"))
            self.assertEqual(len(pictures), 1, os.listdir(folder))
            pixels = read_pixels(pictures[0])
        # The ball and the near wake are orange, the far wake is blue, most of the stream is all but black.
        self.assertGreater(share(pixels, lambda r, g, b: r > 120 and r > 1.3 * b), 0.01)
        self.assertGreater(share(pixels, lambda r, g, b: b > 60 and b > 1.3 * r), 0.03)
        self.assertGreater(share(pixels, lambda r, g, b: max(r, g, b) < 32), 0.5)

    def test_links_lead_somewhere(self):
        pages = [PROJECT / "README.md"]
        for folder in ("Data", "Documentation", "Plugin", "Shaders", "Testing", "VTKModule"):
            pages += [page for page in sorted((PROJECT / folder).rglob("*.md"))
                      if not page.name.endswith("Page.md")]  # of which a page elsewhere is made
        links = [(page, link) for page in pages
                 for link in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8"))]
        self.assertIn((PROJECT / "README.md", "Data/golfball_wake.png"), links)
        self.assertEqual([f"{page.relative_to(PROJECT)}: {link}" for page, link in links
                          if not (page.parent / link).exists()], [])


if __name__ == "__main__":
    PROJECT = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main(verbosity=2)
