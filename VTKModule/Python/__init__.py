"""TetMarch: volume rendering by marching rays from cell to cell, of unstructured grids and images."""

import importlib

from .vtk_check import check_vtk

check_vtk()

# VTK's own modules first: they register the base classes that ours derive from, and the factories of OpenGL and text.
import vtkmodules.vtkCommonExecutionModel  # noqa: F401
import vtkmodules.vtkRenderingAnnotation  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingVolume  # noqa: F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

from .first_picture import TransferFunctions, auto_transfer_functions
from .replacement import replace_smart_volume_mapper, replace_unstructured_mappers
from .vtkRenderingTetMarch import (
    vtkTetMarchDualGrid,
    vtkTetMarchFirstPicture,
    vtkTetMarchFrameStatistics,
    vtkTetMarchImageReader,
    vtkTetMarchLegend,
    vtkTetMarchObjectFactory,
    vtkTetMarchProjectedTetrahedraMapper,
    vtkTetMarchSettings,
    vtkTetMarchSmartVolumeMapper,
    vtkTetMarchTessellator,
    vtkTetMarchVolumeMapper,
    vtkTetMarchWebExporter,
)

# The modules of functions that need NumPy and further modules of VTK: imported on demand.
HOMES = {
    "Figure": "figures",
    "compare": "figures",
    "configure": "volumes",
    "figure": "figures",
    "from_arrays": "arrays",
    "from_image": "images",
    "read": "readers",
    "screenshot": "figures",
    "show": "figures",
    "statistics": "measures",
    "time_values": "readers",
    "volume": "volumes",
}

__all__ = [
    "Figure",
    "TransferFunctions",
    "auto_transfer_functions",
    "compare",
    "configure",
    "figure",
    "from_arrays",
    "from_image",
    "read",
    "replace_smart_volume_mapper",
    "replace_unstructured_mappers",
    "screenshot",
    "show",
    "statistics",
    "time_values",
    "volume",
    "vtkTetMarchDualGrid",
    "vtkTetMarchFirstPicture",
    "vtkTetMarchFrameStatistics",
    "vtkTetMarchImageReader",
    "vtkTetMarchLegend",
    "vtkTetMarchObjectFactory",
    "vtkTetMarchProjectedTetrahedraMapper",
    "vtkTetMarchSettings",
    "vtkTetMarchSmartVolumeMapper",
    "vtkTetMarchTessellator",
    "vtkTetMarchVolumeMapper",
    "vtkTetMarchWebExporter",
]


def __getattr__(name):
    if name not in HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    found = globals()[name] = getattr(importlib.import_module("." + HOMES[name], __name__), name)
    return found


def __dir__():
    return sorted({*globals(), *HOMES})
