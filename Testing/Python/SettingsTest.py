# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Settings of a mapper, alone and shared by several mappers."""
import gc
import unittest

import scenes
import vtkmodules.all  # noqa: F401
from vtktetmarch import vtkTetMarchProjectedTetrahedraMapper, vtkTetMarchSettings, vtkTetMarchVolumeMapper


def count_of_modified(thing):
    events = []
    thing.AddObserver("ModifiedEvent", lambda *_: events.append(True))
    return events


class SettingsTest(unittest.TestCase):
    def test_a_mapper_has_its_own(self):
        one, other = vtkTetMarchVolumeMapper(), vtkTetMarchVolumeMapper()
        self.assertIsInstance(one.GetSettings(), vtkTetMarchSettings)
        self.assertIsNot(one.GetSettings(), other.GetSettings())
        one.SetErrorTolerance(0.25)
        self.assertEqual(one.GetSettings().GetErrorTolerance(), 0.25)
        one.GetSettings().SetViewRange(1, 2)
        self.assertEqual(one.GetViewRange(), (1, 2))
        self.assertEqual(other.GetErrorTolerance(), 1 / 255)

    def test_shared_ones_change_for_all(self):
        settings = vtkTetMarchSettings()
        settings.SetAccuracyLevelToAccurate()
        one, other = vtkTetMarchVolumeMapper(), vtkTetMarchVolumeMapper()
        for mapper in (one, other):
            before = mapper.GetMTime()
            mapper.SetSettings(settings)
            self.assertGreater(mapper.GetMTime(), before)
            self.assertIs(mapper.GetSettings(), settings)
        before, events = other.GetMTime(), count_of_modified(other)
        one.SetShadowMethodToAlongRays()
        self.assertEqual(other.GetShadowMethod(), other.SHADOWS_ALONG_RAYS)
        self.assertGreater(other.GetMTime(), before)
        self.assertEqual(len(events), 1)

    def test_none_are_the_defaults(self):
        mapper = vtkTetMarchVolumeMapper()
        shared = vtkTetMarchSettings()
        shared.SetErrorTolerance(0.5)
        mapper.SetSettings(shared)
        mapper.SetSettings(None)
        self.assertIsNot(mapper.GetSettings(), shared)
        self.assertEqual(mapper.GetErrorTolerance(), 1 / 255)

    def test_settings_that_were_left_have_no_effect(self):
        mapper = vtkTetMarchVolumeMapper()
        left = mapper.GetSettings()
        mapper.SetSettings(vtkTetMarchSettings())
        before = mapper.GetMTime()
        left.SetErrorTolerance(0.5)
        self.assertEqual(mapper.GetMTime(), before)
        self.assertEqual(mapper.GetErrorTolerance(), 1 / 255)

    def test_settings_outlive_the_mapper(self):
        mapper = vtkTetMarchVolumeMapper()
        settings = mapper.GetSettings()
        del mapper
        gc.collect()
        settings.SetErrorTolerance(0.5)
        self.assertEqual(settings.GetErrorTolerance(), 0.5)

    def test_the_replaced_mapper_hears_of_them(self):
        mapper = vtkTetMarchProjectedTetrahedraMapper()
        before = mapper.GetMTime()
        mapper.GetMarchingMapper().GetSettings().AmbientOcclusionOn()
        self.assertGreater(mapper.GetMTime(), before)

    def test_frames_follow_shared_settings(self):
        settings = vtkTetMarchSettings()
        views = []
        for _ in range(2):
            mapper = vtkTetMarchVolumeMapper()
            mapper.SetScalarModeToUsePointFieldData()
            mapper.SelectScalarArray("high")
            mapper.SetSettings(settings)
            views.append(scenes.View(mapper, scenes.make_grid(2)))
        for view in views:
            self.assertEqual(view.centre(), "red")
            self.assertEqual(view.mapper.GetUsedAccuracyLevel(), settings.DEFAULT)
            self.assertEqual(view.mapper.GetNumberOfCrossedCells(), 0)
        settings.SetAccuracyLevelToAccurate()
        settings.CollectDiagnosticsOn()
        for view in views:
            self.assertEqual(view.centre(), "red")
            self.assertEqual(view.mapper.GetUsedAccuracyLevel(), settings.ACCURATE)
            self.assertGreater(view.mapper.GetNumberOfCrossedCells(), 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
