# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A script that was written for vtkSmartVolumeMapper runs with ours unchanged."""
import inspect
import unittest

import scenes
import vtkmodules.all as vtk
from vtktetmarch import vtkTetMarchSettings, vtkTetMarchSmartVolumeMapper

# Mean difference inside the silhouette, of 255. VTK's samples begin up to one sample behind a clipping plane.
ALLOWED = 2.5


def make_image(cells=16, components=1):
    image = vtk.vtkImageData()
    image.SetDimensions(cells + 1, cells + 1, cells + 1)
    image.SetSpacing(1 / cells, 1 / cells, 1 / cells)
    array = vtk.vtkFloatArray()
    array.SetName("f")
    array.SetNumberOfComponents(components)
    array.SetNumberOfTuples(image.GetNumberOfPoints())
    for point in range(image.GetNumberOfPoints()):
        x, y, z = image.GetPoint(point)
        for component, value in enumerate((x + 0.3 * y * z, y, z)[:components]):
            array.SetComponent(point, component, value)
    image.GetPointData().SetScalars(array)
    return image


def set_everything(mapper, volume_property):
    """All that vtkSmartVolumeMapper of VTK 9.1 has, called as its users do, with values that change the picture."""
    mapper.SetBlendModeToComposite()
    mapper.SetAverageIPScalarRange(0, 1)
    mapper.SetRequestedRenderModeToDefault()
    mapper.SetInterpolationModeToLinear()
    mapper.SetMaxMemoryInBytes(1 << 30)
    mapper.SetMaxMemoryFraction(0.75)
    mapper.SetFinalColorWindow(0.8)
    mapper.SetFinalColorLevel(0.45)
    mapper.SetInteractiveUpdateRate(5)
    mapper.InteractiveAdjustSampleDistancesOff()
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetSampleDistance(0.01)
    mapper.SetVectorMode(mapper.COMPONENT)
    mapper.SetVectorComponent(0)
    mapper.SelectScalarArray("f")
    mapper.SetScalarModeToUsePointFieldData()
    plane = vtk.vtkPlane()
    plane.SetOrigin(0.5, 0.5, 0.2)
    plane.SetNormal(0, 0.2, 1)
    mapper.AddClippingPlane(plane)
    volume_property.SetInterpolationTypeToLinear()


def picture(mapper_class, prepare, components=1):
    mapper = mapper_class()
    volume_property = scenes.make_property()
    prepare(mapper, volume_property)
    view = scenes.View(mapper, make_image(components=components), volume_property)
    return view.pixels(), mapper


class SmartTest(unittest.TestCase):
    def test_samples_are_those_of_a_script_that_sets_them(self):
        def sampled(mapper, volume_property):
            set_everything(mapper, volume_property)
            mapper.SetAccuracyLevelToSampled()
            mapper.SetSampleDistance(0.25)

        def jittered(mapper, volume_property):
            sampled(mapper, volume_property)
            mapper.UseJitteringOn()

        exact, _ = picture(vtkTetMarchSmartVolumeMapper, set_everything)
        coarse, mapper = picture(vtkTetMarchSmartVolumeMapper, sampled)
        self.assertEqual(mapper.GetUsedAccuracyLevelAsString(), "Sampled")
        self.assertEqual(mapper.GetUsedAccuracyLevel(), mapper.SAMPLED)
        self.assertFalse(mapper.GetUseJittering())
        self.assertGreater(scenes.mean_difference(coarse, exact), 2)
        noisy, mapper = picture(vtkTetMarchSmartVolumeMapper, jittered)
        self.assertTrue(mapper.GetUseJittering())
        self.assertGreater(scenes.mean_difference(noisy, coarse), 2)

    def test_the_picture_stays(self):
        theirs, stock = picture(vtk.vtkSmartVolumeMapper, set_everything)
        ours, mapper = picture(vtkTetMarchSmartVolumeMapper, set_everything)
        self.assertGreater(scenes.covered(theirs), 0.2)
        difference = scenes.mean_difference(ours, theirs)
        print(f"mean difference: {difference:.2f} of 255")
        self.assertLess(difference, ALLOWED)
        self.assertEqual(mapper.GetLastUsedRenderMode(), stock.GetLastUsedRenderMode())

    def test_that_the_comparison_would_notice(self):
        theirs, _ = picture(vtk.vtkSmartVolumeMapper, set_everything)

        def set_almost_everything(mapper, volume_property):
            set_everything(mapper, volume_property)
            mapper.SetFinalColorWindow(1)

        ours, _ = picture(vtkTetMarchSmartVolumeMapper, set_almost_everything)
        self.assertGreater(scenes.mean_difference(ours, theirs), 2 * ALLOWED)

    def test_it_has_what_vtks_has(self):
        ours = vtkTetMarchSmartVolumeMapper()
        self.assertIsInstance(ours, vtk.vtkSmartVolumeMapper)
        self.assertIs(vtk.vtkSmartVolumeMapper.SafeDownCast(ours), ours)
        stock = vtk.vtkSmartVolumeMapper()
        properties = [name[3:] for cls in (vtk.vtkSmartVolumeMapper, vtk.vtkVolumeMapper)
                      for name, method in vars(cls).items()
                      if name.startswith("Set") and inspect.isroutine(method) and hasattr(cls, "Get" + name[3:])]
        self.assertGreater(len(properties), 15)
        # VTK guesses how much memory there is, leaves the component undefined in 9.1, and from 9.2 on has a reach of 0.
        for name in set(properties) - {"MaxMemoryInBytes", "VectorComponent", "GlobalIlluminationReach"}:
            with self.subTest(property=name):
                self.assertEqual(getattr(ours, "Get" + name)(), getattr(stock, "Get" + name)())
        self.assertEqual((ours.GetMaxMemoryInBytes(), ours.GetVectorComponent()), (0, 0))

    def test_settings_are_set_by_the_class_of_vtks(self):
        mapper = vtkTetMarchSmartVolumeMapper()
        self.assertIs(type(mapper.GetAutoAdjustSampleDistances()), int)
        mapper.AutoAdjustSampleDistancesOff()
        self.assertFalse(mapper.GetSettings().GetAutoAdjustSampleDistances())
        mapper.SetMaxMemoryInBytes(7)
        self.assertEqual(mapper.GetSettings().GetMaxMemoryInBytes(), 7)
        self.assertEqual(mapper.GetOpacityLawAsString(), "Structured")
        mapper.SetSettings(vtkTetMarchSettings())
        self.assertEqual(mapper.GetOpacityLawAsString(), "Unstructured")
        mapper.SetSettings(None)
        self.assertEqual(mapper.GetOpacityLawAsString(), "Structured")
        self.assertEqual(mapper.GetMaxMemoryInBytes(), 0)

    def test_it_picks(self):
        pixels, mapper = picture(vtkTetMarchSmartVolumeMapper, lambda *_: None)
        self.assertGreater(scenes.covered(pixels), 0.2)
        view = scenes.View(mapper)
        view.pixels()
        middle = scenes.SIZE // 2
        self.assertTrue(mapper.Pick(view.renderer, view.volume, middle, middle))
        x, y, z = mapper.GetPickedPosition()
        self.assertTrue(all(-1e-6 <= c <= 1 + 1e-6 for c in (x, y, z)))
        self.assertEqual(mapper.GetPickedBlock(), 0)
        self.assertFalse(mapper.Pick(view.renderer, view.volume, 0, 0))
        self.assertEqual(mapper.GetPickedCellId(), -1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
