# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The options of light, by closed forms: RenderLightTest.py EXECUTABLE PROJECT_FOLDER.

The scalar grows along x, so that the surfaces that are lit face x; its transfer functions are constant.
"""
import math

from render_case import RenderCase, main

# The cube is 1 deep and seen along z on black; extinction is 0.7 / 0.5.
EXTINCTION = 1.4
COLOUR = (1, 0.5, 0.25)
SCENE = ("cube.vtu", "--array", "ramp", "--preset", "constant.json", "--unit-distance", 0.5, "--background", "0,0,0",
         "--camera", "0.5,0.5,5,0.5,0.5,0.5,0,1,0", "--parallel-scale", 0.4, "--size", "64x48")
COLUMNS = (4, 18, 32, 46, 60)


class RenderLightTest(RenderCase):
    def row(self, *light):
        """The middle row's pixels."""
        pixels, _ = self.render(*SCENE, *light)
        return pixels[24]

    def expect(self, brightness, *light, colour=COLOUR, delta=1.1):
        """brightness: of the colour, by x."""
        with self.subTest(light=light):
            row = self.row(*light)
            opacity = 1 - math.exp(-EXTINCTION)
            for column in COLUMNS:
                x = 0.5 + (column + 0.5 - 32) / 60
                for channel, share in zip(row[column], colour):
                    self.assertAlmostEqual(channel, 255 * opacity * share * brightness(x), delta=delta)

    def test_without_light(self):
        self.expect(lambda x: 1)

    def test_lights_and_material(self):
        matt = ("--ambient", 0.2, "--diffuse", 0.5, "--specular", 0)
        self.expect(lambda x: 0.2, *matt)  # the headlight grazes the surfaces
        self.expect(lambda x: 0.2 + 0.5 * 0.6, *matt, "--light", "3,0,4")
        self.expect(lambda x: 0.2 + 0.5 * 0.6 * 0.5, *matt, "--light=-3,0,4,0.5")
        self.expect(lambda x: 0.2 + 0.5 * (0.6 + 0.25), *matt, "--light", "3,0,4", "--light", "1,0,0,0.25")
        self.expect(lambda x: 0.1 + 0.7 * 0.6, "--specular", 0, "--light", "3,0,4")
        self.expect(lambda x: 0.1, "--shade", "--specular", 0)

    def test_presets(self):
        self.expect(lambda x: 0.25, "--light-preset", "headlight")  # it grazes the surfaces
        facing = 0.45 / math.hypot(0.45, 0.7, 0.55)  # of the sun's way
        lit = [share * (0.45 + facing * sun) for share, sun in zip(COLOUR, (1.35, 1.3, 1.2))]
        self.expect(lambda x: 1, "--light-preset", "sun", "--reach", 0, "--occlusion", 0, colour=lit)

    def test_lights_without_shadows_are_counted(self):
        lights = [f"--light={x},0,1" for x in range(5)]
        for shadows, without in (("off", 0), ("rays", 2)):
            _, stats = self.render(*SCENE, *lights, "--shadows", shadows)
            self.assertEqual(stats["lights"], {"left_out": 0, "without_shadows": without})

    def test_highlights(self):
        shiny = ("--ambient", 0, "--diffuse", 0, "--specular", 0.8)
        self.expect(lambda x: 0, *shiny, "--light", "4,0,3")  # is mirrored away from the eye
        for power in (1, 3):
            self.expect(lambda x: 0.8 * 0.6 ** power, *shiny, "--light=4,0,-3", "--specular-power", power,
                        colour=(1, 1, 1))

    def test_shadows(self):
        light = ("--ambient", 0, "--diffuse", 1, "--specular", 0, "--light", "1,0,0")
        self.expect(lambda x: 1, *light, "--shadows", "off")
        self.expect(lambda x: math.exp(-EXTINCTION * (1 - x)), *light, "--shadows", "rays", delta=2)
        # Between its vertices, of which the cube has but eight, light is interpolated.
        for method in ("vertices", "automatic"):
            self.expect(lambda x: math.exp(-EXTINCTION) * (1 - x) + x, *light, "--shadows", method, delta=6)

    def test_shadows_of_surfaces(self):
        light = ("--ambient", 0.25, "--diffuse", 0.75, "--specular", 0, "--surface", "plate.vtk")
        for method in ("vertices", "rays"):
            shadows = ("--shadows", method, "--opaque-shadows")
            self.expect(lambda x: 0.25, *light, *shadows, "--light", "1,0,0")
            # The plate is beyond reach.
            self.expect(lambda x: 1, *light, *shadows, "--light", "1,0,0", "--reach", 0)
        self.expect(lambda x: 0.25 + 0.75 * math.exp(-EXTINCTION * (1 - x)), *light, "--shadows", "rays",
                    "--light", "1,0,0", delta=2)

    def test_surfaces_hide_the_volume(self):
        row = self.row("--surface", "plate.vtk", "--camera", "9,0.5,0.5,0.5,0.5,0.5,0,1,0")
        for column in COLUMNS:
            self.assertEqual(row[column][:3], row[0][:3])
            self.assertEqual(len(set(row[column][:3])), 1, "the plate is not grey")

    def test_scattering_casts_shadows_as_far_as_light_reaches(self):
        light = ("--ambient", 0, "--diffuse", 1, "--specular", 0, "--light", "3,0,4")
        self.expect(lambda x: 1, *light, "--scattering", 2, "--reach", 0)
        far, near = (self.row(*light, "--scattering", 2, "--shadows", "rays", *reach)
                     for reach in ((), ("--reach", 0.2)))
        self.assertLess(sum(far[32]), 0.8 * sum(near[32]))

    def test_occlusion(self):
        light = ("--ambient", 1, "--diffuse", 0, "--specular", 0)
        self.expect(lambda x: 1, *light, "--occlusion", 0)
        near, far = (sum(self.row(*light, "--occlusion", radius)[32]) for radius in (0.1, 1))
        bright = sum(self.row(*light)[32])
        self.assertLess(near, 0.97 * bright)
        self.assertLess(far, 0.95 * near)


if __name__ == "__main__":
    main()
