# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Puts classes of ours in the place of VTK's, for scripts that create VTK's."""
import os
import sys

from vtkmodules.vtkRenderingVolume import vtkUnstructuredGridVolumeRayCastMapper, vtkUnstructuredGridVolumeZSweepMapper
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper

from .vtkRenderingTetMarch import vtkTetMarchObjectFactory, vtkTetMarchSmartVolumeMapper, vtkTetMarchVolumeMapper


class CastingMapper(vtkTetMarchVolumeMapper):
    """A vtkTetMarchVolumeMapper with what VTK's ray casters of unstructured grids have beside it.

    What it has no use for is kept and has no effect: it has no threads, functions and integrators of its own, and
    opaque geometry always intermixes.
    """

    def __init__(self):
        super().__init__()
        self._kept = {"NumberOfThreads": 1, "IntermixIntersectingGeometry": 1, "RayCastFunction": None,
                      "RayIntegrator": None, "MaxPixelListSize": 32}

    def SetImageSampleDistance(self, distance):
        """Distances below a pixel are drawn as one: a pixel has one ray."""
        super().SetImageSampleDistance(max(1.0, distance))

    def SetMinimumImageSampleDistance(self, distance):
        """As SetImageSampleDistance()."""
        super().SetMinimumImageSampleDistance(max(1.0, distance))

    def SetMaximumImageSampleDistance(self, distance):
        """As SetImageSampleDistance()."""
        super().SetMaximumImageSampleDistance(max(1.0, distance))

    def IntermixIntersectingGeometryOn(self):
        """No effect."""
        self._kept["IntermixIntersectingGeometry"] = 1

    def IntermixIntersectingGeometryOff(self):
        """No effect."""
        self._kept["IntermixIntersectingGeometry"] = 0


def add_kept(name):
    """The methods Set...() and Get...() of a property without an effect."""

    def set_kept(self, value):
        self._kept[name] = value

    def get_kept(self):
        return self._kept[name]

    for begin, method in (("Set", set_kept), ("Get", get_kept)):
        method.__name__ = begin + name
        method.__doc__ = "No effect."
        setattr(CastingMapper, begin + name, method)


for each in ("NumberOfThreads", "IntermixIntersectingGeometry", "RayCastFunction", "RayIntegrator", "MaxPixelListSize"):
    add_kept(each)


class RayCastMapper(CastingMapper):
    """In the place of a vtkUnstructuredGridVolumeRayCastMapper."""


class ZSweepMapper(CastingMapper):
    """In the place of a vtkUnstructuredGridVolumeZSweepMapper."""


def replace(stock, ours, replaces):
    """Puts a class of ours in the place of VTK's, in each module of VTK's that is loaded, or VTK's back."""
    old, new = (stock, ours) if replaces else (ours, stock)
    name = stock.__name__
    for module in map(sys.modules.get, (stock.__module__, "vtkmodules.all", "vtk")):
        if module is not None and getattr(module, name, None) is old:
            setattr(module, name, new)


def replace_smart_volume_mapper(replaces=True):
    """Whether vtkSmartVolumeMapper of VTK's Python modules is our vtkTetMarchSmartVolumeMapper from now on.

    A script that imports the name afterwards, or looks it up in a module (vtk.vtkSmartVolumeMapper), gets ours. What it
    imported before stays, and so do mappers that VTK makes inside. In C++, vtkObjectFactory::CreateInstance() follows
    (see vtkTetMarchObjectFactory). The environment variable TETMARCH_REPLACE_SMART_VOLUME, unless it is empty or 0,
    does this when vtktetmarch is imported.
    """
    vtkTetMarchObjectFactory.SetReplacesSmartVolume(bool(replaces))
    replace(vtkSmartVolumeMapper, vtkTetMarchSmartVolumeMapper, replaces)


def replace_unstructured_mappers(replaces=True):
    """Whether VTK's mappers of unstructured grids are ours from now on.

    They are vtkProjectedTetrahedraMapper, by vtkTetMarchObjectFactory, and vtkUnstructuredGridVolumeRayCastMapper and
    vtkUnstructuredGridVolumeZSweepMapper, by their names in VTK's Python modules, since VTK asks no factory for these
    two. Names that a script imported before stay, and so do mappers that exist. The environment variable
    TETMARCH_REPLACE_UNSTRUCTURED, unless it is empty or 0, does this when vtktetmarch is imported; so does
    `python3 -m vtktetmarch SCRIPT`, which runs a script that doesn't know of vtktetmarch.
    """
    vtkTetMarchObjectFactory.SetReplacesProjectedTetrahedra(bool(replaces))
    replace(vtkUnstructuredGridVolumeRayCastMapper, RayCastMapper, replaces)
    replace(vtkUnstructuredGridVolumeZSweepMapper, ZSweepMapper, replaces)


def is_asked_for(variable):
    """Whether a variable of the environment is neither empty nor 0."""
    return os.environ.get(variable, "0") not in ("", "0")


if is_asked_for("TETMARCH_REPLACE_SMART_VOLUME"):
    replace_smart_volume_mapper()
if is_asked_for("TETMARCH_REPLACE_UNSTRUCTURED"):
    replace_unstructured_mappers()
