# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista's add_volume() with our mappers: PyVista's arguments, exact data, our arguments, and what plotters do."""
import importlib.util
import pathlib
import tempfile
import unittest

import numpy as np

import vtktetmarch

HAS_PYVISTA = importlib.util.find_spec("pyvista") is not None
if HAS_PYVISTA:
    import pyvista
    from pyvista import examples

    from pyvista_pictures import EXAMPLES, SIZE, View, curvilinear, mean_difference, tetrahedra

OURS = {"mapper": "tetmarch"}
# Arguments of add_volume(), which have the same meaning for both.
ARGUMENTS = (
    {}, {"clim": (100, 200)}, {"clim": 150}, {"rng": (0, 250)}, {"opacity": "sigmoid_10"}, {"opacity": "linear_r"},
    {"opacity": [0.0, 0.0, 0.8, 0.0, 0.3]}, {"opacity": np.linspace(0, 255, 256) ** 2 / 255}, {"cmap": "magma"},
    {"opacity_unit_distance": 4}, {"colormap": ["green", "red", "blue"]}, {"user_matrix": np.diag((1, 2, 0.5, 1))},
    {"flip_scalars": True}, {"log_scale": True}, {"categories": 7}, {"blending": "maximum"}, {"blending": "minimum"},
    {"blending": "average"}, {"blending": "additive", "opacity": [0.01, 0.01]}, {"n_colors": 5}, {"pickable": False},
    {"shade": True, "ambient": 0.3, "diffuse": 0.9, "specular": 0.4, "specular_power": 33})
# Rounding of two pictures by half of 1/255, and our tolerance of 1/255.
ROUNDED = 2


def wavelet():
    return pyvista.Wavelet(extent=(-6, 6, -6, 6, -6, 6))


def state(view):
    """All that add_volume() sets."""
    shown, volume, mapper = view.volume.prop, view.volume, view.mapper
    values = np.linspace(*mapper.scalar_range, 300)
    return {"colors": [shown.GetRGBTransferFunction().GetColor(value) for value in values],
            "opacities": [shown.GetScalarOpacity().GetValue(value) for value in values],
            "numbers": (shown.opacity_unit_distance, shown.ambient, shown.diffuse, shown.specular,
                        shown.specular_power),
            "switches": (shown.shade, shown.independent_components, bool(volume.GetPickable())),
            "others": (mapper.blend_mode, mapper.scalar_range, mapper.scalar_map_mode, volume.user_matrix.tolist())}


@unittest.skipUnless(HAS_PYVISTA, "PyVista is not installed; Debian 12 has none")
class PyVistaTest(unittest.TestCase):
    def view(self, data, **arguments):
        view = View(data, **{**OURS, **arguments})
        self.addCleanup(view.close)
        return view

    def plotter(self, **arguments):
        plotter = pyvista.Plotter(off_screen=True, window_size=SIZE, **arguments)
        self.addCleanup(plotter.close)
        return plotter


class ArgumentsTest(PyVistaTest):
    def test_arguments_and_defaults_are_those_of_pyvista(self):
        for arguments in (*ARGUMENTS, {"cmap": pyvista.LookupTable("bone", scalar_range=(50, 200))}):
            with self.subTest(arguments=arguments):
                ours, theirs = self.view(wavelet(), **arguments), self.view(wavelet(), mapper=None, **arguments)
                self.assertEqual(state(ours), state(theirs))
                self.assertTrue(ours.mapper.IsA("vtkTetMarchSmartVolumeMapper"))
                self.assertFalse(theirs.mapper.IsA("vtkTetMarchSmartVolumeMapper"))
                if not arguments.get("shade"):  # VTK shades images in another way
                    theirs.mapper.SetSampleDistance(0.05)  # of cells of size 1
                    self.assertGreater(ours.pixels().max(), 10)
                    self.assertLess(mean_difference(ours.pixels(), theirs.pixels()), ROUNDED)

    def test_scalars_of_colours(self):
        colors = (wavelet().points + 6) / 12 * 255
        colors = np.column_stack((colors, colors.mean(axis=1))).astype(np.uint8)
        ours, theirs = self.view(wavelet(), scalars=colors), self.view(wavelet(), mapper=None, scalars=colors)
        self.assertEqual(state(ours), state(theirs))
        # VTK's mapper takes the unit distance from the last component, which PyVista doesn't set.
        theirs.volume.prop.SetScalarOpacityUnitDistance(3, theirs.volume.prop.opacity_unit_distance)
        self.assertLess(mean_difference(ours.pixels(), theirs.pixels()), ROUNDED)

    def test_a_theme_holds(self):
        theme = pyvista.themes.DarkTheme()
        theme.cmap, theme.show_scalar_bar = "plasma", False
        ours, theirs = (self.view(wavelet(), theme=theme, mapper=mapper) for mapper in ("tetmarch", None))
        self.assertEqual(state(ours), state(theirs))

    def test_arguments_of_ours(self):
        for name, value, getter in (("error_tolerance", 1e-3, "GetErrorTolerance"),
                                    ("accuracy_level", "accurate", "GetAccuracyLevelAsString"),
                                    ("shadow_method", "along_rays", "GetShadowMethodAsString"),
                                    ("collect_diagnostics", True, "GetCollectDiagnostics")):
            view = self.view(tetrahedra(), **{name: value})
            self.assertEqual(str(getattr(view.mapper, getter)()).lower(), str(value).replace("_", "").lower())
        self.assertGreater(vtktetmarch.statistics(view.volume)["cells"]["mean"], 1)
        view = self.view(wavelet(), interpolation_type="linear", clipping_planes=[((0, 0, 0), (1, 0, 0))],
                         gradient_opacity=[(0, 0.0), (50, 1.0)])
        self.assertEqual((view.volume.prop.interpolation_type, view.mapper.GetClippingPlanes().GetNumberOfItems()),
                         ("linear", 1))
        self.assertEqual(view.volume.prop.GetGradientOpacity().GetValue(25), 0.5)
        view = self.view(wavelet(), blend_mode="isosurface", isosurface_values=[150])
        self.assertGreater(view.pixels().max(), 30)

    def test_wrong_arguments_are_named_and_add_nothing(self):
        plotter = self.plotter()
        for error, text, named in (
                (TypeError, "no argument 'opacty'; did you mean 'opacity'", {"opacty": 1}),
                (TypeError, "no argument 'nan_colour'; did you mean 'nan_color'", {"nan_colour": 1}),
                (TypeError, "no argument 'error_tolerence'; did you mean 'error_tolerance'", {"error_tolerence": 1}),
                (TypeError, "clipping_planes is a list", {"clipping_planes": 3}),
                (ValueError, "accuracy_level has no 'best'; it has 'accurate'", {"accuracy_level": "best"}),
                (ValueError, "nan_opacity is 0 to 1, not 7", {"nan_opacity": 7}),
                (ValueError, "nan_color is a colour", {"nan_color": "no such"}),
                (ValueError, "opacity_unit_distance is above 0, not -1", {"opacity_unit_distance": -1}),
                (ValueError, "foo", {"blending": "foo"})):
            with self.subTest(**named), self.assertRaisesRegex(error, text):
                plotter.add_volume(wavelet(), **OURS, **named)
        for error, data in ((TypeError, pyvista.Sphere()), (ValueError, examples.load_structured()),
                            (TypeError, [1, 2]), (ValueError, pyvista.MultiBlock([pyvista.Sphere()]))):
            self.assertRaises(error, plotter.add_volume, data, **OURS)
        self.assertEqual(len(plotter.actors), 0)


class DataTest(PyVistaTest):
    def test_examples_agree_with_the_ground_truth(self):
        for name, (make, arguments) in EXAMPLES.items():
            view = self.view(make(), **arguments)
            found = view.compare()
            print(f"{name}: error {found['max']:.5f} at most, {found['rms']:.5f} RMS")
            self.assertLess(found["max"], 1 / 255, name)
            self.assertGreater(found["pixels"], 1000, name)

    def test_tetrahedra_agree_with_vtks_ray_caster(self):
        for make, arguments in ((tetrahedra, {}), (tetrahedra, {"opacity": "sigmoid_5", "cmap": "magma"})):
            ours = self.view(make(), **arguments)
            distance = ours.volume.prop.opacity_unit_distance
            theirs = self.view(make(), mapper=None, opacity_unit_distance=distance, **arguments)
            self.assertFalse(theirs.mapper.IsA("vtkTetMarchVolumeMapper"))
            pixels = ours.pixels()
            # VTK's rays may be off by half a pixel, in x and in y.
            allowed = ROUNDED + mean_difference(pixels, np.roll(pixels, (1, 1), (0, 1))) / 2
            self.assertLess(mean_difference(pixels, theirs.pixels()), allowed)
            theirs.volume.prop.opacity_unit_distance = 4 * distance
            self.assertGreater(mean_difference(pixels, theirs.pixels()), allowed)

    def test_the_default_unit_distance(self):
        grid = tetrahedra()
        view = self.view(grid)
        self.assertAlmostEqual(view.volume.prop.opacity_unit_distance, grid.length / (np.cbrt(grid.n_points) - 1))
        self.assertEqual(view.mapper.GetOpacityLaw(), view.mapper.UNSTRUCTURED)
        view = self.view(wavelet())
        self.assertAlmostEqual(view.volume.prop.opacity_unit_distance, wavelet().length / (13 - 1))
        self.assertEqual(view.mapper.GetOpacityLaw(), view.mapper.STRUCTURED)

    def picked(self, view):
        """{cell: value} in some pixels."""
        found = {}
        for x in range(0, SIZE[0], 4):
            for y in range(0, SIZE[1], 4):
                if view.mapper.Pick(view.plotter.renderer, view.volume, x, y):
                    found[view.mapper.GetPickedCellId()] = view.mapper.GetPickedScalar()
        return found

    def test_values_of_cells_are_not_averaged(self):
        cells = pyvista.ImageData(dimensions=(3, 2, 2)).to_tetrahedra(6)
        self.assertEqual(cells.n_points, cells.n_cells)  # an array may be of either
        cells.cell_data["both"], cells.point_data["both"] = np.arange(12.0) ** 2, np.full(12, 1000.0)
        hexahedra = examples.load_hexbeam()
        for grid, name, preference in ((hexahedra, "sample_cell_scalars", "point"), (cells, "both", "cell")):
            values = np.asarray(grid.cell_data[name])
            found = self.picked(self.view(grid, scalars=name, preference=preference, opacity=[1.0, 1.0],
                                          pick_opacity_threshold=0.1))
            self.assertGreater(len(found), 4)
            for cell, value in found.items():
                self.assertAlmostEqual(value, values[cell], places=4)
        found = self.picked(self.view(cells, scalars="both", opacity=[1.0, 1.0], clim=(0, 1000),
                                      pick_opacity_threshold=0.1))
        self.assertEqual({round(value, 2) for value in found.values()}, {1000})

    def test_the_users_data_stay_as_they_are(self):
        for grid in (examples.load_hexbeam(), examples.load_uniform(), curvilinear()):
            before = grid.copy()
            self.view(grid, scalars=np.arange(grid.n_cells, dtype=float))
            self.assertEqual(grid, before)
            self.assertEqual((grid.array_names, grid.active_scalars_info),
                             (before.array_names, before.active_scalars_info))

    def test_arrays_of_numpy(self):
        values = np.random.default_rng(2).random((9, 8, 7))
        ours, theirs = (self.view(values, resolution=(1, 2, 3), mapper=mapper) for mapper in ("tetmarch", None))
        self.assertEqual((state(ours), ours.volume.bounds), (state(theirs), theirs.volume.bounds))

    def test_nan(self):
        image = wavelet()
        image["RTData"][300:] = np.nan
        green = {}
        for name, named in (("left out", {}), ("drawn", {"nan_color": "lime"}),
                            ("faint", {"nan_color": "lime", "nan_opacity": 0.01})):
            view = self.view(image, opacity=[0.0, 0.0], **named)
            green[name] = view.pixels()[SIZE[1] // 2, SIZE[0] // 2, 1]
            view.mapper.lookup_table.cmap = "gray"  # makes new functions
            self.assertEqual(view.pixels()[SIZE[1] // 2, SIZE[0] // 2, 1], green[name])
        self.assertEqual((green["left out"], green["drawn"]), (0, 255))
        self.assertTrue(0 < green["faint"] < 200)

    def test_blocks(self):
        whole = wavelet()
        halves = pyvista.MultiBlock([whole.extract_subset((0, 6, -6, 6, -6, 6)), None,
                                     whole.extract_subset((-6, 0, -6, 6, -6, 6)), pyvista.Sphere()])
        named = {"opacity": [0.0, 0.6], "opacity_unit_distance": 2}
        expected = self.view(whole, **named)
        view = self.view(halves, **named)
        self.assertEqual(view.mapper.scalar_range, expected.mapper.scalar_range)
        self.assertLess(mean_difference(view.pixels(), expected.pixels()), ROUNDED)
        grids = pyvista.MultiBlock([tetrahedra(), tetrahedra().translate((3, 0, 0))])
        view = self.view(grids, scalars="wave")
        self.assertEqual(vtktetmarch.statistics(view.volume)["number_of_tetrahedra"], 2 * tetrahedra().n_cells)
        for data in (halves, grids):
            plotter = self.plotter()
            drawn = plotter.add_volume(data, multi_colors=True, name="block", blending="maximum", **OURS)
            self.assertEqual([volume.mapper.blend_mode for volume in drawn], ["maximum"] * 2)
            self.assertLessEqual({"block-0", "block-1"}, set(plotter.actors))


class PlotterTest(PyVistaTest):
    def test_the_default_mapper(self):
        plotter = self.plotter()
        self.addCleanup(vtktetmarch.pyvista.make_default, False)
        for is_default, expected in ((True, True), (False, False)):
            vtktetmarch.pyvista.make_default(is_default)
            self.assertEqual(hasattr(plotter.add_volume(wavelet()).mapper, "GetErrorTolerance"), expected)
            self.assertFalse(hasattr(plotter.add_volume(wavelet(), mapper="smart").mapper, "GetErrorTolerance"))

    def test_the_accessor(self):
        named = {"off_screen": True, "window_size": SIZE, "background": "black", "return_img": True, "cpos": "xy",
                 "show_scalar_bar": False, "show_axes": False}
        for data in (tetrahedra(), wavelet(), pyvista.MultiBlock([wavelet()])):
            picture = data.tetmarch.plot(**named)
            self.assertEqual(picture.shape, (*SIZE[::-1], 3))
            self.assertGreater(picture.max(), 30)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "picture.png")
            wavelet().tetmarch.plot(off_screen=True, screenshot=path, accuracy_level="fast")
            self.assertGreater(path.stat().st_size, 1000)

    def test_subplots_names_and_removal(self):
        plotter = self.plotter(shape=(1, 2), border=False)
        plotter.background_color = "black"
        plotter.subplot(0, 0)
        plotter.add_volume(wavelet(), name="volume", **OURS)
        plotter.subplot(0, 1)
        plotter.add_volume(tetrahedra(), name="volume", show_scalar_bar=False, **OURS)
        second = plotter.add_volume(wavelet(), name="volume", show_scalar_bar=False, **OURS)
        self.assertEqual(list(plotter.renderers[1].actors.values()), [second])
        self.assertIn("RTData", plotter.scalar_bars)
        plotter.show(auto_close=False)
        half = SIZE[0] // 2
        picture = plotter.screenshot(return_img=True)
        self.assertTrue(picture[:, :half].max() > 30 and picture[:, half:].max() > 30)
        plotter.remove_actor(second)
        self.assertEqual(plotter.screenshot(return_img=True)[:, half:].max(), 0)

    def test_a_plane_widget_clips(self):
        for data in (wavelet(), tetrahedra()):
            view = self.view(data)
            before = np.count_nonzero(view.pixels().max(axis=2))
            view.plotter.add_volume_clip_plane(view.volume, normal="x", implicit=False)
            view.plotter.widgets.plane_widgets[0].Off()
            after = np.count_nonzero(view.pixels().max(axis=2))
            self.assertTrue(0.2 * before < after < 0.9 * before, (before, after))
        self.plotter().add_volume_clip_plane(wavelet(), **OURS)

    def test_an_animation(self):
        view = self.view(wavelet())
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "turning.gif")
            view.plotter.open_gif(str(path))
            for _ in range(3):
                view.plotter.camera.azimuth += 30
                view.plotter.write_frame()
            view.plotter.close()
            self.assertEqual(path.read_bytes()[:3], b"GIF")

    def test_copies(self):
        for data in (tetrahedra(), pyvista.MultiBlock([wavelet()])):
            view = self.view(data, view_mode="cells", vector_mode=vtktetmarch.vtkTetMarchVolumeMapper.MAGNITUDE)
            before = view.pixels()
            shallow, copy = view.volume.copy(deep=False), view.volume.copy()
            self.assertEqual((shallow.mapper, copy.mapper.GetVectorMode()), (view.mapper, view.mapper.GetVectorMode()))
            view.mapper.SetViewModeToPicture()  # of the original alone
            view.plotter.remove_actor(view.volume)
            self.assertEqual(view.pixels().max(), 0)
            view.plotter.add_actor(copy, reset_camera=False)
            self.assertTrue((view.pixels() == before).all())


if __name__ == "__main__":
    unittest.main(verbosity=2)
