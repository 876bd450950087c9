# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever pieces several processes have, the picture is that of one process: PicturesTest.py [PROCESSES...]"""
import json
import pathlib
import sys
import tempfile
import unittest

import numpy as np

import mpi
import partitions
from draw_pieces import SCENES

PROCESSES = tuple(map(int, sys.argv[1:])) or (2, 4, 8)
MOST = 2  # of 255: how far a channel of a pixel may be off
MOST_OF = {"shadows": 40}  # each piece casts shadows in itself alone: Documentation/Processes.md


class PicturesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not mpi.has_mpi():
            raise unittest.SkipTest("there is no mpiexec")
        names = [name for name in SCENES if partitions.has_metis() or name != "metis"]
        cls.pictures, cls.figures = {}, {}
        with tempfile.TemporaryDirectory() as folder:
            for count in (1, *PROCESSES):
                output = pathlib.Path(folder) / f"{count}.npz"
                printed = mpi.run(count, "draw_pieces.py", output, *names)
                if "ERR|" in printed or "WARN|" in printed:
                    raise AssertionError(printed)
                with np.load(output) as drawn:
                    cls.pictures[count] = {name: drawn[name].astype(int) for name in names}
                    cls.figures[count] = json.loads(str(drawn["figures"]))
        cls.names = names

    def each(self):
        return [(count, name) for count in PROCESSES for name in self.names]

    def test_all_processes_draw_the_picture_of_one(self):
        for count, name in self.each():
            apart = np.abs(self.pictures[count][name] - self.pictures[1][name])
            with self.subTest(scene=name, processes=count):
                self.assertLessEqual(apart.max(), MOST_OF.get(name, MOST), f"{np.count_nonzero(apart > MOST)} values")

    def test_there_is_something_to_see(self):
        for name in self.names:
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
        for count in PROCESSES:
            figures = self.figures[count]["behind_crust"]
            first, then = (sum(figures[name][1:]) for name in ("FirstVisits", "NumberOfVisits"))
            self.assertLess(then, 0.2 * first)  # but for what is seen through the hole
            figures = self.figures[count]["dense_random"]
            # The first picture has saved some by its turns.
            self.assertLess(sum(figures["NumberOfVisits"]), 0.9 * sum(figures["FirstVisits"]))

    def test_of_what_is_seen_each_picture_has_the_same_visits(self):
        for count in PROCESSES:
            for name in ("composite", "random", "maximum", "minimum", "average"):
                figures = self.figures[count][name]
                self.assertEqual(figures["NumberOfVisits"], figures["FirstVisits"])

    def test_one_process_sends_nothing(self):
        for name in self.names:
            self.assertEqual(self.figures[1][name]["SentBytes"], [0])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
