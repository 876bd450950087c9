# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scan of a bonsai, by ParaView's own volume rendering.

As a script, it keeps the picture that ParaView draws without the plugin, for test_images.py.
"""
import argparse
import pathlib

from paraview import simple
from views import open_view, picture_of

CELLS = 127**3
ARRAY = "density"
KIND = "UniformGridRepresentation"
# Leaves, branches and pot; air is clear.
OPACITY = [0.0, 0.0, 30.0, 0.0, 45.0, 0.3, 80.0, 0.7, 255.0, 0.95]
COLOURS = [0.0, 0.3, 0.5, 0.2, 58.0, 0.5, 0.6, 0.3, 120.0, 0.7, 0.5, 0.3, 255.0, 0.9, 0.6, 0.5]
UNIT_DISTANCE = 8.0


def use_functions():
    colours = simple.GetColorTransferFunction(ARRAY)
    colours.ColorSpace = "RGB"
    colours.Discretize = 0
    colours.RGBPoints = COLOURS
    points = []
    for i in range(0, len(OPACITY), 2):
        points += [OPACITY[i], OPACITY[i + 1], 0.5, 0.0]
    simple.GetOpacityTransferFunction(ARRAY).Points = points


def open_stock(data):
    """ParaView's own volume rendering of it, in a view of its own."""
    reader = simple.OpenDataFile(data)
    reader.UpdatePipeline()
    cells = reader.GetDataInformation().GetNumberOfCells()
    assert cells == CELLS, f"{cells} cells were read instead of {CELLS}"
    view = open_view()
    view.CameraPosition = [400.0, 330.0, 600.0]
    view.CameraFocalPoint = [128.0, 110.0, 128.0]
    view.CameraViewUp = [0.0, 1.0, 0.0]
    display = simple.Show(reader, view, KIND)
    simple.ColorBy(display, ("POINTS", ARRAY))
    use_functions()
    display.SetRepresentationType("Volume")
    display.ScalarOpacityUnitDistance = UNIT_DISTANCE
    return reader, view, display


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("data", "output"):
        parser.add_argument("--" + name, required=True)
    arguments = parser.parse_args()
    _, view, _ = open_stock(arguments.data)
    pathlib.Path(arguments.output).write_bytes(b"".join(picture_of(view)))


if __name__ == "__main__":
    main()
