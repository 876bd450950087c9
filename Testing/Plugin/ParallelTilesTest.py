# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A tile display of pvserver, two screens side by side, shows the volume: ParallelTilesTest.py PVBATCH PLUGIN"""
import pathlib
import shutil
import subprocess
import sys
import unittest

import numpy as np

from parallel_runs import HERE, ParallelCase, environment, run_batch, write_pieces
from pictures import read_png, read_xwd
from programs import serving

PVBATCH = PLUGIN = None
PROCESSES = 2
# Of 255. After redistribution pictures of bytes are put over each other; before, boxes of slabs overlap by a cell.
MOST_MOVED = 2
MOST_LYING_RMS = 1.0
BACKGROUND = [51, 76, 26]


def screen_of(file):
    """Rows from the bottom, as those of PNG files."""
    return read_xwd(file.read_bytes())[::-1].astype(int)


class ParallelTilesTest(ParallelCase):
    @classmethod
    def setUpClass(cls):
        if not shutil.which("Xvfb"):
            raise unittest.SkipTest("there is no Xvfb")
        super().setUpClass()
        cls.screens = [cls.open_screen(tile) for tile in range(PROCESSES)]
        one = cls.folder / "one"
        one.mkdir()
        run_batch(one, PVBATCH, 1, "draw_tiles.py", "--plugin", PLUGIN, "--data",
                  write_pieces(cls.grid, "slabs", 1, one), "--folder", one)
        cls.of_one = read_png(one / "one.png")

    @classmethod
    def open_screen(cls, tile):
        """The display's number, and the file of its frame buffer."""
        folder = cls.folder / f"screen{tile}"
        folder.mkdir()
        server = subprocess.Popen(["Xvfb", "-displayfd", "1", "-noreset", "-screen", "0", "320x240x24", "-fbdir", folder],
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        cls.addClassCleanup(server.stdout.close)
        cls.addClassCleanup(server.wait, 30)
        cls.addClassCleanup(server.terminate)
        return ":" + server.stdout.readline().strip(), folder / "Xvfb_screen0"

    def show(self, partition):
        """What the screens show, by scene, and what the server printed."""
        folder = self.folder / partition
        folder.mkdir()
        data = write_pieces(self.grid, partition, PROCESSES, folder)
        programs = pathlib.Path(PVBATCH).parent
        variables = environment(folder)
        displays = ",".join(display for display, _ in self.screens)
        printed = folder / "server.txt"
        words = ["mpiexec", "-n", str(PROCESSES), programs / "pvserver", "--tdx=2", "--tdy=1", f"--displays={displays}"]
        with serving(words, printed, variables) as (server, port):
            result = subprocess.run(
                [programs / "pvpython", HERE / "draw_tiles.py", "--plugin", PLUGIN, "--data", data, "--folder", folder,
                 "--server", str(port), "--screens", *(file for _, file in self.screens)],
                text=True, timeout=1000, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=variables)
            self.assertEqual(result.returncode, 0, result.stdout + printed.read_text())
            server.wait(1000)
        return {name: np.hstack([screen_of(folder / f"{name}-{tile}.xwd") for tile in range(PROCESSES)])
                for name in ("lying", "moved", "maximum")}, printed.read_text()

    def test_tiles_are_parts_of_the_picture(self):
        pictures, printed = self.show("slabs")
        errors = [line for line in printed.splitlines() if "ERR|" in line]
        lying = pictures["lying"] - self.of_one
        self.assertLessEqual(np.sqrt((lying**2).mean()), MOST_LYING_RMS)
        if any("Cells were not redistributed" in error for error in errors):
            np.testing.assert_array_equal(pictures["moved"], pictures["lying"])
        else:
            self.assertLessEqual(np.abs(pictures["moved"] - self.of_one).max(), MOST_MOVED)
        self.assertEqual(sum("in the blend mode MaximumIntensity" in error for error in errors), 1, printed)
        self.assertTrue((pictures["maximum"] == BACKGROUND).all(), "pieces were drawn over each other")

    def test_both_tiles_show_something(self):
        """Of the picture of one process, by which the other test goes."""
        for half in np.hsplit(self.of_one, PROCESSES):
            self.assertGreater(len(np.unique(half.reshape(-1, 3), axis=0)), 100)


if __name__ == "__main__":
    PVBATCH, PLUGIN = sys.argv.pop(1), sys.argv.pop(1)
    unittest.main(verbosity=2)
