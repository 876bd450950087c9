# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Complete volumes in one call."""
from numbers import Real

from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput
from vtkmodules.vtkRenderingCore import vtkVolume

from .checks import checked_items, checked_number, checked_numbers, checked_positive
from .colors import color_function
from .first_picture import choose_first_picture
from .inputs import drawn_data, is_structured, vtk_data
from .opacities import piecewise_function
from .properties import set_properties
from .vtkRenderingTetMarch import vtkTetMarchSmartVolumeMapper, vtkTetMarchVolumeMapper


def connect(mapper, source, data):
    """Sets the mapper's input: an algorithm's output stays connected, so that upstream changes take effect."""
    if isinstance(source, vtkAlgorithm):
        source = source.GetOutputPort()
    if isinstance(source, vtkAlgorithmOutput) and vtk_data(source) is data:
        mapper.SetInputConnection(source)
    else:
        mapper.SetInputDataObject(data)


def plane_of(plane):
    """A vtkPlane: itself, or of (a point on it, the normal towards the kept side)."""
    if isinstance(plane, vtkPlane):
        return plane
    try:
        point, normal = plane
    except (TypeError, ValueError):
        raise TypeError(f"each of clipping_planes is a vtkPlane or (point, normal), not {plane!r}") from None
    made = vtkPlane()
    made.SetOrigin(*checked_numbers(point, 3, "the point of each of clipping_planes"))
    made.SetNormal(*checked_numbers(normal, 3, "the normal of each of clipping_planes"))
    if not any(normal):
        raise ValueError(f"the normal of each of clipping_planes has a direction, unlike {normal!r}")
    return made


def set_special(drawn, name, value):
    """Sets a property without Set...() in VTK; returns whether it is one."""
    of_volume = drawn.GetProperty()
    if name == "clipping_planes":
        planes = [plane_of(plane) for plane in
                  checked_items(value, "clipping_planes is a list of vtkPlane or (point, normal)")]
        drawn.GetMapper().RemoveAllClippingPlanes()
        for plane in planes:
            drawn.GetMapper().AddClippingPlane(plane)
    elif name == "isosurface_values":
        values = [value] if isinstance(value, Real) else checked_items(value, "isosurface_values is a list of values")
        values = [float(checked_number(each, "each of isosurface_values")) for each in values]
        of_volume.GetIsoSurfaceValues().SetNumberOfContours(len(values))
        for i, each in enumerate(values):
            of_volume.GetIsoSurfaceValues().SetValue(i, each)
    elif name == "gradient_opacity":
        of_volume.SetGradientOpacity(piecewise_function(value, 0.0, 1.0, name))
    else:
        return False
    return True


def configure(drawn, **properties):
    """Sets properties of a vtkVolume made by volume(), with the names of its arguments. Returns the volume."""
    if not isinstance(drawn, vtkVolume):
        raise TypeError(f"configure() takes a vtkVolume that volume() made, not {drawn!r}")
    mapper = drawn.GetMapper()
    if not hasattr(mapper, "GetSettings"):
        raise TypeError("the vtkVolume has no mapper of TetMarch: volume() makes one that has")
    rest = {name: value for name, value in properties.items() if not set_special(drawn, name, value)}
    set_properties((mapper, mapper.GetSettings(), drawn.GetProperty(), drawn), rest)
    return drawn


def volume(data, array=None, *, association=None, component=None, cmap=None, opacity=None, range=None,
           unit_distance=None, **properties):
    """A complete vtkVolume. Parameters not given are chosen as by auto_transfer_functions().

    data: unstructured grids, images, rectilinear and curvilinear grids, trees of such blocks; PyVista's data; a NumPy
        array (x, y, z) or (x, y, z, components), see from_image(); an xarray.DataArray of three dimensions, by its
        coordinates; a meshio.Mesh; an algorithm of VTK, which stays connected; or the path of a file, see read().
        Images and rectilinear grids, and trees of these alone, get a vtkTetMarchSmartVolumeMapper, all others a
        vtkTetMarchVolumeMapper.
    array: its name. association: "points" or "cells". component: from 0, or "magnitude".
    cmap: a vtkColorTransferFunction; the name of a colour map; a list of colours, spread evenly over the range, or of
        (value, colour). A colour is a name, "#rrggbb" or three numbers, 0 to 1.
    opacity: a vtkPiecewiseFunction; a number, 0 to 1, for all values; a list of numbers, spread evenly over the range;
        pairs (value, opacity); a function of a value that returns an opacity, called for 257 values of the range; or
        "linear": from 0 at the low end of the range to 1 at the high one.
    range: (low, high), low < high, in the array's unit.
    unit_distance: above 0, in units of the data's coordinates: the thickness to which an opacity refers.
    properties: any property of the mapper, its vtkTetMarchSettings, the vtkVolumeProperty or the vtkVolume, by VTK's
        name in snake case: accuracy_level="accurate", error_tolerance=1e-3, shade=True, shadow_method="automatic",
        blend_mode="maximum", pickable=False. Enumerations by a word or the beginning of one. Also clipping_planes: a
        list of vtkPlane or (point, normal), whose normal points to the kept side; isosurface_values: a list of values;
        gradient_opacity: like opacity, over the length of the gradient.

    Raises ValueError for arrays that the data lack (with a list of existing ones) and values out of range, TypeError
    for unknown properties (with the most similar ones) and for data without a volume.
    """
    if unit_distance is not None:
        checked_positive(unit_distance, "unit_distance")
    drawn_from = drawn_data(data)
    structured = is_structured(drawn_from)
    mapper = vtkTetMarchSmartVolumeMapper() if structured else vtkTetMarchVolumeMapper()
    connect(mapper, data, drawn_from)
    made = vtkVolume()
    made.SetMapper(mapper)
    first = choose_first_picture(drawn_from, array, association, component, range)
    first.ApplyTo(made)
    shown = made.GetProperty()
    low, high = first.GetChosenRange()
    if opacity is not None:
        function = piecewise_function(opacity, low, high)
        shown.SetScalarOpacity(function)
        if unit_distance is None and first.ChooseUnitDistance(function):
            shown.SetScalarOpacityUnitDistance(first.GetUnitDistance())
    if cmap is not None:
        shown.SetColor(color_function(cmap, low, high))
    if unit_distance is not None:
        shown.SetScalarOpacityUnitDistance(unit_distance)
    return configure(made, **properties)
