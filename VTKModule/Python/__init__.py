"""TetMarch: volume rendering by marching rays from cell to cell, of unstructured grids, images and rectilinear grids."""

# VTK's own modules first: they register the base classes that ours derive from, and the factories of OpenGL and text.
import vtkmodules.vtkCommonExecutionModel  # noqa: F401
import vtkmodules.vtkRenderingAnnotation  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingVolume  # noqa: F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

from .first_picture import TransferFunctions, auto_transfer_functions
from .replacement import replace_smart_volume_mapper
from .vtkRenderingTetMarch import (
    vtkTetMarchFirstPicture,
    vtkTetMarchFrameStatistics,
    vtkTetMarchLegend,
    vtkTetMarchObjectFactory,
    vtkTetMarchProjectedTetrahedraMapper,
    vtkTetMarchSettings,
    vtkTetMarchSmartVolumeMapper,
    vtkTetMarchVolumeMapper,
)

__all__ = [
    "TransferFunctions",
    "auto_transfer_functions",
    "replace_smart_volume_mapper",
    "vtkTetMarchFirstPicture",
    "vtkTetMarchFrameStatistics",
    "vtkTetMarchLegend",
    "vtkTetMarchObjectFactory",
    "vtkTetMarchProjectedTetrahedraMapper",
    "vtkTetMarchSettings",
    "vtkTetMarchSmartVolumeMapper",
    "vtkTetMarchVolumeMapper",
]
