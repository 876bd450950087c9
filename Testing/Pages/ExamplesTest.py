# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pages' Python, word for word: ExamplesTest.py BUILD_FOLDER."""
import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import vtkmodules.all as vtk

from pages import PROJECT, fenced_blocks, folder_of_a_user, indented_blocks, name_of, pages, text_of

BUILD = None
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


class ExamplesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        (cls.example,) = fenced_blocks(text_of("README.md"), "python")
        cls.example_of_python, cls.example_with_vtk = fenced_blocks(text_of("Documentation/Python.md"), "python")
        # With the interpreter for which the package was built.
        (command,) = re.findall(r"^PYTHONPATH=.*$", "\n".join(indented_blocks(text_of("README.md"))), re.MULTILINE)
        cls.command = command.replace("/usr/bin/python3", sys.executable)

    def setUp(self):
        self.folder = folder_of_a_user(self, BUILD)

    def run_example(self, text):
        """As the README says; returns what is printed."""
        (self.folder / "example.py").write_text(text, encoding="utf-8")
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        result = subprocess.run(["bash", "-c", self.command], cwd=self.folder, env=environment, text=True,
                                capture_output=True, timeout=1000)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout

    def test_the_readmes_is_short(self):
        self.assertLessEqual(len([line for line in self.example.splitlines() if line.strip()]), MOST_LINES)

    def test_those_of_the_wake_draw_it(self):
        for example in (self.example, self.example_with_vtk):
            with self.subTest(example=example):
                self.assertEqual(self.run_example(example), "")
                pixels = read_pixels(self.folder / "golfball.png")
                # The ball and the near wake are orange, the far wake is blue, most of the stream is all but black.
                self.assertGreater(share(pixels, lambda r, g, b: r > 120 and r > 1.3 * b), 0.01)
                self.assertGreater(share(pixels, lambda r, g, b: b > 60 and b > 1.3 * r), 0.03)
                self.assertGreater(share(pixels, lambda r, g, b: max(r, g, b) < 40), 0.5)

    def test_those_of_accuracy_go_on_from_it(self):
        """The first prints the greatest error bound, the mean of cells, and an error; the second what a budget chose."""
        blocks = fenced_blocks(text_of("Documentation/AccuracyLevels.md"), "python")
        self.assertEqual(len(blocks), 4)
        printed = self.run_example(self.example_with_vtk + "".join(blocks)).splitlines()
        measured, true_error, budget, interpolated, rays = printed
        bound, cells = map(float, measured.split())
        # The tolerance is 1e-5; the steps of the tables' integrals are in the bound, too.
        self.assertTrue(0 < bound < 1e-3 and cells > 10, measured)
        self.assertTrue(0 <= float(true_error) <= bound, true_error)
        self.assertRegex(budget, r"^[0-3] [0-9.e-]+ (True|False)$")
        self.assertEqual(interpolated, "0.0")  # none, with a budget of the error
        self.assertTrue(1000 < int(rays) < 100000, rays)

    def test_that_of_python_prints_what_is_known_of_the_picture(self):
        shape, known = self.run_example(self.example_of_python).splitlines()
        self.assertEqual(shape, "(200, 300, 4) 271607")
        self.assertRegex(known, r"^(None|\{'position': .*\}) True$")
        pixels = read_pixels(self.folder / "speed.png")
        self.assertGreater(share(pixels, lambda r, g, b: max(r, g, b) > 60), 0.05)

    def test_that_of_five_minutes_chooses(self):
        (block,) = fenced_blocks(text_of("Documentation/FiveMinutes.md"), "python")
        self.assertRegex(self.run_example(block), r"^speed \(0\.\d+, 1\.\d+\) 0\.\d+\n$")
        pixels = read_pixels(self.folder / "first_of_python.png")
        self.assertGreater(share(pixels, lambda r, g, b: max(r, g, b) > 30), 0.2)

    def test_that_of_several_processes_draws_the_volume(self):
        if not shutil.which("mpiexec") or not importlib.util.find_spec("mpi4py"):
            self.skipTest("there is no MPI")
        page = text_of("Documentation/Processes.md")
        (block,) = fenced_blocks(page, "python")
        (command,) = re.findall(r"^ +(PYTHONPATH=.*parallel\.py)$", page, re.MULTILINE)
        (self.folder / "parallel.py").write_text(block, encoding="utf-8")
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                           OMPI_MCA_rmaps_base_oversubscribe="1", LP_NUM_THREADS="1",
                           PRTE_MCA_rmaps_default_mapping_policy=":oversubscribe")
        result = subprocess.run(["bash", "-c", command.replace("/usr/bin/python3", sys.executable)], cwd=self.folder,
                                env=environment, text=True, capture_output=True, timeout=1000)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotIn("ERR|", result.stderr)
        pixels = read_pixels(self.folder / "parallel.png")
        self.assertGreater(share(pixels, lambda r, g, b: r > 100 and r > 1.3 * b), 0.005)
        self.assertGreater(share(pixels, lambda r, g, b: max(r, g, b) > 0), 0.1)

    def test_properties_of_the_plugins_are_its_own(self):
        """That example needs ParaView; here its properties and their values are looked up in what ParaView reads."""
        (block,) = fenced_blocks(text_of("Plugin/README.md"), "python")
        files = sorted(PROJECT.glob("Plugin/Representation/*.xml.in"))
        self.assertTrue(files)
        properties = "".join(map(text_of, files)) + self.settings_as_xml()
        for line in block.splitlines():
            for name, value in re.findall(r"display\.(TetMarch\w+) = (.*)", line):
                with self.subTest(property=name):
                    self.assertIn(f'name="{name}"', properties)
                    for text in re.findall(r'"([^"]+)"', value):
                        self.assertIn(f'text="{text}"', properties)

    @staticmethod
    def settings_as_xml():
        settings = [row for row in json.loads(text_of("VTKModule/Mapper/settings.json")) if "panel" in row]
        names = [f'name="TetMarch{row["name"]}"' for row in settings]
        choices = [choice for row in settings for choice in row.get("choices", [])]
        spaced = [re.sub("([a-z])([A-Z])", r"\1 \2", choice["name"]) for choice in choices]
        labels = [choice.get("label", words) for choice, words in zip(choices, spaced)]
        return "".join(names + [f'text="{label}"' for label in labels])

    def test_every_example_is_here(self):
        shown = [name_of(page) for page in pages() if fenced_blocks(page.read_text(encoding="utf-8"), "python")]
        self.assertEqual(shown, ["Documentation/AccuracyLevels.md", "Documentation/FiveMinutes.md",
                                 "Documentation/Gallery.md", "Documentation/Processes.md", "Documentation/Python.md",
                                 "Plugin/README.md", "README.md"])


if __name__ == "__main__":
    BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main(verbosity=2)
