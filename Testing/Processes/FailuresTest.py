# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong in one process is one message of the first, no process draws the volume, and none waits for ever."""
import unittest

import mpi

ERRORS = {
    "without_array": "Process 1: .*field",
    "other_kind": "scalars are of different kinds",
    "short_of_memory": "Process 1: .*MaxMemoryInBytes",
    "bad_points": "Process 1: .*finite",
    "other_window": "viewports of different sizes",
    "bad_view": "Process 1: .*view mode",
}
WARNINGS = {
    "nothing_finite": "Nothing is visible, because none of the scalars is a finite number",
    "no_opacity": "Nothing is visible, because the opacity is 0",
    "clipped_away": "Nothing is visible, because clipping planes and cropping leave nothing",
}
SILENT = ("aborted", "aborted_while_marching")


class FailuresTest(unittest.TestCase):
    def setUp(self):
        if not mpi.has_mpi():
            self.skipTest("there is no mpiexec")

    def check(self, case):
        printed = mpi.run(3, "fail_pieces.py", case)
        for rank in range(3):
            self.assertIn(f"process {rank}: False False True", printed)
        if case not in SILENT:
            self.assertRegex(printed, {**ERRORS, **WARNINGS}[case])
        self.assertEqual((printed.count("ERR|"), printed.count("WARN|")), (case in ERRORS, case in WARNINGS), printed)


def add_test(case):
    setattr(FailuresTest, f"test_{case}", lambda self: self.check(case))


for each in (*ERRORS, *WARNINGS, *SILENT):
    add_test(each)

if __name__ == "__main__":
    unittest.main(verbosity=2)
