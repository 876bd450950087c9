# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Opacity functions from numbers, lists and words."""
from numbers import Real

from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction


def piecewise_function(what, low, high, largest=1.0):
    """A vtkPiecewiseFunction: as it is; a number, for all values; (value, opacity) pairs; "linear": from 0 to 1.

    Raises ValueError for an opacity below 0 or above `largest`, and for other words.
    """
    if isinstance(what, vtkPiecewiseFunction):
        return what
    if what == "linear" and isinstance(what, str):
        pairs = [(low, 0.0), (high, 1.0)]
    elif isinstance(what, str):
        raise ValueError(f"opacity is 'linear', a number, (value, opacity) pairs or a vtkPiecewiseFunction, "
                         f"not {what!r}")
    elif isinstance(what, Real):
        pairs = [(low, what)]
    else:
        pairs = [tuple(pair) for pair in what]
    if not pairs or any(len(pair) != 2 for pair in pairs):
        raise ValueError("opacity as a list has pairs (value, opacity), at least one")
    function = vtkPiecewiseFunction()
    for value, opacity in pairs:
        if not 0 <= opacity <= largest:
            raise ValueError(f"an opacity is 0 to {largest:g}, not {opacity!r}")
        function.AddPoint(float(value), float(opacity))
    return function
