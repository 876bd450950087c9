# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The first picture of data of every kind, judged by numbers: the data are seen, neither dim nor saturated."""
import os
import sys
import unittest

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

import first_data
import vtktetmarch

WIDTH, HEIGHT = 240, 180
FOLDER = os.environ.get("TETMARCH_PICTURES")  # where pictures are kept, to be looked at


class Shot:
    """What a volume looks like over black, and where it is."""

    def __init__(self, data, first):
        lattice = isinstance(data, (vtk.vtkImageData, vtk.vtkRectilinearGrid))
        self.mapper = vtktetmarch.vtkTetMarchSmartVolumeMapper() if lattice else vtktetmarch.vtkTetMarchVolumeMapper()
        self.mapper.SetInputDataObject(data)
        self.volume = vtk.vtkVolume()
        self.volume.SetMapper(self.mapper)
        assert first.ApplyTo(self.volume)
        self.renderer = vtk.vtkRenderer()
        self.renderer.AddVolume(self.volume)
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(WIDTH, HEIGHT)
        self.window.AddRenderer(self.renderer)
        assert first.PlaceCamera(self.renderer.GetActiveCamera(), WIDTH / HEIGHT)
        self.renderer.ResetCameraClippingRange()

    def pixels(self):
        self.window.Render()
        picture = vtk.vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, WIDTH - 1, HEIGHT - 1, 0, picture, 0)
        return vtk_to_numpy(picture).reshape(HEIGHT, WIDTH, 3).astype(float) / 255

    def opacities(self):
        """Of each pixel: what a white volume shows over black."""
        white = vtk.vtkColorTransferFunction()
        white.AddRGBPoint(0, 1, 1, 1)
        before = self.volume.GetProperty().GetRGBTransferFunction()
        self.volume.GetProperty().SetColor(white)
        opacities = self.pixels()[:, :, 0]
        self.volume.GetProperty().SetColor(before)
        return opacities

    def covered(self):
        """Pixels before the data: where an opaque volume is not clear."""
        opaque = vtk.vtkPiecewiseFunction()
        opaque.AddPoint(0, 1)
        of_volume = self.volume.GetProperty()
        before = of_volume.GetScalarOpacity()
        distance = of_volume.GetScalarOpacityUnitDistance()
        of_volume.SetScalarOpacity(opaque)
        of_volume.SetScalarOpacityUnitDistance(1e-6 * distance)
        covered = self.opacities() > 0.5
        of_volume.SetScalarOpacity(before)
        of_volume.SetScalarOpacityUnitDistance(distance)
        return covered


def entropy(colours):
    """In bits, of the colours of pixels, in 8 steps of each channel."""
    steps = np.minimum((colours * 8).astype(int), 7)
    _, counts = np.unique(steps @ np.array([64, 8, 1]), return_counts=True)
    shares = counts / counts.sum()
    return float(-(shares * np.log2(shares)).sum())


def chosen_for(data):
    first = vtktetmarch.vtkTetMarchFirstPicture()
    first.SetInputData(data)
    assert first.Choose()
    return first


def keep(name, picture):
    if FOLDER:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.image
        matplotlib.image.imsave(os.path.join(FOLDER, name + ".png"), picture[::-1])


class FirstPictureTest(unittest.TestCase):
    def test_data_of_every_kind_are_seen(self):
        for make in first_data.ALL:
            with self.subTest(make.__name__):
                self.check(make)

    def check(self, make):
        data = make()
        shot = Shot(data, chosen_for(data))
        picture, opacities, covered = shot.pixels(), shot.opacities(), shot.covered()
        keep(make.__name__, picture)
        rows, columns = np.nonzero(covered)
        across = (columns.max() - columns.min() + 1) / WIDTH
        upwards = (rows.max() - rows.min() + 1) / HEIGHT
        seen = (picture[covered].max(axis=1) > 4 / 255).mean()
        shown = opacities[covered & (opacities > 0.02)]
        median, saturated = float(np.median(shown)), float((shown > 0.98).mean())
        bits = entropy(picture[covered])
        print(f"{make.__name__:28} fills {max(across, upwards):.2f}  seen {seen:.2f}  median {median:.2f}  "
              f"saturated {saturated:.2f}  {bits:.1f} bits")
        lattice = isinstance(data, (vtk.vtkImageData, vtk.vtkRectilinearGrid))
        self.assertGreater(max(across, upwards), 0.85)
        self.assertGreater(seen, 0.2 if lattice else 0.8)
        self.assertLess(saturated, 0.1)
        self.assertGreater(median, 0.05)
        self.assertLess(median, 0.85)
        self.assertGreater(bits, 0.5 if make is first_data.constant else 1.3)

    def test_the_same_data_give_the_same_functions(self):
        for make in (first_data.flow, first_data.integers_with_air):
            first, second = chosen_for(make()), chosen_for(make())
            self.assertEqual(first.GetUnitDistance(), second.GetUnitDistance())
            self.assertEqual(first.GetChosenRange(), second.GetChosenRange())
            for place in np.linspace(*first.GetChosenRange(), 50):
                self.assertEqual(first.GetOpacity().GetValue(place), second.GetOpacity().GetValue(place))

    def test_auto_transfer_functions(self):
        grid = first_data.hexahedra_with_cell_scalars()
        found = vtktetmarch.auto_transfer_functions(grid)
        self.assertEqual((found.array, found.association, found.component), ("stress", "cells", 0))
        low, high = found.range
        self.assertLess(low, high)
        self.assertEqual(found.color.GetRange(), (low, high))
        self.assertGreater(found.unit_distance, 0)
        asked = vtktetmarch.auto_transfer_functions(grid, "vtkOriginalCellIds", "cells", range=(10, 20))
        self.assertEqual((asked.array, asked.range), ("vtkOriginalCellIds", (10, 20)))
        swirl = vtktetmarch.auto_transfer_functions(first_data.vectors())
        self.assertEqual((swirl.array, swirl.component), ("velocity", -1))

    def test_what_is_wrong_is_said(self):
        grid = first_data.constant()
        with self.assertRaisesRegex(ValueError, r"there is no array 'two' \(on points: one; on cells: none\)"):
            vtktetmarch.auto_transfer_functions(grid, "two")
        with self.assertRaisesRegex(ValueError, "has no component 3"):
            vtktetmarch.auto_transfer_functions(grid, "one", component=3)
        with self.assertRaisesRegex(ValueError, "no cells to draw"):
            vtktetmarch.auto_transfer_functions(vtk.vtkUnstructuredGrid())
        with self.assertRaisesRegex(ValueError, "SetInputData"):
            vtktetmarch.auto_transfer_functions(None)
        with self.assertRaisesRegex(ValueError, "low < high"):
            vtktetmarch.auto_transfer_functions(grid, range=(2, 1))
        with self.assertRaisesRegex(ValueError, "association is"):
            vtktetmarch.auto_transfer_functions(grid, association="faces")

    def test_what_the_data_contradicts_itself_in_is_said(self):
        grid = first_data.constant()
        short = vtk.vtkDoubleArray()
        short.SetName("short")
        short.SetNumberOfTuples(5)
        grid.GetPointData().AddArray(short)
        with self.assertRaisesRegex(ValueError, '"short" has 5 tuples, but the grid has .* points'):
            vtktetmarch.auto_transfer_functions(grid, "short")
        self.assertEqual(vtktetmarch.auto_transfer_functions(grid).array, "one")
        tree = vtk.vtkMultiBlockDataSet()
        tree.SetBlock(0, first_data.constant())
        tree.SetBlock(1, grid)
        first = chosen_for(tree)
        faults = vtk.vtkStringArray()
        self.assertTrue(first.ListFaults(faults))
        self.assertEqual(faults.GetNumberOfValues(), 1)
        self.assertIn('Block number 2: The scalar array "short" has 5 tuples', faults.GetValue(0))
        vtk_to_numpy(grid.GetPoints().GetData())[:] = np.inf
        grid.GetPoints().GetData().Modified()  # the tree itself is not told
        with vtktetmarch.errors.VtkErrors() as errors:
            self.assertFalse(first.CheckData())
        self.assertRegex(str(errors), "Block number 2: Coordinate 0 of point .* is inf")
        with self.assertRaisesRegex(ValueError, "Block number 2: Coordinate 0"):
            vtktetmarch.auto_transfer_functions(tree)

    def test_trees_are_their_leaves(self):
        source = vtk.vtkRandomHyperTreeGridSource()
        source.SetDimensions(3, 3, 3)
        source.Update()
        trees = source.GetHyperTreeGridOutput()
        leaves = vtk.vtkHyperTreeGridToUnstructuredGrid()
        leaves.SetInputData(trees)
        leaves.Update()
        self.assertEqual(chosen_for(trees).Describe(), chosen_for(leaves.GetOutput()).Describe())
        trees.GetCellData().GetArray("Depth").SetNumberOfTuples(5)
        trees.GetCellData().Modified()
        with self.assertRaisesRegex(ValueError, '"Depth" has 5 tuples, but the tree has .* cells'):
            vtktetmarch.volume(trees)

    def test_curvilinear_grids_are_checked_before_they_become_cells(self):
        grid = vtk.vtkStructuredGrid()
        grid.SetDimensions(6, 6, 6)
        points = vtk.vtkPoints()
        for i in range(216):
            points.InsertNextPoint(np.inf if i == 77 else i % 6, i // 6 % 6, i // 36)
        grid.SetPoints(points)
        values = vtk.vtkDoubleArray()
        values.SetName("f")
        values.SetNumberOfTuples(5)
        grid.GetPointData().AddArray(values)
        with self.assertRaisesRegex(ValueError, 'point 77, which cell 54 has, is inf.* "f" has 5 tuples'):
            vtktetmarch.volume(grid)

    def test_other_and_modified_data_are_chosen_anew(self):
        first = chosen_for(first_data.constant())
        self.assertEqual(first.GetChosenArray().GetName(), "one")
        grid = first_data.vectors()
        first.SetInputData(grid)
        self.assertIsNone(first.GetChosenArray())
        self.assertTrue(first.Choose())
        self.assertEqual(first.Describe().split(",")[0], "magnitude of velocity on points")
        first_data.with_points(grid, "speed", lambda p: p[0])
        grid.Modified()
        self.assertTrue(first.Choose())
        self.assertEqual(first.GetChosenArray().GetName(), "speed")

    def test_cameras_are_refused(self):
        first, camera, volume = chosen_for(first_data.constant()), vtk.vtkCamera(), vtk.vtkVolume()
        upright = vtk.vtkCamera()
        upright.SetPosition(0, 1, 0)  # its view up is y
        box, wrong = (0, 1, 0, 1, 0, 1), (0, 1, 1, 0, 0, 1)
        for words, method, arguments in (
                ("camera and the width / height", first.PlaceCamera, (None, 1.0)),
                ("camera and the width / height", first.FitCamera, (camera, volume, 0.0)),
                ("camera and the width / height", first.FitCameraToBox, (camera, box, np.nan, 1.0)),
                ("no volume", first.FitCamera, (camera, None, 1.0)),
                ("must not be parallel", first.FitCamera, (upright, volume, 1.0)),
                ("must not be parallel", first.FitCameraToBox, (upright, box, 1.0, 1.0)),
                ("A box whose", first.FitCameraToBox, (camera, wrong, 1.0, 1.0)),
                ("share of the picture", first.FitCameraToBox, (camera, box, 1.0, 0.0)),
                ("share of the picture", first.FitCameraToBox, (camera, box, 1.0, 1.1))):
            with self.subTest(method=method.__name__, arguments=arguments), vtktetmarch.errors.VtkErrors() as errors:
                self.assertFalse(method(*arguments))
                self.assertRegex(str(errors), words)
            self.assertEqual((camera.GetPosition(), upright.GetPosition()), ((0, 0, 1), (0, 1, 0)))  # not moved

    def test_arrays_are_listed(self):
        table = vtk.vtkTable()
        first = vtktetmarch.vtkTetMarchFirstPicture()
        first.SetInputData(first_data.blocks())
        self.assertTrue(first.ListArrays(table))
        rows = [[table.GetValue(i, k).ToString() for k in (0, 1, 3, 6)] for i in range(table.GetNumberOfRows())]
        self.assertEqual(rows, [["head", "points", "1", "values"], ["material", "points", "1", "numbers"]])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + ["-v"] + sys.argv[1:])
