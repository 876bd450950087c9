# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws pieces of a grid in several processes: mpiexec -n N pvbatch draw_parallel.py --plugin ... --data F.pvtu

The file has as many pieces as there are processes. Each scene's picture and how many cells were read go to FOLDER.
"""
import argparse
import json
import pathlib

from paraview import servermanager, simple
from views import load_plugin, open_view, show

ARRAY = "field"
FIGURES = ("NumberOfVisits", "SentBytes", "MarchSeconds", "ExchangeSeconds", "MergeSeconds", "SpreadSeconds")

# name: properties of the representation, and what else is in the view.
SCENES = {
    "composite": {},
    "maximum": {"BlendMode": "Maximum Intensity"},
    "minimum": {"BlendMode": "Minimum Intensity"},
    "average": {"BlendMode": "Average Intensity"},
    "additive": {"BlendMode": "Additive"},
    "isosurface": {"BlendMode": "Isosurface", "IsosurfaceValues": [0.36, 0.47, 0.58]},
    "shaded": {"Shade": 1, "Ambient": 0.2, "Diffuse": 0.8, "Specular": 0.3},
    "cropped": {"UseCropping": 1, "CroppingScale": [0.5, 1.0, 1.0]},
    "cells": {"array": ("CELLS", "of_cells")},
    "inside": {"camera": ([0.35, 0.12, 0.41], [0.7, 0.9, 0.6])},
    "surface": {"surface": True},
    "translucent": {"surface": True, "surface_opacity": 0.5},
    "moving": {"interactive": True},
    "reduced": {"reduction": 2},
    "hidden": {"hidden": True},
}


def set_functions(name):
    colors = simple.GetColorTransferFunction(name)
    colors.RGBPoints = [0.1, 0.1, 0.2, 0.9, 0.4, 0.2, 0.9, 0.3, 0.7, 0.9, 0.8, 0.1]
    opacities = simple.GetOpacityTransferFunction(name)
    opacities.Points = [0.0, 0.1, 0.5, 0.0, 0.35, 0.1, 0.5, 0.0, 0.5, 0.6, 0.5, 0.0, 0.6, 0.1, 0.5, 0.0, 0.9, 0.8, 0.5, 0.0]


def look_from(view, position, focus):
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = position, focus, [0, 0, 1]


def hide_cells(reader):
    """Those of the upper half, as blanked cells are: by their centres, which no partition changes."""
    centres = simple.PythonCalculator(Input=reader, ArrayAssociation="Cell Data", ArrayName="vtkGhostType",
                                      Expression="numpy.where(of_cells > 0.5, 32, 0).astype('uint8')")
    centres.UpdatePipeline()
    return centres


def draw(reader, name, scene, folder, arguments):
    view = open_view()
    view.ViewSize = [200, 150]
    view.UseFXAA = 0  # which ParaView applies in parallel alone
    view.StillRenderImageReductionFactor = scene.get("reduction", 1)
    view.ImageReductionFactor = 2  # while somebody moves the view
    if scene.get("hidden"):
        reader = hide_cells(reader)
    association, array = scene.get("array", ("POINTS", ARRAY))
    display = show(reader, view, array, association)
    set_functions(array)
    display.ScalarOpacityUnitDistance = 0.25
    display.TetMarchExactCompositing = 0 if arguments.pieces or arguments.redistribute else 1
    display.TetMarchUseDataPartitions = 0 if arguments.redistribute else 1
    for key, value in scene.items():
        if key[0].isupper():
            setattr(display, "TetMarch" + key, value)
    surface = None
    if scene.get("surface"):
        # Of all processes: each has a part of the slice.
        surface = simple.Slice(Input=reader)
        surface.SliceType.Origin, surface.SliceType.Normal = [0.5, 0.5, 0.5], [0.3, 1.0, 0.2]
        shown = simple.Show(surface, view)
        simple.ColorBy(shown, None)
        shown.Opacity = scene.get("surface_opacity", 1.0)
    look_from(view, *scene.get("camera", ([1.5, -2.2, 1.6], [0.5, 0.5, 0.45])))
    simple.Render(view)
    if scene.get("interactive"):
        view.SMProxy.InteractiveRender()
    simple.SaveScreenshot(str(folder / f"{name}.png"), view, TransparentBackground=0)
    display.UpdatePropertyInformation()
    figures = {figure: display.GetPropertyValue("TetMarch" + figure) for figure in FIGURES}
    if surface:
        simple.Delete(surface)
    simple.Delete(view)
    return figures


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("plugin", "data", "folder"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--scenes", nargs="*", default=list(SCENES))
    parser.add_argument("--pieces", action="store_true", help="one over the other")
    parser.add_argument("--redistribute", action="store_true", help="pieces in regions of a k-d tree")
    parser.add_argument("--without-icet", action="store_true")
    parser.add_argument("--server", type=int, help="the port of a pvserver, which draws")
    arguments = parser.parse_args()
    load_plugin(arguments, arguments.server)
    folder = pathlib.Path(arguments.folder)
    reader = simple.XMLPartitionedUnstructuredGridReader(FileName=[arguments.data])
    reader.UpdatePipeline()
    if arguments.without_icet:
        settings = servermanager.ProxyManager().GetProxy("settings", "RenderViewSettings")
        settings.GetProperty("DisableIceT").SetElement(0, 1)
        settings.UpdateVTKObjects()
    figures = {name: draw(reader, name, SCENES[name], folder, arguments) for name in arguments.scenes}
    (folder / "figures.json").write_text(json.dumps(figures))
    cells = reader.GetDataInformation().GetNumberOfCells()
    processes = servermanager.ActiveConnection.GetNumberOfDataPartitions()
    (folder / "read.json").write_text(json.dumps({"cells": cells, "processes": processes}))


if __name__ == "__main__":
    main()
