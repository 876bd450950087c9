# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""volume() gives what the same set-up by hand gives, to the last bit, and says what is wrong."""
import os
import unittest

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

import first_data
import vtktetmarch

SIZE = (160, 120)
MESH, IMAGE = (os.path.join(first_data.DATA, name) for name in ("golfball_small.vtu", "bonsai_small.vti"))


def picture_of(volume, camera):
    """By VTK's classes alone."""
    renderer = vtk.vtkRenderer()
    renderer.AddVolume(volume)
    renderer.SetActiveCamera(camera)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetAlphaBitPlanes(1)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    renderer.ResetCameraClippingRange()
    window.Render()
    pixels = vtk.vtkUnsignedCharArray()
    window.GetPixelData(0, 0, SIZE[0] - 1, SIZE[1] - 1, 0, pixels, 0)
    return vtk_to_numpy(pixels).reshape(SIZE[1], SIZE[0], 3)[::-1]


def by_hand(mapper, data, array, points):
    mapper.SetInputDataObject(data)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray(array)
    volume = vtk.vtkVolume()
    volume.SetMapper(mapper)
    of_volume = volume.GetProperty()
    of_volume.SetInterpolationTypeToLinear()
    color, opacity = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
    for value, rgb, alpha in points:
        color.AddRGBPoint(value, *rgb)
        opacity.AddPoint(value, alpha)
    of_volume.SetColor(color)
    of_volume.SetScalarOpacity(opacity)
    of_volume.SetScalarOpacityUnitDistance(0.5)
    return volume


class PictureTest(unittest.TestCase):
    def check(self, path, mapper, array, points, hand, **properties):
        data = vtktetmarch.read(path)
        figure = vtktetmarch.figure(
            data, array, size=SIZE, background="black", unit_distance=0.5, opacity=[(v, a) for v, _, a in points],
            cmap=[(v, c) for v, c, _ in points], **properties)
        made = by_hand(mapper, data, array, points)
        hand(mapper, made.GetProperty())
        expected = picture_of(made, figure.camera)
        self.assertGreater(expected.max(), 60)
        self.assertTrue(np.array_equal(figure.screenshot(), expected))

    def test_mesh(self):
        def hand(mapper, of_volume):
            mapper.SetAccuracyLevelToAccurate()
            mapper.SetGradientTypeToCell()
            of_volume.ShadeOn()
            of_volume.SetAmbient(0.3)

        self.check(MESH, vtktetmarch.vtkTetMarchVolumeMapper(), "speed",
                   [(0.2, (0, 0, 1), 1), (0.9, (1, 0.5, 0), 0.1), (1.0, (1, 1, 1), 0)], hand,
                   accuracy_level="accurate", gradient_type="cell", shade=True, ambient=0.3)

    def test_image(self):
        def hand(mapper, _of_volume):
            mapper.SetErrorTolerance(1e-3)
            mapper.SetBlendModeToMaximumIntensity()

        self.check(IMAGE, vtktetmarch.vtkTetMarchSmartVolumeMapper(), "density",
                   [(20, (0, 0.2, 0), 0), (100, (1, 0.8, 0.6), 0.5), (255, (1, 1, 1), 1)], hand,
                   error_tolerance=1e-3, blend_mode="maximum")

    def test_nothing_said_is_auto_transfer_functions(self):
        data = first_data.scan()
        chosen = vtktetmarch.auto_transfer_functions(data)
        of_volume = vtktetmarch.volume(data).GetProperty()
        self.assertEqual(of_volume.GetScalarOpacityUnitDistance(), chosen.unit_distance)
        for value in np.linspace(*chosen.range, 20):
            self.assertEqual(of_volume.GetScalarOpacity().GetValue(value), chosen.opacity.GetValue(value))
            self.assertEqual(of_volume.GetRGBTransferFunction().GetColor(value), chosen.color.GetColor(value))

    def test_follows_what_is_upstream(self):
        source = vtk.vtkRTAnalyticSource()
        source.SetWholeExtent(0, 9, 0, 9, 0, 9)
        tetrahedra = vtk.vtkDataSetTriangleFilter()
        tetrahedra.SetInputConnection(source.GetOutputPort())
        for given in (tetrahedra, tetrahedra.GetOutputPort()):
            figure = vtktetmarch.figure(given, size=SIZE)
            before = figure.screenshot()
            source.SetXFreq(source.GetXFreq() + 60)
            self.assertFalse(np.array_equal(figure.screenshot(), before))


class MapperTest(unittest.TestCase):
    def test_of_each_kind_of_data(self):
        structured = vtk.vtkMultiBlockDataSet()
        structured.SetBlock(0, first_data.integers_with_air())
        mixed = vtk.vtkMultiBlockDataSet()
        mixed.SetBlock(0, first_data.with_points(first_data.image((4, 4, 4)), "head", lambda p: p[0]))
        mixed.SetBlock(1, first_data.blocks())
        curvilinear = vtk.vtkStructuredGrid()
        curvilinear.SetDimensions(2, 2, 2)
        points = vtk.vtkPoints()
        for i in range(8):
            points.InsertNextPoint(i & 1, i >> 1 & 1, i >> 2)
        curvilinear.SetPoints(points)
        first_data.with_points(curvilinear, "x", lambda p: p[0])
        adaptive = vtk.vtkAMRGaussianPulseSource()
        adaptive.SetDimension(3)
        adaptive.Update()
        trees = vtk.vtkRandomHyperTreeGridSource()
        trees.SetDimensions(3, 3, 3)
        smart, tets = vtktetmarch.vtkTetMarchSmartVolumeMapper, vtktetmarch.vtkTetMarchVolumeMapper
        for data, expected in ((first_data.one_tetrahedron(), tets), (first_data.blocks(), tets), (mixed, tets),
                               (curvilinear, tets), (adaptive.GetOutput(), tets), (trees, tets), (MESH, tets), (IMAGE, smart), (structured, smart),
                               (first_data.rectilinear(), smart), (first_data.integers_with_air(), smart)):
            with self.subTest(data=type(data).__name__):
                self.assertIs(type(vtktetmarch.volume(data).GetMapper()), expected)

    def test_array_component_association(self):
        mapper = vtktetmarch.volume(first_data.vectors(), "velocity", component=1).GetMapper()
        self.assertEqual((mapper.GetVectorModeAsString(), mapper.GetVectorComponent()), ("Component", 1))
        mapper = vtktetmarch.volume(first_data.vectors(), component="magnitude").GetMapper()
        self.assertEqual(mapper.GetVectorModeAsString(), "Magnitude")
        mapper = vtktetmarch.volume(first_data.hexahedra_with_cell_scalars(), "stress", association="cells").GetMapper()
        self.assertEqual(mapper.GetArrayName(), "stress")
        self.assertEqual(mapper.GetScalarMode(), vtk.VTK_SCALAR_MODE_USE_CELL_FIELD_DATA)


class FunctionsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.data = first_data.one_tetrahedron()

    def opacity(self, what, **more):
        return vtktetmarch.volume(self.data, opacity=what, **more).GetProperty().GetScalarOpacity()

    def color(self, cmap):
        function = vtktetmarch.volume(self.data, cmap=cmap, range=(0, 2)).GetProperty().GetRGBTransferFunction()
        return lambda value: tuple(round(part, 3) for part in function.GetColor(value))

    def test_maps_of_ours_by_name(self):
        warm = vtktetmarch.volume(self.data, cmap="Cool to Warm", range=(0, 2)).GetProperty().GetRGBTransferFunction()
        self.assertEqual(warm.GetColorSpace(), 3)  # VTK_CTF_DIVERGING
        self.assertEqual(warm.GetRange(), (0, 2))
        ours = vtktetmarch.volume(self.data, cmap="viridis", range=(0, 2)).GetProperty().GetRGBTransferFunction()
        self.assertEqual([round(channel, 3) for channel in ours.GetColor(0)], [0.267, 0.005, 0.329])

    def test_opacity(self):
        self.assertEqual([self.opacity(0.25).GetValue(x) for x in (-1, 0, 2)], [0.25] * 3)
        self.assertEqual([self.opacity("linear", range=(1, 3)).GetValue(x) for x in (0, 1, 2, 3, 4)], [0, 0, 0.5, 1, 1])
        self.assertEqual([self.opacity([(0, 1), (1, 0)]).GetValue(x) for x in (0, 0.25, 1)], [1, 0.75, 0])
        for spread in ([0, 1, 0.5], np.array([0, 1, 0.5]), lambda value: max(0, min(value - 1, 2 - value / 2))):
            self.assertEqual([self.opacity(spread, range=(1, 3)).GetValue(x) for x in (0, 1, 1.5, 2, 2.5, 3, 4)],
                             [0, 0, 0.5, 1, 0.75, 0.5, 0.5])
        squared = self.opacity(np.square, range=(0, 1))
        self.assertLess(max(abs(squared.GetValue(x) - x * x) for x in np.linspace(0, 1, 1001)), 1e-5)
        own = vtk.vtkPiecewiseFunction()
        self.assertIs(self.opacity(own), own)

    def test_unit_distance_suits_an_opacity_of_ones_own(self):
        distances = [vtktetmarch.volume(self.data, opacity=value).GetProperty().GetScalarOpacityUnitDistance()
                     for value in (0.1, 0.2)]
        self.assertAlmostEqual(distances[1] / distances[0], 2, 2)

    def test_colors(self):
        self.assertEqual([self.color(["red", "#00f"])(x) for x in (0, 1, 2)], [(1, 0, 0), (0.5, 0, 0.5), (0, 0, 1)])
        self.assertEqual(self.color([(0, "black"), (0.5, (1, 1, 0)), (2, "#00ff00")])(0.5), (1, 1, 0))
        own = vtk.vtkColorTransferFunction()
        self.assertIs(vtktetmarch.volume(self.data, cmap=own).GetProperty().GetRGBTransferFunction(), own)

    def test_a_color_map_by_name(self):
        viridis = self.color("viridis")
        for value, expected in ((0, (0.267, 0.005, 0.329)), (1, (0.128, 0.567, 0.551)), (2, (0.993, 0.906, 0.144))):
            np.testing.assert_allclose(viridis(value), expected, atol=0.01)


class PropertiesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.data = first_data.one_tetrahedron()

    def test_of_mapper_settings_property_and_volume(self):
        made = vtktetmarch.volume(
            self.data, blend_mode="isosurface", isosurface_values=[0.2, 0.4], max_memory_in_bytes=10**9, shade=True,
            shadow_method="at_vertices", view_range=(0.1, 2), average_ip_scalar_range=(1, 2), pickable=False,
            gradient_opacity=[(0, 0), (1, 0.5)], clipping_planes=[((0, 0, 0), (0, 0, 1)), vtk.vtkPlane()])
        mapper, of_volume = made.GetMapper(), made.GetProperty()
        self.assertEqual(mapper.GetBlendModeAsString(), "IsoSurface")
        self.assertEqual([of_volume.GetIsoSurfaceValues().GetValue(i) for i in (0, 1)], [0.2, 0.4])
        self.assertEqual(mapper.GetSettings().GetMaxMemoryInBytes(), 10**9)
        self.assertEqual((of_volume.GetShade(), made.GetPickable()), (1, 0))
        self.assertEqual(mapper.GetShadowMethod(), mapper.SHADOWS_AT_VERTICES)
        self.assertEqual((mapper.GetViewRange(), mapper.GetAverageIPScalarRange()), ((0.1, 2), (1, 2)))
        self.assertEqual(of_volume.GetGradientOpacity().GetValue(1), 0.5)
        self.assertEqual(mapper.GetClippingPlanes().GetNumberOfItems(), 2)
        self.assertIs(vtktetmarch.configure(made, shade=False, accuracy_level=0, clipping_planes=[]), made)
        self.assertEqual((of_volume.GetShade(), mapper.GetAccuracyLevelAsString()), (0, "Fast"))
        self.assertEqual(mapper.GetClippingPlanes().GetNumberOfItems(), 0)

    def test_what_is_wrong_is_said(self):
        for wrong, error, text in (
                ({"acuracy_level": "fast"}, TypeError, "did you mean 'accuracy_level'"),
                ({"accuracy_level": "best"}, ValueError, "'accurate', 'default', 'fast', 'reference', 'sampled'"),
                ({"accuracy_level": 7}, ValueError, r"can't be 7: it is 0 \('fast'\), .* 4 \('sampled'\)"),
                ({"error_tolerance": 5}, ValueError, "the nearest is 1.0"),
                ({"error_tolerance": "low"}, TypeError, "takes no word"),
                ({"error_tolerance": [1, 2]}, TypeError, r"error_tolerance can't be \[1, 2\]"),
                ({"clipping_planes": [3]}, TypeError, "a vtkPlane or \\(point, normal\\)"),
                ({"array": "pressure"}, ValueError, "on points: z"),
                ({"component": -2}, ValueError, "'magnitude' or None"),
                ({"association": "faces"}, ValueError, "'points', 'cells' or None"),
                ({"range": (1, 0)}, ValueError, "low < high"),
                ({"unit_distance": 0}, ValueError, "above 0"),
                ({"opacity": 2}, ValueError, "0 to 1"),
                ({"opacity": "cubic"}, ValueError, "'linear'"),
                ({"opacity": []}, ValueError, "at least one"),
                ({"cmap": "no such map"}, ValueError, "cmap has no 'no such map'"),
                ({"cmap": ["no such colour"]}, ValueError, "no colour 'no such colour'"),
                ({"cmap": []}, ValueError, "no colours")):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(error, text):
                vtktetmarch.volume(self.data, **wrong)

    def test_what_is_no_volume_is_said(self):
        for data, error, text in ((vtk.vtkPolyData(), TypeError, "is a surface"), (3, TypeError, "int is no data"),
                                  (vtk.vtkUnstructuredGrid(), ValueError, "no cells to draw"),
                                  (vtk.vtkMultiBlockDataSet(), ValueError, "no block with cells"),
                                  (vtk.vtkTable(), TypeError, "vtkTable is no data")):
            with self.subTest(data=data.__class__.__name__), self.assertRaisesRegex(error, text):
                vtktetmarch.volume(data)


if __name__ == "__main__":
    unittest.main(verbosity=2)
