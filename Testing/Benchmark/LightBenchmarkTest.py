# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""measure_light.py on tiny scenes: errors and times are there, ground truths are kept, and a page is made."""
import importlib.util
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
MESH, IMAGE = "lattice1.3k", "scan"
EFFECTS = ("shading", "scattering")
MEASURED = ("rms", "q999", "max", "seconds", "times_unlit")


def run(script, *arguments):
    subprocess.run([sys.executable, HERE / script, *arguments], check=True, stdout=subprocess.DEVNULL)


class LightBenchmarkTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.report = cls.measure()

    @classmethod
    def measure(cls, *scenes):
        run("measure_light.py", cls.folder, "--size", "32x32", "--timed-size", "16x16", "--stride", "2",
            "--frames", "1", "--scenes", *(scenes or (MESH, IMAGE)), "--effects", *EFFECTS)
        return json.loads((cls.folder / "light.json").read_text())

    def results(self, number):
        return {(r["effect"], r["way"]): r for r in self.report["scenes"][number]["results"]}

    def test_each_way_has_errors_and_times(self):
        self.assertEqual([scene["name"] for scene in self.report["scenes"]], [MESH, IMAGE])
        for number in range(2):
            for key, result in self.results(number).items():
                with self.subTest(scene=number, key=key):
                    self.assertIn(key[0], EFFECTS)
                    for name in MEASURED:
                        self.assertGreater(result[name], 0)
                    self.assertEqual("first_seconds" in result, key[0] == "scattering" and key[1].startswith("at v"))
                    self.assertLessEqual(result["rms"], result["q999"])
                    self.assertLessEqual(result["q999"], result["max"])
                    self.assertLess(result["rms"], 0.1)  # of the same picture
                    self.assertLessEqual(result["within"], 1)

    def test_errors_are_those_of_the_way(self):
        """Light of cell gradients is constant in a cell; rays see shadows that vertices don't have."""
        mesh, image = self.results(0), self.results(1)
        self.assertLess(20 * mesh["shading", "cell gradients"]["rms"], mesh["shading", "at vertices"]["rms"])
        for results in (mesh, image):
            self.assertLess(results["scattering", "along rays"]["rms"], results["scattering", "at vertices"]["rms"])
        self.assertLess(image["shading", "VTK, 4 samples"]["rms"], image["shading", "VTK, 1 sample"]["rms"])
        self.assertNotIn(("shading", "cell gradients"), image)
        self.assertNotIn(("shading", "VTK, 1 sample"), mesh)

    def test_ground_truths_are_kept(self):
        truths = sorted((self.folder / "truths").iterdir())
        times = [file.stat().st_mtime_ns for file in truths]
        self.assertEqual(len(truths), 5)
        again = self.measure(MESH)
        self.assertEqual([file.stat().st_mtime_ns for file in truths], times)
        (scene,) = again["scenes"]
        self.assertEqual([r["rms"] for r in scene["results"]], [r["rms"] for r in self.results(0).values()])

    def test_page_and_chart(self):
        if importlib.util.find_spec("matplotlib") is None:
            self.skipTest("there is no matplotlib")
        file = self.folder / "report.json"
        file.write_text(json.dumps(self.report))
        run("make_light_page.py", file, self.folder)
        page = (self.folder / "LightAccuracy.md").read_text()
        self.assertRegex(page, rf"\| {MESH} \| scattering \| along rays \| [0-9.e-]+ \| 0")
        self.assertNotRegex(page, "@[a-z]+@")
        self.assertTrue((self.folder / "Charts" / "light.png").read_bytes().startswith(b"\x89PNG"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
