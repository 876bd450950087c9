# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a volume draws, in words."""
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkRenderingCore import (VTK_SCALAR_MODE_DEFAULT, VTK_SCALAR_MODE_USE_CELL_DATA,
                                         VTK_SCALAR_MODE_USE_CELL_FIELD_DATA, VTK_SCALAR_MODE_USE_POINT_DATA)

from .inputs import blocks_of
from .vtkRenderingTetMarch import vtkTetMarchFrameStatistics, vtkTetMarchVolumeMapper

OF_CELLS = VTK_SCALAR_MODE_USE_CELL_DATA, VTK_SCALAR_MODE_USE_CELL_FIELD_DATA
ACTIVE = VTK_SCALAR_MODE_DEFAULT, VTK_SCALAR_MODE_USE_POINT_DATA, VTK_SCALAR_MODE_USE_CELL_DATA


def drawn_array(volume):
    """(the array that a volume draws, in the first block that has it; "points" or "cells"), or (None, None)."""
    mapper = volume.GetMapper()
    data = mapper.GetInputDataObject(0, 0)
    mode = mapper.GetScalarMode()
    for block in blocks_of(data) if isinstance(data, vtkCompositeDataSet) else [data] if data is not None else []:
        for attributes, where in ((block.GetPointData(), "points"), (block.GetCellData(), "cells")):
            if mode != VTK_SCALAR_MODE_DEFAULT and (mode in OF_CELLS) != (where == "cells"):
                continue
            key = mapper.GetArrayName() if mapper.GetArrayAccessMode() else mapper.GetArrayId()
            array = attributes.GetScalars() if mode in ACTIVE else attributes.GetArray(key)
            if array is not None:
                return array, where
    return None, None


def array_title(volume):
    """The name of the drawn array, and of its component if it has several."""
    array, _ = drawn_array(volume)
    if array is None:
        return ""
    name, mapper = array.GetName() or "values", volume.GetMapper()
    if array.GetNumberOfComponents() == 1 or mapper.GetVectorMode() == vtkTetMarchVolumeMapper.DISABLED:
        return name
    if mapper.GetVectorMode() == vtkTetMarchVolumeMapper.MAGNITUDE:
        return name + " (magnitude)"
    return f"{name} (component {mapper.GetVectorComponent()})"


def describe_frame(mapper):
    """The last frame's seconds and error, or "" before the first one."""
    frame = mapper.GetLastFrameStatistics()
    if not frame.GetSeconds() > 0:
        return ""
    bound, tolerance = vtkTetMarchFrameStatistics.ERROR_BOUND, frame.GetUsedErrorTolerance()
    error = "no error bound"
    if frame.GetNumberOfPixels(bound) > 0:
        error = f"error at most {frame.GetMaximum(bound):.2g}"
    elif tolerance > 0:
        error = f"error tolerance {tolerance:.2g}"
    return f"; last frame {frame.GetSeconds():.2g} s, {error}"


def describe(volume):
    """A line of a volume: array, range of its colours, unit distance, and after a frame its seconds and error."""
    _, where = drawn_array(volume)
    of_volume = volume.GetProperty()
    low, high = of_volume.GetRGBTransferFunction().GetRange()
    ours = hasattr(volume.GetMapper(), "GetLastFrameStatistics")
    array = f"{array_title(volume)} on {where}" if where else "no array"
    return (f"{array}, {low:.4g} to {high:.4g}, unit distance {of_volume.GetScalarOpacityUnitDistance():.4g}"
            + (describe_frame(volume.GetMapper()) if ours else ""))
