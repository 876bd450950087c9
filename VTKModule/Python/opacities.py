# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Opacity functions from numbers, lists, words and functions."""
from numbers import Real

from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction

from .checks import checked_items, checked_number, checked_numbers

FORMS = ("'linear', a number, a list of numbers or of (value, opacity) pairs, a function of a value or a "
         "vtkPiecewiseFunction")
STEPS = 256  # pieces of a function of Python's


def places(count, low, high):
    """Values spread evenly from low to high."""
    return [low + (high - low) * i / max(count - 1, 1) for i in range(count)]


def nodes_of(function):
    """(value, opacity) pairs of a vtkPiecewiseFunction."""
    pairs, node = [], [0.0] * 4
    for i in range(function.GetSize()):
        function.GetNodeValue(i, node)
        pairs.append((node[0], node[1]))
    return pairs


def sampled(function, low, high, name):
    """(value, opacity) pairs of a function of a value."""
    pairs = []
    for value in places(STEPS + 1, low, high):
        found = function(value)
        if getattr(found, "size", 0) == 1:
            found = found.item()  # of NumPy
        if not isinstance(found, Real):
            raise TypeError(f"{name} as a function returns a number, not {found!r} of {value!r}")
        pairs.append((value, found))
    return pairs


def pairs_of(what, low, high, name):
    """(value, opacity) pairs of what piecewise_function() takes, opacities not yet checked."""
    if isinstance(what, str):
        if what != "linear":
            raise ValueError(f"{name} is {FORMS}, not {what!r}")
        return [(low, 0.0), (high, 1.0)]
    if isinstance(what, Real):
        return [(low, what)]
    if callable(what):
        return sampled(what, low, high, name)
    items = checked_items(what, f"{name} is {FORMS}")
    if not items:
        raise ValueError(f"{name} as a list has numbers or pairs (value, opacity), at least one")
    if isinstance(items[0], Real):
        return [(value, checked_number(item, f"each of {name}, as the first one,"))
                for value, item in zip(places(len(items), low, high), items)]
    return items


def piecewise_function(what, low, high, name="opacity"):
    """A vtkPiecewiseFunction: itself; a number, for all values; numbers, spread evenly from low to high; (value,
    opacity) pairs; a function of a value, which is called for 257 values from low to high; "linear": from 0 to 1.

    name: that of the argument. Raises ValueError for an opacity below 0 or above 1, and for other words, TypeError for
    other types.
    """
    if isinstance(what, vtkPiecewiseFunction):
        return what
    function = vtkPiecewiseFunction()
    for pair in pairs_of(what, low, high, name):
        value, opacity = checked_numbers(pair, 2, f"a pair (value, opacity) of {name}")
        if not 0 <= checked_number(opacity, name) <= 1:
            raise ValueError(f"{name} is 0 to 1, not {opacity!r}")
        function.AddPoint(float(value), float(opacity))
    return function
