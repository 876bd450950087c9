# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests that run tetmarch-bench as a user would: ...Test.py EXECUTABLE."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest


class BenchmarkCase(unittest.TestCase):
    executable = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_benchmark(self, *arguments, **options):
        return subprocess.run([self.executable, *arguments], cwd=self.folder, text=True, timeout=1000,
                              capture_output=True, **options)

    def report_of(self, *arguments):
        result = self.run_benchmark(*arguments, "--output", "out.json", "--markdown", "out.md")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual((self.folder / "out.md").read_text(), result.stdout)
        return json.loads((self.folder / "out.json").read_text()), result.stdout

    def assert_times(self, times, count):
        self.assertEqual(len(times["seconds"]), count)
        self.assertGreater(times["min_seconds"], 0)
        self.assertLessEqual(times["min_seconds"], times["median_seconds"])
        self.assertLessEqual(times["median_seconds"], times["max_seconds"])


def main():
    BenchmarkCase.executable = sys.argv.pop(1)
    unittest.main(verbosity=2)
