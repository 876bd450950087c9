# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs tetmarch-render as a user would: RenderTest.py EXECUTABLE PROJECT_FOLDER."""
import json
import math
import os
import re

from render_case import RenderCase, main


# Along the axis of a unit cube, of which all pixels see the same.
ALONG = ("--unit-distance", 0.5, "--background", "0,0,0", "--camera", "0.5,0.5,5,0.5,0.5,0.5,0,1,0",
         "--parallel-scale", 0.4, "--size", "64x48")
SLAB = ("--array", "half", "--preset", "constant.json", *ALONG)


class RenderTest(RenderCase):
    def test_help_and_version(self):
        result = self.run_tool("--help")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertTrue(result.stdout.startswith("Usage: tetmarch-render INPUT [options]"))
        self.assertLessEqual(max(map(len, result.stdout.splitlines())), 110)
        result = self.run_tool("--version")
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stdout, r"^tetmarch-render \d+\.\d+\.\d+ \(VTK \d+\.\d+\.\d+\)\n$")

    def test_bad_command_lines(self):
        self.expect_failure(2, "no input file is given (--help shows the options)")
        self.expect_failure(2, "unknown option '--bogus'", "cube.vtu", "--bogus")
        self.expect_failure(2, "--compare adds to the figures of --stats", "cube.vtu", "--compare")
        self.expect_failure(2, "more than one input", "cube.vtu", "cube.vtk")
        self.expect_failure(2, "option --size needs a value", "cube.vtu", "--size")
        for option, value in (("--size", "12"), ("--size", "0x9"), ("--background", "1,2,3"), ("--range", "2,1"),
                              ("--unit-distance", "0"), ("--unit-distance", "nan"), ("--parallel-scale", "-1"),
                              ("--camera", "1,2,3"), ("--camera", "0,0,1,0,0,0,0,0,1"), ("--frames", "-1"),
                              ("--opacity-law", "none"), ("--association", "edges"), ("--time-step", "x")):
            self.expect_failure(2, f"bad value '{value}' of {option}: ", "cube.vtu", option, value)
        self.assertEqual(list(self.folder.glob("*.png")), [])

    def test_inputs_that_cannot_be_drawn(self):
        self.expect_failure(1, "cannot read 'none.vtu': there is no such file", "none.vtu")
        self.expect_failure(1, ": it is a folder", self.folder)
        self.expect_failure(1, "no reader for the ending '.txt'", "notes.txt")
        for name in ("garbage.vtu", "truncated.vtu", "empty.vtu", "garbage.vtk", "truncated.vtk", "garbage.ex2",
                     "garbage.cgns"):
            self.expect_failure(1, f"cannot read '{name}': ", name)
        self.expect_failure(1, "'surface.vtk' has no 3D cells", "surface.vtk")
        self.expect_failure(1, "there is no array 'x' (on points: half, ramp; on cells: material)", "cube.vtu",
                            "--array", "x")
        self.expect_failure(1, "there is no array 'half' on cells", "cube.vtu", "--array", "half", "--association",
                            "cells")
        self.expect_failure(1, "the data has no array to draw", "bare.vtk")
        self.expect_failure(1, "time step 2 does not exist: the file has no time steps", "cube.vtu", "--time-step", 2)
        self.assertEqual(list(self.folder.glob("*.png")), [])

    def test_bad_presets(self):
        self.expect_failure(1, "preset 'none.json' can't be read", "cube.vtu", "--preset", "none.json")
        self.expect_failure(1, "parse error at line 3", "cube.vtu", "--preset", "malformed.json")
        self.expect_failure(1, "the field RGBPoints is missing", "cube.vtu", "--preset", "colourless.json")

    def test_outputs_that_cannot_be_written(self):
        self.expect_failure(1, "cannot write 'no/such/folder.png'", "cube.vtu", "--output", "no/such/folder.png")
        self.expect_failure(1, "cannot write 'no/such/folder.json'", "cube.vtu", "--stats", "no/such/folder.json")

    def test_unknown_backend(self):
        self.expect_failure(1, "TETMARCH_GL is 'glide'; it must be egl, osmesa or unset", "cube.vtu",
                            TETMARCH_GL="glide")

    def test_egl_device_by_number(self):
        """A device that is not there is an error, or with TETMARCH_GL unset the reason to take OSMesa."""
        environment = {"VTK_DEFAULT_EGL_DEVICE_INDEX": "99"}
        version = self.run_tool("--version").stdout
        if re.search(r"VTK 9\.[0-3]\.", version) is None:
            self.skipTest("VTK chooses by itself from 9.4 on")
        self.expect_failure(1, "no EGL display gives a context of GL 3.2 or later", "cube.vtu", TETMARCH_GL="egl",
                            **environment)
        result = self.run_tool("cube.vtu", "--stats", "s.json", "--size", "16x16", TETMARCH_GL="", **environment)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(json.loads((self.folder / "s.json").read_text())["gl"]["backend"], "OSMesa")

    def test_a_slab_has_its_known_colour(self):
        # The cube is 1 deep, its opacity 0.7, the unit distance 0.5, the colour (1, 0.5, 0.25) on black.
        for law, opacity in (("unstructured", 1 - math.exp(-0.7 / 0.5)), ("structured", 1 - 0.3 ** (1 / 0.5))):
            for name in ("cube.vtu", "cube.vtk"):
                with self.subTest(law=law, name=name):
                    pixels, _ = self.render(name, *SLAB, "--opacity-law", law)
                    self.assertEqual((len(pixels[0]), len(pixels)), (64, 48))
                    for x, y in ((32, 24), (10, 10), (50, 40)):
                        for channel, colour in zip(pixels[y][x], (1, 0.5, 0.25)):
                            self.assertAlmostEqual(channel, 255 * opacity * colour, delta=1.01)

    def test_what_is_cut_away_of_a_slab(self):
        # Below all planes in y: of the cross, that is only the layer between those in z.
        aside = "--crop=-1,2,5,6,0.2,0.5"
        for depth, cuts in ((0.6, ("--clip", "0,0,0.6,0,0,-1")), (0.4, ("--clip", "9,9,0.6,0,0,1")),
                            (0.1, ("--clip", "0,0,0.6,0,0,-1", "--clip", "0,0,0.5,0,0,2")),
                            (0.3, ("--crop", "0,1,0,1,0.2,0.5")), (0.3, (aside, "--crop-regions", "cross")),
                            (0.7, (aside, "--crop-regions", "inverted-cross")),
                            (0.6, (aside, "--crop-regions", "inverted-cross", "--clip", "0,0,0.1,0,0,1"))):
            with self.subTest(cuts=cuts):
                pixels, _ = self.render("cube.vtu", *SLAB, *cuts)
                for channel, colour in zip(pixels[24][32], (1, 0.5, 0.25)):
                    self.assertAlmostEqual(channel, 255 * (1 - math.exp(-1.4 * depth)) * colour, delta=1.01)

    def test_components_of_a_vector(self):
        for choice, name, scalar in (((), 0, 0.3), (("--component", 0), 0, 0.3), (("--component", 1), 1, 0.4),
                                     (("--component", "magnitude"), "magnitude", 0.5)):
            with self.subTest(choice=choice):
                pixels, stats = self.render("vectors.vtu", "--array", "vector", "--preset", "ramp.json", *ALONG, *choice)
                self.assertEqual((stats["array"]["component"], stats["array"]["components"]), (name, 3))
                self.assertAlmostEqual(stats["array"]["range"][0], scalar, places=12)
                self.assertAlmostEqual(pixels[24][32][0], 255 * (1 - math.exp(-scalar / 0.5)), delta=1.01)
        self.expect_failure(1, "array 'vector' has no component 3: it has 3, counted from 0", "vectors.vtu", "--array",
                            "vector", "--component", 3)
        for value in ("-1", "length"):
            self.expect_failure(2, f"bad value '{value}' of --component: ", "vectors.vtu", "--component", value)

    def test_a_warning_says_that_nothing_is_visible(self):
        for cuts, words in ((("--clip", "0,0,7,0,0,1"), "clipping planes and cropping leave nothing"),
                            (("--crop", "5,6,0,1,0,1"), "clipping planes and cropping leave nothing"),
                            (("--blend", "isosurface", "--isovalues", "70,80"), "no isosurface value lies among the values of the array")):
            with self.subTest(cuts=cuts):
                pixels = self.draw_with_warning("Nothing is visible, because " + words, "cube.vtu", *SLAB, *cuts)
                self.assertEqual({pixel for row in pixels for pixel in row}, {(0, 0, 0)})

    def test_values_that_are_not_finite(self):
        scene = ("vectors.vtu", "--array", "unknown", "--preset", "constant.json", *ALONG)
        pixels = self.draw_with_warning("none of the scalars is a finite number", *scene)
        self.assertEqual(pixels[24][32], (0, 0, 0))
        for color, opacity in (("0.2,1,0.6", 1), ("0.2,1,0.6,0.3", 0.3)):
            with self.subTest(color=color):
                pixels, _ = self.render(*scene, "--nan", color)
                for channel, part in zip(pixels[24][32], (0.2, 1, 0.6)):
                    self.assertAlmostEqual(channel, 255 * part * (1 - math.exp(-opacity / 0.5)), delta=1.01)
        for value in ("1,0", "0,0,2", "0,0,0,-1", "red"):
            self.expect_failure(2, f"bad value '{value}' of --nan: ", "vectors.vtu", "--nan", value)

    def test_background_and_default_view(self):
        pixels, _ = self.render("cube.vtu", "--size", "80x60", "--background", "0.2,0.4,0.6")
        self.assertEqual(pixels[0][0], (51, 102, 153))
        self.assertEqual(pixels[59][79], (51, 102, 153))
        inside = [pixel for row in pixels for pixel in row if pixel != (51, 102, 153)]
        self.assertGreater(len(inside), 80 * 60 // 10)

    def test_statistics(self):
        _, stats = self.render("cube.vtu", "--size", "80x60", "--array", "ramp", "--accuracy", "reference",
                               "--compare")
        self.assertEqual(stats["accuracy"], {"level": "Reference", "tolerance": 1e-5, "pixel_tolerance": 0.0})
        pixels = stats["pixels"]
        self.assertGreater(pixels["cells"]["count"], 100)
        self.assertLessEqual(pixels["cells"]["mean"], pixels["lookups"]["mean"])
        # Entries are led into their face by up to 1e-4 of it, here of a whole side.
        self.assertLess(pixels["error"]["rms"], 3e-4)
        self.assertLess(pixels["error_bound"]["max"], 1.01e-5)
        self.assertEqual(stats["input"], "cube.vtu")
        self.assertEqual(stats["size"], [80, 60])
        self.assertEqual(stats["array"], {"name": "ramp", "association": "points", "components": 1,
                                          "component": 0, "range": [0.0, 1.0]})
        self.assertEqual(stats["cells"], {"vtkHexahedron": 1, "vtkTriangle": 1})
        self.assertEqual(stats["points"], 8)
        self.assertIn(stats["tetrahedra"], (5, 6))
        self.assertEqual(stats["boundary_faces"], 12)
        self.assertGreater(stats["gpu_bytes"], 0)
        self.assertEqual(set(stats["seconds"]), {"read", "mesh", "scalars", "tables", "visible_part", "entries", "upload",
                                                 "first_frame"})
        self.assertGreater(stats["seconds"]["first_frame"], 0)
        frames = stats["frames"]
        self.assertEqual(frames["count"], 3)
        self.assertEqual(frames["median_seconds"], sorted(frames["seconds"])[1])
        self.assertEqual(set(stats["gl"]), {"backend", "vendor", "renderer", "version"})
        backend = {"egl": ("EGL", "vtkEGLRenderWindow"), "osmesa": ("OSMesa", "vtkOSOpenGLRenderWindow")}
        if os.environ.get("TETMARCH_GL") in backend:
            self.assertIn(stats["gl"]["backend"], backend[os.environ["TETMARCH_GL"]])
        self.assertRegex(stats["vtk_version"], r"^\d+\.\d+\.\d+")

    def test_budgets(self):
        scene = ("cube.vtu", "--size", "80x60", "--array", "ramp", "--accuracy", "accurate")
        for budgets, accuracy, kept in (
                (("--frame-time", 1000), {"level": "Reference", "tolerance": 1e-5}, True),
                (("--frame-time", 1e-6), {"level": "Fast", "tolerance": 0.0}, False),
                (("--error", 0.01), {"level": "Default", "tolerance": 0.01}, True),
                (("--frame-time", 1e-6, "--error", 0.01), {"level": "Default", "tolerance": 0.01}, False)):
            with self.subTest(budgets=budgets):
                _, stats = self.render(*scene, *budgets)
                pixel_tolerance = stats["accuracy"].pop("pixel_tolerance")
                self.assertEqual(stats["accuracy"], accuracy)
                # Pixels are interpolated where that is measured to be quicker than the level Fast.
                self.assertTrue(pixel_tolerance == 0 or accuracy["level"] == "Fast", pixel_tolerance)
                self.assertIs(stats["budget"]["kept"], kept)

    def test_output_goes_to_the_current_folder_by_default(self):
        (self.folder / "sub").mkdir()
        (self.folder / "cube.vtu").rename(self.folder / "sub" / "cube.vtu")
        result = self.run_tool("sub/cube.vtu", "--size", "32x32", "--quiet")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        self.assertTrue((self.folder / "cube.png").exists())

    def test_frame_time_is_printed_without_statistics(self):
        result = self.run_tool("cube.vtu", "--size", "32x32", "--frames", 2)
        self.assertRegex(result.stdout, r"^\d+\.\d+ s a frame \(median of 2\)\n$")

    def test_progress_bar_on_a_terminal_only(self):
        text = self.run_on_terminal("cube.vtu")
        self.assertIn(b"reading [", text)
        self.assertTrue(text.endswith(b"\r\x1b[K"), text[-80:])

    def test_views_of_measures_have_a_legend(self):
        picture, _ = self.render("cube.vtu", "--array", "ramp", "--size", "320x240")
        for view in ("error", "cells", "lookups"):
            with self.subTest(view=view):
                pixels, _ = self.render("cube.vtu", "--array", "ramp", "--size", "320x240", "--view", view)
                self.assertNotEqual(pixels, picture)
                # Text is white; the palest colour has 184 of blue.
                white = sum(min(pixel) > 190 for row in pixels for pixel in row[240:])
                self.assertGreater(white, 50)
        for view in ("illumination", "gradients", "faces", "coordinates"):
            with self.subTest(view=view):
                pixels, _ = self.render("cube.vtu", "--array", "ramp", "--size", "320x240", "--view", view)
                self.assertNotEqual(pixels, picture)
                self.assertEqual(pixels[0], picture[0])  # only the cube is drawn over
        same, _ = self.render("cube.vtu", "--array", "ramp", "--size", "320x240", "--view", "picture")
        self.assertEqual(same, picture)

    def test_the_shell_shows_faces_in_plain_colours(self):
        scene = ("cube.vtu", "--array", "ramp", "--size", "96x64", "--camera", "0.5,0.5,5,0.5,0.5,0.5,0,1,0",
                 "--parallel-scale", 0.4)
        faces, _ = self.render(*scene, "--view", "faces")
        colours = {pixel for row in faces for pixel in row[16:-16]}
        self.assertEqual(len(colours), 2)  # the cube's side is two triangles
        self.assertTrue(all(max(pixel) == 255 and min(pixel) >= 64 for pixel in colours))
        places, _ = self.render(*scene, "--view", "coordinates")
        self.assertLessEqual({sum(pixel) for row in places for pixel in row[16:-16]}, {254, 255, 256})

    def test_cell_array(self):
        _, stats = self.render("cube.vtu", "--array", "material", "--size", "32x32")
        self.assertEqual(stats["array"]["association"], "cells")

    def test_a_reader_of_vtk_that_crashes(self):
        """VTK 9.1's does, 9.6's says that the file is damaged."""
        self.draw("polyhedron.vtu", "--size", "32x24")
        for options in (("--list",), ("--size", "32x24", "--output", "crash.png")):
            self.expect_failure(1, "cannot read 'lying_faces.vtu': ", "lying_faces.vtu", *options)
            self.assertFalse((self.folder / "crash.png").exists())

    def test_golf_ball(self):
        path = self.project / "Data" / "golfball_small.vtu"
        if not path.exists():
            self.skipTest(f"{path} is missing")
        pixels, stats = self.render(path, "--array", "nut", "--size", "128x96")
        self.assertEqual(stats["cells"], {"vtkTetra": 271607})
        self.assertEqual(stats["tetrahedra"], 271607)
        self.assertEqual(stats["points"], 47439)
        self.assertGreater(len({pixel for row in pixels for pixel in row}), 100)

    def test_shared_data(self):
        folder = self.project.parent / "shared" / "data" / "unstructured"
        cases = (("disk_out_ref.ex2", "Temp", {"vtkHexahedron": 7472}, 8499),
                 ("mug.e", "convected", {"vtkHexahedron": 2476}, 3774))
        for name, array, cells, points in cases:
            with self.subTest(name=name):
                if not (folder / name).exists():
                    self.skipTest(f"{folder / name} is not present")
                _, stats = self.render(folder / name, "--size", "64x48")
                self.assertEqual((stats["array"]["name"], stats["cells"], stats["points"]), (array, cells, points))

    def test_time_steps(self):
        path = self.project.parent / "shared" / "data" / "unstructured" / "mug.e"
        if not path.exists():
            self.skipTest(f"{path} is not present")
        first, last = (self.render(path, "--size", "64x48", "--array", "convected", *step)[0]
                       for step in (("--time-step", 1), ()))
        twentieth = self.render(path, "--size", "64x48", "--array", "convected", "--time-step", 20)[0]
        self.assertTrue(twentieth == last, "the last time step is not the default")
        self.assertTrue(first != last, "the time steps look the same")
        self.expect_failure(1, "time step 21 does not exist: the file has 21, counted from 0 to 20", path,
                            "--time-step", 21)


if __name__ == "__main__":
    main()
