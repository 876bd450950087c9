# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A client of a server: the server draws, and the client is told of its last frame."""
import socket
import subprocess
import time

from paraview import simple
from views import REPRESENTATION, open_view, parse_arguments

LONGEST = 60  # seconds to wait for the server


def free_port():
    with socket.socket() as made:
        made.bind(("localhost", 0))
        return made.getsockname()[1]


def start_server(program, port):
    server = subprocess.Popen([program, f"--server-port={port}"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True)
    end = time.monotonic() + LONGEST
    for line in server.stdout:
        if "Accepting connection" in line:
            return server
        if time.monotonic() > end:
            break
    server.kill()
    raise RuntimeError("pvserver accepts no connection")


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
    port = free_port()
    server = start_server(arguments.server, port)
    try:
        simple.Connect("localhost", port)
        simple.LoadPlugin(arguments.plugin, remote=True, ns=globals())
        simple.LoadPlugin(arguments.plugin, remote=False, ns=globals())
        view = open_view()
        image = simple.Wavelet(WholeExtent=[0, 10, 0, 10, 0, 10])
        grid = simple.AppendDatasets(Input=image)
        assert check_figures(image, view, "UniformGridRepresentation", "NumberOfLatticeCells") == 1000
        assert check_figures(grid, view, "UnstructuredGridRepresentation", "NumberOfTetrahedra") >= 5000
    finally:
        server.kill()
        server.wait()


main()
