# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvbatch and by ParaView's window where the plugin's package is installed, without LoadPlugin.

Draws with "Tet Marching" and writes what it found, then ends the program: status 0 if the volume was drawn. The
environment variable TETMARCH_TRIED names the text file; the picture lies beside it.
"""
import os
import traceback

from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

RESULT = os.environ["TETMARCH_TRIED"]
FEWEST_COLORS = 1000


def colors_of(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return len({tuple(pixel) for pixel in vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())})


def draw():
    display = simple.Show(simple.AppendDatasets(Input=simple.Wavelet()))  # which makes an unstructured grid of it
    simple.ColorBy(display, ("POINTS", "RTData"))
    if "Tet Marching" not in display.GetProperty("Representation").Available:
        raise RuntimeError("ParaView didn't load the plugin by itself")
    display.SetRepresentationType("Tet Marching")
    simple.ResetCamera()
    simple.Render()
    display.UpdatePropertyInformation()
    picture = os.path.splitext(RESULT)[0] + ".png"
    simple.SaveScreenshot(picture, simple.GetActiveView(), ImageResolution=[300, 200])
    seconds, colors = display.GetPropertyValue("TetMarchTimeToDraw"), colors_of(picture)
    if not seconds > 0 or colors < FEWEST_COLORS:
        raise RuntimeError(f"nothing was drawn: {seconds} s, {colors} colours")
    return f"{picture}: {colors} colours, {seconds:.3f} s"


status = 0
try:
    found = draw()
except Exception:  # the test is to know, whatever it is
    found, status = traceback.format_exc(), 1
print(found, flush=True)
with open(RESULT, "w", encoding="utf-8") as file:
    file.write(found)
os._exit(status)  # ParaView's window would stay
