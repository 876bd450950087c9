# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the VTK of this Python is the one that the package was built for: any other would crash."""
from .built_for import VTK


def check_vtk():
    """Raises ImportError."""
    remedy = "install that VTK, or install vtktetmarch again from its sources"
    try:
        from vtkmodules.vtkCommonCore import vtkVersion
    except ImportError as error:
        raise ImportError(f"vtktetmarch was built for VTK {VTK}, and this Python has no VTK ({error}): {remedy}") \
            from None
    found = vtkVersion.GetVTKVersion()
    if found != VTK:
        raise ImportError(f"vtktetmarch was built for VTK {VTK}, and this Python has VTK {found}: {remedy}")
