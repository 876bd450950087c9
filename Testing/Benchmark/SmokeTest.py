# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs tetmarch-bench on tiny lattices; the figures must be there and positive: SmokeTest.py EXECUTABLE."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

EXECUTABLE = None


class SmokeTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_benchmark(self, *arguments):
        return subprocess.run([EXECUTABLE, *arguments], cwd=self.folder, text=True, timeout=300,
                              capture_output=True)

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

    def test_figures_of_the_quick_run(self):
        report, table = self.report_of("--quick", "--rounds", "2")
        self.assertEqual([dataset["tetrahedra"] for dataset in report["datasets"]], [6 * 6**3, 6 * 8**3])
        for key in ("vtk_version", "gl", "smp", "multithreader_threads"):
            self.assertTrue(report["environment"][key])
        for key in ("date", "cpu", "cpu_threads", "memory_bytes"):
            self.assertTrue(report[key])
        for dataset in report["datasets"]:
            self.assertEqual([mapper["name"] for mapper in dataset["mappers"]],
                             ["tetmarch", "projected", "bunyk"])
            for mapper in dataset["mappers"]:
                with self.subTest(dataset=dataset["name"], mapper=mapper["name"]):
                    self.check_mapper(mapper, dataset["tetrahedra"])
                self.assertIn(f"| {dataset['name']} | {dataset['tetrahedra']} | {mapper['name']} |", table)

    def check_mapper(self, mapper, tetrahedra):
        ours = mapper["name"] == "tetmarch"
        if mapper["name"] == "bunyk" and "crashed" in (mapper["failure"] or ""):
            self.skipTest(f"VTK's own ray caster is known to do this: {mapper['failure']}")
        self.assertIsNone(mapper["failure"])
        self.assert_times(mapper["frames"], 4)
        self.assert_times(mapper["first_frame"], 2)
        # The unit cube fills a good part of the window from every side.
        self.assertGreater(mapper["covered_share"], 0.2)
        self.assertLess(mapper["covered_share"], 0.9)
        self.assertGreaterEqual(mapper["peak_resident_bytes"], mapper["dataset_resident_bytes"])
        self.assertGreater(mapper["dataset_resident_bytes"], 0)
        if ours:
            self.assertEqual(mapper["class"], "vtkTetMarchVolumeMapper")
            self.assertGreater(mapper["preprocessing_seconds"], 0)
            self.assertAlmostEqual(mapper["preprocessing_seconds"], sum(mapper["stages_seconds"].values()))
            self.assertGreater(mapper["preprocessing_tetrahedra_per_second"], 0)
            self.assertGreater(mapper["uploaded_bytes_per_tetrahedron"], 32)
            self.assertGreaterEqual(mapper["gpu_bytes"], mapper["uploaded_bytes"])
        else:
            self.assertGreater(mapper["frame_ratio_to_tetmarch"], 0)

    def test_one_mapper_fails_and_the_run_goes_on(self):
        """No mapper draws a lattice of a million tetrahedra within a millisecond."""
        report, table = self.report_of("--quick", "--datasets", "lattice:60,lattice:3", "--mappers", "tetmarch",
                                       "--limit", "0.001")
        failed = report["datasets"][0]["mappers"][0]
        self.assertEqual(failed["failure"], "preparation: took more than 0.005 s")
        self.assertIsNone(failed["frames"])
        self.assertIn("took more than", table)
        self.assertEqual(len(report["datasets"]), 2)

    def test_missing_data_is_told(self):
        report, _ = self.report_of("--quick", "--datasets", "golfball", "--mappers", "tetmarch", "--data",
                                   "no/such/folder")
        self.assertIn("no/such/folder/golfball_small.vtu", report["datasets"][0]["mappers"][0]["failure"])

    def test_bad_command_lines(self):
        for message, *arguments in (("unknown option '--bogus'", "--bogus"),
                                    ("--size needs a value", "--size"),
                                    ("expected WIDTHxHEIGHT", "--size", "512"),
                                    ("1 or more", "--frames", "0"),
                                    ("above 0", "--limit", "-1"),
                                    ("there is no 'torus'", "--datasets", "golfball,torus"),
                                    ("there is no 'magic'", "--mappers", "magic")):
            with self.subTest(arguments=arguments):
                result = self.run_benchmark(*arguments)
                self.assertEqual((result.returncode, result.stdout), (2, ""))
                self.assertIn(message, result.stderr)

    def test_help(self):
        result = self.run_benchmark("--help")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertTrue(result.stdout.startswith("Usage: tetmarch-bench [options]"))


if __name__ == "__main__":
    EXECUTABLE = sys.argv.pop(1)
    unittest.main(verbosity=2)
