# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples for Python run as they are, and their pictures show what they tell of."""
import importlib.util
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

from PicturesTest import pixels_of_png

PROJECT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = PROJECT / "Documentation" / "Examples"
MOST_LINES = 40


def share(condition):
    """Of the pixels."""
    return float(np.mean(condition))


class ExamplesTest(unittest.TestCase):
    def run_example(self, name, *pictures):
        """What it prints, and its pictures as arrays, each channel 0 to 1."""
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "Data").symlink_to(PROJECT / "Data")
            run = subprocess.run([sys.executable, str(EXAMPLES / name)], cwd=folder, capture_output=True, text=True,
                                 timeout=1000)
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertEqual(sorted(path.name for path in folder.glob("*.png")), sorted(pictures))
            found = [pixels_of_png(folder / picture)[:, :, :3] / 255 for picture in pictures]
        return run.stdout, [(picture[:, :, 0], picture[:, :, 1], picture[:, :, 2]) for picture in found]

    def test_each_is_short_and_tested(self):
        files = sorted(set(EXAMPLES.glob("*.py")) - {EXAMPLES / "remote_view.py"})  # RemoteViewTest.py's
        self.assertEqual(len(files), 6)
        text = pathlib.Path(__file__).read_text(encoding="utf-8")
        for file in files:
            lines = file.read_text(encoding="utf-8").splitlines()
            self.assertLessEqual(len(lines), MOST_LINES, file.name)
            self.assertLessEqual(max(map(len, lines)), 120, file.name)
            self.assertIn(f'run_example("{file.name}"', text)

    def test_first_picture(self):
        printed, ((r, g, b), (wr, wg, wb)) = self.run_example("first_picture.py", "first_picture.png", "wake.png")
        self.assertRegex(printed, r"^271607 tetrahedra in \d+\.\d\d s\n$")
        self.assertGreater(share((r > 0.5) & (b < 0.3)), 0.01)
        self.assertGreater(share((b > g + 0.15) & (b > 0.3)), 0.003)
        self.assertGreater(share((wr > 0.4) & (wr > wg + 0.1)), 0.05)
        self.assertGreater(share(np.maximum(wr, wb) < 0.05), 0.5)

    def test_accuracy(self):
        if not importlib.util.find_spec("matplotlib"):
            self.skipTest("Matplotlib isn't installed")
        _, ((r, g, b),) = self.run_example("accuracy.py", "accuracy.png")
        self.assertGreater(share((r > 0.9) & (g > 0.9) & (b > 0.9)), 0.005)  # text
        self.assertGreater(share((r > 0.85) & (g > 0.85) & (b < 0.3)), 0.0002)  # the most accurate one

    def test_light(self):
        _, ((r, g, b),) = self.run_example("light.py", "light.png")
        self.assertGreater(share((g > 0.3) & (g > 1.3 * r)), 0.04)  # leaves
        self.assertGreater(share((r > 0.7) & (r > 1.2 * g)), 0.01)  # where the pot is cut
        self.assertGreater(share(g < 0.08), 0.4)

    def test_time_series(self):
        printed, frames = self.run_example("time_series.py", *(f"dye_{frame:02}.png" for frame in range(12)))
        self.assertEqual(printed, "the mesh was prepared 1 time, the values 12 times\n")
        for one, next_one in zip(frames, frames[1:]):
            self.assertGreater(np.abs(one[1] - next_one[1]).max(), 0.1)
        self.assertGreater(min(share(g > 0.3) for _, g, _ in frames), 0.02)

    def test_clipping(self):
        _, ((r, g, b),) = self.run_example("clipping.py", "clipping.png")
        self.assertGreater(share((r > 0.5) & (r > 1.5 * b)), 0.005)  # high pressure before the ball
        self.assertGreater(share((b > 0.5) & (b > 1.5 * r)), 0.02)  # low pressure beside it
        middle = np.s_[200:320, 310:420]
        self.assertGreater(share((np.abs(r - g)[middle] < 0.05) & (r[middle] > 0.4)), 0.5)  # the ball

    def test_picking(self):
        printed, ((r, g, b),) = self.run_example("picking.py", "picking.png")
        rows = [re.split(r"[ ,()]+", line.strip(" )")) for line in printed.splitlines()[1:]]
        self.assertGreater(len(rows), 5)
        for _, cell, vorticity, x, y, z in rows:
            self.assertTrue(0 <= int(cell) < 271607 and float(vorticity) > 1, rows)
            self.assertLess(max(abs(float(y)), abs(float(z))), 1)
        positions = [float(row[3]) for row in rows]
        self.assertEqual(positions, sorted(positions))
        self.assertGreater(share((r > 0.5) & (r > 2 * g)), 1e-4 * len(rows))


if __name__ == "__main__":
    unittest.main(verbosity=2)
