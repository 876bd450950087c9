# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rewrite a .vtu file with its data inline instead of appended.

libexpat1 2.5.0-1+deb12u2 and later made Debian 12's ParaView 5.11 read appended data as 0 cells, without an
error; inline data is read well. The VTK of the system reads both, so this runs in its Python, not pvpython.
"""
import sys

from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter


def main(source, target):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(source)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputConnection(reader.GetOutputPort())
    writer.SetFileName(target)
    writer.SetDataModeToBinary()
    if not writer.Write() or reader.GetOutput().GetNumberOfCells() == 0:
        sys.exit(f"{source}: not converted")


if __name__ == "__main__":
    main(*sys.argv[1:])
