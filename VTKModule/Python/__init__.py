"""TetMarch: volume rendering by marching rays from cell to cell, of unstructured grids and images."""

# VTK's own modules first: they register the base classes that ours derive from, and the factories of OpenGL and text.
import vtkmodules.vtkCommonExecutionModel  # noqa: F401
import vtkmodules.vtkRenderingAnnotation  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingVolume  # noqa: F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

from .arrays import from_arrays
from .figures import Figure, figure, screenshot, show
from .first_picture import TransferFunctions, auto_transfer_functions
from .measures import compare, statistics
from .readers import read, time_values
from .replacement import replace_smart_volume_mapper, replace_unstructured_mappers
from .volumes import configure, volume
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
    "Figure",
    "TransferFunctions",
    "auto_transfer_functions",
    "compare",
    "configure",
    "figure",
    "from_arrays",
    "read",
    "replace_smart_volume_mapper",
    "replace_unstructured_mappers",
    "screenshot",
    "show",
    "statistics",
    "time_values",
    "volume",
    "vtkTetMarchFirstPicture",
    "vtkTetMarchFrameStatistics",
    "vtkTetMarchLegend",
    "vtkTetMarchObjectFactory",
    "vtkTetMarchProjectedTetrahedraMapper",
    "vtkTetMarchSettings",
    "vtkTetMarchSmartVolumeMapper",
    "vtkTetMarchVolumeMapper",
]
