# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs tetmarch-bench on tiny lattices; the figures must be there and positive: SmokeTest.py EXECUTABLE."""
import importlib.util
import json
import math
import pathlib
import re
import subprocess
import sys

from benchmark_case import BenchmarkCase, main


class SmokeTest(BenchmarkCase):
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

    def errors_of(self, *arguments):
        """{(dataset, functions): {mapper: errors}} of a quick run, and the report."""
        kind, *rest = arguments
        report, table = self.report_of(kind, "--quick", *rest)
        errors = {}
        for dataset in report["datasets"]:
            self.assertNotIn("reference_failure", dataset)
            for mapper in dataset["mappers"]:
                self.assertIsNone(mapper["failure"], mapper["name"])
                self.assertIn(f"| {dataset['name']} | {dataset['functions']} | {mapper['name']} |", table)
                errors.setdefault((dataset["name"], dataset["functions"]), {})[mapper["name"]] = mapper["errors"]
        return errors, report

    def test_errors_are_those_of_each_mapper(self):
        """Coarse images are further off than fine ones, levels less than all; opacities are on both grounds."""
        mappers = ["tetmarch-adaptive", "tetmarch-fast", "tetmarch", "tetmarch-reference", "projected", "bunyk-linear",
                   "zsweep", "resample:8/1", "resample:64/2"]
        errors, report = self.errors_of("accuracy", "--datasets", "front:16", "--functions", "smooth,ramp,spikes",
                                        "--mappers", ",".join(mappers))
        self.assertEqual(report["kind"], "accuracy")
        self.assertEqual(set(errors), {("front:16", name) for name in ("smooth", "ramp", "spikes")})
        for subject, of_mappers in errors.items():
            with self.subTest(subject=subject):
                self.assertEqual(list(of_mappers), mappers)
                for e in of_mappers.values():
                    self.assertLessEqual(e["rms"], e["p999"])
                    self.assertLessEqual(e["p999"], e["max"])
                rms = {name: e["rms"] for name, e in of_mappers.items()}
                self.assertLessEqual(rms["tetmarch-reference"], rms["tetmarch"])
                self.assertLessEqual(of_mappers["tetmarch"]["max"], 1 / 255)
                self.assertLess(rms["tetmarch-reference"], 1e-4)
                self.assertGreater(rms["resample:8/1"], 2 * rms["resample:64/2"])
                for name in ("projected", "bunyk-linear", "zsweep", "resample:8/1"):
                    self.assertGreater(rms[name], 3 * rms["tetmarch"], name)
                    self.assertLess(rms[name], 0.6, name)  # of the same thing, at least
                self.assertGreater(of_mappers["tetmarch-reference"]["lookups_per_cell"],
                                   of_mappers["tetmarch-fast"]["lookups_per_cell"])
                self.assertLessEqual(of_mappers["tetmarch-reference"]["bound_max"], 1.001e-5)
                # With spikes, each covered pixel of so small a window has a ray.
                self.assertEqual(of_mappers["tetmarch-adaptive"]["bound_max"] == 1.0, subject[1] != "spikes")
                self.assertLess(rms["tetmarch-adaptive"], 4 / 255)

    def test_refinement_is_of_second_order(self):
        errors, _ = self.errors_of("refinement", "--datasets", "refined:8,refined:16", "--mappers",
                                   "tetmarch-reference")
        coarse, fine = (e["tetmarch-reference"]["rms"] for e in errors.values())
        self.assertAlmostEqual(math.log2(coarse / fine), 2.0, delta=0.3)

    def test_page_and_charts(self):
        if importlib.util.find_spec("matplotlib") is None:
            self.skipTest("there is no matplotlib")
        self.report_of("refinement", "--quick", "--datasets", "refined:8,refined:16", "--mappers",
                       "tetmarch,bunyk-linear")
        (self.folder / "out.json").rename(self.folder / "refinement.json")
        self.report_of("accuracy", "--quick", "--datasets", "golfball", "--functions", "smooth", "--mappers",
                       "tetmarch-fast,tetmarch,tetmarch-adaptive,resample:8/1")
        maker = pathlib.Path(__file__).resolve().parent / "make_accuracy_page.py"
        subprocess.run([sys.executable, maker, "out.json", "refinement.json", "page"], cwd=self.folder, check=True)
        page = (self.folder / "page" / "Accuracy.md").read_text()
        self.assertRegex(page, r"\| golfball \| smooth \|  \| [0-9.]+ \(resample:8/1\) \|")
        self.assertRegex(page, r"\| golfball \| smooth \| tetmarch-adaptive \|.* \| none \| [0-9.]+ \|")
        self.assertRegex(page, r"\| bunyk-linear \| [0-9.e-]+ \| -?[0-9.]+ \|")
        self.assertNotRegex(page, "@[a-z]+@")
        for link in re.findall(r"\]\((Charts/[^)]*)\)", page) + ["Charts/overview.png"]:
            chart = (self.folder / "page" / link).read_bytes()
            self.assertTrue(chart.startswith(b"\x89PNG"), link)

    def test_effects(self):
        """Each beside the base frame; stages run where an effect has them, in every turn."""
        names = ["gradient-opacity", "one-light", "cell-gradients", "vertex-shadows", "occlusion", "illumination"]
        report, table = self.report_of("effects", "--quick", "--datasets", "lattice:8", "--effects", ",".join(names))
        dataset = report["datasets"][0]
        self.assertEqual([e["name"] for e in dataset["effects"]], names)
        self.assertEqual(len(dataset["base"]["seconds"]), 2 * len(names))
        for e in dataset["effects"]:
            with self.subTest(effect=e["name"]):
                self.assertIsNone(e["failure"])
                self.assert_times(e["frames"], 2)
                self.assert_times(e["first_frame"], 2)
                self.assertLessEqual(e["base_ratio"]["min"], e["base_ratio"]["median"])
                self.assertGreater(e["on_ratio"]["min"], 0)
                self.assertGreater(e["gradients_seconds"], 0)
                self.assertEqual("light_seconds" in e, e["name"] in ("vertex-shadows", "occlusion"))
                self.assertGreater(e["gpu_bytes_more"], 0)
                self.assertIn(f"| lattice:8 | {e['name']} |", table)
        more = {e["name"]: e["gpu_bytes_more"] for e in dataset["effects"]}
        self.assertGreater(more["vertex-shadows"], more["one-light"])

    def test_all_effects_draw(self):
        report, _ = self.report_of("effects", "--quick", "--datasets", "lattice:3", "--size", "16x16", "--frames", "1")
        for e in report["datasets"][0]["effects"]:
            self.assertIsNone(e["failure"], e["name"])
        self.assertEqual(len(report["datasets"][0]["effects"]), 13)

    def test_against_another_build(self):
        """Here, itself; a program that is none is told of."""
        report, text = self.report_of("--quick", "--datasets", "lattice:8", "--mappers", "tetmarch", "--against",
                                      self.executable)
        dataset = report["datasets"][0]
        self.assertEqual([m["name"] for m in dataset["mappers"]], ["tetmarch", "against"])
        self.assertEqual(dataset["against"]["count"], 2)
        self.assertGreater(dataset["against"]["pairs"], 0)
        self.assertIn("times as long as the other", text)
        report, text = self.report_of("--quick", "--datasets", "lattice:8", "--mappers", "tetmarch", "--against",
                                      "no/such/program")
        self.assertIn("ended early", report["datasets"][0]["mappers"][1]["failure"])
        self.assertNotIn("times as long as the other", text)

    def test_page_and_chart_of_effects(self):
        if importlib.util.find_spec("matplotlib") is None:
            self.skipTest("there is no matplotlib")
        self.report_of("--quick", "--datasets", "lattice:8", "--mappers", "tetmarch", "--against", self.executable)
        (self.folder / "out.json").rename(self.folder / "against.json")
        self.report_of("effects", "--quick", "--datasets", "lattice:8", "--effects", "one-light,vertex-shadows")
        maker = pathlib.Path(__file__).resolve().parent / "make_effects_page.py"
        subprocess.run([sys.executable, maker, "out.json", "page", "--against", "against.json"], cwd=self.folder,
                       check=True)
        page = (self.folder / "page" / "Effects.md").read_text()
        self.assertRegex(page, r"\| shading by one light, base frames \| 1.5 \| [0-9.]+")
        self.assertRegex(page, r"\| lattice:8 \| vertex-shadows \| [0-9.]+ \| [0-9.]+ \(.*\| one-light \| [0-9.]+ \(")
        self.assertRegex(page, r"without effects \| 1.02 \| [0-9.]+")
        self.assertNotRegex(page, "@[a-z]+@")
        for link in re.findall(r"\]\((Charts/[^)]*)\)", page):
            chart = (self.folder / "page" / link).read_bytes()
            self.assertTrue(chart.startswith(b"\x89PNG"), link)

    def test_growth(self):
        """Frames that take the cube root of the size: the exponent is of the sizes from 100,000 tetrahedra on."""
        if importlib.util.find_spec("matplotlib") is None:
            self.skipTest("there is no matplotlib")
        datasets = [{"tetrahedra": n, "mappers": [
            {"name": "tetmarch", "frames": {"median_seconds": 1e-3 * n ** (1 / 3) if n > 5e4 else 7.0}},
            {"name": "bunyk", "frames": {"median_seconds": 1e-6 * n} if n < 5e6 else None},
        ]} for n in (10_000, 100_000, 1_000_000, 10_000_000)]
        report = {"date": "today", "tetmarch_version": "1", "environment": None, "cpu": "a CPU", "cpu_threads": 2,
                  "datasets": datasets}
        (self.folder / "growth.json").write_text(json.dumps(report))
        maker = pathlib.Path(__file__).resolve().parent / "growth_chart.py"
        subprocess.run([sys.executable, maker, "page", "growth.json"], cwd=self.folder, check=True)
        page = (self.folder / "page" / "growth.md").read_text()
        self.assertIn("| 100,000 | 0.0464 | 0.1 |\n", page)
        self.assertIn("| 10,000,000 | 0.215 |  |\n", page)
        self.assertIn("| exponent | 0.33 | 1.00 |\n", page)
        self.assertTrue((self.folder / "page" / "growth.png").read_bytes().startswith(b"\x89PNG"))

    def test_images(self):
        """Errors fall with samples and with levels; scalars in float have no row of their own for stored ones."""
        mappers = ["tetmarch-adaptive", "tetmarch-adaptive-fast", "tetmarch-fast", "tetmarch", "tetmarch-accurate",
                   "fixed-point", "gpu:1", "gpu:4", "gpu-jitter:1"]
        report, table = self.report_of("structured", "--quick", "--stride", "2", "--mappers",
                                       ",".join([*mappers, "gpu-stored:2"]))
        self.assertEqual([v["functions"] for v in report["datasets"]], ["ramp", "peaks", "smooth"])
        for volume in report["datasets"]:
            with self.subTest(functions=volume["functions"]):
                self.assertEqual(volume["dimensions"], [16, 16, 16])
                self.assertEqual([m["name"] for m in volume["mappers"]], mappers)
                for mapper in volume["mappers"]:
                    self.assertIsNone(mapper["failure"])
                    self.assert_times(mapper["frames"], 2)
                    self.assertIn(f"| marschner-lobb:16 | {volume['functions']} | {mapper['name']} |", table)
                errors = {m["name"]: m["errors"] for m in volume["mappers"]}
                self.assertLessEqual(errors["tetmarch"]["max"], 1 / 255)
                self.assertLess(errors["tetmarch-accurate"]["rms"], errors["tetmarch"]["rms"])
                self.assertLess(errors["tetmarch"]["rms"], errors["tetmarch-fast"]["rms"])
                self.assertLess(errors["gpu:4"]["rms"], errors["gpu:1"]["rms"])
                for level in ("", "-fast"):
                    adaptive, all_rays = errors["tetmarch-adaptive" + level], errors["tetmarch" + level]
                    self.assertNotEqual(adaptive, all_rays)
                    self.assertLess(adaptive["rms"], all_rays["rms"] + 4 / 255)
                for rival in ("fixed-point", "gpu:1", "gpu:4", "gpu-jitter:1"):
                    self.assertGreater(errors[rival]["rms"], errors["tetmarch"]["rms"], rival)
                self.assertLess(errors["gpu:4"]["rms"], 0.3)  # of the same thing, at least
        with_jitter, without = ({v["functions"]: v["mappers"][mappers.index(name)]["errors"] for v in
                                 report["datasets"]} for name in ("gpu-jitter:1", "gpu:1"))
        self.assertNotEqual(with_jitter, without)

    def test_images_whose_files_are_absent_are_left_out(self):
        result = self.run_benchmark("structured", "--quick", "--datasets", "bonsai,marschner-lobb:8", "--functions",
                                    "ramp", "--mappers", "tetmarch", "--more-data", "no/such/folder")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("bonsai is left out: it is not in no/such/folder", result.stderr)
        self.assertIn("| marschner-lobb:8 | ramp | tetmarch |", result.stdout)
        self.assertNotIn("| bonsai |", result.stdout)

    def test_page_and_chart_of_images(self):
        if importlib.util.find_spec("matplotlib") is None:
            self.skipTest("there is no matplotlib")
        self.report_of("structured", "--quick", "--functions", "ramp", "--mappers",
                       "tetmarch-adaptive,tetmarch,gpu:2,fixed-point")
        maker = pathlib.Path(__file__).resolve().parent / "make_structured_page.py"
        subprocess.run([sys.executable, maker, "out.json", "page"], cwd=self.folder, check=True)
        page = (self.folder / "page" / "Structured.md").read_text()
        for level in ("tetmarch", "tetmarch-adaptive"):
            self.assertRegex(page, rf"\| marschner-lobb:16 \| ramp \| `{level}` \|" + r" [0-9.]+ \|" * 4 + " [a-z]")
        self.assertNotRegex(page, "@[a-z]+@")
        for link in re.findall(r"\]\((Charts/[^)]*)\)", page):
            chart = (self.folder / "page" / link).read_bytes()
            self.assertTrue(chart.startswith(b"\x89PNG"), link)

    def test_bad_command_lines(self):
        for message, *arguments in (("unknown option '--bogus'", "--bogus"),
                                    ("--size needs a value", "--size"),
                                    ("expected WIDTHxHEIGHT", "--size", "512"),
                                    ("1 or more", "--frames", "0"),
                                    ("above 0", "--limit", "-1"),
                                    ("there is no 'torus'", "--datasets", "golfball,torus"),
                                    ("there is no 'magic'", "--mappers", "magic"),
                                    ("there is no 'tetmarch:1/0'", "--mappers", "tetmarch:1/0"),
                                    ("there is no 'resample:8'", "--mappers", "resample:8"),
                                    ("there is no 'grey'", "--functions", "smooth,grey"),
                                    ("there is no 'golfball'", "structured", "--datasets", "golfball"),
                                    ("there is no 'gpu:0'", "structured", "--mappers", "gpu:0"),
                                    ("there is no 'fog'", "effects", "--effects", "occlusion,fog"),
                                    ("unknown option 'accuracy'", "--quick", "accuracy")):
            with self.subTest(arguments=arguments):
                result = self.run_benchmark(*arguments)
                self.assertEqual((result.returncode, result.stdout), (2, ""))
                self.assertIn(message, result.stderr)

    def test_help(self):
        result = self.run_benchmark("--help")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertTrue(
            result.stdout.startswith("Usage: tetmarch-bench [accuracy|refinement|effects|structured] [options]"))


if __name__ == "__main__":
    main()
