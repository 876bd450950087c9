# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks of arguments. Errors contain the argument's name."""
import math
import os
from numbers import Integral, Real


def checked_number(value, what):
    """A finite number. Raises TypeError for other types, ValueError for NaN and infinity."""
    if not isinstance(value, Real):
        raise TypeError(f"{what} is a number, not {value!r}")
    if not math.isfinite(value):
        raise ValueError(f"{what} is a finite number, not {value!r}")
    return value


def checked_positive(value, what):
    """A finite number above 0."""
    if not checked_number(value, what) > 0:
        raise ValueError(f"{what} is above 0, not {value!r}")
    return value


def checked_integer(value, what):
    """An integer of Python or NumPy; True and False are not accepted."""
    if not isinstance(value, Integral) or isinstance(value, bool):
        raise TypeError(f"{what} is an integer, not {value!r}")
    return int(value)


def checked_items(value, what):
    """A list of an iterable, except texts."""
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError
        return list(value)
    except TypeError:
        raise TypeError(f"{what}, not {value!r}") from None


def checked_numbers(value, count, what):
    """A tuple of `count` finite numbers."""
    items = checked_items(value, f"{what} has {count} numbers")
    if len(items) != count:
        raise ValueError(f"{what} has {count} numbers, not {len(items)}: {value!r}")
    return tuple(checked_number(item, f"each of the {count} numbers of {what}") for item in items)


def checked_range(value):
    """(low, high) with low < high."""
    low, high = checked_numbers(value, 2, "range (low, high)")
    if not low < high:
        raise ValueError(f"range is (low, high) with low < high, not {value!r}")
    return low, high


def checked_size(value):
    """(width, height) of a picture."""
    size = checked_numbers(value, 2, "size (width, height)")
    if not all(side == int(side) and 1 <= side <= 16384 for side in size):
        raise ValueError(f"size is (width, height) in pixels, integers from 1 to 16384, not {value!r}")
    return int(size[0]), int(size[1])


def checked_word(value, words, what):
    """One of the words; None may be one of them."""
    if not isinstance(value, (str, type(None))) or value not in words:
        *some, last = map(repr, words)
        raise ValueError(f"{what} is {', '.join(some)} or {last}, not {value!r}")
    return value


def checked_text(value, what):
    """A text."""
    if not isinstance(value, str):
        raise TypeError(f"{what}, not {value!r}")
    return value


def checked_path(value, what):
    """The path of a file, as a text."""
    if not isinstance(value, (str, bytes, os.PathLike)):
        raise TypeError(f"{what} is the path of a file, not {value!r}")
    return os.fsdecode(value)


def checked_flag(value, what):
    """True or False, of Python or NumPy, or 1 or 0."""
    if not type(value).__name__.startswith("bool") and not (isinstance(value, Integral) and value in (0, 1)):
        raise TypeError(f"{what} is True or False, not {value!r}")
    return bool(value)
