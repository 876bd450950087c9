# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scripts that use VTK's ray casters of unstructured grids run unchanged with mappers that march."""
import gc
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import first_data

NAMES = ("vtkProjectedTetrahedraMapper", "vtkUnstructuredGridVolumeRayCastMapper",
         "vtkUnstructuredGridVolumeZSweepMapper")
# Uses all that VTK's two ray casters have beside other mappers; prints the kind of its mapper and a pixel.
SCRIPT = """
import sys
import vtkmodules.all as vtk
import first_data
mapper = vtk.{name}()
mapper.SetInputData(first_data.one_tetrahedron())
mapper.SetScalarModeToUsePointFieldData(); mapper.SelectScalarArray("z")
if "Volume" in "{name}":
    mapper.SetImageSampleDistance(0.5); mapper.SetMinimumImageSampleDistance(0.2); mapper.AutoAdjustSampleDistancesOff()
    mapper.SetIntermixIntersectingGeometry(0); mapper.IntermixIntersectingGeometryOn()
    mapper.SetRayIntegrator(vtk.vtkUnstructuredGridLinearRayIntegrator())
if "RayCast" in "{name}":
    mapper.SetNumberOfThreads(2); mapper.SetRayCastFunction(vtk.vtkUnstructuredGridBunykRayCastFunction())
    assert mapper.GetNumberOfThreads() == 2
volume = vtk.vtkVolume(); volume.SetMapper(mapper)
del mapper
color = vtk.vtkColorTransferFunction(); color.AddRGBPoint(0, 1, 1, 1); volume.GetProperty().SetColor(color)
opacity = vtk.vtkPiecewiseFunction(); opacity.AddPoint(0, 0.6); volume.GetProperty().SetScalarOpacity(opacity)
volume.GetProperty().SetScalarOpacityUnitDistance(0.3)
renderer = vtk.vtkRenderer(); renderer.AddVolume(volume)
window = vtk.vtkRenderWindow(); window.SetOffScreenRendering(True); window.SetSize(60, 60); window.AddRenderer(renderer)
renderer.ResetCamera()
window.Render()
pixels = vtk.vtkUnsignedCharArray(); window.GetPixelData(22, 22, 22, 22, 0, pixels, 0)
kind = volume.GetMapper()
print("marches" if kind.IsA("vtkTetMarchVolumeMapper") or hasattr(kind, "GetMarchingMapper") else "stock",
      isinstance(kind, vtk.{name}), pixels.GetValue(0), *sys.argv[1:])
"""


class ReplaceUnstructuredTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.script = pathlib.Path(folder.name) / "script.py"

    def run_script(self, name, *options, before="", value=""):
        self.script.write_text(before + SCRIPT.format(name=name))
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path), "TETMARCH_REPLACE_UNSTRUCTURED": value}
        run = subprocess.run([sys.executable, *options, str(self.script), "a", "b"], env=environment, text=True,
                             capture_output=True, timeout=1000)
        self.assertEqual(run.returncode, 0, run.stderr)
        kind, is_instance, pixel, *arguments = run.stdout.split()
        self.assertEqual((is_instance, arguments), ("True", ["a", "b"]))
        return kind, int(pixel)

    def test_by_the_module(self):
        for name in NAMES:
            with self.subTest(name=name):
                kind, expected = self.run_script(name)
                self.assertEqual(kind, "stock")
                kind, pixel = self.run_script(name, "-m", "vtktetmarch")
                self.assertEqual(kind, "marches")
                self.assertGreater(pixel, 30)
                if "Volume" in name:  # the ray casters of VTK integrate as ours do
                    self.assertLess(abs(pixel - expected), 6, (pixel, expected))

    def test_by_the_environment_and_by_a_call(self):
        name, module = NAMES[1], "import vtktetmarch\n"
        replace = module + "vtktetmarch.replace_unstructured_mappers()\n"
        for before, value, expected in (
                (module, "1", "marches"), (module, "0", "stock"), (module, "", "stock"),
                (replace, "", "marches"),
                (replace + "vtktetmarch.replace_unstructured_mappers(False)\n", "", "stock")):
            with self.subTest(before=before, value=value):
                self.assertEqual(self.run_script(name, before=before, value=value)[0], expected)

    def test_no_script(self):
        for arguments, text in (([], "python3 -m vtktetmarch SCRIPT"), (["/no/such/script.py"], "there is no script")):
            run = subprocess.run([sys.executable, "-m", "vtktetmarch", *arguments], capture_output=True, text=True,
                                 env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})
            self.assertEqual(run.returncode, 1)
            self.assertIn(text, run.stderr)

    def test_what_was_set_stays_when_vtk_alone_holds_the_mapper(self):
        import vtkmodules.all as vtk
        import vtktetmarch

        vtktetmarch.replace_unstructured_mappers()
        self.addCleanup(vtktetmarch.replace_unstructured_mappers, False)
        volume = vtk.vtkVolume()
        volume.SetMapper(vtk.vtkUnstructuredGridVolumeZSweepMapper())
        volume.GetMapper().SetMaxPixelListSize(7)
        gc.collect()
        self.assertEqual(volume.GetMapper().GetMaxPixelListSize(), 7)
        volume.GetMapper().SetInputData(first_data.one_tetrahedron())
        volume.GetMapper().SetMaximumImageSampleDistance(0.1)
        self.assertEqual(volume.GetMapper().GetMaximumImageSampleDistance(), 1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
