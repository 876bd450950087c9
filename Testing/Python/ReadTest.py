# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""read() and time_values(): files of every kind, and what is wrong with a file."""
import os
import pathlib
import tempfile
import unittest
import warnings

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

import first_data
import vtktetmarch
from vtktetmarch.inputs import leaves_of

# The writer of Exodus that vtkmodules.all puts in place of the serial one crashes without it in VTK 9.6.
CONTROLLER = vtk.vtkDummyController()  # VTK keeps no reference to it
vtk.vtkMultiProcessController.SetGlobalController(CONTROLLER)

MESH, IMAGE = (pathlib.Path(first_data.DATA) / name for name in ("golfball_small.vtu", "bonsai_small.vti"))


def curvilinear():
    grid = vtk.vtkStructuredGrid()
    grid.SetDimensions(2, 2, 2)
    points = vtk.vtkPoints()
    for i in range(8):
        points.InsertNextPoint(i & 1, i >> 1 & 1, i >> 2)
    grid.SetPoints(points)
    return first_data.with_points(grid, "x", lambda p: p[0])


class ReadTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """Without a controller VTK 9.6 crashes as it writes Exodus."""
        cls.controller = vtk.vtkDummyController()
        vtk.vtkMultiProcessController.SetGlobalController(cls.controller)
        cls.addClassCleanup(vtk.vtkMultiProcessController.SetGlobalController, None)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, writer, name, data):
        path = self.folder / name
        writer.SetFileName(str(path))
        writer.SetInputData(data)
        writer.Write()
        return path

    def values(self, data):
        return set(vtk_to_numpy(data.GetPointData().GetArray("v")))

    def write_steps(self):
        """Images a.vti, b.vti and c.vti, each of one value: 1, 2 and 3."""
        for value, name in enumerate("abc", 1):
            image = first_data.image((2, 2, 2))
            first_data.with_points(image, "v", lambda p, value=value: value)
            self.write(vtk.vtkXMLImageDataWriter(), f"{name}.vti", image)

    def write_list(self, entries, name="list.pvd"):
        (self.folder / name).write_text(f'<VTKFile type="Collection"><Collection>{entries}</Collection></VTKFile>')
        return self.folder / name

    def test_lists_of_files_by_time(self):
        self.write_steps()
        path = self.write_list('<DataSet timestep="2.5" file="b.vti"/><DataSet timestep="-1" file="a.vti"/>'
                               '<DataSet timestep="2.5" part="1" name="third" file="c.vti"/>')
        self.assertEqual(vtktetmarch.time_values(path), (-1.0, 2.5))
        self.assertEqual(self.values(vtktetmarch.read(path, 0)), {1})
        tree = vtktetmarch.read(path)
        self.assertEqual([self.values(tree.GetBlock(k)) for k in range(2)], [{2}, {3}])
        self.assertEqual(tree.GetMetaData(1).Get(vtk.vtkCompositeDataSet.NAME()), "third")
        self.assertRaisesRegex(IndexError, "it has 2, from 0", vtktetmarch.read, path, 2)
        series = self.folder / "x.vti.series"
        series.write_text('{"files": [{"name": "c.vti", "time": 3}, {"name": "a.vti", "time": 0}]}')
        self.assertEqual(vtktetmarch.time_values(series), (0.0, 3.0))
        self.assertEqual(self.values(vtktetmarch.read(series, -1)), {3})
        timeless = self.write_list('<DataSet file="a.vti"/><DataSet file="b.vti"/>', "timeless.pvd")
        self.assertEqual(vtktetmarch.time_values(timeless), ())
        self.assertEqual(vtktetmarch.read(timeless).GetNumberOfBlocks(), 2)

    def test_bad_lists_of_files(self):
        for text, reason in (("no list", "it is no XML"), ("<VTKFile/>", "no element <Collection>"),
                             ("<V><Collection/></V>", "it lists no files"),
                             ('<V><Collection><DataSet timestep="soon" file="a.vti"/></Collection></V>', "'soon'"),
                             ('<V><Collection><DataSet file="b.pvd"/></Collection></V>', "which is a list of files"),
                             ("<V><Collection><DataSet/></Collection></V>", "a file without a name")):
            with self.subTest(text=text):
                (self.folder / "bad.pvd").write_text(text)
                self.assertRaisesRegex(ValueError, f"bad.pvd' can't be read: .*{reason}", vtktetmarch.read,
                                       self.folder / "bad.pvd")
        for text, reason in (("no list", "it is no JSON"), ("[]", 'no list "files"'), ('{"files": []}', "no files"),
                             ('{"files": [7]}', "each entry"),
                             ('{"files": [{"name": 1, "time": 2}]}', "without a name"),
                             ('{"files": [{"name": "a.vti", "time": "x"}]}', "'x' is no time")):
            with self.subTest(text=text):
                (self.folder / "bad.series").write_text(text)
                self.assertRaisesRegex(ValueError, reason, vtktetmarch.time_values, self.folder / "bad.series")
        gone = self.write_list('<DataSet timestep="0" file="gone.vti"/>')
        self.assertRaisesRegex(FileNotFoundError, "lists .*gone.vti', which isn't there", vtktetmarch.read, gone)
        self.assertRaises(FileNotFoundError, vtktetmarch.time_values, self.folder / "none.pvd")

    def test_data_of_every_kind(self):
        grid, image = first_data.one_tetrahedron(), first_data.image((3, 4, 5))
        first_data.with_points(image, "x", lambda p: p[0], vtk.vtkShortArray)
        image.GetPointData().SetActiveScalars("x")
        partitions = vtk.vtkPartitionedDataSet()
        partitions.SetPartition(0, grid)
        collection = vtk.vtkPartitionedDataSetCollection()
        collection.SetPartitionedDataSet(0, partitions)
        for writer, name, data in (
                (vtk.vtkXMLUnstructuredGridWriter(), "a.vtu", grid),
                (vtk.vtkXMLPUnstructuredGridWriter(), "a.pvtu", grid),
                (vtk.vtkXMLImageDataWriter(), "a.vti", image), (vtk.vtkXMLPImageDataWriter(), "a.pvti", image),
                (vtk.vtkXMLRectilinearGridWriter(), "a.vtr", first_data.rectilinear()),
                (vtk.vtkXMLStructuredGridWriter(), "a.vts", curvilinear()),
                (vtk.vtkXMLMultiBlockDataWriter(), "a.vtm", first_data.blocks()),
                (vtk.vtkXMLPartitionedDataSetWriter(), "a.vtpd", partitions),
                (vtk.vtkXMLPartitionedDataSetCollectionWriter(), "a.vtpc", collection),
                (vtk.vtkUnstructuredGridWriter(), "a.vtk", grid), (vtk.vtkStructuredPointsWriter(), "b.VTK", image),
                (vtk.vtkMetaImageWriter(), "a.mha", image), (vtk.vtkMetaImageWriter(), "a.mhd", image),
                (vtk.vtkNIFTIImageWriter(), "a.nii", image), (vtk.vtkExodusIIWriter(), "a.ex2", grid)):
            with self.subTest(name=name):
                found = vtktetmarch.read(self.write(writer, name, data))
                kind = "vtkMultiBlockDataSet" if name == "a.ex2" else data.GetClassName()
                self.assertTrue(found.IsA(kind) or data.IsA(found.GetClassName()), found.GetClassName())
                self.assertEqual(found.GetNumberOfPoints(), data.GetNumberOfPoints())
                self.assertGreater(vtktetmarch.screenshot(found, size=(60, 50)).max(), 40)

    def test_adaptive_meshes(self):
        blocks, trees = vtk.vtkAMRGaussianPulseSource(), vtk.vtkRandomHyperTreeGridSource()
        blocks.SetDimension(3)
        trees.SetDimensions(3, 3, 3)
        for source, writer, name in ((blocks, vtk.vtkXMLUniformGridAMRWriter(), "a.vth"),
                                     (trees, vtk.vtkXMLHyperTreeGridWriter(), "a.htg")):
            with self.subTest(name=name):
                source.Update()
                found = vtktetmarch.read(self.write(writer, name, source.GetOutputDataObject(0)))
                self.assertIs(type(found), type(source.GetOutputDataObject(0)))
                if name == "a.vth":
                    self.assertEqual(found.GetNumberOfLevels(), 2)
                    self.assertEqual(len(list(leaves_of(found))), 3)
                self.assertGreater(vtktetmarch.screenshot(found, size=(60, 50)).max(), 40)

    @unittest.skipUnless(hasattr(vtk, "vtkCellGridWriter"), "VTK 9.5 and later have cell grids")
    def test_cell_grids(self):
        convert = vtk.vtkUnstructuredGridToCellGrid()
        convert.SetInputDataObject(first_data.one_tetrahedron())
        convert.Update()
        trees = convert.GetOutputDataObject(0)
        writer = vtk.vtkCellGridWriter()
        writer.SetInputDataObject(trees.GetPartitionAsDataObject(0, 0))
        path = self.folder / "a.dg"
        writer.SetFileName(str(path))
        writer.Write()
        found = vtktetmarch.read(path)
        self.assertEqual(found.GetNumberOfCells(), 1)
        drawn = (first_data.one_tetrahedron(), found, trees)
        pictures = [vtktetmarch.screenshot(data, size=(60, 50)) for data in drawn]
        self.assertGreater(pictures[0].max(), 40)
        for picture in pictures[1:]:
            np.testing.assert_array_equal(picture, pictures[0])

    def test_plot3d(self):
        places = np.stack(np.meshgrid(*[np.arange(3.0)] * 3, indexing="ij")[::-1])
        sizes = np.array([3, 3, 3], dtype=np.int32).tobytes()
        (self.folder / "a.xyz").write_bytes(sizes + places.astype(np.float32).tobytes())
        (self.folder / "a.q").write_bytes(sizes + bytes(16) + np.tile(places[0] + 1, (5, 1, 1, 1)).astype("f4").tobytes())
        path = self.folder / "a.p3d"
        path.write_text('{"filenames": [{"time": 0.5, "xyz": "a.xyz", "q": "a.q"}]}')
        for name in (path, os.path.relpath(path)):
            found = vtktetmarch.read(name)
            self.assertEqual(found.GetBlock(0).GetNumberOfCells(), 8)
            self.assertGreater(vtktetmarch.screenshot(found, "Density", size=(60, 50)).max(), 40)

    def test_all_arrays_of_a_legacy_file(self):
        grid = first_data.one_tetrahedron()
        for name in ("second", "third"):
            first_data.with_points(grid, name, lambda p: p[1])
        path = self.write(vtk.vtkUnstructuredGridWriter(), "a.vtk", grid)
        self.assertEqual(vtktetmarch.read(path).GetPointData().GetNumberOfArrays(), 3)

    def test_nrrd(self):
        path = self.folder / "a.nrrd"
        values = np.arange(24, dtype=np.uint8)
        head = b"NRRD0004\ntype: uchar\ndimension: 3\nsizes: 12 2 1\nencoding: "
        path.write_bytes(head + b"raw\n\n" + values.tobytes())
        image = vtktetmarch.read(path)
        self.assertEqual(image.GetDimensions(), (12, 2, 1))
        self.assertTrue(np.array_equal(vtk_to_numpy(image.GetPointData().GetScalars()), values))
        path.write_bytes(head + b"ascii\n\n" + b" ".join(b"%d" % value for value in values))
        self.assertTrue(np.array_equal(vtk_to_numpy(vtktetmarch.read(path).GetPointData().GetScalars()), values))

    def test_time_steps(self):
        grid = first_data.one_tetrahedron()
        writer = vtk.vtkXMLUnstructuredGridWriter()
        writer.SetFileName(str(self.folder / "a.vtu"))
        writer.SetInputData(grid)
        writer.SetNumberOfTimeSteps(3)
        writer.Start()
        for step in range(3):
            vtk_to_numpy(grid.GetPointData().GetArray("z"))[:] = step
            grid.GetPointData().GetArray("z").Modified()
            writer.WriteNextTime(step)
        writer.Stop()
        path = self.folder / "a.vtu"
        self.assertEqual(vtktetmarch.time_values(path), (0, 1, 2))
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(path))
        reader.UpdateTimeStep(1)
        for step, expected in ((None, 2), (0, 0), (1, 1), (2, 2), (-1, 2), (-3, 0)):
            if reader.GetOutput().GetPointData().GetArray("z").GetValue(0) == 1:
                self.assertEqual(vtktetmarch.read(path, step).GetPointData().GetArray("z").GetValue(0), expected, step)
            else:  # VTK 9.6
                self.assertRaisesRegex(ValueError, "named z already exists", vtktetmarch.read, path, step)
        for step in (3, -4):
            with self.assertRaisesRegex(IndexError, "it has 3, from 0"):
                vtktetmarch.read(path, step)
        self.assertEqual(vtktetmarch.time_values(IMAGE), ())
        with self.assertRaisesRegex(IndexError, "no time steps"):
            vtktetmarch.read(IMAGE, time_step=0)

    def test_time_values_of_exodus(self):
        source = vtk.vtkTimeSourceExample()
        writer = vtk.vtkExodusIIWriter()
        path = self.folder / "a.ex2"
        writer.SetFileName(str(path))
        writer.SetInputConnection(source.GetOutputPort())
        writer.WriteAllTimeStepsOn()
        writer.Write()
        times = vtktetmarch.time_values(path)
        np.testing.assert_allclose(times, np.arange(10) / 9, rtol=1e-6)
        grids = [vtktetmarch.read(path, step).GetBlock(0).GetBlock(0) for step in (0, 4, -1, None)]
        values = [vtk_to_numpy(grid.GetPointData().GetArray("Point Value")) for grid in grids]
        self.assertFalse(np.array_equal(values[0], values[1]))
        self.assertTrue(np.array_equal(values[2], values[3]))

    def test_what_is_wrong_is_said(self):
        path = self.folder / "nothing.vtu"
        with self.assertRaisesRegex(FileNotFoundError, "no file .*nothing.vtu"):
            vtktetmarch.read(path)
        (self.folder / "a.txt").write_text("a")
        with self.assertRaisesRegex(ValueError, "the ending '.txt' .* .vtu, .vti"):
            vtktetmarch.read(self.folder / "a.txt")
        (self.folder / "folder.vtu").mkdir()
        with self.assertRaises(IsADirectoryError):
            vtktetmarch.read(self.folder / "folder.vtu")

    def test_damaged_files(self):
        mesh, image = MESH.read_bytes(), IMAGE.read_bytes()
        meta = b"ObjectType = Image\nNDims = 3\nDimSize = 4 4 4\nElementType = MET_UCHAR\nElementDataFile = LOCAL\nabc"
        nrrd = b"NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 4 4\nencoding: raw\n\nabc"
        legacy = b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n1 2"
        for name, content, text in (
                ("a.vtu", mesh[:300000], 'Cannot read point data array "vorticity_mag"'),
                ("b.vtu", b"hello", "syntax error"),
                ("a.vti", image[:3000], 'Cannot read point data array "density"'),
                ("a.vtk", legacy, "reading ascii data"),
                ("b.vtk", b"", "."), ("a.mha", meta, "64 bytes, but there are only 3"),
                ("a.nrrd", nrrd, "64 bytes, but there are only 3"),
                ("a.ex2", mesh, "damaged, or not what its ending says"), ("a.cgns", b"", "damaged"),
                ("a.vtkhdf", b"x" * 600, "damaged"), ("a.case", b"hello", "."), ("a.nii", b"hello", ".")):
            with self.subTest(name=name):
                path = self.folder / name
                path.write_bytes(content)
                with warnings.catch_warnings():
                    warnings.simplefilter("error")
                    with self.assertRaisesRegex(ValueError, f"{name}' can't be read: .*{text}") as caught:
                        vtktetmarch.read(path)
                # The folder's name is random, and may well have such letters.
                said = str(caught.exception).replace(str(self.folder), "")
                self.assertNotRegex(said, "0x|ERROR|\\.cxx")

    def test_errors_go_where_they_went_before(self):
        window = vtk.vtkOutputWindow.GetInstance()
        self.test_damaged_files()
        self.assertIs(vtk.vtkOutputWindow.GetInstance(), window)


if __name__ == "__main__":
    unittest.main(verbosity=2)
