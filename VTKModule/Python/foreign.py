# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data of other packages: NumPy, xarray and meshio; and what to do with data that are no volume."""
import numpy as np

from .dataarrays import from_dataarray
from .images import make_image
from .meshes import from_meshio
from .protocols import LikeDataArray, LikeDataset, LikeMesh


def is_of_pandas(data):
    """Whether the type of an object is one of pandas."""
    return type(data).__module__.partition(".")[0] == "pandas"


# Whether it is one of these, and what to do with it.
REFUSED = (
    (is_of_pandas, "a table has no cells: from_arrays() takes columns of points and cells, as table[['x', 'y', 'z']]"
                   ".to_numpy(), and .to_xarray() makes a DataArray of a Series with three indices"),
    (lambda data: isinstance(data, LikeDataset), "it has several arrays: give one of them, as in "
                                                 "dataset['temperature']"),
    (lambda data: isinstance(data, (list, tuple)), "numpy.array(data) makes an array of it, which can be drawn if it "
                                                   "has three dimensions; from_arrays() takes lists of points and "
                                                   "cells"),
)


def foreign_data(data, what="data"):
    """Data of VTK of a NumPy array, an xarray.DataArray or a meshio.Mesh; None of what is none of these.

    what: the argument's name, for errors.
    Raises TypeError with the remedy for tables of pandas, lists and an xarray.Dataset.
    """
    if isinstance(data, np.ndarray):
        return make_image(data, what=what)
    for refuses, remedy in REFUSED:
        if refuses(data):
            raise TypeError(f"{what} is a {type(data).__name__}, which is no volume; {remedy}")
    if isinstance(data, LikeDataArray):
        return from_dataarray(data)
    if isinstance(data, LikeMesh):
        return from_meshio(data)
    return None
