# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Types of the package, for editors and type checkers. What functions do is in their docstrings."""
from os import PathLike
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, Union, overload

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkPiecewiseFunction, vtkUnstructuredGrid
from vtkmodules.vtkRenderingCore import (vtkAbstractVolumeMapper, vtkCamera, vtkColorTransferFunction, vtkProp,
                                         vtkRenderer, vtkVolume)

from .vtkRenderingTetMarch import (
    vtkTetMarchFirstPicture as vtkTetMarchFirstPicture,
    vtkTetMarchFrameStatistics as vtkTetMarchFrameStatistics,
    vtkTetMarchImageReader as vtkTetMarchImageReader,
    vtkTetMarchLegend as vtkTetMarchLegend,
    vtkTetMarchObjectFactory as vtkTetMarchObjectFactory,
    vtkTetMarchProjectedTetrahedraMapper as vtkTetMarchProjectedTetrahedraMapper,
    vtkTetMarchSettings as vtkTetMarchSettings,
    vtkTetMarchSmartVolumeMapper as vtkTetMarchSmartVolumeMapper,
    vtkTetMarchVolumeMapper as vtkTetMarchVolumeMapper,
)

__all__: list[str]

Path = Union[str, PathLike[str]]
Association = Literal["points", "cells", None]
Component = Union[int, Literal["magnitude"], None]
Color = Union[str, Sequence[float]]
ColorMap = Union[vtkColorTransferFunction, str, Sequence[Color], Sequence[tuple[float, Color]], None]
Opacity = Union[vtkPiecewiseFunction, float, Sequence[float], Sequence[tuple[float, float]], Callable[[float], float],
                Literal["linear"], None]
Range = Union[Sequence[float], None]
Camera = Union[Literal["iso", "x", "-x", "y", "-y", "z", "-z"], Mapping[str, Any], vtkCamera]
Size = Sequence[int]
Pixels = np.ndarray[Any, np.dtype[np.uint8]]

class TransferFunctions(NamedTuple):
    color: vtkColorTransferFunction
    opacity: vtkPiecewiseFunction
    unit_distance: float
    array: str
    association: str
    component: int
    range: tuple[float, float]

def auto_transfer_functions(data: Any, array: str | None = None, association: Association = None,
                            component: Component = None, range: Range = None,
                            structured_law: bool | None = None) -> TransferFunctions: ...
def volume(data: Any, array: str | None = None, *, association: Association = None, component: Component = None,
           cmap: ColorMap = None, opacity: Opacity = None, range: Range = None, unit_distance: float | None = None,
           **properties: Any) -> vtkVolume: ...
def configure(drawn: vtkVolume, **properties: Any) -> vtkVolume: ...

class Figure:
    volume: vtkVolume
    renderer: vtkRenderer
    size: Size
    transparent: bool
    def __init__(self, data: Any, *arguments: Any, size: Size = ..., background: Color = ..., camera: Camera = "iso",
                 transparent: bool = False, **how: Any) -> None: ...
    @property
    def camera(self) -> vtkCamera: ...
    @property
    def mapper(self) -> vtkAbstractVolumeMapper: ...
    def add(self, *props: vtkProp) -> Figure: ...
    def look(self, camera: Camera) -> Figure: ...
    def render(self) -> Figure: ...
    @overload
    def screenshot(self, filename: None = None, *, size: Size | None = None,
                   transparent: bool | None = None) -> Pixels: ...
    @overload
    def screenshot(self, filename: Path, *, size: Size | None = None, transparent: bool | None = None) -> Path: ...
    def save(self, path: Path) -> Path: ...
    def show(self, title: str = "TetMarch") -> None: ...
    def pick(self, x: int, y: int) -> dict[str, Any] | None: ...
    def statistics(self) -> dict[str, Any]: ...
    def compare(self) -> dict[str, Any]: ...
    def _repr_png_(self) -> bytes: ...

def figure(data: Any, *arguments: Any, **how: Any) -> Figure: ...
@overload
def screenshot(data: Any, *arguments: Any, filename: None = None, **how: Any) -> Pixels: ...
@overload
def screenshot(data: Any, *arguments: Any, filename: Path, **how: Any) -> Path: ...
def show(data: Any, *arguments: Any, **how: Any) -> None: ...
def statistics(drawn: Any) -> dict[str, Any]: ...
def compare(data: Any, *arguments: Any, **how: Any) -> dict[str, Any]: ...
def read(path: Path, time_step: int | None = None) -> vtkDataObject: ...
def time_values(path: Path) -> tuple[float, ...]: ...
def from_arrays(points: Any, cells: Any, cell_types: Any, point_data: Mapping[str, Any] | None = None,
                cell_data: Mapping[str, Any] | None = None) -> vtkUnstructuredGrid: ...
def from_image(array: Any, spacing: Sequence[float] = (1, 1, 1), origin: Sequence[float] = (0, 0, 0), *,
               axes: str = "xyz", association: Literal["points", "cells"] = "points",
               name: str = "values") -> vtkImageData: ...
def replace_smart_volume_mapper(replaces: bool = True) -> None: ...
def replace_unstructured_mappers(replaces: bool = True) -> None: ...
