# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects go in any order, as Python's references do, without a crash and without an error; their memory goes, too."""
import gc
import itertools
import os
import subprocess
import sys
import threading
import unittest

import numpy as np

import first_data
import scenes
import vtktetmarch
from vtktetmarch import vtkTetMarchVolumeMapper

LEAST_LEAK = 20_000  # bytes of a volume: its arrays of one tetrahedron, tables and textures have more
# A figure that is alive when the interpreter ends.
ALIVE_AT_THE_END = {
    "a global": "kept = figure",
    "a cycle": "kept = [figure]; kept.append(kept)",
    "of a function at exit": "import atexit; atexit.register(figure.screenshot)",
    "of a daemon": "import threading; threading.Thread(target=threading.Event().wait, args=(9,), daemon=True).start()",
    "a member of its own data": "figure.volume.GetMapper().kept = figure",
}


def resident_bytes():
    with open("/proc/self/statm", encoding="ascii") as statm:
        return int(statm.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


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

    def test_volumes_leave_no_memory(self):
        """Many in one window: a window of VTK's own keeps some kilobytes."""
        view, grid = shown_view(), first_data.one_tetrahedron()
        count = 300

        def draw_and_forget():
            for _ in range(count):
                volume = vtktetmarch.volume(grid)
                view.renderer.AddVolume(volume)
                view.window.Render()
                view.renderer.RemoveVolume(volume)

        draw_and_forget()
        before = resident_bytes()
        draw_and_forget()
        self.assertLess(resident_bytes() - before, count * LEAST_LEAK)

    def test_the_interpreter_ends(self):
        for name, line in ALIVE_AT_THE_END.items():
            with self.subTest(name):
                script = ("import first_data, vtktetmarch\nfigure = vtktetmarch.figure(first_data.one_tetrahedron(), "
                          f"size=(16, 12))\nfigure.screenshot()\n{line}\n")
                run = subprocess.run([sys.executable, "-c", script], cwd=os.path.dirname(os.path.abspath(__file__)),
                                     capture_output=True, text=True, timeout=600, check=False)
                self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_figures_in_threads(self):
        """Two at once, each in a thread of its own; and some that have drawn in another."""
        grid = first_data.one_tetrahedron()
        drawn = [vtktetmarch.figure(grid, size=(60, 40)) for _ in range(3)]
        expected, pictures = drawn[0].screenshot(), []
        drawn[1].pick(30, 20)
        drawn[2].compare()
        makers = [lambda: vtktetmarch.figure(grid, size=(60, 40))] * 2 + [lambda each=each: each for each in drawn]
        threads = [threading.Thread(target=lambda make=make: pictures.extend(
            figure.screenshot() for figure in [make()] for _ in range(10))) for make in makers]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(pictures), 10 * len(threads))
        for picture in [*pictures, *(figure.screenshot() for figure in drawn)]:
            self.assertTrue(np.array_equal(picture, expected))


if __name__ == "__main__":
    unittest.main(verbosity=2)
