# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever pieces several processes have, the picture is that of one process"""
import json
import pathlib
import tempfile
import unittest

import numpy as np

import mpi
import partitions
from draw_pieces import SCENES

# Four processes draw every scene; other counts change who meets whose visits, and draw those where that matters.
EVERY = tuple(SCENES)
BY_PARTITION = ("composite", "random", "metis", "random_ghosts", "average", "isosurface_random", "behind_crust",
                "dense_random", "dense_bands", "bands", "shadows")
DRAWN = {1: EVERY, 2: BY_PARTITION, 4: EVERY, 8: BY_PARTITION}
MOST = 2  # of 255: how far a channel of a pixel may be off
MOST_OF = {"shadows": 40}  # each piece casts shadows in itself alone: Documentation/Processes.md


class PicturesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not mpi.has_mpi():
            raise unittest.SkipTest("there is no mpiexec")
        cls.names = {count: [name for name in names if partitions.has_metis() or name != "metis"]
                     for count, names in DRAWN.items()}
        cls.pictures, cls.figures = {}, {}
        with tempfile.TemporaryDirectory() as folder:
            for count, names in cls.names.items():
                output = pathlib.Path(folder) / f"{count}.npz"
                printed = mpi.run(count, "draw_pieces.py", output, *names)
                if "ERR|" in printed or "WARN|" in printed:
                    raise AssertionError(printed)
                with np.load(output) as drawn:
                    cls.pictures[count] = {name: drawn[name].astype(int) for name in names}
                    cls.figures[count] = json.loads(str(drawn["figures"]))

    def each(self, *names):
        return [(count, name) for count, drawn in self.names.items() for name in drawn
                if count > 1 and (not names or name in names)]

    def test_all_processes_draw_the_picture_of_one(self):
        for count, name in self.each():
            apart = np.abs(self.pictures[count][name] - self.pictures[1][name])
            with self.subTest(scene=name, processes=count):
                self.assertLessEqual(apart.max(), MOST_OF.get(name, MOST), f"{np.count_nonzero(apart > MOST)} values")

    def test_there_is_something_to_see(self):
        for name in self.names[1]:
            with self.subTest(scene=name):
                colors, counts = np.unique(self.pictures[1][name].reshape(-1, 4), axis=0, return_counts=True)
                self.assertGreater(len(colors), 20)
                self.assertLess(counts.max(), 0.9 * counts.sum())

    def test_each_cell_is_drawn_by_one_process(self):
        for count, name in self.each():
            tetrahedra = self.figures[count][name]["NumberOfTetrahedra"]
            self.assertEqual(len(tetrahedra), count)
            self.assertEqual(sum(tetrahedra), self.figures[1][name]["NumberOfTetrahedra"][0])

    def test_figures_tell_what_it_took(self):
        for count, name in self.each():
            figures = self.figures[count][name]
            self.assertGreater(sum(figures["NumberOfVisits"]), 0)
            self.assertGreater(min(figures["SentBytes"]), 0)
            for stage in ("ExchangeSeconds", "MergeSeconds", "SpreadSeconds"):
                self.assertGreater(min(figures[stage]), 0)
            bound = figures["SharedErrorBound"]
            self.assertEqual(max(bound), min(bound))

    def test_what_is_hidden_by_other_processes_is_not_marched(self):
        for count, name in self.each("behind_crust"):
            figures = self.figures[count][name]
            first, then = (sum(figures[name][1:]) for name in ("FirstVisits", "NumberOfVisits"))
            self.assertLess(then, 0.2 * first)  # but for what is seen through the hole
        for count, name in self.each("dense_random"):
            figures = self.figures[count][name]
            # The first picture has saved some by its turns.
            self.assertLess(sum(figures["NumberOfVisits"]), 0.9 * sum(figures["FirstVisits"]))

    def test_of_what_is_seen_each_picture_has_the_same_visits(self):
        for count, name in self.each("composite", "random", "maximum", "minimum", "average"):
            figures = self.figures[count][name]
            self.assertEqual(figures["NumberOfVisits"], figures["FirstVisits"])

    def test_one_process_sends_nothing(self):
        for name in self.names[1]:
            self.assertEqual(self.figures[1][name]["SentBytes"], [0])


if __name__ == "__main__":
    unittest.main(verbosity=2)
