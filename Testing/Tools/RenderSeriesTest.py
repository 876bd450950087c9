# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Series of pictures, and the threads that draw them: RenderSeriesTest.py EXECUTABLE PROJECT_FOLDER."""
import pathlib
import subprocess

from read_png import read_png
from render_case import RenderCase, main


class RenderSeriesTest(RenderCase):
    def series(self, *arguments):
        """The pixels of each file that was written, by its name."""
        before = set(self.folder.glob("*.png"))
        result = self.run_tool(*arguments, "--quiet")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        return {path.name: read_png(path) for path in sorted(set(self.folder.glob("*.png")) - before)}

    def test_a_turntable_goes_around_the_focal_point(self):
        scene = ("cube.vtu", "--array", "ramp", "--size", "80x60")
        frames = self.series(*scene, "--camera", "4.5,0.5,1.5,0.5,0.5,0.5,0,0,1", "--turntable", 4, "--output", "t.png")
        self.assertEqual(list(frames), ["t_0000.png", "t_0001.png", "t_0002.png", "t_0003.png"])
        for (name, pixels), place in zip(frames.items(), ("4.5,0.5", "0.5,4.5", "-3.5,0.5", "0.5,-3.5")):
            with self.subTest(name=name):
                single = self.draw(*scene, "--camera", f"{place},1.5,0.5,0.5,0.5,0,0,1")
                worst = max(abs(a - b) for row, other in zip(pixels, single) for p, q in zip(row, other)
                            for a, b in zip(p, q))
                self.assertLessEqual(worst, 1)
        self.assertNotEqual(frames["t_0000.png"], frames["t_0002.png"])

    def test_on_a_turntable_all_is_in_view_from_all_sides(self):
        for size in ("90x60", "60x90"):
            for name, pixels in self.series("blocks.vtm", "--turntable", 6, "--size", size, "--output",
                                            f"s{size}.png").items():
                with self.subTest(name=name):
                    border = {*pixels[0], *pixels[-1], *(row[0] for row in pixels), *(row[-1] for row in pixels)}
                    self.assertEqual(border, {(20, 23, 31)})
                    self.assertGreater(sum(pixel != (20, 23, 31) for row in pixels for pixel in row), 300)

    def test_time_steps_share_colours_and_camera(self):
        frames = self.series("steps.vtu", "--size", "320x240", "--scalar-bar", "--axes", "--time", "all", "--output",
                             "a.png")
        self.assertEqual(list(frames), ["a_0000.png", "a_0001.png", "a_0002.png"])
        first, *others = frames.values()
        around = [row[240:] for row in first] + [row[:240] for row in first[215:]]  # the bar; the labels of an axis
        self.assertGreater(len({pixel for row in around for pixel in row}), 100)
        for pixels in others:
            self.assertEqual([row[240:] for row in pixels] + [row[:240] for row in pixels[215:]], around)
            self.assertNotEqual(pixels, first)

    def test_each_time_step_is_the_picture_of_that_step(self):
        scene = ("steps.vtu", "--array", "ramp", "--preset", "ramp.json", "--range", "0,3", "--unit-distance", 1,
                 "--size", "64x48", "--camera", "0.5,-4,0.5,0.5,0.5,0.5,0,0,1")
        frames = self.series(*scene, "--time", "1:2", "--output", "b.png")
        self.assertEqual(list(frames), ["b_0001.png", "b_0002.png"])
        for step, pixels in enumerate(frames.values(), 1):
            self.assertEqual(pixels, self.draw(*scene, "--time-step", step))
        self.assertNotEqual(*frames.values())

    def test_on_a_turntable_time_steps_go_by_evenly(self):
        scene = ("steps.vtu", "--array", "ramp", "--preset", "ramp.json", "--range", "0,3", "--unit-distance", 1,
                 "--size", "64x48", "--camera", "4.5,0.5,1.5,0.5,0.5,0.5,0,0,1")
        for pictures, steps in ((4, (0, 0, 1, 2)), (2, (0, 1))):  # of three steps, with more or fewer pictures
            name = f"turned{pictures}.png"
            frames = self.series(*scene, "--time", "all", "--turntable", pictures, "--output", name)
            self.assertEqual(list(frames), [f"turned{pictures}_{k:04}.png" for k in range(pictures)])
            for number, (pixels, step) in enumerate(zip(frames.values(), steps)):
                with self.subTest(pictures=pictures, number=number):
                    turned = self.series(*scene, "--time-step", step, "--turntable", pictures, "--output",
                                         f"of{pictures}_{number}_{step}.png")
                    self.assertEqual(pixels, list(turned.values())[number])

    def test_a_list_of_files_is_a_series(self):
        files = "".join(f'<DataSet timestep="{k}.5" part="0" file="{name}"/>' for k, name in
                        enumerate(("cube.vtu", "steps.vtu")))
        (self.folder / "list.pvd").write_text(f'<VTKFile type="Collection"><Collection>{files}</Collection></VTKFile>')
        scene = ("--array", "ramp", "--preset", "ramp.json", "--range", "0,3", "--unit-distance", 1, "--size", "64x48",
                 "--camera", "0.5,-4,0.5,0.5,0.5,0.5,0,0,1")
        frames = self.series("list.pvd", *scene, "--time", "all", "--output", "l.png")
        self.assertEqual(list(frames), ["l_0000.png", "l_0001.png"])
        for pixels, name in zip(frames.values(), ("cube.vtu", "steps.vtu")):
            self.assertEqual(pixels, self.draw(name, *scene))
        self.expect_failure(1, "time step 2 does not exist", "list.pvd", "--time-step", 2)

    def test_series_that_cannot_be_drawn(self):
        self.expect_failure(1, "'cube.vtu' has no time steps for --time to draw", "cube.vtu", "--time", "all")
        self.expect_failure(1, "time step 3 does not exist: the file has 3, counted from 0 to 2", "steps.vtu",
                            "--time", "1:3")
        self.expect_failure(1, "cannot read 'none.vtu': there is no such file", "none.vtu", "--time", "all")
        self.expect_failure(1, "cannot write 'no/such/folder_0000.png'", "cube.vtu", "--turntable", 2, "--output",
                            "no/such/folder.png")

    def test_a_step_without_the_array_is_named(self):
        def series(*names):
            files = "".join(f'<DataSet timestep="{k}" file="{name}"/>' for k, name in enumerate(names))
            (self.folder / "list.pvd").write_text(
                f'<VTKFile type="Collection"><Collection>{files}</Collection></VTKFile>')
        series("cube.vtu", "vectors.vtu", "cube.vtu")
        message = "time step 1 of 'list.pvd': there is no array 'ramp' on points (on points: vector; on cells: unknown)"
        self.expect_failure(1, message, "list.pvd", "--time", "all")
        self.expect_failure(1, message, "list.pvd", "--time", "all", "--array", "ramp")
        self.expect_failure(1, "time step 1 of 'list.pvd': there is no array 'ramp' (", "list.pvd", "--time", "0:1",
                            "--array", "ramp")
        series("cube.vtu", "image.vti", "cube.vtu")
        self.expect_failure(1, "time step 1 of 'list.pvd' has images or rectilinear grids, but the last step has not",
                            "list.pvd", "--time", "all")
        self.assertEqual(list(self.folder.glob("*.png")), [])

    def bars(self, *arguments):
        """What a terminal shows of a run."""
        return self.run_on_terminal(*arguments).decode().split("\r")

    def test_one_progress_bar_for_all_frames(self):
        shown = [line for line in self.bars("cube.vtu", "--array", "ramp", "--size", "32x32", "--turntable", 4)
                 if "rendering [" in line]
        percents = [int(line.rsplit("] ", 1)[1].split(" %")[0]) for line in shown]
        self.assertEqual(percents, [0, 25, 50, 75, 100])
        steps = self.bars("steps.vtu", "--array", "ramp", "--size", "32x32", "--time", "all")
        last = max(i for i, line in enumerate(steps) if "reading [" in line)
        self.assertEqual(len([line for line in steps[last + 1:] if "rendering [" in line]), 4)
        self.assertEqual("".join(self.bars("cube.vtu", "--size", "32x32", "--turntable", 4, "--quiet")), "")

    def test_threads(self):
        """Those of Mesa's llvmpipe have a name."""
        for count in (1, 3):
            with subprocess.Popen([self.executable, "cube.vtu", "--array", "ramp", "--size", "700x700", "--quiet",
                                   "--turntable", "6", "--threads", str(count)], cwd=self.folder) as process:
                most = 0
                while process.poll() is None:
                    names = []
                    for task in pathlib.Path(f"/proc/{process.pid}/task").glob("*/comm"):
                        try:
                            names.append(task.read_text())
                        except OSError:  # it has ended
                            pass
                    most = max(most, sum(name.startswith("llvmpipe-") for name in names))
            self.assertEqual(process.returncode, 0)
            if most == 0:
                self.skipTest("the GL isn't llvmpipe")
            self.assertEqual(most, count)


if __name__ == "__main__":
    main()
