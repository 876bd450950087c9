# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView in several processes shows the picture of one, whatever pieces they have: ParallelTest.py PVBATCH PLUGIN [TEST...]"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

from parallel_runs import HERE, ParallelCase, environment, partitions, run_batch, write_pieces
from pictures import read_png
from programs import serving

PVBATCH = PLUGIN = None
MOST = 2  # of 255: how far a channel of a pixel may be off
EXACT = ("composite", "maximum", "minimum", "average", "additive", "isosurface", "shaded", "cropped", "cells", "inside",
         "surface", "moving", "reduced", "hidden")
# Partition, processes, and what of draw_parallel.py is drawn. Testing/Processes has more partitions and processes.
RUNS = (("spirals", 4, EXACT), ("random_cells", 2, ("composite", "maximum", "surface")),
        ("only_last", 3, ("composite", "surface", "reduced")),
        ("ghosts", 4, ("composite", "shaded", "cells", "inside")))
# After redistribution pictures of bytes are put over each other, which rounds once for each process but one.
REDISTRIBUTED = (("spirals", 2, ("composite", "isosurface", "surface", "translucent", "hidden")),
                 ("random_cells", 4, ("composite", "cells", "inside")), ("ghosts", 3, ("composite", "cropped")))


class DrawnCase(ParallelCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.of_one = cls.draw("slabs", 1, ())

    @classmethod
    def draw(cls, partition, processes, scenes, *options, may_fail=False):
        folder = pathlib.Path(tempfile.mkdtemp(dir=cls.folder))
        data = write_pieces(cls.grid, partition, processes, folder)
        printed = run_batch(folder, PVBATCH, processes, "draw_parallel.py", "--plugin", PLUGIN, "--data", data,
                            "--folder", folder, *options, *(["--scenes", *scenes] if scenes else []))
        cls.errors = [line for line in printed.splitlines() if "ERR|" in line]
        if cls.errors and not may_fail:
            raise AssertionError(printed)
        read = json.loads((folder / "read.json").read_text())
        ghosts = partition == "ghosts"
        cells = cls.grid.GetNumberOfCells()
        if read["processes"] != processes or (read["cells"] <= cells if ghosts else read["cells"] != cells):
            raise AssertionError(f"{read} was read, but there are {cells} cells in {processes} pieces")
        cls.figures = json.loads((folder / "figures.json").read_text())
        return {file.stem: read_png(file) for file in folder.glob("*.png")}

    def expect_same(self, pixels, of_one, most=MOST):
        apart = np.abs(pixels - of_one)
        self.assertLessEqual(apart.max(), most, f"{np.count_nonzero(apart > most)} values")


class ExactTest(DrawnCase):
    def test_one_process_shows_something(self):
        for name, pixels in self.of_one.items():
            self.assertGreater(len(np.unique(pixels.reshape(-1, 3), axis=0)), 20, name)

    def test_exact_pictures(self):
        reduced = []
        for partition, processes, scenes in RUNS:
            pictures = self.draw(partition, processes, scenes)
            reduced += [pictures.pop("reduced")] if "reduced" in pictures else []
            for name, pixels in pictures.items():
                with self.subTest(partition=partition, processes=processes, scene=name):
                    self.expect_same(pixels, self.of_one[name])
        with self.subTest("fewer pixels, which one process alone doesn't have"):
            for pixels in reduced[1:]:
                self.expect_same(pixels, reduced[0])
            self.assertGreater(np.abs(reduced[0] - self.of_one["composite"]).max(), 5 * MOST)


class RunsTest(DrawnCase):
    def test_without_icet(self):
        self.expect_same(self.draw("spirals", 2, ("composite",), "--without-icet")["composite"],
                         self.of_one["composite"])

    def test_redistributed_cells(self):
        """Where VTK can move cells; else there is one error, and no crash."""
        for partition, processes, scenes in REDISTRIBUTED:
            pictures = self.draw(partition, processes, scenes, "--redistribute", may_fail=True)
            if tells_fault := [error for error in self.errors if "not redistributed: VTK loses the cells" in error]:
                self.assertEqual(len(tells_fault), len(scenes), self.errors)
                continue  # what ParaView's own surfaces lose is not ours
            self.assertFalse(self.errors)
            for name, pixels in pictures.items():
                with self.subTest(partition=partition, processes=processes, scene=name):
                    self.expect_same(pixels, self.of_one[name], MOST + processes - 1)

    def test_blend_modes_of_pieces(self):
        """A greatest value can't be drawn over another one."""
        pixels = self.draw("spirals", 2, ("maximum",), "--pieces", may_fail=True)["maximum"]
        self.assertEqual(len(self.errors), 1, self.errors)
        self.assertIn("in the blend mode MaximumIntensity", self.errors[0])
        self.assertEqual(len(np.unique(pixels)), 1, "something was drawn")

    def test_figures_of_process_0(self):
        self.draw("metis" if partitions.has_metis() else "slabs", 2, ("composite",))
        for name, value in self.figures["composite"].items():
            self.assertGreater(value, 0, name)

    def test_a_client_shows_what_servers_draw(self):
        """pvserver in two processes; pvpython is the client."""
        folder = self.folder / "client"
        folder.mkdir()
        data = write_pieces(self.grid, "spirals", 2, folder)
        programs = pathlib.Path(PVBATCH).parent
        variables = environment(folder)
        with serving(["mpiexec", "-n", "2", programs / "pvserver"], folder / "server.txt", variables) as (_, port):
            result = subprocess.run(
                [programs / "pvpython", HERE / "draw_parallel.py", "--plugin", PLUGIN, "--data", data, "--folder", folder,
                 "--server", str(port), "--scenes", "composite", "surface", "moving"],
                text=True, timeout=1000, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=variables)
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertNotIn("ERR|", result.stdout)
        for name in ("composite", "surface", "moving"):
            with self.subTest(name):
                self.expect_same(read_png(folder / f"{name}.png"), self.of_one[name])

    def test_pieces_over_each_other_differ(self):
        """So the test above can fail."""
        pixels = self.draw("spirals", 2, ("composite",), "--pieces")["composite"]
        self.assertGreater(np.abs(pixels - self.of_one["composite"]).max(), 5 * MOST)


if __name__ == "__main__":
    PVBATCH, PLUGIN = sys.argv.pop(1), sys.argv.pop(1)
    unittest.main(verbosity=2)
