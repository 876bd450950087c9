# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A client of a server: the server draws, and the client is told of its last frame."""
import tempfile

from paraview import simple
from programs import serving
from views import REPRESENTATION, load_plugin, open_view, parse_arguments


def check_figures(source, view, kind, cells):
    display = simple.Show(source, view, kind)
    simple.ColorBy(display, ("POINTS", "RTData"))
    assert REPRESENTATION in display.GetProperty("Representation").Available
    display.SetRepresentationType(REPRESENTATION)
    display.TetMarchAccuracyLevel = "Accurate"
    simple.ResetCamera(view)
    simple.Render(view)
    here = display.GetClientSideObject().GetActiveRepresentation().GetActor().GetMapper()
    assert here.GetTimeToDraw() == 0, "the client has drawn"
    display.UpdatePropertyInformation()
    figures = {name: display.GetPropertyValue("TetMarch" + name)
               for name in ("TimeToDraw", "UsedAccuracyLevel", "GPUMemoryBytes", cells)}
    print(kind, figures)
    assert figures["UsedAccuracyLevel"] == 2, figures
    assert all(value > 0 for value in figures.values()), figures
    simple.Hide(source, view)
    return figures[cells]


def main():
    arguments = parse_arguments(__doc__, "server")
    with tempfile.TemporaryDirectory() as folder, serving([arguments.server], f"{folder}/server.txt") as (_, port):
        load_plugin(arguments, port)
        view = open_view()
        image = simple.Wavelet(WholeExtent=[0, 10, 0, 10, 0, 10])
        grid = simple.AppendDatasets(Input=image)
        assert check_figures(image, view, "UniformGridRepresentation", "NumberOfLatticeCells") == 1000
        assert check_figures(grid, view, "UnstructuredGridRepresentation", "NumberOfTetrahedra") >= 5000


main()
