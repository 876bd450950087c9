# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours by name, as numbers or as a list, and colour functions."""
import json
import os
from collections.abc import Sequence

from vtkmodules.vtkCommonColor import vtkNamedColors
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

from .checks import checked_items, checked_number, checked_numbers
from .opacities import places

STEPS = 32  # pieces of a colour map of Matplotlib's, which has 256 colours


def rgb(color, what="color"):
    """A colour as three numbers, 0 to 1: from a name ("slategray"), "#rrggbb", "#rgb" or three numbers.

    what: it is called so in errors.
    """
    if isinstance(color, str):
        names = vtkNamedColors()
        if color.startswith("#"):
            digits = color[1:]
            if len(digits) in (3, 6) and all(digit in "0123456789abcdefABCDEF" for digit in digits):
                width = len(digits) // 3
                return tuple(int(digits[i:i + width] * (2 // width), 16) / 255 for i in range(0, len(digits), width))
        elif names.ColorExists(color):
            return tuple(names.GetColor3d(color))
        raise ValueError(f"{what} is a name as in CSS, '#rrggbb' or three numbers, 0 to 1; there is no colour "
                         f"{color!r}")
    numbers = checked_numbers(color, 3, f"{what}, unless it is a text,")
    if not all(0 <= number <= 1 for number in numbers):
        raise ValueError(f"{what} is a text or three numbers, 0 to 1, not {color!r}")
    return tuple(map(float, numbers))


def plain(name):
    """The significant characters of a colour map's name."""
    return name.lower().replace("(matplotlib)", "").replace(" ", "")


def maps_of_ours():
    """The colour maps of the package, as dicts: the same as those of tetmarch-render."""
    with open(os.path.join(os.path.dirname(__file__), "color_maps.json"), encoding="utf-8") as file:
        return json.load(file)


def map_names():
    """Their names."""
    return [each["Name"] for each in maps_of_ours()]


def map_of_ours(name, low, high):
    """A colour map of the package, or None."""
    found = [each for each in maps_of_ours() if plain(each["Name"]) == plain(name)]
    if not found:
        return None
    numbers = found[0]["RGBPoints"]
    points = [numbers[i:i + 4] for i in range(0, len(numbers), 4)]
    first, last = points[0][0], points[-1][0]
    function = vtkColorTransferFunction()
    getattr(function, "SetColorSpaceTo" + found[0]["ColorSpace"])()
    function.SetNanColor(found[0]["NanColor"])
    for place, *color in points:
        function.AddRGBPoint(low + (high - low) * (place - first) / (last - first), *color)
    return function


def map_of_matplotlib(name, low, high):
    """A colour map of Matplotlib's."""
    try:
        import matplotlib
        from matplotlib import cm
    except ImportError:
        raise ValueError(f"cmap has no {name!r} here; with Matplotlib, which isn't installed, there are its "
                         "own. A list of colours or a vtkColorTransferFunction will do without") from None
    try:
        colors = matplotlib.colormaps[name] if hasattr(matplotlib, "colormaps") else cm.get_cmap(name)
    except (KeyError, ValueError):
        raise ValueError(f"cmap has no {name!r}: give a name of Matplotlib's ('viridis', 'plasma', "
                         "'coolwarm', ...), a list of colours or a vtkColorTransferFunction") from None
    return [colors(step / STEPS)[:3] for step in range(STEPS + 1)]


def is_pair(item):
    """Whether an item of a list is (value, colour), not a colour alone."""
    return isinstance(item, Sequence) and not isinstance(item, str) and len(item) == 2


def color_function(cmap, low, high):
    """A vtkColorTransferFunction: cmap itself; by name; or of a list, from the value low to the value high.

    A list has colours (see rgb()), spread evenly from low to high, or pairs (value, colour). Raises ValueError.
    """
    if isinstance(cmap, vtkColorTransferFunction):
        return cmap
    if isinstance(cmap, str):
        ours = map_of_ours(cmap, low, high)
        if ours is not None:
            return ours
        cmap = map_of_matplotlib(cmap, low, high)
    items = checked_items(cmap, "cmap is a name, a list of colours or a vtkColorTransferFunction")
    if not items:
        raise ValueError("cmap has no colours")
    function = vtkColorTransferFunction()
    for value, color in zip(places(len(items), low, high), items):
        if is_pair(color):
            value, color = checked_number(color[0], "the value of a colour of cmap"), color[1]
        function.AddRGBPoint(float(value), *rgb(color, "each colour of cmap"))
    return function
