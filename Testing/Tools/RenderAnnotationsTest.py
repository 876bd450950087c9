# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What tetmarch-render tells of what it draws, and draws beside it: ...Test.py EXECUTABLE PROJECT_FOLDER."""
from render_case import RenderCase, main

# Towards a unit cube, of which some is seen from all sides but the far one.
TOWARDS = ("--camera", "0.5,0.5,5,0.5,0.5,0.5,0,1,0", "--size", "200x200")
SLAB = ("--array", "half", "--preset", "constant.json", "--unit-distance", 0.5, *TOWARDS)
OBLIQUE = ("--camera", "3,-4,2,0.5,0.5,0.5,0,0,1", "--size", "240x180")


def differing(a, b, tolerance=0):
    """Places (x, y) of the pixels that differ."""
    return [(x, y) for y, (row, other) in enumerate(zip(a, b)) for x, (p, q) in enumerate(zip(row, other))
            if max(abs(i - j) for i, j in zip(p, q)) > tolerance]


def on_black(picture):
    """Colours that a file without background has were divided by opacity: compared is what they add to a picture."""
    return [[tuple(round(c * p[3] / 255) for c in p[:3]) + (p[3],) if len(p) == 4 else p for p in row] for row in picture]


class RenderAnnotationsTest(RenderCase):
    def test_what_is_drawn_is_told_unless_it_was_asked_for(self):
        def told(*arguments):
            result = self.run_tool("cube.vtu", "--size", "16x16", *arguments)
            self.assertEqual((result.returncode, result.stdout), (0, ""))
            return result.stderr
        self.assertEqual(told(), "tetmarch-render: note: drawing ramp on points, 0 to 1 (--list shows all arrays)\n")
        self.assertEqual(told("--array", "half"), "")
        self.assertEqual(told("--quiet"), "")

    def test_list(self):
        def listed(*arguments):
            result = self.run_tool(*arguments, "--list")
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            return result.stdout
        self.assertEqual(listed("cube.vtu"),
                         "      array      on    type  components  minimum  maximum  kind\n"
                         "       half  points  double           1      0.5      0.5  constant\n"
                         "*      ramp  points  double           1        0        1  values\n"
                         "   material   cells     int           1        2        7  numbers\n"
                         "* is drawn unless --array says otherwise\nno time steps\n")
        self.assertIn("\n*  material   cells ", listed("cube.vtu", "--array", "material"))
        steps = listed("steps.vtu", "--time-step", 1)
        self.assertIn("\n*   ramp  points  double           1        0        2  values\n", steps)
        self.assertTrue(steps.endswith("\ntime steps: 0 to 2, times 0 to 2\n"), steps)
        self.assertEqual(list(self.folder.glob("*.png")), [])
        self.expect_failure(1, "there is no array 'x'", "cube.vtu", "--list", "--array", "x")
        self.expect_failure(1, "the data has no array to draw", "bare.vtk", "--list")

    def test_numbers_have_as_many_digits_as_tell_the_ends_apart(self):
        cube = (self.folder / "cube.vtu").read_text()
        for low, high, told in ((101324.9, 101325.4, "101324.9 to 101325.4"), (1, 1234567, "1 to 1234567"),
                                (1e9, 1e9 + 1.5, "1000000000 to 1000000001.5")):
            ramp = " ".join(str(low + (high - low) * x) for x in (0, 1, 1, 0) * 2)
            (self.folder / "near.vtu").write_text(cube.replace("0 1 1 0 0 1 1 0", ramp))
            with self.subTest(told=told):
                result = self.run_tool("near.vtu", "--size", "16x16")
                self.assertEqual(result.stderr, f"tetmarch-render: note: drawing ramp on points, {told} (--list shows all "
                                                "arrays)\n")
                listed = self.run_tool("near.vtu", "--list").stdout
                self.assertRegex(listed, "ramp  points  double +1 +" + told.replace(" to ", " +") + "  values")
                # Labels with many digits are beside the bar, not cut off.
                pixels = self.draw("near.vtu", "--size", "320x240", "--axes", "--scalar-bar", "--range", f"{low},{high}")
                border = {*pixels[0], *pixels[-1], *(row[0] for row in pixels), *(row[-1] for row in pixels)}
                self.assertEqual(border, {(20, 23, 31)})

    def test_color_maps(self):
        result = self.run_tool("--colors", "list")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        names = result.stdout.splitlines()
        self.assertIn("Viridis", names)
        scene = ("cube.vtu", "--array", "ramp", "--preset", "ramp.json", *TOWARDS)
        pictures = [str(self.draw(*scene, "--colors", name)) for name in names] + [str(self.draw(*scene))]
        self.assertEqual(len(set(pictures)), len(names) + 1)
        self.expect_failure(2, "there is no colour map 'Rainbow'; known are ", "cube.vtu", "--colors", "Rainbow")

    def test_a_scalar_bar_has_the_colours(self):
        scene = ("cube.vtu", "--array", "ramp", "--colors", "viridis", "--range", "0,1", "--camera",
                 "9,9,9,0.5,0.5,0.5,0,0,1", "--size", "512x384")
        without, pixels = self.draw(*scene), self.draw(*scene, "--scalar-bar")
        changed = differing(without, pixels)
        self.assertGreater(min(x for x, _ in changed), 512 - 80)
        x = 512 - 75 + 10
        bar = [row[x] for row in pixels[63:336]]
        for color, end in ((bar[-1], (68, 1, 84)), (bar[len(bar) // 2], (33, 145, 140)), (bar[0], (253, 231, 37))):
            for a, b in zip(color, end):
                self.assertAlmostEqual(a, b, delta=6)

    def test_text_is_legible_on_any_background(self):
        for background, text in (("0,0,0", (255, 255, 255)), ("1,1,1", (0, 0, 0)), ("0,0.2,0.9", (255, 255, 255)),
                                 ("1,0.8,0", (0, 0, 0))):
            for option in ("--scalar-bar", "--axes"):
                with self.subTest(background=background, option=option):
                    pixels = self.draw("cube.vtu", "--size", "640x480", "--background", background, option)
                    like_text = sum(max(abs(a - b) for a, b in zip(pixel, text)) < 64
                                    for row in pixels for pixel in row)
                    self.assertGreater(like_text, 30)

    def test_a_vectors_title_says_which_part(self):
        scene = ("vectors.vtu", "--array", "vector", "--size", "512x384", "--scalar-bar", "--range", "0,1")
        parts = [self.draw(*scene, "--component", part) for part in ("0", "1", "magnitude")]
        titles = [[row[512 - 75:] for row in pixels[:60]] for pixels in parts]
        self.assertGreater(len(differing(titles[0], titles[1])), 3)
        self.assertGreater(len(differing(titles[0], titles[2])), 30)

    def test_the_volume_hides_the_outline_as_far_as_it_is_opaque(self):
        # The near side of the box is 46.6 pixels to either side of the middle, the far one 37.3.
        plain = self.draw("cube.vtu", *SLAB, "--background", "0,0,0")
        pixels = self.draw("cube.vtu", *SLAB, "--background", "0,0,0", "--outline")
        changed = set(differing(plain, pixels))
        near, far = ([(x, 100) for x in columns if (x, 100) in changed] for columns in ((52, 53, 54), (61, 62, 63)))
        self.assertTrue(near and far)
        for x, y in near:
            self.assertEqual(pixels[y][x], (255, 255, 255))
        for x, y in far:  # the line is white, the volume (1, 0.5, 0.25) by its opacity
            through = 255 - plain[y][x][0]
            self.assertGreater(plain[y][x][0], 150)
            for channel, before in zip(pixels[y][x], plain[y][x]):
                self.assertAlmostEqual(channel, before + through, delta=2)

    def test_axes_go_along_the_silhouette(self):
        scene = ("cube.vtu", *SLAB, "--background", "0,0,0")
        plain, pixels = self.draw(*scene), self.draw(*scene, "--axes")
        changed = differing(plain, pixels, 8)
        self.assertGreater(sum(y in (145, 146, 147) and 54 <= x <= 146 for x, y in changed), 80)  # along x, below
        self.assertGreater(sum(x in (52, 53, 54) and 54 <= y <= 146 for x, y in changed), 80)  # along y, on the left
        inside = [(x, y) for x, y in changed if 56 < x < 144 and 56 < y < 144]
        self.assertEqual(inside, [])

    def test_no_axes_of_a_box_around_the_camera(self):
        result = self.run_tool("cube.vtu", "--array", "half", "--size", "32x32", "--axes", "--camera",
                               "0.5,0.5,0.5,0.5,0.5,0,0,1,0")
        self.assertEqual(result.returncode, 0)
        self.assertIn("warning: there are no axes, since some of the data's box is behind the camera", result.stderr)

    def test_what_is_beside_the_volume_has_room(self):
        """None of it is cut off at the picture's border, by whatever shape of the picture."""
        for size in ("320x240", "200x400", "500x150"):
            with self.subTest(size=size):
                pixels = self.draw("cube.vtu", "--size", size, "--axes", "--outline", "--scalar-bar")
                border = {*pixels[0], *pixels[-1], *(row[0] for row in pixels), *(row[-1] for row in pixels)}
                self.assertEqual(border, {(20, 23, 31)})

    def test_without_background_a_picture_can_be_laid_over_any(self):
        beside = ("--camera", "1,-4,1,1,0.5,0.5,0,0,1", "--size", "240x180", "--surface", "plate.vtk")
        for name, options in (("cube.vtu", beside), ("image.vti", ("--shade", *OBLIQUE))):
            free = self.draw(name, "--array", "ramp", *options, "--background", "none")
            opacities = {pixel[3] for row in free for pixel in row}
            self.assertGreater(len(opacities), 20)
            self.assertIn(0, opacities)
            self.assertEqual(255 in opacities, "plate.vtk" in options)
            for background in ((1, 0.5, 0.2), (0, 0, 0), (0.3, 0.9, 1)):
                with self.subTest(name=name, background=background):
                    pixels = self.draw(name, "--array", "ramp", *options, "--background",
                                       ",".join(map(str, background)))
                    worst = max(abs(c * p[3] / 255 + b * (255 - p[3]) - q) for row, other in zip(free, pixels)
                                for p, o in zip(row, other) for c, b, q in zip(p, background, o))
                    print(f"[ MEASURED ] {name}: {worst:.2f}/255")
                    self.assertLess(worst, 1.5)

    def test_what_is_beside_the_volume_is_legible_without_background(self):
        pixels = self.draw("cube.vtu", *TOWARDS, "--background", "none", "--axes", "--outline", "--scalar-bar")
        grey = sum(pixel == (128, 128, 128, 255) for row in pixels for pixel in row)
        self.assertGreater(grey, 200)
        plate = [pixel for row in pixels[90:110] for pixel in row[130:]]
        self.assertGreater(sum(pixel == (25, 25, 25, 191) for pixel in plate), 200)

    def test_tiles_make_the_picture(self):
        beside = ("--axes", "--scalar-bar")
        for name, options in (("cube.vtu", ()), ("cube.vtu", beside), ("image.vti", ("--shade",)),
                              ("cube.vtu", (*beside, "--parallel-scale", 1)), ("cube.vtu", ("--background", "none"))):
            for size, tile in (("241x181", 100), ("150x45", 7)):
                with self.subTest(name=name, options=options, size=size):
                    scene = (name, "--array", "ramp", "--size", size, *options)
                    one, tiles = self.draw(*scene), self.draw(*scene, "--tile-size", tile)
                    self.assertEqual((len(one), len(one[0])), (len(tiles), len(tiles[0])))
                    # A line's steps from pixel to pixel may be elsewhere.
                    self.assertLessEqual(len(differing(on_black(one), on_black(tiles), 1)), 6 if "--axes" in options else 0)
                    self.assertGreater(len({pixel for row in one for pixel in row}), 50)
        # The noise of samples goes on from tile to tile.
        scene = ("image.vti", "--array", "ramp", "--size", "241x181", "--sample-distance", 0.2, "--jitter")
        self.assertEqual(differing(self.draw(*scene), self.draw(*scene, "--tile-size", 128), 1), [])
        scene = ("cube.vtu", "--array", "ramp", "--size", "241x181", "--outline")
        self.assertLess(len(differing(self.draw(*scene), self.draw(*scene, "--tile-size", 100), 1)), 20)

    def test_what_looks_at_a_whole_frame_takes_no_tiles(self):
        for option, value in (("--pixel", "5,5"), ("--stats", "s.json"), ("--frames", 3), ("--view", "cells")):
            self.expect_failure(2, "is for a picture in one piece, but --tile-size 50", "cube.vtu", "--size", "60x40",
                                "--tile-size", 50, option, value)


if __name__ == "__main__":
    main()
