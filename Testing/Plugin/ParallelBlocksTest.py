# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Blocks in several processes look as in one, whoever has which: ParallelBlocksTest.py PVBATCH PLUGIN"""
import json
import sys
import unittest

import numpy as np

from parallel_runs import ParallelCase, partitions, run_batch, write_inline
from pictures import read_png

PVBATCH = PLUGIN = None
MOST = 2  # of 255: how far a channel of a pixel may be off
BLOCKS = 3


class ParallelBlocksTest(ParallelCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.block = partitions.slabs(cls.grid, BLOCKS)
        cls.of_one = cls.draw("one", np.zeros(cls.grid.GetNumberOfCells(), dtype=int), 1)

    @classmethod
    def draw(cls, name, owner, processes):
        """Pictures, by name; each process has the cells that it owns, in their blocks."""
        folder = cls.folder / name
        folder.mkdir()
        for process in range(processes):
            own = partitions.piece_of(cls.grid, owner, process)
            blocks_of_own = cls.block[owner == process]
            for block in np.unique(blocks_of_own):
                write_inline(partitions.piece_of(own, blocks_of_own, block), folder / f"{block}-{process}.vtu")
        printed = run_batch(folder, PVBATCH, processes, "draw_blocks.py", "--plugin", PLUGIN, "--data", folder)
        if "ERR|" in printed or "WARN|" in printed:
            raise AssertionError(printed)
        cells = cls.grid.GetNumberOfCells()
        read = json.loads((folder / "read.json").read_text())
        if read != {"blocks": cells, "collection": cells, "processes": processes}:
            raise AssertionError(f"{read} was read, but there are {cells} cells in {processes} processes")
        return {file.stem: read_png(file) for file in folder.glob("*.png")}

    def expect_pictures_of_one(self, pictures):
        self.assertEqual(set(pictures), set(self.of_one))
        for name, pixels in pictures.items():
            with self.subTest(name):
                apart = np.abs(pixels - self.of_one[name])
                self.assertLessEqual(apart.max(), MOST, f"{np.count_nonzero(apart > MOST)} values")

    def test_hidden_blocks_are_not_seen(self):
        for kind in ("blocks", "collection"):
            for one, other in (("all", "two"), ("two", "one"), ("all", "one")):
                apart = np.abs(self.of_one[f"{kind}-{one}"] - self.of_one[f"{kind}-{other}"])
                self.assertGreater(apart.max(), 20 * MOST, (kind, one, other))

    def test_each_process_has_a_part_of_each_block(self):
        self.expect_pictures_of_one(self.draw("parts", partitions.spirals(self.grid, 2), 2))

    def test_each_process_has_whole_blocks(self):
        """One process has none."""
        self.expect_pictures_of_one(self.draw("whole", np.array([2, 0, 2])[self.block], 4))

    def test_one_block_is_shared_out(self):
        owner = np.where(self.block == 1, partitions.random_cells(self.grid, 3), 1)
        self.expect_pictures_of_one(self.draw("shared", owner, 3))


if __name__ == "__main__":
    PVBATCH, PLUGIN = sys.argv.pop(1), sys.argv.pop(1)
    unittest.main(verbosity=2)
