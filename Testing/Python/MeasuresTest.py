# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Statistics of a figure's frame, its error, and picking."""
import unittest

import numpy as np
import vtkmodules.all as vtk

import first_data
import vtktetmarch
from PicturesTest import SIZE, figure_of_tetrahedron


class MeasuresTest(unittest.TestCase):
    def test_statistics(self):
        figure = figure_of_tetrahedron(accuracy_level="accurate")
        figure.screenshot()
        found = vtktetmarch.statistics(figure)
        self.assertEqual((found["number_of_tetrahedra"], found["number_of_boundary_faces"]), (1, 4))
        self.assertEqual((found["used_accuracy_level"], found["used_shader_stage"]), ("accurate", "fragment"))
        self.assertGreater(found["seconds"], 0)
        self.assertGreater(found["gpu_memory_bytes"], 0)
        self.assertIsNone(found["cells"])
        self.assertEqual(found.keys(), vtktetmarch.statistics(figure.volume).keys())
        self.assertEqual(found.keys(), vtktetmarch.statistics(figure.mapper).keys())
        vtktetmarch.configure(figure.volume, collect_diagnostics=True)
        found = figure.render().statistics()
        self.assertEqual((found["cells"]["minimum"], found["cells"]["max"]), (1, 1))
        self.assertEqual(found["cells"]["pixels"], found["number_of_rays"])
        with self.assertRaisesRegex(TypeError, "no mapper of TetMarch"):
            vtktetmarch.statistics(vtk.vtkSmartVolumeMapper())

    def test_every_figure_is_there(self):
        found = vtktetmarch.statistics(vtktetmarch.vtkTetMarchVolumeMapper())
        frame = vtktetmarch.vtkTetMarchFrameStatistics
        self.assertEqual(len([name for name in vars(frame) if name.startswith("Set") and name != "SetValues"]) + 4,
                         len(found))

    def test_compare(self):
        figure = figure_of_tetrahedron(error_tolerance=1e-4)
        found = figure.compare()
        self.assertEqual(list(found["percentiles"]), [50, 90, 99, 99.9])
        self.assertTrue(0 < found["rms"] <= found["max"] < 1e-3)
        self.assertLessEqual(found["error_bound"]["max"], 1e-4)
        self.assertGreater(found["pixels"], 1000)
        self.assertFalse(figure.mapper.GetCollectDiagnostics())
        rougher = vtktetmarch.compare(first_data.one_tetrahedron(), size=SIZE, error_tolerance=0.1)
        self.assertGreater(rougher["statistics"]["used_error_tolerance"], 0.09)
        with self.assertRaisesRegex(RuntimeError, "can't be compared"):
            figure_of_tetrahedron(camera={"position": (9, 9, 9), "focal_point": (20, 20, 20)}).compare()

    def test_pick(self):
        figure = figure_of_tetrahedron(opacity=1, unit_distance=1e-4, camera={
            "position": (0.2, -5, 0.2), "focal_point": (0.2, 0, 0.2), "view_up": (0, 0, 1), "parallel_scale": 0.5})
        hit = figure.pick(80, 30)  # a quarter from above: z = 0.2 + 0.25
        self.assertEqual((hit["cell"], hit["block"]), (0, 0))
        np.testing.assert_allclose(hit["position"], (0.2, 0, 0.45), atol=0.01)
        self.assertAlmostEqual(hit["value"], hit["position"][2], 5)
        self.assertIsNone(figure.pick(2, 2))
        with self.assertRaisesRegex(ValueError, "outside of the picture"):
            figure.pick(160, 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
