# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK arrays that share the memory of NumPy arrays."""
from collections.abc import Mapping

import numpy as np
from vtkmodules.util.numpy_support import create_vtk_array, get_vtk_array_type
from vtkmodules.vtkCommonCore import vtkTypeInt32Array, vtkTypeInt64Array


def keep_with(vtk_object, *kept):
    """Keeps Python objects alive at least as long as an object of VTK."""

    def holds(_object, _event, kept=kept):
        """Does nothing: the observer keeps the objects alive."""

    vtk_object.AddObserver("DeleteEvent", holds)


def array_of(values, what):
    """A NumPy array, masked or not; itself, if it is one."""
    try:
        return np.asanyarray(values)
    except ValueError:
        raise ValueError(f"{what} has rows of different lengths, which are no array") from None


def with_nan(values, what):
    """An array of floats with NaN for masked values; an array without masked values itself."""
    values = array_of(values, what)
    if not np.ma.is_masked(values):
        return np.ma.getdata(values)
    if values.dtype.kind not in "biuf":
        raise TypeError(f"{what} has values of type {values.dtype}, and some are masked; those become NaN, which "
                        "floats have")
    return values.astype(np.promote_types(values.dtype, np.float32)).filled(np.nan)


def unmasked(values, what, then):
    """An array without masked values. Raises ValueError with the remedy if there are some."""
    values = array_of(values, what)
    if np.ma.is_masked(values):
        raise ValueError(f"{what} has {np.ma.count_masked(values)} masked numbers; {then}")
    return np.ma.getdata(values)


def numeric_array(values, what):
    """A NumPy array of numbers that VTK can share: the array itself if it can be, else a copy.

    Copied are: lists, arrays that aren't contiguous in C order, or aligned, of another byte order, of booleans (which
    become 0 and 1) and of half floats (which become single ones). Arrays that are read-only are shared: nothing here
    writes to them.
    Raises TypeError for types that VTK lacks: complex numbers, texts, objects.
    """
    array = np.asarray(array_of(values, what))
    if array.dtype == bool:
        array = array.astype(np.uint8)
    elif array.dtype.kind == "f" and array.dtype.itemsize == 2:
        array = array.astype(np.float32)
    if array.dtype.kind not in "iuf" or array.dtype.itemsize > 8:
        raise TypeError(f"{what} has values of type {array.dtype}; VTK has integers and floats of up to 64 bits")
    return np.require(array, array.dtype.newbyteorder("="), ("C_CONTIGUOUS", "ALIGNED"))


def shared_array(array, name=None):
    """A vtkDataArray over the memory of a NumPy array of one or two dimensions, which it keeps alive."""
    made = create_vtk_array(get_vtk_array_type(array.dtype))
    made.SetNumberOfComponents(1 if array.ndim == 1 else array.shape[1])
    made.SetVoidArray(array.reshape(-1), array.size, 1)
    keep_with(made, array)
    if name is not None:
        made.SetName(name)
    return made


def shared_ids(array):
    """A vtkTypeInt32Array or vtkTypeInt64Array over the memory of a NumPy array of such integers."""
    made = vtkTypeInt32Array() if array.dtype == np.int32 else vtkTypeInt64Array()
    made.SetVoidArray(array, len(array), 1)
    keep_with(made, array)
    return made


def add_arrays(attributes, arrays, count, what):
    """Adds {name: array} to the attributes of points or cells; each array has count values or tuples."""
    if arrays is not None and not isinstance(arrays, Mapping):
        raise TypeError(f"{what[:-1]}_data is a dict {{name: array}}, not {arrays!r}")
    for name, values in (arrays or {}).items():
        shown = f"the array {name!r} of {what}"
        array = numeric_array(with_nan(values, shown), shown)
        if array.ndim not in (1, 2) or len(array) != count:
            raise ValueError(f"the array {name!r} of {what} has the shape {array.shape}; it has to be ({count},) or "
                             f"({count}, components)")
        attributes.AddArray(shared_array(array, str(name)))
