# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects go in any order, as Python's references do, without a crash and without an error."""
import gc
import itertools
import unittest

import scenes
from vtktetmarch import vtkTetMarchVolumeMapper


def shown_view():
    mapper = vtkTetMarchVolumeMapper()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("high")
    view = scenes.View(mapper, scenes.make_grid(2))
    assert view.centre() == "red"
    return view


class LifetimeTest(unittest.TestCase):
    def test_any_order_of_deletion(self):
        for order in itertools.permutations(("mapper", "volume", "renderer", "window")):
            with self.subTest(order=order):
                view = shown_view()
                for name in order:
                    delattr(view, name)
                    gc.collect()

    def test_the_window_is_finalized_and_drawn_again(self):
        view = shown_view()
        self.assertGreater(view.mapper.GetGPUMemoryBytes(), 0)
        view.window.Finalize()
        self.assertEqual(view.mapper.GetGPUMemoryBytes(), 0)
        self.assertEqual(view.centre(), "red")

    def test_a_mapper_moves_to_another_window(self):
        view = shown_view()
        other = scenes.View(view.mapper)
        self.assertEqual(other.centre(), "red")
        del view
        gc.collect()
        self.assertEqual(other.centre(), "red")

    def test_the_volume_leaves_the_renderer(self):
        view = shown_view()
        view.renderer.RemoveVolume(view.volume)
        self.assertEqual(view.centre(), "empty")
        view.renderer.AddVolume(view.volume)
        self.assertEqual(view.centre(), "red")


if __name__ == "__main__":
    unittest.main(verbosity=2)
