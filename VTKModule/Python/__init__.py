"""TetMarch: volume rendering of unstructured grids by marching rays from tetrahedron to tetrahedron."""

# VTK's own modules first: they register the base classes that ours derive from, and the factories of OpenGL and text.
import vtkmodules.vtkCommonExecutionModel  # noqa: F401
import vtkmodules.vtkRenderingAnnotation  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingVolume  # noqa: F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

from .vtkRenderingTetMarch import (
    vtkTetMarchFrameStatistics,
    vtkTetMarchLegend,
    vtkTetMarchObjectFactory,
    vtkTetMarchProjectedTetrahedraMapper,
    vtkTetMarchSettings,
    vtkTetMarchSmartVolumeMapper,
    vtkTetMarchVolumeMapper,
)

__all__ = [
    "vtkTetMarchFrameStatistics",
    "vtkTetMarchLegend",
    "vtkTetMarchObjectFactory",
    "vtkTetMarchProjectedTetrahedraMapper",
    "vtkTetMarchSettings",
    "vtkTetMarchSmartVolumeMapper",
    "vtkTetMarchVolumeMapper",
]
