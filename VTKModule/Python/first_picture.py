# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Default transfer functions for data."""
from numbers import Integral
from typing import NamedTuple

from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import VTK_SCALAR_MODE_USE_CELL_FIELD_DATA, vtkColorTransferFunction

from .checks import checked_flag, checked_range, checked_text, checked_word
from .errors import VtkErrors
from .vtkRenderingTetMarch import vtkTetMarchFirstPicture, vtkTetMarchVolumeMapper

ASSOCIATIONS = {"points": vtkTetMarchFirstPicture.POINTS, "cells": vtkTetMarchFirstPicture.CELLS,
                None: vtkTetMarchFirstPicture.ANY}


class TransferFunctions(NamedTuple):
    """The result of auto_transfer_functions()."""

    color: vtkColorTransferFunction
    opacity: vtkPiecewiseFunction
    unit_distance: float  # in units of the data's coordinates, above 0
    array: str
    association: str  # "points" or "cells"
    component: int  # -1: the magnitude
    range: tuple  # of the values that are shown: (low, high), low < high


def component_number(component):
    """Of a vtkTetMarchFirstPicture: -1 for the magnitude."""
    if isinstance(component, str) and component == "magnitude":
        return -1
    if not isinstance(component, Integral) or isinstance(component, bool) or component < 0:
        raise ValueError(f"component is a number from 0, 'magnitude' or None, not {component!r}")
    return int(component)


def succeed(choose):
    """Calls a method of a vtkTetMarchFirstPicture. Its error becomes a ValueError."""
    with VtkErrors() as errors:
        done = choose()
    if not done:
        raise ValueError(str(errors))


def choose_array(data, array=None, association=None, component=None):
    """A vtkTetMarchFirstPicture that has chosen an array; the parameters are those of auto_transfer_functions()."""
    first = vtkTetMarchFirstPicture()
    if data is not None and not isinstance(data, vtkDataObject):
        raise TypeError(f"data is a vtkDataObject, not {data!r}")
    first.SetInputData(data)
    first.SetArrayName("" if array is None else checked_text(array, "array is a name"))
    first.SetArrayAssociation(ASSOCIATIONS[checked_word(association, ASSOCIATIONS, "association")])
    if component is not None:
        first.SetComponent(component_number(component))
    succeed(first.ChooseArray)
    return first


def choose_first_picture(data, array=None, association=None, component=None, range=None, structured_law=None):
    """A vtkTetMarchFirstPicture that has chosen; the parameters are those of auto_transfer_functions()."""
    first = choose_array(data, array, association, component)
    if range is not None:
        first.SetRange(*checked_range(range))
    if structured_law is not None:
        structured = checked_flag(structured_law, "structured_law, unless it is None,")
        first.SetOpacityLaw(first.STRUCTURED if structured else first.UNSTRUCTURED)
    succeed(first.ChooseTransferFunctions)
    return first


def auto_transfer_functions(data, array=None, association=None, component=None, range=None, structured_law=None):
    """Transfer functions and a unit distance with which a picture is neither empty nor opaque throughout.

    data: a vtkUnstructuredGrid, vtkImageData, vtkRectilinearGrid or vtkStructuredGrid, or a tree of such blocks.
    array: its name; None: physical values before numbers of cells or blocks, points before cells.
    association: "points", "cells" or None: points, then cells.
    component: from 0, or "magnitude"; None: the first of an array with a name, else the magnitude.
    range: (low, high) of the values to show; None: the 2nd to the 98th percentile.
    structured_law: the opacity law, see vtkTetMarchSettings.SetOpacityLaw; None: as in mappers for such data.

    Needs no window and no OpenGL. The result is deterministic; see vtkTetMarchFirstPicture. Raises ValueError if there
    is no such array. Returns a TransferFunctions.
    """
    first = choose_first_picture(data, array, association, component, range, structured_law)
    color = vtkColorTransferFunction()
    color.DeepCopy(first.GetColor())
    opacity = vtkPiecewiseFunction()
    opacity.DeepCopy(first.GetOpacity())
    where = "cells" if first.GetChosenAssociation() == first.CELLS else "points"
    return TransferFunctions(color, opacity, first.GetUnitDistance(), first.GetChosenArray().GetName(), where,
                             first.GetChosenComponent(), first.GetChosenRange())


def first_picture_of(volume):
    """A vtkTetMarchFirstPicture of a volume's data that has chosen the volume's array and component."""
    mapper = volume.GetMapper()
    if mapper.GetNumberOfInputConnections(0):
        mapper.GetInputAlgorithm().Update()
    data = mapper.GetInputDataObject(0, 0)
    if data is None:
        raise ValueError("the volume's mapper has no input")
    named = mapper.GetArrayAccessMode() == 1  # VTK_GET_ARRAY_BY_NAME
    component = None
    if named and hasattr(mapper, "GetVectorMode"):
        component = {vtkTetMarchVolumeMapper.MAGNITUDE: "magnitude",
                     vtkTetMarchVolumeMapper.COMPONENT: mapper.GetVectorComponent()}.get(mapper.GetVectorMode())
    where = "cells" if mapper.GetScalarMode() == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA else None
    return choose_array(data, mapper.GetArrayName() if named else None, where, component)
