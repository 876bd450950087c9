# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of figures: their shapes and values, and what is known of them."""
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import unittest
import warnings

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

import first_data
import vtktetmarch

SIZE = (160, 120)


def pixels_of_png(picture):
    """(height, width, channels) of a file, by its path or as bytes; the uppermost row first."""
    return pixels_of(vtk.vtkPNGReader(), picture)


def pixels_of(reader, picture):
    """The same by a reader of VTK's."""
    if isinstance(picture, bytes):
        reader.SetMemoryBuffer(picture)
        reader.SetMemoryBufferLength(len(picture))
    else:
        reader.SetFileName(str(picture))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[::-1]


def ball():
    source = vtk.vtkSphereSource()
    source.SetCenter(0.3, 0.3, 0.3)
    source.SetRadius(0.2)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def figure_of_tetrahedron(**how):
    """The corner at 0 is x, y and z from 0 to 1."""
    return vtktetmarch.figure(first_data.one_tetrahedron(), **{"size": SIZE, **how})


class ScreenshotTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_shape_and_background(self):
        figure = figure_of_tetrahedron(background="#204060")
        picture = figure.screenshot()
        self.assertEqual((picture.shape, picture.dtype), ((120, 160, 3), np.uint8))
        self.assertEqual(tuple(picture[0, 0]), (0x20, 0x40, 0x60))
        self.assertEqual(figure.screenshot(size=(33, 21)).shape, (21, 33, 3))
        self.assertEqual(figure.screenshot(transparent=True).shape, (21, 33, 4))

    def test_the_first_row_is_the_uppermost(self):
        figure = figure_of_tetrahedron(cmap=["white"], opacity=1, unit_distance=1e-3, background="black", camera={
            "position": (0.2, -5, 0.4), "focal_point": (0.2, 0, 0.4), "view_up": (0, 0, 1), "parallel_scale": 0.7})
        widths = np.count_nonzero(figure.screenshot()[:, :, 0] > 128, axis=1)  # it is wide below, and pointed above
        rows = np.flatnonzero(widths)
        self.assertGreater(widths[rows[-1]], 20 + widths[rows[0]])

    def test_files(self):
        figure = figure_of_tetrahedron()
        for transparent, channels in ((False, 3), (True, 4)):
            path = self.folder / f"{channels}.png"
            self.assertEqual(figure.screenshot(path, transparent=transparent), path)
            written = pixels_of_png(path)
            self.assertEqual(written.shape, (120, 160, channels))
            self.assertTrue(np.array_equal(written, figure.screenshot()))
        self.assertEqual(figure.save(str(path)), str(path))
        path.write_bytes(figure._repr_png_())
        self.assertTrue(np.array_equal(pixels_of_png(path), figure.screenshot()))

    def test_a_full_disk_leaves_the_earlier_picture(self):
        """A limit of the size of files fails a write as a full disk does."""
        figure = figure_of_tetrahedron()
        path = figure.save(self.folder / "a.png")
        path.chmod(0o640)
        (self.folder / "link.png").symlink_to("a.png")
        before = path.read_bytes()
        limits = resource.getrlimit(resource.RLIMIT_FSIZE)
        for name in ("a.png", "link.png", "new.png"):
            resource.setrlimit(resource.RLIMIT_FSIZE, (500, limits[1]))
            try:
                with self.assertRaisesRegex(OSError, f"File too large: '.*{name}'"):
                    figure.save(self.folder / name)
            finally:
                resource.setrlimit(resource.RLIMIT_FSIZE, limits)
            self.assertEqual(path.read_bytes(), before)
            self.assertEqual(sorted(os.listdir(self.folder)), ["a.png", "link.png"])
        figure.look({"azimuth": 90}).save(self.folder / "link.png")
        self.assertNotEqual(path.read_bytes(), before)
        self.assertTrue(np.array_equal(pixels_of_png(path), figure.screenshot()))
        self.assertTrue((self.folder / "link.png").is_symlink())
        self.assertEqual(path.stat().st_mode & 0o777, 0o640)

    def test_what_is_no_file_is_not_replaced(self):
        figure = figure_of_tetrahedron()
        (self.folder / "folder.png").mkdir()
        with self.assertRaisesRegex(IsADirectoryError, "folder.png"):
            figure.save(self.folder / "folder.png")
        self.assertEqual(os.listdir(self.folder), ["folder.png"])

    def test_transparent_over_a_color_is_that_color_behind(self):
        for behind in ((0, 0, 0), (1, 1, 1), (0.2, 0.7, 0.4)):
            figure = figure_of_tetrahedron(background=behind).add(ball())
            direct = figure.screenshot().astype(float)
            over = figure.screenshot(transparent=True).astype(float)
            opacity = over[:, :, 3:] / 255
            composed = over[:, :, :3] * opacity + 255 * np.array(behind) * (1 - opacity)
            self.assertLess(np.abs(composed - direct).max(), 1.6)
            self.assertTrue(((0 < opacity) & (opacity < 1)).any() and (opacity == 0).any() and (opacity == 1).any())
            self.assertTrue(np.array_equal(figure.screenshot(transparent=False), direct))

    def test_functions_are_those_of_a_figure(self):
        data = first_data.one_tetrahedron()
        expected = vtktetmarch.figure(data, size=SIZE, cmap="plasma").screenshot()
        self.assertTrue(np.array_equal(vtktetmarch.screenshot(data, size=SIZE, cmap="plasma"), expected))
        path = vtktetmarch.screenshot(data, size=SIZE, cmap="plasma", filename=str(self.folder / "a.png"))
        self.assertTrue(np.array_equal(pixels_of_png(path), expected))
        self.assertTrue(np.array_equal(
            vtktetmarch.screenshot(vtktetmarch.volume(data, cmap="plasma"), size=SIZE), expected))

    def test_what_is_wrong_is_said(self):
        figure = figure_of_tetrahedron()
        with self.assertRaisesRegex(ValueError, "ends with .png, not as 'a.jpg'"):
            figure.save("a.jpg")
        with self.assertRaisesRegex(FileNotFoundError, "no_such_folder"):
            figure.save(self.folder / "no_such_folder" / "a.png")
        for size in ((0, 5), (5, 1e6), (2.5, 3)):
            with self.assertRaisesRegex(ValueError, "width, height"):
                figure.screenshot(size=size)
        with self.assertRaisesRegex(TypeError, "go to volume"):
            vtktetmarch.figure(figure.volume, cmap="plasma")
        with self.assertRaisesRegex(ValueError, "has no mapper"):
            vtktetmarch.figure(vtk.vtkVolume())

    def test_a_warning_says_that_nothing_is_visible(self):
        """Once, until it has been visible; whether VTK displays messages or not."""
        self.addCleanup(vtk.vtkObject.SetGlobalWarningDisplay, vtk.vtkObject.GetGlobalWarningDisplay())
        for displayed in (0, 1):
            vtk.vtkObject.SetGlobalWarningDisplay(displayed)
            for how, text in (({"opacity": 0}, "the opacity is 0 for all of the values of the array, 0 to 1"),
                              ({"opacity": [(5, 0), (7, 1)]}, "the opacity is 0 for all"),
                              ({"blend_mode": "isosurface", "isosurface_values": 2}, "no isosurface value lies among"),
                              ({"clipping_planes": [((0, 0, 2), (0, 0, 1))]}, "clipping planes and cropping leave"),
                              ({"cropping": True, "cropping_region_planes": (3, 4, 0, 1, 0, 1)},
                               "clipping planes and cropping leave")):
                figure = figure_of_tetrahedron(**how)
                expected = "Nothing is visible, because " + text
                with self.subTest(how=how), self.assertWarnsRegex(RuntimeWarning, expected):
                    figure.screenshot()
                with warnings.catch_warnings():
                    warnings.simplefilter("error")
                    figure.screenshot()

    def test_what_is_too_small_for_cameras_is_said(self):
        points = 1e-22 * np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], float)
        grid = vtktetmarch.from_arrays(points, [[0, 1, 2, 3]], "tetra", {"v": range(4)})
        with self.assertWarnsRegex(RuntimeWarning, "Nothing is visible, because the data is so small.*Scale the data"):
            vtktetmarch.figure(grid, size=SIZE)

    def test_an_error_of_the_mapper_is_raised_as_long_as_it_holds(self):
        figure = figure_of_tetrahedron(accuracy_level="sampled")
        for _ in range(3):
            with self.assertRaisesRegex(RuntimeError, "^The accuracy level is Sampled"):
                figure.screenshot()
        vtktetmarch.configure(figure.volume, accuracy_level="default")
        self.assertGreater(figure.screenshot().max(), 60)

    def test_errors_are_raised_whoever_else_hears_of_them(self):
        """Scripts switch VTK's messages off, for all of VTK, or collect those of a mapper."""
        collected = []
        damaged = self.folder / "damaged.vtu"
        damaged.write_text("<VTKFile>")
        self.addCleanup(vtk.vtkObject.SetGlobalWarningDisplay, vtk.vtkObject.GetGlobalWarningDisplay())
        for displayed in (0, 1):
            for observed in (False, True):
                vtk.vtkObject.SetGlobalWarningDisplay(displayed)
                figure = figure_of_tetrahedron(accuracy_level="sampled")
                if observed:
                    figure.mapper.AddObserver("ErrorEvent", lambda *_: collected.append(1))
                for call in (figure.screenshot, figure.show, figure.compare):
                    with self.assertRaisesRegex(RuntimeError, "The accuracy level is Sampled"):
                        call()
                self.assertEqual(vtk.vtkObject.GetGlobalWarningDisplay(), displayed)
                with self.assertRaisesRegex(ValueError, "damaged.vtu' can't be read: .*parsing"):
                    vtktetmarch.read(damaged)
        self.assertTrue(collected)

    def test_an_error_that_nobody_heard_is_raised_later(self):
        self.addCleanup(vtk.vtkObject.SetGlobalWarningDisplay, vtk.vtkObject.GetGlobalWarningDisplay())
        vtk.vtkObject.GlobalWarningDisplayOff()
        figure = figure_of_tetrahedron(accuracy_level="sampled")
        window = vtk.vtkRenderWindow()
        window.SetOffScreenRendering(True)
        renderer = vtk.vtkRenderer()
        renderer.AddVolume(figure.volume)
        window.AddRenderer(renderer)
        window.Render()
        window.RemoveRenderer(renderer)
        with self.assertRaisesRegex(RuntimeError, "The accuracy level is Sampled"):
            figure.screenshot()

    def test_without_a_display_there_is_an_exception_or_the_picture(self):
        """VTK before 9.4 needs one; later it draws by EGL or OSMesa."""
        path = self.folder / "a.png"
        script = ("import sys, vtktetmarch, first_data\n"
                  "vtktetmarch.screenshot(first_data.one_tetrahedron(), size=(160, 120), filename=sys.argv[1])")
        for display in ("", ":4711"):
            environment = {**os.environ, "DISPLAY": display, "PYTHONPATH": os.pathsep.join(sys.path)}
            run = subprocess.run([sys.executable, "-c", script, path], env=environment, capture_output=True, text=True,
                                 timeout=1000)
            if (vtk.VTK_MAJOR_VERSION, vtk.VTK_MINOR_VERSION) < (9, 4):
                self.assertEqual(run.returncode, 1)
                self.assertRegex(run.stderr, "RuntimeError: VTK needs a display.*xvfb-run")
            else:
                self.assertEqual(run.returncode, 0, run.stderr)
                shown = figure_of_tetrahedron().screenshot().astype(int)
                self.assertLess(np.abs(pixels_of_png(path) - shown).max(), 3)
                path.unlink()


class CameraTest(unittest.TestCase):
    def test_of_a_dict(self):
        figure = figure_of_tetrahedron(camera={"position": (3, 0, 0), "focal_point": (0, 0, 0), "view_up": (0, 0, 1),
                                               "view_angle": 40})
        camera = figure.camera
        self.assertEqual((camera.GetPosition(), camera.GetFocalPoint()), ((3, 0, 0), (0, 0, 0)))
        self.assertEqual(camera.GetViewAngle(), 40)
        figure.look({"position": (3, 0, 0), "focal_point": (0, 0, 0), "view_up": (0, 0, 1), "azimuth": 90, "zoom": 2})
        np.testing.assert_allclose(figure.camera.GetPosition(), (0, 3, 0), atol=1e-9)
        self.assertEqual(figure.camera.GetViewAngle(), 30 / 2)
        figure.look({"parallel_scale": 5})
        self.assertEqual((figure.camera.GetParallelProjection(), figure.camera.GetParallelScale()), (1, 5))

    def test_of_another_one(self):
        camera = vtk.vtkCamera()
        camera.SetPosition(1, 2, 3)
        figure = figure_of_tetrahedron(camera=camera)
        self.assertEqual(figure.camera.GetPosition(), (1, 2, 3))
        self.assertIsNot(figure.camera, camera)

    def test_iso_fits_wherever_the_volume_is_put(self):
        stays = figure_of_tetrahedron().screenshot()
        moved = figure_of_tetrahedron(position=(100, 20, 3), size=SIZE).screenshot()
        self.assertLess(np.abs(stays.astype(int) - moved).mean(), 0.1)

    def test_what_is_wrong_is_said(self):
        with self.assertRaisesRegex(TypeError, "no 'positon'; it has position"):
            figure_of_tetrahedron(camera={"positon": (1, 2, 3)})


class ShowTest(unittest.TestCase):
    def test_opens_a_window_and_comes_back(self):
        figure = figure_of_tetrahedron()
        before = figure.screenshot()
        seen = []

        def close(_renderer, _event):
            window = figure.renderer.GetRenderWindow()
            if not seen and window.GetInteractor():
                seen.append((window.GetSize(), window.GetShowWindow()))
                window.GetInteractor().AddObserver("TimerEvent", lambda interactor, _: interactor.TerminateApp())
                window.GetInteractor().CreateRepeatingTimer(20)

        figure.renderer.AddObserver("EndEvent", close)
        vtktetmarch.show(figure)
        self.assertEqual(seen, [(SIZE, True)])
        self.assertTrue(np.array_equal(figure.screenshot(), before))


if __name__ == "__main__":
    unittest.main(verbosity=2)
