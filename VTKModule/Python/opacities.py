# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Opacity functions from numbers, lists and words."""
from numbers import Real

from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction

from .checks import checked_items, checked_number, checked_numbers

FORMS = "'linear', a number, (value, opacity) pairs or a vtkPiecewiseFunction"


def piecewise_function(what, low, high, name="opacity"):
    """A vtkPiecewiseFunction: itself; a number, for all values; (value, opacity) pairs; "linear": from 0 to 1.

    name: that of the argument. Raises ValueError for an opacity below 0 or above 1, and for other words, TypeError for
    other types.
    """
    if isinstance(what, vtkPiecewiseFunction):
        return what
    if isinstance(what, str):
        if what != "linear":
            raise ValueError(f"{name} is {FORMS}, not {what!r}")
        pairs = [(low, 0.0), (high, 1.0)]
    elif isinstance(what, Real):
        pairs = [(low, what)]
    else:
        pairs = checked_items(what, f"{name} is {FORMS}")
        if not pairs:
            raise ValueError(f"{name} as a list has pairs (value, opacity), at least one")
    function = vtkPiecewiseFunction()
    for pair in pairs:
        value, opacity = checked_numbers(pair, 2, f"a pair (value, opacity) of {name}")
        if not 0 <= checked_number(opacity, name) <= 1:
            raise ValueError(f"{name} is 0 to 1, not {opacity!r}")
        function.AddPoint(float(value), float(opacity))
    return function
