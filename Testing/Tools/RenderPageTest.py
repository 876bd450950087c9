# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of tetmarch-render --html: RenderPageTest.py EXECUTABLE PROJECT_FOLDER."""
import json
import re

from render_case import RenderCase, main

SMALL = ("--size", "240x180", "--quiet")
MARKUP = "</script><img src=x onerror=alert(1)>"


class RenderPageTest(RenderCase):
    def scene(self, *arguments, warnings=""):
        """What page.html says of its scene. The folder has no other new file than pictures."""
        result = self.run_tool(*arguments, *SMALL, "--html", "page.html")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", warnings))
        text = (self.folder / "page.html").read_text(encoding="utf-8")
        self.assertTrue(text.startswith("<!DOCTYPE html>") and text.rstrip().endswith("</html>"))
        (scene,) = re.findall(r'<script type="application/json" id="scene">(.*?)</script>', text, re.DOTALL)
        return json.loads(scene)

    def test_a_page_of_either_kind_stands_alone(self):
        for name, law in (("cube.vtu", "unstructured"), ("image.vti", "structured"), ("grid.vtr", "structured")):
            with self.subTest(name=name):
                scene = self.scene(name)
                (step,) = scene["steps"]
                self.assertEqual([volume["law"] for volume in step["volumes"]], [law])
                self.assertEqual((scene["size"], scene["controls"], scene["omissions"]), ([240, 180], "all", []))
                self.assertTrue(scene["title"].startswith(name + ": "), scene["title"])
        self.assertEqual(list(self.folder.glob("*.png")), [])

    def test_options_of_a_picture_are_those_of_the_page(self):
        scene = self.scene("cube.vtu", "--array", "ramp", "--blend", "maximum", "--surface", "plate.vtk", "--camera",
                           "1,2,9,0,0,0,0,1,0,20", "--background", "1,0,0.5", "--html-controls", "none", "--output",
                           "beside.png")
        (step,) = scene["steps"]
        self.assertIn("EXTREME", step["volumes"][0]["features"])
        self.assertEqual(len(step["surfaces"]), 1)
        self.assertEqual((scene["camera"]["position"], scene["camera"]["viewAngle"]), ([1, 2, 9], 20))
        self.assertEqual((scene["background"], scene["controls"]), ([1, 0, 0.5], "none"))
        self.assertTrue((self.folder / "beside.png").exists())

    def test_time_steps_are_in_one_page(self):
        scene = self.scene("steps.vtu", "--time", "1:2", "--output", "t.png")
        self.assertEqual([step["label"] for step in scene["steps"]], ["time 1", "time 2"])
        scalars = [step["volumes"][0] for step in scene["steps"]]
        self.assertNotEqual(scalars[0], scalars[1])
        self.assertEqual({path.name for path in self.folder.glob("*.png")}, {"t_0001.png", "t_0002.png"})

    def test_what_the_page_lacks_is_told(self):
        lines = ("Lines of 1 actor are not in the page: it shows triangles.",
                 "Texts and other 2D props are not in the page: it draws a scalar bar and axes of its own.",
                 "The view mode of a volume is not in the page: it shows the picture.",
                 "The page has no opacities: its background is black.")
        for options, told in ((("--outline",), lines[:1]), (("--axes",), lines[1:2]), (("--view", "cells"), lines[2:3]),
                              (("--background", "none"), lines[3:])):
            with self.subTest(options=options):
                self.scene("cube.vtu", *options, warnings="".join(f"tetmarch-render: warning: {one}\n" for one in told))

    def test_names_are_text(self):
        text = (self.folder / "cube.vtu").read_text()
        name = MARKUP.replace("<", "&lt;").replace(">", "&gt;")
        (self.folder / "<b>.vtu").write_text(text.replace('Name="ramp"', f'Name="{name}"'))
        scene = self.scene("<b>.vtu", "--array", MARKUP)
        self.assertEqual(scene["title"], "<b>.vtu: " + MARKUP)
        self.assertNotIn("<img", (self.folder / "page.html").read_text())

    def test_standard_output(self):
        self.scene("cube.vtu")
        result = self.run_tool("cube.vtu", *SMALL, "--html", "-")
        self.assertEqual((result.stdout, result.stderr), ((self.folder / "page.html").read_text(), ""))


if __name__ == "__main__":
    main()
