# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by ParaView's own window (--script): draws an image as surface and as our volume, says what it found as JSON.

The environment variable TETMARCH_GUI_RESULT names the file; pictures lie beside it.
"""
import json
import os

from paraview import simple

RESULT = os.environ["TETMARCH_GUI_RESULT"]


def picture(name):
    path = os.path.join(os.path.dirname(RESULT), name)
    simple.SaveScreenshot(path, simple.GetActiveView(), ImageResolution=[300, 200])
    return path


def draw():
    source = simple.Wavelet()
    cells = simple.AppendDatasets(Input=source)  # makes an unstructured grid of it
    found = {}
    for name, shown in (("image", source), ("mesh", cells)):
        display = simple.Show(shown)
        simple.ColorBy(display, ("POINTS", "RTData"))
        representations = list(display.GetProperty("Representation").Available)
        display.SetRepresentationType("Surface")
        simple.Render()
        surface = picture(name + "_surface.png")
        display.SetRepresentationType("Tet Marching")
        simple.Render()
        display.UpdatePropertyInformation()
        found[name] = {"representations": representations, "surface": surface, "volume": picture(name + ".png"),
                       "seconds": display.GetPropertyValue("TetMarchTimeToDraw")}
        simple.Hide(shown)
    return found


try:
    answer = draw()
except Exception as error:  # the test is to know, whatever it is
    answer = {"error": repr(error)}
with open(RESULT + ".part", "w", encoding="utf-8") as file:
    json.dump(answer, file)
os.replace(RESULT + ".part", RESULT)
