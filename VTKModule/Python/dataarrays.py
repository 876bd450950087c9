# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images and grids from an xarray.DataArray."""
import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkRectilinearGrid, vtkStructuredGrid

from .images import flat_values, make_image
from .shared_arrays import shared_array

# The axis of a coordinate: by its attribute `axis`, else by one of these as its standard name or in its own name.
NAMES = {"x": {"x", "i", "lon", "longitude", "xlong", "grid_longitude", "projection_x_coordinate"},
         "y": {"y", "j", "lat", "latitude", "xlat", "grid_latitude", "projection_y_coordinate"},
         "z": {"z", "k", "lev", "level", "depth", "height", "altitude"}}
ROUNDING = 1e-6  # of a step, of coordinates that are evenly spaced


def letter_of(name, coordinate):
    """The axis of a dimension or coordinate: "x", "y", "z", or None if neither attributes nor name tell."""
    attributes = getattr(coordinate, "attrs", {})
    axis = str(attributes.get("axis", "")).lower()
    if axis in NAMES:
        return axis
    words = {str(attributes.get("standard_name", "")), *str(name).lower().split("_")}
    found = [letter for letter, names in NAMES.items() if names & words]
    return found[0] if len(found) == 1 else None


def dimensions_of(data):
    """{"z": a dimension, "y": ..., "x": ...} of a DataArray of three dimensions."""
    found = {}
    for dim in data.dims:
        letter = letter_of(dim, data.coords[dim] if dim in data.coords else None)
        if letter is not None:
            found.setdefault(letter, dim)
    rest = iter([letter for letter in "zyx" if letter not in found])
    found.update({next(rest): dim for dim in data.dims if dim not in list(found.values())})
    return {letter: found[letter] for letter in "zyx"}


def coordinate_of(data, letter, dim):
    """(dimensions, numbers) of an axis: the coordinate of most dimensions; without one, numbers from 0."""
    found = {name: each for name, each in data.coords.items() if each.dims and set(each.dims) <= set(data.dims) and (
        name == dim or name not in data.dims and letter_of(name, each) == letter
        and (len(each.dims) > 1 or tuple(each.dims) == (dim,)))}
    most = max((len(each.dims) for each in found.values()), default=0)
    found = {name: each for name, each in found.items() if len(each.dims) == most}
    if not found:
        return (dim,), np.arange(data.values.shape[data.dims.index(dim)], dtype=float)
    if len(found) > 1 and dim not in found:
        raise ValueError(f"the DataArray has several coordinates of {letter}: {', '.join(map(repr, found))}; leave "
                         "only one by .drop_vars()")
    name = dim if dim in found else next(iter(found))
    values = np.asarray(found[name].values)
    if values.dtype.kind not in "iuf" or not np.isfinite(values).all():
        raise ValueError(f"the coordinate {name!r} has the type {values.dtype}, or values that aren't finite; those of "
                         f"a volume are finite numbers: .drop_vars({name!r}) makes it numbers from 0")
    return tuple(found[name].dims), values


def is_even(places):
    """Whether coordinates are evenly spaced, but for rounding."""
    step = (places[-1] - places[0]) / (len(places) - 1)
    exact = places[0] + step * np.arange(len(places))
    rounding = np.finfo(places.dtype).eps if places.dtype.kind == "f" else 0.0
    return bool(np.abs(places - exact).max() <= ROUNDING * abs(step) + 2 * rounding * np.abs(places).max())


def lattice(values, places, name):
    """An image or a rectilinear grid of (z, y, x) values at three arrays of increasing or decreasing coordinates."""
    for axis, each in enumerate(places):
        steps = np.diff(each)
        if (steps < 0).all():
            values, places[axis] = np.flip(values, axis), each[::-1]
        elif not (steps > 0).all():
            raise ValueError(f"the coordinates of {'zyx'[axis]} neither rise nor fall throughout")
    x, y, z = (np.ascontiguousarray(each, np.float64) for each in reversed(places))
    if all(map(is_even, places)):
        return make_image(values, [(each[-1] - each[0]) / (len(each) - 1) for each in (x, y, z)],
                          (x[0], y[0], z[0]), axes="zyx", name=name, what="data")
    grid = vtkRectilinearGrid()
    grid.SetDimensions(len(x), len(y), len(z))
    grid.SetXCoordinates(shared_array(x))
    grid.SetYCoordinates(shared_array(y))
    grid.SetZCoordinates(shared_array(z))
    grid.GetPointData().SetScalars(flat_values(values, "zyx", name, "data"))
    return grid


def curvilinear(values, places, dims, name):
    """A vtkStructuredGrid of (z, y, x) values; places: (dimensions, numbers) for z, y and x; dims: of the values."""
    points = np.empty((*values.shape, 3), np.result_type(np.float32, *(each for _, each in places)))
    for component, (own, numbers) in enumerate(reversed(places)):
        order = [dim for dim in dims if dim in own]
        numbers = numbers.transpose([own.index(dim) for dim in order])
        points[..., component] = numbers.reshape([n if dim in own else 1 for dim, n in zip(dims, values.shape)])
    grid = vtkStructuredGrid()
    grid.SetDimensions(*reversed(values.shape))
    made = vtkPoints()
    made.SetData(shared_array(points.reshape(-1, 3)))
    grid.SetPoints(made)
    grid.GetPointData().SetScalars(flat_values(values, "zyx", name, "data"))
    return grid


def from_dataarray(data):
    """Data of VTK from an xarray.DataArray of numbers with three dimensions, others of length 1 left out.

    Dimensions and coordinates are x, y and z by the attribute `axis` or `standard_name`, or by a name such as "lon",
    "lat_rho", "depth"; other dimensions are, in their order, what is left of z, y, x. With coordinates of one dimension
    it is a vtkImageData if all are evenly spaced, else a vtkRectilinearGrid; with coordinates of two or three it is a
    vtkStructuredGrid, whatever other coordinates there are. Units are not converted. Memory of values is shared as by
    from_image(), if no coordinate falls.

    Raises ValueError or TypeError for other dimensions, coordinates and values.
    """
    if len(data.dims) > 3:
        sizes = dict(zip(data.dims, data.shape))
        data = data.isel({dim: 0 for dim in data.dims if sizes[dim] == 1})
    if len(data.dims) != 3:
        raise ValueError(f"the DataArray has the dimensions {tuple(data.dims)}; a volume has three: choose of others, "
                         "as by .isel(time=0)")
    found = dimensions_of(data)
    dims = list(found.values())
    values = data.values.transpose([data.dims.index(dim) for dim in dims])
    if min(values.shape) < 2:
        raise ValueError(f"the DataArray has the shape {data.values.shape}; a volume has at least 2 values along each "
                         "dimension")
    places = [coordinate_of(data, letter, dim) for letter, dim in found.items()]
    name = "values" if data.name is None else str(data.name)
    if all(len(own) == 1 for own, _ in places):
        return lattice(values, [numbers for _, numbers in places], name)
    return curvilinear(values, places, dims, name)
