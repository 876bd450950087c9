# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The file that tetmarch-bench --gpu-report writes, of drivers that work and of some that don't:
GpuReportTest.py EXECUTABLE."""
import json
import math
import os

from benchmark_case import BenchmarkCase, main

KEYS = ["format", "date", "tetmarch_version", "vtk_version", "os", "cpu", "cpu_threads", "memory_bytes", "failures",
        "gl", "probes", "parity", "benchmark"]
SCENES = [("lattice:12", "base"), ("cheese:18", "base"), ("golfball", "base"), ("lattice:12", "vertex-shadows")]
COUNTS = ("rays", "crossed_cells", "lookups", "refused_entries", "lost_rays", "guard_hits", "pixels_not_finite")
# What GL 3.2 requires at least.
LEAST = {"max_texture_size": 1024, "max_3d_texture_size": 256, "max_array_texture_layers": 256,
         "max_texture_buffer_size": 65536, "max_texture_image_units": 16, "max_combined_texture_image_units": 48,
         "max_vertex_texture_image_units": 16, "max_fragment_uniform_components": 1024,
         "max_vertex_uniform_components": 1024, "max_uniform_block_size": 16384, "max_varying_components": 60,
         "max_draw_buffers": 8, "max_color_attachments": 8, "max_renderbuffer_size": 1024, "max_clip_distances": 8,
         "subpixel_bits": 4}
# What it doesn't have: from GL 3.3, 4.2 and 4.3 on.
LATER = {"timer_query_counter_bits", "texture_buffer_offset_alignment", "max_shader_storage_block_size",
         "max_fragment_shader_storage_blocks", "max_image_units", "max_compute_work_group_count",
         "max_compute_work_group_size", "max_compute_work_group_invocations", "max_compute_shared_memory_size",
         "max_compute_shader_storage_blocks"}


def numbers(value):
    """Those within a value of JSON, with what names them; null is none."""
    for key, part in value.items() if isinstance(value, dict) else enumerate(value):
        if isinstance(part, (dict, list)):
            yield from numbers(part)
        elif not isinstance(part, (str, bool, type(None))):
            yield key, part


class GpuReportTest(BenchmarkCase):
    def report(self, *arguments, **environment):
        """Whatever fails, the program ends well."""
        result = self.run_benchmark("--quick", "--mappers", "tetmarch", "--gpu-report", "gpu.json", *arguments,
                                    env={**os.environ, **environment})
        self.assertEqual(result.returncode, 0, result.stderr)
        report = json.loads((self.folder / "gpu.json").read_text())
        self.assertEqual(list(report), KEYS)
        self.assertEqual([(scene["dataset"], scene["effect"]) for scene in report["parity"]], SCENES)
        return report

    def check_differences(self, differences, bound):
        self.assertEqual(set(differences), {"max", "mean", "p999", "pixels", "worst_pixel"})
        self.assertLessEqual(differences["mean"], differences["max"])
        self.assertLessEqual(differences["p999"], differences["max"])
        self.assertGreater(differences["max"], 0)  # of two pictures
        self.assertLess(differences["max"], bound)

    def check_parity(self, scene):
        self.assertIsNone(scene["failure"])
        self.assertEqual(set(scene), {"dataset", "effect", "size", "failure", "tolerance", "ground_truth", "cpu", "compute", *COUNTS})
        self.assertAlmostEqual(scene["tolerance"], 1 / 255)
        # The true light is that of every point, that of the GL is of the vertices of a coarse lattice: 6.6 / 255.
        self.check_differences(scene["ground_truth"], scene["tolerance"] if scene["effect"] == "base" else 8 / 255)
        self.check_differences(scene["cpu"], 1e-4)
        if scene["compute"]:
            self.assertEqual(scene["compute"]["max"], 0)
            self.assertEqual(scene["compute"]["pixels"], scene["ground_truth"]["pixels"])
        self.assertGreater(scene["cpu"]["pixels"], 40)
        self.assertGreaterEqual(scene["rays"], scene["ground_truth"]["pixels"])
        self.assertGreater(scene["crossed_cells"], scene["rays"])
        for count in ("lost_rays", "guard_hits", "pixels_not_finite"):
            self.assertEqual(scene[count], 0, count)

    def test_a_driver_that_works(self):
        report = self.report()
        self.assertEqual(report["failures"], [])
        self.assertEqual(report["format"], 1)
        for key in KEYS[1:8]:
            self.assertTrue(report[key], key)
        for key, number in numbers(report):
            self.assertTrue(math.isfinite(number), key)
        gl = report["gl"]
        self.assertEqual(set(gl), {"backend", "vendor", "renderer", "version", "glsl_version", "limits", "extensions"})
        for key, value in gl.items():
            self.assertTrue(value, key)
        self.assertTrue(all(name.startswith("GL_") for name in gl["extensions"]))
        self.assertEqual(set(gl["limits"]), {*LEAST, *LATER})
        for key, least in LEAST.items():
            self.assertGreaterEqual(gl["limits"][key], least, key)
        self.assertEqual({type(answer) for answer in report["probes"].values()}, {bool})
        self.assertEqual(set(report["probes"]),
                         {"has_compute_shaders", "chooses_compute_shaders", "predicate_is_right",
                          "predicate_by_fma", "has_texture_gather", "skips_helper_invocations"})
        self.assertEqual(report["probes"]["has_compute_shaders"], "GL_ARB_compute_shader" in gl["extensions"])
        self.assertEqual(report["probes"]["has_texture_gather"], "GL_ARB_texture_gather" in gl["extensions"])
        for scene in report["parity"]:
            with self.subTest(scene=(scene["dataset"], scene["effect"])):
                self.check_parity(scene)

    def test_the_benchmark_is_in_it(self):
        report = self.report("--output", "out.json")
        self.assertEqual(report["benchmark"], json.loads((self.folder / "out.json").read_text()))
        self.assertEqual(len(report["benchmark"]["datasets"]), 2)

    def test_an_old_gl(self):
        """Mesa says that it has no more than GL 3.2 and lacks an extension."""
        report = self.report(MESA_GL_VERSION_OVERRIDE="3.2", MESA_EXTENSION_OVERRIDE="-GL_ARB_texture_gather")
        if "Mesa" not in report["gl"]["version"]:
            self.skipTest("this GL is not Mesa's")
        self.assertTrue(report["gl"]["version"].startswith("3.2"))
        self.assertEqual({key for key, limit in report["gl"]["limits"].items() if limit is None}, LATER)
        self.assertFalse(report["probes"]["has_texture_gather"])
        self.assertFalse(report["probes"]["has_compute_shaders"])
        self.assertEqual([scene["compute"] for scene in report["parity"]], [None] * len(SCENES))
        self.assertEqual(report["failures"], [])

    def test_no_gl(self):
        """Then all there is to say is why, of each step."""
        report = self.report("--datasets", "lattice:6", TETMARCH_GL="egl", MESA_GL_VERSION_OVERRIDE="2.1",
                             VTK_DEFAULT_EGL_DEVICE_INDEX="99")
        self.assertIsNone(report["gl"])
        self.assertIsNone(report["probes"])
        steps = ["GL", *(f"parity of {dataset}, {effect}" for dataset, effect in SCENES),
                 "lattice:6, tetmarch: preparation"]
        self.assertEqual(len(report["failures"]), len(steps))
        for step, failure in zip(steps, report["failures"]):
            self.assertRegex(failure, f"^{step}: ..........")
        for scene in report["parity"]:
            self.assertTrue(scene["failure"])

    def test_one_scene_fails_and_the_rest_goes_on(self):
        report = self.report("--data", "no/such/folder")
        self.assertEqual(len(report["failures"]), 1)
        self.assertRegex(report["failures"][0], "^parity of golfball, base: .*no/such/folder/golfball_small.vtu")
        for scene in report["parity"]:
            if scene["dataset"] == "golfball":
                self.assertIn("golfball_small.vtu", scene["failure"])
            else:
                self.check_parity(scene)

    def test_mappers_that_fail_are_told(self):
        report = self.report("--datasets", "lattice:60", "--limit", "0.001")
        self.assertRegex("\n".join(report["failures"]), "lattice:60, tetmarch: .*took more than 0.00")


if __name__ == "__main__":
    main()
