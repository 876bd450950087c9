# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The members that we use of other packages' data. The packages themselves are not imported."""
from typing import Any, Protocol, runtime_checkable


@runtime_checkable
class LikeDataArray(Protocol):
    """An xarray.DataArray."""

    @property
    def dims(self) -> Any: ...
    @property
    def coords(self) -> Any: ...
    @property
    def values(self) -> Any: ...
    @property
    def attrs(self) -> Any: ...
    @property
    def isel(self) -> Any: ...


@runtime_checkable
class LikeDataset(Protocol):
    """An xarray.Dataset."""

    @property
    def dims(self) -> Any: ...
    @property
    def coords(self) -> Any: ...
    @property
    def data_vars(self) -> Any: ...


@runtime_checkable
class LikeMesh(Protocol):
    """A meshio.Mesh."""

    @property
    def points(self) -> Any: ...
    @property
    def cells(self) -> Any: ...
    @property
    def point_data(self) -> Any: ...
    @property
    def cell_data(self) -> Any: ...
