# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A build is compared with itself, and differences are told: ComparisonTest.py BUILD"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from drawn_variants import missing_variants
from variant_scenes import FEATURES, VariantScene

BUILD = None
HERE = pathlib.Path(__file__).resolve().parent
EVERY = 61  # a few scenes: pictures, picks and options
FEWEST_COLORS = 3  # a view of the light on isosurfaces, say, has one for each surface, and the background


class ComparisonTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_script(self, script, *arguments, status=0):
        result = subprocess.run([sys.executable, HERE / script, *arguments], cwd=self.folder, text=True,
                                capture_output=True)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        return result.stdout

    def compare(self, first, second, status):
        np.savez(self.folder / "first.npz", driver="a", build="b", **first)
        np.savez(self.folder / "second.npz", driver="a", build="c", **second)
        return self.run_script("compare_pictures.py", "compare", "first.npz", "second.npz", status=status)

    def test_a_build_draws_what_it_drew(self):
        for name in ("one.npz", "two.npz"):
            text = self.run_script("compare_pictures.py", "draw", BUILD, name, "--check", "--every", str(EVERY))
            self.assertRegex(text, "All [0-9]+ variants were drawn|isn't Mesa's")
        self.assertIn("all equal", self.run_script("compare_pictures.py", "compare", "one.npz", "two.npz"))
        drawn = np.load(self.folder / "one.npz")
        kinds = {name.rpartition(": ")[2] for name in drawn.files}
        self.assertLessEqual({"bytes", "floats", "picks"}, kinds)
        self.assertNotIn("refused", kinds)
        for name in drawn.files:
            if name.endswith((": bytes", ": floats")):
                pixels = drawn[name].reshape(-1, drawn[name].shape[-1])
                colors, counts = np.unique(pixels, axis=0, return_counts=True)
                self.assertGreater(len(colors), FEWEST_COLORS, name)
                self.assertLess(counts.max(), 0.95 * len(pixels), name)

    def test_both_shader_stages_draw_the_same(self):
        for stage in ("Fragment", "Compute"):
            self.run_script("compare_pictures.py", "draw", BUILD, f"{stage}.npz", "--every", str(EVERY), "--stage", stage)
        self.assertIn("all equal", self.run_script("compare_pictures.py", "compare", "Fragment.npz", "Compute.npz"))

    def test_each_difference_is_told(self):
        floats = np.linspace(0, 1, 12, dtype=np.float32)
        with_nan = np.array([1.0, np.nan])
        self.assertIn("2 pictures, all equal", self.compare({"a": floats, "b": with_nan},
                                                            {"a": floats, "b": with_nan}, 0))
        changed = floats.copy()
        changed[3] = np.nextafter(changed[3], np.float32(2))
        self.assertIn("a: 1 of 12 values differ, by up to 2.98e-08", self.compare({"a": floats}, {"a": changed}, 1))
        self.assertIn("b: 1 of 2 values differ", self.compare({"b": with_nan}, {"b": np.ones(2)}, 1))
        self.assertIn("a: float32[12] became float32[11]", self.compare({"a": floats}, {"a": floats[1:]}, 1))
        self.assertIn("a: only in the first", self.compare({"a": floats, "b": floats}, {"b": floats}, 1))
        self.assertIn("b: only in the second", self.compare({"a": floats}, {"a": floats, "b": floats}, 1))
        refused = {"a: refused": np.array("no memory")}
        self.assertIn("a: refused: no memory", self.compare(refused, refused, 1))

    def test_there_is_a_scene_for_each_feature(self):
        lines = self.run_variants()
        self.assertEqual({word for line in lines for word in line.split()[1:]}, FEATURES)

    def test_a_scene_is_made_for_each_variant(self):
        for number, line in enumerate(self.run_variants()):
            with self.subTest(variant=line):
                VariantScene(frozenset(line.split()[1:]), number)

    def run_variants(self):
        program = pathlib.Path(BUILD) / "bin/tetmarch-variants"
        return subprocess.run([program], check=True, text=True, stdout=subprocess.PIPE).stdout.splitlines()

    def test_a_variant_that_was_not_drawn_is_told(self):
        for name in ("texts", "captures"):
            (self.folder / name).mkdir()
        for number, body in enumerate(("a();", "b();", "c();")):
            for kind, word in (("portable", "slow();"), ("extended", "fast();")):
                (self.folder / f"texts/{number}-{kind}.frag").write_text(
                    f"//VTK::System::Dec\n#line 7\n{word}\n{body}\ngl_FragData[0] = x;\n")
        begin = "[vertex shader]\nvoid main();\n[fragment shader]\n#version 150\n#line 7\nout vec4 fragOutput0;\n"
        for number, body in enumerate(("fast();\na();\nfragOutput0 = x;",
                                       "slow();\nb();\nfragOutput0 = x;\npeel();",
                                       "slow();\nc();\nd();\nfragOutput0 = x;")):
            (self.folder / f"captures/{number}.shader_test").write_text(begin + body + "\n")
        self.assertEqual(missing_variants(self.folder / "texts", self.folder / "captures", range(3)), [2])

    def test_times(self):
        text = self.run_script("compare_times.py", BUILD, BUILD, "--datasets", "golfball", "--rounds", "2",
                               "--frames", "1", "--size", "32x32", "--output", "times.json")
        self.assertRegex(text, r"golfball: [0-9.]+ s, the other build [0-9.]+ s; ratio of medians [0-9.]+, median of "
                               r"ratios of 2 pairs [0-9.]+")
        datasets = json.loads((self.folder / "times.json").read_text())["datasets"]
        self.assertEqual([d["name"] for d in datasets], ["golfball", "golfball, lit", "golfball, from inside"])
        for dataset in datasets:
            self.assertGreater(dataset["against"]["pairs"], 0)


if __name__ == "__main__":
    BUILD = sys.argv.pop(1)
    unittest.main(verbosity=2)
