# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cameras by name, what is drawn beside a volume, and the line that tells of a figure."""
import gc
import math
import os
import unittest
import weakref

import numpy as np
import vtkmodules.all as vtk

import first_data
import vtktetmarch
from vtktetmarch.overlay import round_values

SIZE = WIDTH, HEIGHT = (200, 150)
MESH = os.path.join(first_data.DATA, "golfball_small.vtu")
# Which way the camera looks, what is to the right and upwards.
NAMED = {"x": ((1, 0, 0), (0, -1, 0), (0, 0, 1)), "-x": ((-1, 0, 0), (0, 1, 0), (0, 0, 1)),
         "y": ((0, 1, 0), (1, 0, 0), (0, 0, 1)), "-y": ((0, -1, 0), (-1, 0, 0), (0, 0, 1)),
         "z": ((0, 0, 1), (-1, 0, 0), (0, 1, 0)), "-z": ((0, 0, -1), (1, 0, 0), (0, 1, 0))}
DARK, BRIGHT = "black", "white"
BAR = 125  # where the scalar bar's share of the picture begins: 150 pixels of 1024 in a half of the scale


def block(place, side=4, count=20):
    """An image of zeros but for a cube of ones with its lowest corner at a place."""
    values = np.zeros((count,) * 3, np.float32)
    values[tuple(slice(start, start + side) for start in place)] = 1
    return values


def box_of(drawn):
    """(left, right, bottom, top) of pixels, as shares of the picture."""
    rows, columns = np.nonzero(drawn)
    return (columns.min() / drawn.shape[1], (columns.max() + 1) / drawn.shape[1],
            1 - (rows.max() + 1) / drawn.shape[0], 1 - rows.min() / drawn.shape[0])


def box_of_volume(figure):
    """Of the pixels before an opaque volume."""
    vtktetmarch.configure(figure.volume, scalar_opacity_unit_distance=1e-6)
    return box_of(figure.screenshot().max(axis=2) > 20)


class CamerasTest(unittest.TestCase):
    def test_directions_and_what_fits(self):
        made = first_data.one_tetrahedron()
        for data, opacity in ((made, 1.0), (block((3, 9, 14)), "linear")):
            figure = vtktetmarch.figure(data, size=SIZE, background=DARK, opacity=opacity, cmap=["white"])
            for name, (along, right, up) in NAMED.items():
                with self.subTest(camera=name, data=type(data).__name__):
                    camera = figure.look(name).camera
                    np.testing.assert_allclose(camera.GetDirectionOfProjection(), along, atol=1e-12)
                    np.testing.assert_allclose(camera.GetViewUp(), up, atol=1e-12)
                    matrix = camera.GetViewTransformMatrix()
                    np.testing.assert_allclose([matrix.GetElement(0, i) for i in range(3)], right, atol=1e-12)
                    for parallel, least in ((False, 0.85), (True, 0.7)):
                        camera.SetParallelProjection(parallel)
                        left, right_, bottom, top = box_of_volume(figure)
                        self.assertGreater(max(right_ - left, top - bottom), least)
                        self.assertTrue(min(left, bottom) > 0 and max(right_, top) < 1)

    def test_of_blocks_of_cells_and_of_moved_volumes(self):
        tree = vtk.vtkMultiBlockDataSet()
        for number, place in enumerate(((3, 3, 3), (13, 13, 13))):
            tree.SetBlock(number, vtktetmarch.from_image(block(place), association="cells", origin=(40 * number, 0, 0)))
        figure = vtktetmarch.figure(tree, size=SIZE, background=DARK, opacity="linear", position=(1000, 0, 0),
                                    camera="y")
        # From 3 to 57 along x, from 3 to 17 along z.
        self.assertAlmostEqual(figure.camera.GetFocalPoint()[0], 1030, delta=2)
        left, right, bottom, top = box_of_volume(figure)
        self.assertGreater(right - left, 0.85)
        self.assertAlmostEqual((top - bottom) * HEIGHT / ((right - left) * WIDTH), 14 / 54, delta=0.03)

    def test_the_drawn_component_is_looked_at(self):
        vectors = np.stack([block((3, 3, 3)), block((13, 13, 13))], axis=-1)
        for component, middle in ((0, 4.5), (1, 14.5), ("magnitude", 9.5)):
            for name in ("iso", "-z"):
                camera = vtktetmarch.figure(vectors, component=component, opacity="linear", camera=name).camera
                np.testing.assert_allclose(camera.GetFocalPoint(), [middle] * 3, atol=2, err_msg=f"{component} {name}")

    def test_the_visible_part_is_that_of_the_opacity(self):
        values = block((30, 30, 30), count=250) + 2 * block((220, 210, 200), count=250)
        figure = vtktetmarch.figure(values, opacity=[(1.5, 0), (2, 1)])
        for name in ("iso", "x", "-y"):
            camera = figure.look(name).camera
            np.testing.assert_allclose(camera.GetFocalPoint(), (221.5, 211.5, 201.5), atol=2, err_msg=name)
            self.assertLess(camera.GetParallelScale(), 10)

    def test_a_stretched_volume_just_fits(self):
        figure = vtktetmarch.figure(block((3, 9, 14)), size=SIZE, background=DARK, opacity="linear", cmap=["white"],
                                    position=(100, 0, 0), scale=(4, 1, 0.5))
        for parallel, least in ((False, 0.85), (True, 0.6)):
            figure.camera.SetParallelProjection(parallel)
            left, right, bottom, top = box_of_volume(figure)
            self.assertGreater(max(right - left, top - bottom), least)
            self.assertTrue(min(left, bottom) > 0 and max(right, top) < 1)

    def test_nothing_visible_is_looked_at_as_a_whole(self):
        figure = vtktetmarch.figure(block((3, 3, 3)), size=SIZE, opacity=0.0, camera="x")
        np.testing.assert_allclose(figure.camera.GetFocalPoint(), (9.5, 9.5, 9.5))


class BesideTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.data = vtktetmarch.read(MESH)

    def figure(self, **how):
        return vtktetmarch.figure(self.data, "speed", size=SIZE, **{"background": DARK, **how})

    def test_the_bar_has_the_colours_of_values(self):
        figure = self.figure(cmap=["blue", "red"], range=(0.5, 1)).scalar_bar()
        self.assertIs(figure.scalar_bar("again"), figure)
        strip = figure.screenshot()[:, 135].astype(int)
        drawn = np.flatnonzero((strip[:, 0] + strip[:, 2] > 200) & (strip[:, 1] < 20))  # without the title
        self.assertEqual(drawn[-1] - drawn[0] + 1, len(drawn))
        self.assertAlmostEqual(len(drawn) / HEIGHT, 0.84 - 0.12, delta=0.12)
        for share in (0.1, 0.5, 0.9):
            red, green, blue = strip[drawn[-1] - int(share * len(drawn))]
            np.testing.assert_allclose((red, green, blue), (255 * share, 0, 255 * (1 - share)), atol=8)

    def test_there_is_room_beside_the_volume(self):
        for axes in (False, True):
            figure = self.figure(opacity=1.0, cmap=["red"]).scalar_bar("")
            if axes:
                figure.axes()
            vtktetmarch.configure(figure.volume, scalar_opacity_unit_distance=1e-6)
            picture = figure.screenshot().astype(int)
            red = (picture[:, :, 0] > 100) & (picture[:, :, 1] < 60)
            left, right, _, _ = box_of(red[:, :BAR])
            self.assertLess(right, 0.98)
            self.assertEqual(left > 30 / BAR, axes)
            self.assertGreater(right - left, 0.3)

    def test_a_camera_that_was_moved_stays(self):
        figure = self.figure()
        figure.camera.Zoom(0.7)
        view = vtktetmarch.cameras.view_of(figure.camera)
        figure.scalar_bar().axes()
        self.assertEqual(vtktetmarch.cameras.view_of(figure.camera), view)
        own = vtk.vtkCamera()
        own.SetPosition(1, 2, 3)
        figure.look(own)
        self.assertEqual(figure.camera.GetPosition(), (1, 2, 3))

    def test_axes_are_along_edges_of_the_box(self):
        figure = self.figure(camera="y", visibility=False).axes(("east", "north", "up"))
        picture = figure.screenshot().max(axis=2) > 100
        x_low, x_high, _, _, z_low, z_high = self.data.GetBounds()
        left, right, bottom, top = box_of(picture)
        row = max(range(HEIGHT), key=lambda i: picture[i].sum())
        column = max(range(WIDTH), key=lambda i: picture[:, i].sum())
        along, upwards = np.flatnonzero(picture[row]), picture[:, column].sum()
        self.assertAlmostEqual(upwards / len(along), (z_high - z_low) / (x_high - x_low), delta=0.05)
        self.assertTrue(left < column / WIDTH < 0.3 and bottom < 1 - row / HEIGHT < 0.5)  # labels are outside
        figure.camera.SetPosition(3, 0, 0)  # within the box
        figure.camera.SetFocalPoint(4, 0, 0)
        self.assertFalse((figure.screenshot().max(axis=2) > 100).any())

    def test_text_is_legible_on_the_background(self):
        for background, transparent, expected in ((DARK, False, 255), (BRIGHT, False, 0), (DARK, True, 128)):
            figure = self.figure(background=background, transparent=transparent, visibility=False).axes()
            picture = figure.screenshot()
            differs = (picture != picture[0, 0]).any(axis=2)
            differs &= picture[:, :, -1] == 255 if transparent else True
            farthest = np.abs(picture[differs][:, 0].astype(int) - picture[0, 0, 0]).argmax()
            self.assertAlmostEqual(int(picture[differs][farthest, 0]), expected, delta=1)

    def test_a_view_of_a_measure_has_its_legend(self):
        figure = self.figure(cmap=["lime"]).scalar_bar()
        green = (0, 255, 0)
        self.assertTrue((figure.screenshot()[:, BAR:] == green).all(axis=2).any())
        vtktetmarch.configure(figure.volume, view_mode="cells")
        picture = figure.screenshot()[:, BAR:]
        self.assertFalse((picture == green).all(axis=2).any())
        self.assertTrue((picture > 200).any())

    def test_figures_are_deleted(self):
        figure = self.figure().scalar_bar().axes()
        figure.screenshot()
        alive = [weakref.ref(each) for each in (figure, figure.renderer, figure.volume, figure.mapper)]
        del figure
        gc.collect()
        self.assertEqual([reference() for reference in alive], [None] * 4)

    def test_round_values(self):
        for given, expected in (((0, 1, 5), [0, 0.5, 1]), ((0, 1, 6), [0, 0.2, 0.4, 0.6, 0.8, 1]), ((-3, 7, 3), [0, 5]),
                                ((1e6, 1e6 + 3, 4), [1e6 + i for i in range(4)]), ((1, 1, 5), []), ((0, 1, 0), []),
                                ((0.3, 0.4, 1), [0.4]), ((2.1, 2.9, 1), [2.5])):
            np.testing.assert_allclose(round_values(*given), expected, err_msg=str(given))


class LineTest(unittest.TestCase):
    def test_says_array_range_unit_distance_and_frame(self):
        figure = vtktetmarch.figure(MESH, "speed", size=SIZE, range=(0.5, 1), unit_distance=0.25)
        before = "<Figure: speed on points, 0.5 to 1, unit distance 0.25"
        self.assertEqual(repr(figure), before + ">")
        figure.screenshot()
        self.assertRegex(repr(figure), before + r"; last frame [0-9.e-]+ s, error tolerance 0\.0039>")
        vtktetmarch.configure(figure.volume, collect_diagnostics=True)
        figure.screenshot()
        bound = figure.statistics()["error_bound"]["max"]
        self.assertTrue(math.isfinite(bound))
        self.assertTrue(repr(figure).endswith(f" s, error at most {bound:.2g}>"), repr(figure))
        vtktetmarch.configure(figure.volume, collect_diagnostics=False, accuracy_level="fast")
        figure.screenshot()
        self.assertTrue(repr(figure).endswith(" s, no error bound>"), repr(figure))
        self.assertLess(len(repr(figure)), 120)

    def test_of_components_cells_and_blocks(self):
        for data, how, expected in (
                (first_data.vectors(), {}, "velocity (magnitude) on points"),
                (first_data.vectors(), {"component": 2}, "velocity (component 2) on points"),
                (first_data.hexahedra_with_cell_scalars(), {"association": "cells"}, "stress on cells"),
                (first_data.blocks(), {}, "head on points"),
                (block((3, 3, 3)), {}, "values on points")):
            self.assertIn(f": {expected}, ", repr(vtktetmarch.figure(data, size=SIZE, **how)))


if __name__ == "__main__":
    unittest.main(verbosity=2)
