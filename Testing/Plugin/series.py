# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of time steps, with their data inline: Debian 12's ParaView reads them whatever libexpat it has."""
from lattices import ARRAY, image, lattice
from other_grids import curvilinear
from paraview import simple
from paraview.vtk.vtkIOXML import vtkXMLImageDataWriter, vtkXMLStructuredGridWriter, vtkXMLUnstructuredGridWriter
from views import open_view, show

SIDE = 6
# What makes the grid, what writes it, and how ParaView shows it.
KINDS = {
    "vtu": (lattice, vtkXMLUnstructuredGridWriter, "UnstructuredGridRepresentation"),
    "vts": (curvilinear, vtkXMLStructuredGridWriter, "StructuredGridRepresentation"),
    "vti": (image, vtkXMLImageDataWriter, "UniformGridRepresentation"),
}


def make_grid(kind, value, origin=(0, 0, 0)):
    return KINDS[kind][0]([SIDE] * 3, value, origin)


def write_steps(kind, folder, grids):
    """The names of the files."""
    names = []
    for i, grid in enumerate(grids):
        writer = KINDS[kind][1]()
        writer.SetInputData(grid)
        writer.SetDataModeToBinary()
        names.append(f"{folder}/step{i}.{kind}")
        writer.SetFileName(names[-1])
        assert writer.Write() == 1
    return names


class Shown:
    """Series of files in a view of their own."""

    def __init__(self, kind, *series):
        """Of several series, each is a block."""
        self.sources = [simple.OpenDataFile(names) for names in series]
        if len(series) > 1:
            self.sources.append(simple.GroupDatasets(Input=self.sources))
        self.view = open_view()
        self.view.ViewSize = [200, 160]
        self.display = show(self.sources[-1], self.view, ARRAY, kind=KINDS[kind][2])
        self.scene = simple.GetAnimationScene()
        self.scene.UpdateAnimationUsingDataTimeSteps()
        simple.ResetCamera(self.view)

    def figure(self, name):
        self.display.UpdatePropertyInformation()
        return self.display.GetPropertyValue("TetMarch" + name)

    def close(self):
        for proxy in (self.display, self.view, *reversed(self.sources)):
            simple.Delete(proxy)
