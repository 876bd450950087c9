# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Puts a class of ours in the place of one of VTK's, for scripts that create VTK's."""
import os
import sys

import vtkmodules.vtkRenderingVolumeOpenGL2 as home

from .vtkRenderingTetMarch import vtkTetMarchObjectFactory, vtkTetMarchSmartVolumeMapper

NAME = "vtkSmartVolumeMapper"
STOCK = getattr(home, NAME)


def replace_smart_volume_mapper(replaces=True):
    """Whether vtkSmartVolumeMapper of VTK's Python modules is our vtkTetMarchSmartVolumeMapper from now on.

    A script that imports the name afterwards, or looks it up in a module (vtk.vtkSmartVolumeMapper), gets ours. What it
    imported before stays, and so do mappers that VTK makes inside. In C++, vtkObjectFactory::CreateInstance() follows
    (see vtkTetMarchObjectFactory). The environment variable TETMARCH_REPLACE_SMART_VOLUME, unless it is empty or 0, does
    this when vtktetmarch is imported.
    """
    vtkTetMarchObjectFactory.SetReplacesSmartVolume(bool(replaces))
    old, new = (STOCK, vtkTetMarchSmartVolumeMapper) if replaces else (vtkTetMarchSmartVolumeMapper, STOCK)
    for name in (home.__name__, "vtkmodules.all", "vtk"):
        module = sys.modules.get(name)
        if module is not None and getattr(module, NAME, None) is old:
            setattr(module, NAME, new)


if os.environ.get("TETMARCH_REPLACE_SMART_VOLUME", "0") not in ("", "0"):
    replace_smart_volume_mapper()
