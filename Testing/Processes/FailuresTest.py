# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong in one process is one error of the first, no process draws the volume, and none waits for ever."""
import unittest

import mpi

WORDS = {
    "without_array": "Process 1: .*field",
    "other_kind": "scalars are of different kinds",
    "short_of_memory": "Process 1: .*MaxMemoryInBytes",
    "bad_points": "Process 1: .*finite",
    "other_window": "viewports of different sizes",
    "aborted": None,
    "bad_view": "Process 1: .*view mode",
}


class FailuresTest(unittest.TestCase):
    def setUp(self):
        if not mpi.has_mpi():
            self.skipTest("there is no mpiexec")

    def check(self, case):
        printed = mpi.run(3, "fail_pieces.py", case, seconds=120)
        for rank in range(3):
            self.assertIn(f"process {rank}: False False True", printed)
        if WORDS[case]:
            self.assertRegex(printed, WORDS[case])
            self.assertEqual(printed.count("ERR|"), 1, printed)
        else:
            self.assertNotIn("ERR|", printed)


def add_test(case):
    setattr(FailuresTest, f"test_{case}", lambda self: self.check(case))


for each in WORDS:
    add_test(each)

if __name__ == "__main__":
    unittest.main(verbosity=2)
