# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images and rectilinear grids, drawn by tetmarch-render: RenderImageTest.py EXECUTABLE PROJECT_FOLDER."""
import json
import math
import os
import subprocess

from render_case import RenderCase, main

# Along z through a unit cube, of which all pixels see the same; x is to the right.
ALONG_Z = ("--background", "0,0,0", "--camera", "0.5,0.5,5,0.5,0.5,0.5,0,1,0", "--parallel-scale", 0.4, "--size",
           "64x48")
UNIT = ("--unit-distance", 0.5)
CONSTANT = ("--preset", "constant.json")  # opacity 0.7, colour (1, 0.5, 0.25)
RAMP = ("--preset", "ramp.json")  # the same colour, the opacity is the scalar
SLAB = ("--array", "half", *CONSTANT, *UNIT, *ALONG_Z)
COLOUR = (1, 0.5, 0.25)


def opacity_of(opacity, length, unit=0.5):
    """Of VTK's law for images."""
    return 1 - (1 - opacity) ** (length / unit)


class RenderImageTest(RenderCase):
    def check(self, pixel, opacity):
        for channel, colour in zip(pixel, COLOUR):
            self.assertAlmostEqual(channel, 255 * opacity * colour, delta=1.01)

    def scalar_at(self, x):
        """Where a column of pixels lies in the cube, along x."""
        return 0.5 + (x + 0.5 - 32) / 48 * 0.8

    def test_a_slab_has_its_known_colour_in_every_format(self):
        raw = ("--dimensions", "3,3,3", "--type", "float", "--spacing", "0.5,0.5,0.5", "--big-endian")
        by_name = ("--spacing", "0.5,0.5,0.5")
        for name, array, more in (("image.vti", "half", ()), ("grid.vtr", "half", ()), ("image.vtk", "half", ()),
                                  ("image.mha", "MetaImage", ()), ("image.nrrd", "ImageFile", ()),
                                  ("image.raw", "ImageFile", raw), ("image_3x3x3_float64.raw", "ImageFile", by_name)):
            with self.subTest(name=name):
                pixels, stats = self.render(name, *CONSTANT, *UNIT, *ALONG_Z, "--array", array, *more)
                for x, y in ((32, 24), (10, 10), (50, 40)):
                    self.check(pixels[y][x], opacity_of(0.7, 1))
                self.assertEqual(stats["array"]["name"], array)
                self.assertNotIn("tetrahedra", stats)

    def test_opacity_laws(self):
        for law, opacity in (("structured", opacity_of(0.7, 1)), ("unstructured", 1 - math.exp(-1.4))):
            with self.subTest(law=law):
                pixels, _ = self.render("image.vti", *SLAB, "--opacity-law", law)
                self.check(pixels[24][32], opacity)

    def test_the_unit_distance_is_the_mean_spacing(self):
        for name, spacing in (("image.vti", 0.5), ("grid.vtr", 0.5), ("image.mha", 1.1 / 3), ("images.vtm", 0.5)):
            with self.subTest(name=name):
                pixels, stats = self.render(name, *CONSTANT, *ALONG_Z)
                self.assertAlmostEqual(stats["unit_distance"], spacing, places=12)
                self.check(pixels[24][32], opacity_of(0.7, 1, spacing))

    def test_interpolation(self):
        """Nearest: each value holds up to the middle between two; of cells, in its cell."""
        columns = range(2, 62, 3)

        def scalars(array, *interpolation):
            pixels, _ = self.render("image.vti", "--array", array, *RAMP, *UNIT, *ALONG_Z, *interpolation)
            return [(self.scalar_at(x), pixels[24][x]) for x in columns]

        for interpolation in ((), ("--interpolation", "linear")):
            for x, pixel in scalars("ramp", *interpolation):
                self.check(pixel, opacity_of(x, 1))
        for x, pixel in scalars("ramp", "--interpolation", "nearest"):
            self.check(pixel, opacity_of(0 if x < 0.25 else 0.5 if x < 0.75 else 1, 1))
        for x, pixel in scalars("side", "--interpolation", "nearest"):
            self.check(pixel, opacity_of(0 if x < 0.5 else 1, 1))
        for x, pixel in scalars("side"):
            self.check(pixel, opacity_of(min(max(2 * x - 0.5, 0), 1), 1))
        self.expect_failure(1, "--interpolation is for images, rectilinear grids and adaptive meshes, but 'cube.vtu' is "
                            "drawn as an unstructured grid", "cube.vtu", "--interpolation", "nearest")
        self.expect_failure(1, "--geometry-tolerance is for meshes of curved cells, but 'image.vti' has images", "image.vti",
                            "--geometry-tolerance", "1e-3")

    def test_samples(self):
        """Of one scalar: four samples, the last of them on the far side; or half of the way beyond it."""
        for distance, depth in ((0.25, 1), (0.8, 0.8), (0.125, 1)):
            with self.subTest(distance=distance):
                pixels, _ = self.render("image.vti", *CONSTANT, *UNIT, *ALONG_Z, "--sample-distance", distance)
                self.check(pixels[24][32], opacity_of(0.7, depth))
        pixels, stats = self.render("image.vti", *CONSTANT, *UNIT, *ALONG_Z, "--accuracy", "sampled", "--jitter",
                                    "--compare")
        self.assertEqual(stats["accuracy"]["level"], "Sampled")
        self.expect_failure(1, "--accuracy sampled and --sample-distance are for images and rectilinear grids, but "
                            "'cube.vtu' is drawn as an unstructured grid", "cube.vtu", "--accuracy", "sampled")

    def test_what_is_cut_away(self):
        for depth, cuts in ((0.6, ("--clip", "0,0,0.6,0,0,-1")), (0.3, ("--crop", "0,1,0,1,0.2,0.5")),
                            (0.7, ("--crop=-1,2,5,6,0.2,0.5", "--crop-regions", "inverted-cross"))):
            for name in ("image.vti", "grid.vtr", "images.vtm"):
                with self.subTest(cuts=cuts, name=name):
                    pixels, _ = self.render(name, *SLAB, *cuts)
                    self.check(pixels[24][32], opacity_of(0.7, depth))

    def test_components_and_values_that_are_not_finite(self):
        for choice, scalar in (((), 0.3), (("--component", 1), 0.4), (("--component", "magnitude"), 0.5)):
            with self.subTest(choice=choice):
                pixels, _ = self.render("image.vti", "--array", "vector", *RAMP, *UNIT, *ALONG_Z, *choice)
                self.check(pixels[24][32], opacity_of(scalar, 1))
        scene = ("image.vti", "--array", "unknown", *CONSTANT, *UNIT, *ALONG_Z)
        pixels = self.draw_with_warning("none of the scalars is a finite number", *scene)
        self.assertEqual(pixels[24][32], (0, 0, 0))
        pixels, _ = self.render(*scene, "--nan", "0.2,1,0.6,0.3")
        for channel, part in zip(pixels[24][32], (0.2, 1, 0.6)):
            self.assertAlmostEqual(channel, 255 * part * opacity_of(0.3, 1), delta=1.01)

    def test_blend_modes(self):
        """Along x the scalar goes from 0 to 1, and its opacity is the same: both count for mean and sum."""
        along_x = ("--array", "ramp", *RAMP, *UNIT, "--background", "0,0,0", "--size", "64x48",
                   "--camera", "5,0.5,0.5,0.5,0.5,0.5,0,1,0", "--parallel-scale", 0.4)
        for mode, shown in (("maximum", 1), ("minimum", 0)):
            with self.subTest(mode=mode):
                pixels, _ = self.render("image.vti", *along_x, "--blend", mode)
                self.check(pixels[24][32], shown)
        for mode, shown in (("average", 1 / 3), ("additive", 2 / 3)):  # in gray
            with self.subTest(mode=mode):
                pixels, _ = self.render("image.vti", *along_x, "--blend", mode)
                self.assertEqual(pixels[24][32], (255 * shown,) * 3)
        pixels, _ = self.render("image.vti", *along_x, "--isovalues", "0.3,0.6")
        self.check(pixels[24][32], 1 - 0.7 * 0.4)
        # What one surface leaves out of two blocks' pictures would be seen.
        both, _ = self.render("images.vtm", *along_x, "--isovalues", "0.3,0.6")
        self.check(both[24][32], 1 - (0.7 * 0.4) ** 2)

    def test_blocks_are_drawn_over_each_other(self):
        along_x = ("--background", "0,0,0", "--size", "64x48", "--camera", "5,0.5,0.5,0.5,0.5,0.5,0,1,0",
                   "--parallel-scale", 0.4)
        pixels, stats = self.render("images.vtm", "--array", "half", *CONSTANT, *UNIT, *along_x)
        self.check(pixels[24][32], opacity_of(0.7, 2))
        self.assertEqual((stats["blocks"], stats["cells"], stats["points"]), (2, {"vtkVoxel": 16}, 54))
        for option in (("--pixel", "3,3"), ("--view", "cells"), ("--blend", "maximum"),
                       ("--compare", "--stats", "s.json")):
            self.expect_failure(1, " is for one image or rectilinear grid, but 'images.vtm' has 2, which are drawn one "
                                "over the other", "images.vtm", *option)

    def test_statistics(self):
        _, stats = self.render("image.vti", "--size", "80x60", "--array", "ramp", "--accuracy", "accurate", "--compare")
        self.assertEqual(stats["cells"], {"vtkVoxel": 8})
        self.assertEqual((stats["points"], stats["blocks"], stats["lattice_cells"]), (27, 1, 8))
        self.assertEqual(stats["accuracy"]["level"], "Accurate")
        self.assertEqual(set(stats["seconds"]), {"read", "lattice", "scalars", "tables", "upload", "first_frame"})
        self.assertGreater(stats["pixels"]["cells"]["count"], 100)
        self.assertLess(stats["pixels"]["error"]["max"], stats["accuracy"]["tolerance"])
        self.assertEqual(stats["array"]["range"], [0, 1])
        _, stats = self.render("image.vti", "--size", "80x60", "--error", 0.01)
        self.assertEqual(stats["accuracy"], {"level": "Default", "tolerance": 0.01, "pixel_tolerance": 0.0})

    def test_light(self):
        """Ambient light alone, of all of the colour, is no light; shadows take some away."""
        scene = ("image.vti", "--array", "ramp", *RAMP, "--size", "80x60")
        plain, _ = self.render(*scene)
        ambient, _ = self.render(*scene, "--ambient", 1, "--diffuse", 0, "--specular", 0)
        self.assertEqual(ambient, plain)
        lit, stats = self.render(*scene, "--shade", "--ambient", 0.1, "--diffuse", 0.6, "--specular", 0)
        self.assertNotEqual(lit, plain)
        self.assertIn("vertex_light", stats["seconds"])
        shadowed, _ = self.render(*scene, "--light", "1,0,0", "--ambient", 0, "--shadows", "rays")
        unshadowed, _ = self.render(*scene, "--light", "1,0,0", "--ambient", 0)
        self.assertLess(*(sum(sum(map(sum, row)) for row in pixels) for pixels in (shadowed, unshadowed)))

    def test_views(self):
        picture, _ = self.render("image.vti", "--array", "ramp", "--size", "320x240")
        for view in ("error", "cells", "lookups"):
            with self.subTest(view=view):
                pixels, _ = self.render("image.vti", "--array", "ramp", "--size", "320x240", "--view", view)
                # The legend: text is white; the palest colour has 184 of blue.
                self.assertGreater(sum(min(pixel) > 190 for row in pixels for pixel in row[240:]), 50)
        for view in ("illumination", "gradients"):
            with self.subTest(view=view):
                pixels, _ = self.render("image.vti", "--array", "ramp", "--size", "320x240", "--view", view)
                self.assertNotEqual(pixels, picture)
        for view in ("faces", "coordinates"):
            self.expect_failure(1, "--view faces and --view coordinates show the boundary of an unstructured grid, but "
                                "'image.vti' has images or rectilinear grids", "image.vti", "--view", view)

    def test_a_pixel(self):
        result = self.run_tool("image.vti", "--pixel", "32,24", "--pixel-json", "pixel.json", *SLAB)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for line in ("In float, as on the GPU: the ray passes 2 cells.", "Array half, accuracy Default, tolerance "
                     "0.003921569.", "In float and in double the ray passes the same cells."):
            self.assertIn(line, result.stdout.splitlines())
        self.assertIn("enters the grid", result.stdout)
        self.assertNotIn("tetrahed", result.stdout)
        trace = json.loads((self.folder / "pixel.json").read_text())
        for which in ("picture", "float", "double", "ground_truth"):
            for channel, colour in zip(trace[which]["color"], (*COLOUR, 1)):
                self.assertAlmostEqual(channel, opacity_of(0.7, 1) * colour, delta=2e-6)
        cells = trace["double"]["cells"]
        self.assertEqual([cell["cell"] for cell in cells], [cell["lattice_cell"] for cell in cells])
        self.assertEqual([cell["cell"] // 4 for cell in cells], [1, 0])
        self.assertEqual(list(self.folder.glob("*.png")), [])

    def test_surfaces_hide_what_is_behind(self):
        along_x = ("--camera", "5,0.5,0.5,0.5,0.5,0.5,0,1,0", "--parallel-scale", 0.4, "--background", "0,0,0")
        pixels, _ = self.render("image.vti", "--array", "half", *CONSTANT, *UNIT, *along_x, "--size", "64x48",
                                "--surface", "plate.vtk")
        self.assertEqual(len({pixel for row in pixels for pixel in row}), 1)  # it is at x = 2
        self.assertEqual(len(set(pixels[0][0])), 1)  # and gray

    def test_inputs_that_cannot_be_drawn(self):
        self.expect_failure(1, "'flat.vtk' has no 3D cells, so there is no volume to render (vtkStructuredPoints of "
                            "3 x 3 x 1 points)", "flat.vtk")
        self.expect_failure(1, "the data has no array to draw (on points: none; on cells: none)", "bare_image.vtk")
        self.expect_failure(2, "'image.raw' holds nothing but values: say what they are by --dimensions NX,NY,NZ and "
                            "--type TYPE", "image.raw")
        self.expect_failure(2, "say what they are by --dimensions NX,NY,NZ", "image.raw", "--type", "float")
        self.expect_failure(2, "bad value 'half' of --type: expected uint8, ", "image.raw", "--type", "half")
        self.expect_failure(2, "bad value '3,3' of --dimensions: ", "image.raw", "--dimensions", "3,3")
        self.expect_failure(1, "cannot read 'image.raw': it has 108 bytes, but 3 x 3 x 4 values of float are 144; "
                            "check --dimensions and --type", "image.raw", "--dimensions", "3,3,4", "--type", "float")
        self.expect_failure(2, "--dimensions, --type, --spacing and --big-endian tell of .raw files", "image.vti",
                            "--type", "float")
        self.assertEqual(list(self.folder.glob("*.png")), [])

    def test_the_large_image_of_the_pages(self):
        """But smaller."""
        name = "waves_48x48x48_uint8.raw"
        script = self.project / "Data" / "make_image.py"
        subprocess.run(["/usr/bin/python3", script, "48", name], cwd=self.folder, check=True)
        pixels, stats = self.render(name, "--unit-distance", 10, "--size", "64x64")
        self.assertEqual(stats["points"], 48 ** 3)
        self.assertGreater(len({pixel for row in pixels for pixel in row}), 100)
        self.assertEqual(pixels[0][0], pixels[63][63])  # nothing is drawn there
        self.expect_failure(1, "it has 110592 bytes, but 48 x 48 x 47 values of uint8 are 108288", name, "--dimensions",
                            "48,48,47")

    def test_the_small_scan(self):
        data = self.project / "Data"
        pixels, stats = self.render(data / "bonsai_small.vti", "--preset", data / "bonsai.json", "--size", "96x96")
        self.assertEqual((stats["points"], stats["array"]["name"]), (128 ** 3, "density"))
        self.assertEqual(stats["array"]["range"], [0, 255])
        self.assertEqual(stats["unit_distance"], 2)
        greens = sum(g > r + 10 and g > b + 10 for row in pixels for r, g, b in row)
        self.assertGreater(greens, 200)  # leaves

    def test_memory(self):
        """A raw file of bytes is held once here and once by the GL, which is this process, too."""
        def most(size):
            """Bytes that the process had at most."""
            with open(self.folder / "zeros.raw", "wb") as file:
                file.truncate(size ** 3)
            arguments = [self.executable, "zeros.raw", "--dimensions", f"{size},{size},{size}", "--type", "uint8",
                         "--size", "32x32"]
            with subprocess.Popen(arguments, cwd=self.folder, env={**os.environ}) as process:
                _, status, usage = os.wait4(process.pid, 0)
                process.returncode = status
            self.assertEqual(status, 0)
            return 1024 * usage.ru_maxrss

        self.assertLess(most(400) - most(2), 2.8 * 400 ** 3)


if __name__ == "__main__":
    main()
