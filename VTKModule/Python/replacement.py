# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Replaces VTK's classes by ours, for existing scripts."""
import os
import sys

from vtkmodules.vtkRenderingVolume import vtkUnstructuredGridVolumeRayCastMapper, vtkUnstructuredGridVolumeZSweepMapper
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper

from .vtkRenderingTetMarch import vtkTetMarchObjectFactory, vtkTetMarchSmartVolumeMapper, vtkTetMarchVolumeMapper


class CastingMapper(vtkTetMarchVolumeMapper):
    """A vtkTetMarchVolumeMapper with the additional properties of VTK's ray casters of unstructured grids.

    Properties without a counterpart are stored and have no effect: there are no threads, ray functions and integrators,
    and opaque geometry always intermixes.
    """

    def __init__(self):
        super().__init__()
        self._kept = {"NumberOfThreads": 1, "IntermixIntersectingGeometry": 1, "RayCastFunction": None,
                      "RayIntegrator": None, "MaxPixelListSize": 32}

    def SetImageSampleDistance(self, distance):
        """Distances below one pixel are set to 1: a pixel has at most one ray."""
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
    """Replaces vtkUnstructuredGridVolumeRayCastMapper."""


class ZSweepMapper(CastingMapper):
    """Replaces vtkUnstructuredGridVolumeZSweepMapper."""


def replace(stock, ours, replaces):
    """Replaces a class of VTK by ours in each loaded module of VTK, or restores it."""
    old, new = (stock, ours) if replaces else (ours, stock)
    name = stock.__name__
    for module in map(sys.modules.get, (stock.__module__, "vtkmodules.all", "vtk")):
        if module is not None and getattr(module, name, None) is old:
            setattr(module, name, new)


def replace_smart_volume_mapper(replaces=True):
    """Replaces vtkSmartVolumeMapper in VTK's Python modules by vtkTetMarchSmartVolumeMapper, or restores it.

    A script that imports the name afterwards, or looks it up in a module (vtk.vtkSmartVolumeMapper), gets our class.
    Names imported before are not changed, nor are mappers that VTK creates internally. In C++,
    vtkObjectFactory::CreateInstance() follows (see vtkTetMarchObjectFactory). The environment variable
    TETMARCH_REPLACE_SMART_VOLUME, unless it is empty or 0, does this when vtktetmarch is imported.
    """
    vtkTetMarchObjectFactory.SetReplacesSmartVolume(bool(replaces))
    replace(vtkSmartVolumeMapper, vtkTetMarchSmartVolumeMapper, replaces)


def replace_unstructured_mappers(replaces=True):
    """Replaces VTK's mappers of unstructured grids by ours, or restores them.

    They are vtkProjectedTetrahedraMapper, by vtkTetMarchObjectFactory, and vtkUnstructuredGridVolumeRayCastMapper and
    vtkUnstructuredGridVolumeZSweepMapper, by their names in VTK's Python modules, since VTK uses no factory for these
    two. Names imported before and existing mappers are not changed. The environment variable
    TETMARCH_REPLACE_UNSTRUCTURED, unless it is empty or 0, does this when vtktetmarch is imported; so does
    `python3 -m vtktetmarch SCRIPT`, for an unchanged script.
    """
    vtkTetMarchObjectFactory.SetReplacesProjectedTetrahedra(bool(replaces))
    replace(vtkUnstructuredGridVolumeRayCastMapper, RayCastMapper, replaces)
    replace(vtkUnstructuredGridVolumeZSweepMapper, ZSweepMapper, replaces)


def is_asked_for(variable):
    """Whether an environment variable is neither empty nor 0."""
    return os.environ.get(variable, "0") not in ("", "0")


if is_asked_for("TETMARCH_REPLACE_SMART_VOLUME"):
    replace_smart_volume_mapper()
if is_asked_for("TETMARCH_REPLACE_UNSTRUCTURED"):
    replace_unstructured_mappers()
