# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images from NumPy arrays of three dimensions."""
import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData

from .checks import checked_numbers, checked_positive, checked_text, checked_word
from .shared_arrays import numeric_array, shared_array, with_nan

COMPONENTS = 4  # at most: colours with an opacity


def flat_values(array, axes, name, what="array"):
    """A vtkDataArray of (x, y, z) or (x, y, z, components) values, x fastest; shared if their memory has this order.

    axes: the array's first three dimensions, as a text: "xyz" or another order of these letters.
    """
    values = with_nan(array, what)
    if values.ndim not in (3, 4) or values.ndim == 4 and not 1 <= values.shape[3] <= COMPONENTS:
        raise ValueError(f"{what} has the shape {values.shape}; a volume has three dimensions, as (x, y, z), or a "
                         f"fourth one of 1 to {COMPONENTS} components")
    order = [axes.index(letter) for letter in "zyx"] + [3] * (values.ndim - 3)
    values = numeric_array(values.transpose(order), what)
    return shared_array(values.reshape(-1, *values.shape[3:]), name)


def from_image(array, spacing=(1, 1, 1), origin=(0, 0, 0), *, axes="xyz", association="points", name="values"):
    """A vtkImageData of a NumPy array of three dimensions.

    array: numbers, (x, y, z): array[i, j, k] is i steps along x, j along y and k along z, as in PyVista; or
        (x, y, z, components), 1 to 4 components.
    spacing: the three steps along x, y and z, above 0, in units of the world. origin: x, y and z of the first value.
    axes: the order of the array's dimensions: "xyz", or another order of these letters: "zyx" for array[k, j, i], as
        in scikit-image, SimpleITK's arrays and most files. spacing and origin are those of x, y and z all the same.
    association: "points": values between which is interpolated, at least 2 along each dimension; "cells": voxels of one
        value each, at least 1, where origin is the first voxel's lower corner.
    name: that of the array in the image.

    Memory is shared, not copied, if x is the fastest dimension in it: arrays in Fortran order, or in C order with
    axes="zyx", of integers and floats of 8 to 64 bits. It lives as long as the image needs it. After a change of a
    shared array call Modified() of the image's array and of the image. Masked values become NaN, which is not drawn.

    Raises ValueError for wrong shapes and numbers, TypeError for other values than numbers.
    """
    return make_image(array, spacing, origin, axes, association, name)


def make_image(array, spacing=(1, 1, 1), origin=(0, 0, 0), axes="xyz", association="points", name="values",
               what="array"):
    """from_image(); what: the array is called so in errors."""
    if not isinstance(axes, str) or sorted(axes) != ["x", "y", "z"]:
        raise ValueError(f"axes is 'xyz', 'zyx' or another order of these letters, not {axes!r}")
    of_points = checked_word(association, ("points", "cells"), "association") == "points"
    spacing = checked_numbers(spacing, 3, "spacing")
    for step in spacing:
        checked_positive(step, "spacing")
    origin = checked_numbers(origin, 3, "origin")
    values = flat_values(array, axes, checked_text(name, "name is a text"), what)
    shape = np.shape(array)
    least = 2 if of_points else 1
    if min(shape[:3]) < least:
        raise ValueError(f"{what} has the shape {shape}; along each of its three dimensions it has at least {least} of "
                         f"an image's {association}")
    image = vtkImageData()
    image.SetDimensions(*(shape[axes.index(letter)] + (not of_points) for letter in "xyz"))
    image.SetSpacing(spacing)
    image.SetOrigin(origin)
    (image.GetPointData() if of_points else image.GetCellData()).SetScalars(values)
    return image
