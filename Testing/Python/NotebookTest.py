# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The notebook among the examples runs in a kernel, and shows the pictures that a script draws."""
import base64
import importlib.util
import os
import pathlib
import tempfile
import unittest

import numpy as np

import vtktetmarch
from PicturesTest import pixels_of_png

PROJECT = pathlib.Path(__file__).resolve().parents[2]
NOTEBOOK = PROJECT / "Documentation" / "Examples" / "notebook.ipynb"
MISSING = [name for name in ("nbclient", "nbformat", "ipykernel", "ipywidgets") if not importlib.util.find_spec(name)]


@unittest.skipIf(MISSING, f"{', '.join(MISSING)} isn't installed: apt-get install python3-nbclient python3-ipykernel "
                          "python3-ipywidgets")
class NotebookTest(unittest.TestCase):
    def setUp(self):
        import nbformat
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "Data").symlink_to(PROJECT / "Data")
        self.notebook = nbformat.read(NOTEBOOK, as_version=4)

    def pictures(self):
        """Of the outputs that are PNG, as arrays."""
        found = []
        for cell in self.notebook.cells:
            for output in cell.get("outputs", ()):
                if "image/png" in output.get("data", {}):
                    found.append(pixels_of_png(base64.b64decode(output["data"]["image/png"])).copy())
        return found

    def test_it_has_no_outputs(self):
        for cell in self.notebook.cells:
            self.assertFalse(cell.get("outputs") or cell.get("execution_count"))

    def test_its_pictures_are_those_of_a_script(self):
        from nbclient import NotebookClient

        class Client(NotebookClient):
            def handle_comm_msg(self, *_):
                """Messages to a front end; Debian 12's nbclient fails at those of Debian 12's ipywidgets."""

        Client(self.notebook, timeout=600, kernel_name="python3",
               resources={"metadata": {"path": str(self.folder)}}).execute()
        first, last = self.pictures()
        how = dict(range=(0.5, 9), cmap="magma", size=(480, 320))
        os.chdir(self.folder)
        expected = vtktetmarch.screenshot("Data/golfball_small.vtu", "vorticity_mag", unit_distance=0.1,
                                          opacity=[(0.6, 0), (2, 0.12), (5, 0.5), (9, 1)], **how)
        self.assertTrue(np.array_equal(first, expected))
        expected = vtktetmarch.screenshot("Data/golfball_small.vtu", "vorticity_mag", unit_distance=0.05,
                                          opacity=[(0.6, 0), (2, 0.05), (5, 0.3), (9, 1)], camera={"azimuth": 25}, **how)
        self.assertTrue(np.array_equal(last, expected))


if __name__ == "__main__":
    unittest.main(verbosity=2)
