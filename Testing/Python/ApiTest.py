# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The wrapped class as a user of Python meets it: its help, constants, defaults and printed state."""
import inspect
import math
import unittest

import vtkmodules.all as vtk
import vtktetmarch
from vtktetmarch import vtkTetMarchLegend, vtkTetMarchSmartVolumeMapper, vtkTetMarchVolumeMapper

CLASSES = [name for name in vtktetmarch.__all__ if name.startswith("vtk")]
# What macros declare without a comment of their own, as in every class of VTK.
FROM_MACROS = {"NewInstance", "SafeDownCast"}


class ApiTest(unittest.TestCase):
    def test_every_method_is_documented(self):
        methods = {f"{cls.__name__}.{name}": method
                   for cls in (getattr(vtktetmarch, name) for name in CLASSES)
                   for name, method in vars(cls).items()
                   if not name.startswith("__") and inspect.isroutine(method) and name not in FROM_MACROS}
        for name in ("SetOpacityLaw", "GetUploadSeconds", "SetShadowMethodToAlongRays", "AmbientOcclusionOn"):
            self.assertIn("vtkTetMarchVolumeMapper." + name, methods)
        self.assertIn("vtkTetMarchFrameStatistics.GetPercentile", methods)
        self.assertIn("vtkTetMarchProjectedTetrahedraMapper.Render", methods)
        for name in sorted(methods):
            with self.subTest(method=name):
                # The signatures in Python and C++ come first, then an empty line.
                _, _, comment = methods[name].__doc__.partition("\n\n")
                self.assertGreater(len(comment.split()), 3)

    def test_the_class_and_the_package_are_documented(self):
        self.assertIn("marching rays", vtkTetMarchVolumeMapper.__doc__)
        self.assertIn("marching rays", vtktetmarch.__doc__)
        self.assertEqual(CLASSES,
                         ["vtkTetMarchDualGrid", "vtkTetMarchFirstPicture", "vtkTetMarchFrameStatistics",
                          "vtkTetMarchImageReader", "vtkTetMarchLegend", "vtkTetMarchObjectFactory",
                          "vtkTetMarchProjectedTetrahedraMapper", "vtkTetMarchSettings",
                          "vtkTetMarchSmartVolumeMapper", "vtkTetMarchTessellator", "vtkTetMarchVolumeMapper",
                          "vtkTetMarchWebExporter"])

    def test_base_classes(self):
        mapper = vtkTetMarchVolumeMapper()
        self.assertIsInstance(mapper, vtk.vtkUnstructuredGridVolumeMapper)
        self.assertEqual(mapper.GetClassName(), "vtkTetMarchVolumeMapper")
        self.assertIsInstance(mapper.NewInstance(), vtkTetMarchVolumeMapper)

    def test_defaults(self):
        mapper = vtkTetMarchVolumeMapper()
        self.assertEqual(mapper.GetOpacityLaw(), vtkTetMarchVolumeMapper.UNSTRUCTURED)
        self.assertFalse(mapper.GetCollectDiagnostics())
        self.assertEqual(mapper.GetMaxDrawTimeInSeconds(), 0.25)
        self.assertEqual(mapper.GetMaxMemoryInBytes(), 0)
        self.assertEqual(mapper.GetAccuracyLevel(), vtkTetMarchVolumeMapper.DEFAULT)
        self.assertEqual(mapper.GetErrorTolerance(), 1 / 255)
        self.assertEqual((mapper.GetFrameTimeBudget(), mapper.GetErrorBudget()), (0, 0))
        self.assertEqual((mapper.GetUsedAccuracyLevel(), mapper.GetUsedErrorTolerance()), (mapper.DEFAULT, 1 / 255))
        self.assertIs(mapper.IsBudgetKept(), False)
        self.assertEqual(mapper.GetLastFrameStatistics().GetNumberOfPixels(0), 0)
        figures = [name for name in dir(mapper)
                   if name.startswith("GetNumberOf") and "Generations" not in name or
                   name.endswith(("Builds", "Seconds", "Bytes")) and name.startswith("Get") and
                   not name.startswith("GetMax")]
        own = [name for name in figures if name in vars(vtkTetMarchVolumeMapper)]
        self.assertGreater(len(own), 15)
        for name in own:
            self.assertEqual(getattr(mapper, name)(), 0, name)
        pixels = vtk.vtkFloatArray()
        mapper.GetDiagnosticPixels(pixels)
        self.assertEqual(pixels.GetNumberOfTuples(), 0)

    def test_the_opacity_law(self):
        mapper = vtkTetMarchVolumeMapper()
        self.assertEqual((mapper.UNSTRUCTURED, mapper.STRUCTURED), (0, 1))
        before = mapper.GetMTime()
        mapper.SetOpacityLawToStructured()
        self.assertEqual(mapper.GetOpacityLaw(), mapper.STRUCTURED)
        self.assertGreater(mapper.GetMTime(), before)
        mapper.SetOpacityLawToUnstructured()
        self.assertEqual(mapper.GetOpacityLaw(), mapper.UNSTRUCTURED)
        for value, clamped in ((-1, mapper.UNSTRUCTURED), (2, mapper.STRUCTURED), (99, mapper.STRUCTURED)):
            mapper.SetOpacityLaw(value)
            self.assertEqual(mapper.GetOpacityLaw(), clamped)
        with self.assertRaises(TypeError):
            mapper.SetOpacityLaw("structured")

    def test_the_diagnostics_switch(self):
        mapper = vtkTetMarchVolumeMapper()
        mapper.CollectDiagnosticsOn()
        self.assertTrue(mapper.GetCollectDiagnostics())
        mapper.CollectDiagnosticsOff()
        self.assertFalse(mapper.GetCollectDiagnostics())

    def test_the_view_modes(self):
        mapper = vtkTetMarchVolumeMapper()
        self.assertEqual(mapper.GetViewMode(), mapper.VIEW_PICTURE)
        self.assertTrue(mapper.GetAutomaticViewRange())
        for value, name in enumerate(("Picture", "ErrorBound", "Cells", "Lookups", "Illumination", "Gradients",
                                       "BoundaryFaces", "BoundaryCoordinates")):
            getattr(mapper, "SetViewModeTo" + name)()
            self.assertEqual((mapper.GetViewMode(), mapper.GetViewModeAsString()), (value, name))
        mapper.SetViewRange(2, 30)
        self.assertEqual(mapper.GetViewRange(), (2.0, 30.0))
        self.assertEqual(mapper.GetViewLookupTable().GetNumberOfTableValues(), 256)

    def test_the_choice_of_a_component(self):
        mapper = vtkTetMarchVolumeMapper()
        self.assertEqual((mapper.GetVectorMode(), mapper.GetVectorComponent()), (mapper.DISABLED, 0))
        for value, name in ((0, "Magnitude"), (1, "Component"), (2, "AllComponents"), (-1, "Disabled")):
            before = mapper.GetMTime()
            getattr(mapper, "SetVectorModeTo" + name)()
            self.assertGreater(mapper.GetMTime(), before)
            self.assertEqual((mapper.GetVectorMode(), mapper.GetVectorModeAsString()), (value, name))
            constant = {"AllComponents": "ALL_COMPONENTS"}.get(name, name.upper())
            self.assertEqual(getattr(mapper, constant), value)
        for value, clamped in ((-2, -1), (3, 2)):
            mapper.SetVectorMode(value)
            self.assertEqual(mapper.GetVectorMode(), clamped)
        mapper.SetVectorComponent(5)
        self.assertEqual(mapper.GetVectorComponent(), 5)
        mapper.SetVectorComponent(-1)
        self.assertEqual(mapper.GetVectorComponent(), 0)

    def test_the_switch_of_what_is_not_finite(self):
        mapper = vtkTetMarchVolumeMapper()
        self.assertFalse(mapper.GetDrawNanCells())
        before = mapper.GetMTime()
        mapper.DrawNanCellsOn()
        self.assertTrue(mapper.GetDrawNanCells())
        self.assertGreater(mapper.GetMTime(), before)
        mapper.DrawNanCellsOff()
        self.assertFalse(mapper.GetDrawNanCells())

    def test_choices_of_light_and_of_the_stage(self):
        mapper = vtkTetMarchVolumeMapper()
        for option, constants, names in (
                ("ShaderStage", ("AUTOMATIC_STAGE", "FRAGMENT_STAGE", "COMPUTE_STAGE"),
                 ("Automatic", "Fragment", "Compute")),
                ("GradientType", ("VERTEX_GRADIENTS", "CELL_GRADIENTS"), ("Vertex", "Cell")),
                ("LightPreset", ("LIGHT_OF_SCENE", "LIGHT_STUDIO", "LIGHT_HEADLIGHT", "LIGHT_SUN"),
                 ("OfScene", "Studio", "Headlight", "Sun")),
                ("ShadowMethod", ("SHADOWS_OFF", "SHADOWS_AUTOMATIC", "SHADOWS_AT_VERTICES", "SHADOWS_ALONG_RAYS"),
                 ("Off", "Automatic", "AtVertices", "AlongRays"))):
            set_option = getattr(mapper, "Set" + option)
            get_option = getattr(mapper, "Get" + option)
            as_string = getattr(mapper, f"Get{option}AsString")
            self.assertEqual((get_option(), as_string()), (0, names[0]))
            for value, (constant, name) in reversed(list(enumerate(zip(constants, names)))):
                before = mapper.GetMTime()
                getattr(mapper, f"Set{option}To{name}")()
                self.assertGreater(mapper.GetMTime(), before)
                self.assertEqual((get_option(), as_string()), (value, name))
                self.assertEqual(getattr(mapper, constant), value)
            for value, clamped in ((-1, 0), (99, len(names) - 1)):
                set_option(value)
                self.assertEqual(get_option(), clamped)

    def test_the_blend_modes(self):
        mapper = vtkTetMarchVolumeMapper()
        images = vtk.vtkFixedPointVolumeRayCastMapper()
        self.assertEqual(mapper.GetAverageIPScalarRange(), images.GetAverageIPScalarRange())
        mapper.SetAverageIPScalarRange(2, 3)
        self.assertEqual(mapper.GetAverageIPScalarRange(), (2, 3))
        names = ("Composite", "MaximumIntensity", "MinimumIntensity", "AverageIntensity", "Additive", "IsoSurface")
        constants = ("COMPOSITE_BLEND", "MAXIMUM_INTENSITY_BLEND", "MINIMUM_INTENSITY_BLEND",
                     "AVERAGE_INTENSITY_BLEND", "ADDITIVE_BLEND", "ISOSURFACE_BLEND")
        for value, (constant, name) in reversed(list(enumerate(zip(constants, names)))):
            before = mapper.GetMTime()
            getattr(mapper, "SetBlendModeTo" + name)()
            self.assertGreater(mapper.GetMTime(), before)
            self.assertEqual((mapper.GetBlendMode(), mapper.GetBlendModeAsString()), (value, name))
            self.assertEqual(getattr(mapper, constant), value)
            self.assertEqual(getattr(images, constant), value)
        mapper.SetBlendMode(images.SLICE_BLEND)
        self.assertEqual(mapper.GetBlendModeAsString(), "Unknown")

    def test_the_numbers_of_light(self):
        mapper = vtkTetMarchVolumeMapper()
        for name, default, value, least, most in (
                ("VolumetricScatteringBlending", 0, 1.5, 0, 2), ("GlobalIlluminationReach", 1, 0.25, 0, 1),
                ("LightTolerance", 0, 0.01, 0, 1), ("AmbientOcclusionRadius", 0.1, 0.3, 0, 1),
                ("AmbientOcclusionDirections", 16, 40, 1, 256)):
            set_number = getattr(mapper, "Set" + name)
            get_number = getattr(mapper, "Get" + name)
            self.assertEqual(get_number(), default)
            before = mapper.GetMTime()
            set_number(value)
            self.assertEqual(get_number(), value)
            self.assertGreater(mapper.GetMTime(), before)
            for beyond, clamped in ((-1, least), (1000, most)):
                set_number(beyond)
                self.assertEqual(get_number(), clamped)

    def test_the_switches_of_light(self):
        mapper = vtkTetMarchVolumeMapper()
        for name in ("AmbientOcclusion", "LightThroughCuts", "OpaqueShadows"):
            is_on = getattr(mapper, "Get" + name)
            self.assertFalse(is_on())
            before = mapper.GetMTime()
            getattr(mapper, name + "On")()
            self.assertTrue(is_on())
            self.assertGreater(mapper.GetMTime(), before)
            getattr(mapper, name + "Off")()
            self.assertFalse(is_on())

    def test_cropping_has_the_names_of_volume_mappers(self):
        mapper = vtkTetMarchVolumeMapper()
        namesake = vtk.vtkFixedPointVolumeRayCastMapper()
        for name in ("Cropping", "CroppingRegionPlanes", "CroppingRegionFlags"):
            self.assertEqual(getattr(mapper, "Get" + name)(), getattr(namesake, "Get" + name)())
        for cropped in (mapper, namesake):
            before = cropped.GetMTime()
            cropped.CroppingOn()
            cropped.SetCroppingRegionPlanes(1, 2, 3, 4, 5, 6)
            self.assertGreater(cropped.GetMTime(), before)
        for name in ("SubVolume", "Fence", "InvertedFence", "Cross", "InvertedCross"):
            for cropped in (mapper, namesake):
                getattr(cropped, "SetCroppingRegionFlagsTo" + name)()
            self.assertEqual(mapper.GetCroppingRegionFlags(), namesake.GetCroppingRegionFlags())
        for flags, clamped in ((-1, 0), (1 << 30, 0x7ffffff)):
            mapper.SetCroppingRegionFlags(flags)
            self.assertEqual(mapper.GetCroppingRegionFlags(), clamped)
        self.assertEqual(mapper.GetCroppingRegionPlanes(), (1, 2, 3, 4, 5, 6))
        self.assertTrue(mapper.GetCropping())
        mapper.CroppingOff()
        self.assertFalse(mapper.GetCropping())

    def test_what_is_picked(self):
        mapper = vtkTetMarchVolumeMapper()
        self.assertEqual(mapper.GetPickOpacityThreshold(), 0.5)
        for value, clamped in ((0.25, 0.25), (-1, 0), (2, 1)):
            before = mapper.GetMTime()
            mapper.SetPickOpacityThreshold(value)
            self.assertEqual(mapper.GetPickOpacityThreshold(), clamped)
            self.assertGreater(mapper.GetMTime(), before)
        self.assertEqual(len(mapper.GetPickedPosition()), 3)
        self.assertTrue(math.isnan(mapper.GetPickedScalar()))
        self.assertEqual(mapper.GetPickedCellId(), -1)
        self.assertEqual(mapper.GetPickedBlock(), 0)
        self.assertTrue(callable(mapper.Pick))

    def test_the_legend(self):
        legend = vtkTetMarchLegend()
        self.assertIsInstance(legend, vtk.vtkScalarBarActor)
        for mapper in (vtkTetMarchVolumeMapper(), vtkTetMarchSmartVolumeMapper()):
            legend.SetMapper(mapper)
            self.assertIs(legend.GetMapper(), mapper)
            mapper.SetViewModeToCells()
            self.assertFalse(legend.IsShown())  # no frame yet
        del mapper
        self.assertIsNone(legend.GetMapper())

    def test_the_limits(self):
        mapper = vtkTetMarchVolumeMapper()
        for name, value in (("MaxDrawTimeInSeconds", 0.5), ("MaxMemoryInBytes", 3 << 33),
                            ("FrameTimeBudget", 0.1), ("ErrorBudget", 0.01), ("LightTimeBudget", 0.5)):
            set_limit = getattr(mapper, "Set" + name)
            get_limit = getattr(mapper, "Get" + name)
            before = mapper.GetMTime()
            set_limit(value)
            self.assertEqual(get_limit(), value)
            self.assertGreater(mapper.GetMTime(), before)
            set_limit(-1)
            self.assertEqual(get_limit(), 0)

    def test_distances_of_rays(self):
        mapper = vtkTetMarchVolumeMapper()
        self.assertTrue(mapper.GetAutoAdjustSampleDistances())
        for name, default in (("Image", 1), ("MinimumImage", 1), ("MaximumImage", 10)):
            set_distance = getattr(mapper, f"Set{name}SampleDistance")
            get_distance = getattr(mapper, f"Get{name}SampleDistance")
            self.assertEqual(get_distance(), default)
            for wanted, got in ((2.5, 2.5), (0, 1), (1e9, 100)):
                set_distance(wanted)
                self.assertEqual(get_distance(), got)
        self.assertEqual(mapper.GetUsedImageSampleDistance(), 1)

    def test_printed_state(self):
        mapper = vtkTetMarchVolumeMapper()
        mapper.SetOpacityLawToStructured()
        text = str(mapper)
        for line in ("OpacityLaw: Structured", "VectorMode: Disabled", "VectorComponent: 0", "DrawNanCells: Off",
                     "CollectDiagnostics: Off", "NumberOfTetrahedra: 0",
                     "MaxDrawTimeInSeconds: 0.25", "ShaderStage: Automatic", "UsedShaderStage: Fragment", "ViewMode: Picture", "MaxMemoryInBytes: 0", "FrameTimeBudget: 0",
                     "ErrorBudget: 0", "UsedAccuracyLevel: Default", "BudgetKept: No", "GradientType: Vertex",
                     "LightPreset: OfScene", "ShadowMethod: Off", "VolumetricScatteringBlending: 0", "GlobalIlluminationReach: 1",
                     "BlendMode: Composite", "AverageIPScalarRange: -1e+38, 1e+38",
                     "OpaqueShadows: Off", "AmbientOcclusion: Off", "AmbientOcclusionRadius: 0.1",
                     "AmbientOcclusionDirections: 16", "LightTimeBudget: 0.1", "AutoAdjustSampleDistances: On",
                     "Cropping: Off", "CroppingRegionPlanes: 0 1 0 1 0 1", "CroppingRegionFlags: 8192",
                     "PickOpacityThreshold: 0.5", "PickedCellId: -1", "PickedBlock: 0"):
            self.assertIn(line, text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
