# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What tetmarch-render --pixel prints and writes: PixelTest.py EXECUTABLE PROJECT_FOLDER."""
import json
import math

from read_png import read_png
from render_case import RenderCase, main

BLACK = ("--background", "0,0,0", "--size", "64x48")
# Opacity 0.7, colour (1, 0.5, 0.25), a unit distance of 0.5.
CONSTANT = ("--array", "half", "--preset", "constant.json", "--unit-distance", 0.5, *BLACK)
ALONG_Z = ("--camera", "0.5,0.5,5,0.5,0.5,0.5,0,1,0", "--parallel-scale", 0.4)
ALONG_X = ("--camera", "5,0.5,0.5,0.5,0.5,0.5,0,1,0", "--parallel-scale", 0.4)


class PixelTest(RenderCase):
    def trace(self, name, pixel, *arguments, warning=None):
        """The text and the JSON of a pixel."""
        result = self.run_tool(name, "--pixel", pixel, "--pixel-json", "pixel.json", "--quiet", *arguments)
        if warning:
            self.check_warning(result, warning)
        else:
            self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout, json.loads((self.folder / "pixel.json").read_text())

    def check_colours(self, trace, opacity):
        for which in ("picture", "float", "double", "ground_truth"):
            with self.subTest(which=which):
                for channel, colour in zip(trace[which]["color"], (1, 0.5, 0.25, 1)):
                    self.assertAlmostEqual(channel, opacity * colour, delta=2e-6)

    def test_a_slab_has_its_known_opacity(self):
        _, trace = self.trace("cube.vtu", "32,24", *CONSTANT, *ALONG_Z)
        self.check_colours(trace, 1 - math.exp(-1.4))
        self.assertEqual((trace["pixel"], trace["size"]), ([32, 24], [64, 48]))
        ray = trace["ray"]
        for part, direction in zip(ray["direction"], (0, 0, -1)):
            self.assertAlmostEqual(part, direction, places=12)
        self.assertAlmostEqual(ray["thickness_per_length"], 2, places=6)
        for which in ("float", "double", "ground_truth"):
            cells = trace[which]["cells"]
            # The cube is cut into tetrahedra.
            self.assertEqual({cell["cell"] for cell in cells}, {0})
            self.assertGreater(len(cells), 1)
            self.assertAlmostEqual(ray["origin"][2] - cells[0]["enter"], 1, delta=1e-6)
            self.assertAlmostEqual(ray["origin"][2] - cells[-1]["leave"], 0, delta=1e-6)
            self.assertEqual([cell["enters_mesh"] for cell in cells], [True] + [False] * (len(cells) - 1))
            for before, cell in zip(cells, cells[1:]):
                self.assertEqual(cell["enter"], before["leave"])
            for cell in cells:
                self.assertEqual((cell["scalar_enter"], cell["scalar_leave"]), (0.5, 0.5))
                self.assertAlmostEqual(cell["opacity"], 1 - math.exp(-1.4 * (cell["end"] - cell["begin"])), delta=1e-6)
            self.assertEqual(cells[-1]["color"], trace[which]["color"])
        self.assertIsNone(trace["parting_row"])
        for difference in trace["differences"].values():
            self.assertLess(max(map(abs, difference)), 1e-6)

    def test_the_text(self):
        text, trace = self.trace("cube.vtu", "10,5", *CONSTANT, *ALONG_Z)
        lines = text.splitlines()
        self.assertEqual(lines[0], "Pixel 10,5 of 64x48, counted from the upper left (10,42 from the lower left).")
        self.assertIn("Array half, accuracy Default, tolerance 0.003921569.", lines)
        titles = [i for i, line in enumerate(lines) if line.split()[:3] == ["row", "cell", "tet"]]
        self.assertEqual(len(titles), 2)  # in float, in double
        for which, first in zip(("float", "double"), titles):
            rows = lines[first + 1:first + 1 + len(trace[which]["cells"])]
            for number, (row, cell) in enumerate(zip(rows, trace[which]["cells"])):
                self.assertEqual(row.split()[:3], [str(number), str(cell["cell"]), str(cell["tetrahedron"])])
                self.assertAlmostEqual(float(row.split()[3]), cell["enter"], places=5)
        self.assertIn("enters the mesh", lines[titles[0] + 1])
        self.assertIn("In float and in double the ray passes the same tetrahedra.", lines)
        self.assertEqual(text, "\n".join(line.rstrip() for line in lines) + "\n")

    def test_pixels_are_those_of_the_png(self):
        """Also the rows: the picture is not the same upside down."""
        scene = ("cube.vtu", "--array", "ramp", *BLACK)
        for x, y in ((20, 12), (30, 30), (40, 20), (0, 0)):
            with self.subTest(x=x, y=y):
                _, trace = self.trace(scene[0], f"{x},{y}", *scene[1:], "--output", "out.png")
                pixel = read_png(self.folder / "out.png")[y][x]
                for channel, drawn, computed in zip(pixel, trace["picture"]["color"], trace["float"]["color"]):
                    self.assertAlmostEqual(channel, 255 * drawn, delta=1.01)
                    self.assertAlmostEqual(drawn, computed, delta=1e-4)

    def test_a_ray_that_misses(self):
        text, trace = self.trace("cube.vtu", "0,0", *BLACK)
        self.assertIn("In float, as on the GPU: the ray passes no tetrahedron.\n", text)
        self.assertEqual(trace["float"]["cells"], [])
        self.assertEqual(trace["float"]["color"], [0, 0, 0, 0])

    def test_bad_command_lines(self):
        outside = "the pixel of --pixel is outside the picture: columns are 0 to 63, rows 0 to 47"
        for pixel in ("64,0", "0,48"):
            self.expect_failure(2, outside, "cube.vtu", "--pixel", pixel, *BLACK)
        self.expect_failure(2, "bad value '5' of --pixel: expected X,Y", "cube.vtu", "--pixel", "5")
        self.expect_failure(2, "--pixel-json writes the ray of --pixel", "cube.vtu", "--pixel-json", "p.json")

    def test_json_that_cannot_be_written(self):
        result = self.run_tool("cube.vtu", "--pixel", "3,3", "--pixel-json", "no/such/folder.json", *BLACK)
        self.assertEqual(result.returncode, 1)
        self.assertIn("cannot write 'no/such/folder.json'", result.stderr)

    def test_a_picture_only_if_asked_for(self):
        self.trace("cube.vtu", "3,3", *BLACK)
        self.assertEqual(list(self.folder.glob("*.png")), [])
        self.trace("cube.vtu", "3,3", *BLACK, "--output", "out.png", "--stats", "out.json", "--frames", 1)
        self.assertTrue((self.folder / "out.png").exists())
        self.assertEqual(json.loads((self.folder / "out.json").read_text())["output"], "out.png")

    def test_several_blocks(self):
        """The cells of all blocks are numbered on; each of the two has a hexahedron and a triangle."""
        _, trace = self.trace("blocks.vtm", "32,24", *CONSTANT, *ALONG_X)
        self.check_colours(trace, 1 - math.exp(-2.8))
        cells = [cell["cell"] for cell in trace["double"]["cells"]]
        self.assertEqual(list(dict.fromkeys(cells)), [2, 0])
        self.assertEqual(sum(cell["enters_mesh"] for cell in trace["double"]["cells"]), 1)

    def test_leaves_are_cells(self):
        options = ("--array", "side", *CONSTANT[2:], *ALONG_Z, "--stats", "out.json")
        text, trace = self.trace("leaves.vthb", "32,24", *options)
        self.check_colours(trace, 1 - math.exp(-1.4))
        self.assertEqual(len(trace["double"]["cells"]), 2)
        self.assertIn("the ray passes 2 cells", text)
        sizes = json.loads((self.folder / "out.json").read_text())
        self.assertEqual((sizes["lattice_cells"], "tetrahedra" in sizes), (8, False))

    def test_what_is_not_gathered(self):
        _, trace = self.trace("cube.vtu", "32,24", *CONSTANT, *ALONG_Z, "--clip", "0,0,0.25,0,0,-1")
        self.check_colours(trace, 1 - math.exp(-1.4 * 0.25))
        self.assertAlmostEqual(trace["ray"]["range"][0], trace["ray"]["origin"][2] - 0.25, delta=1e-6)
        outcomes = {cell["outcome"] for cell in trace["float"]["cells"]}
        self.assertLessEqual(outcomes, {"gathered", "out of range"})
        text, trace = self.trace("vectors.vtu", "32,24", "--array", "unknown", "--preset", "constant.json",
                                 *BLACK, *ALONG_Z, warning="none of the scalars is a finite number")
        self.assertEqual({cell["outcome"] for cell in trace["float"]["cells"]}, {"not finite"})
        self.assertIsNone(trace["float"]["cells"][0]["scalar_enter"])
        self.assertIn("not finite", text)

    def test_blend_modes_without_opacity_of_cells(self):
        _, trace = self.trace("cube.vtu", "32,24", "--array", "ramp", *BLACK, *ALONG_X, "--blend", "maximum")
        self.assertEqual({cell["opacity"] for cell in trace["float"]["cells"]}, {None})


if __name__ == "__main__":
    main()
