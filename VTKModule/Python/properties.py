# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sets properties of VTK's objects by Python names: accuracy_level="accurate"."""
import contextlib
import difflib
import math
from collections.abc import Iterable
from numbers import Real

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from .errors import VtkErrors


NOT_NEGATIVE = ("Ambient", "Diffuse", "Specular", "SpecularPower")
POSITIVE = ("ScalarOpacityUnitDistance",)


def setters(target):
    """The methods of an object that set one property each, by the property's name in small letters."""
    return {name[3:].lower(): name[3:] for name in dir(type(target)) if name.startswith("Set") and len(name) > 3}


def snake_case(name):
    """AverageIPScalarRange -> average_ip_scalar_range."""
    letters = []
    for i, letter in enumerate(name):
        begins = letter.isupper() and i > 0 and (
            not name[i - 1].isupper() or (i + 1 < len(name) and name[i + 1].islower()))
        letters.append("_" + letter.lower() if begins else letter.lower())
    return "".join(letters)


def is_word_of(name, names):
    """Whether a property's name consists of another one and a value: accuracyleveltofast."""
    return any(name.startswith(other + "to") and name != other for other in names)


def property_names(targets):
    """The names that set_properties() accepts for these objects."""
    found = {}
    for target in targets:
        names = setters(target)
        for small, name in names.items():
            if not is_word_of(small, names) and hasattr(target, "Get" + name):
                found.setdefault(small, snake_case(name))
    return sorted(found.values())


def words_of(target, name):
    """The words of an enumeration: {"fast": "SetAccuracyLevelToFast", ...}."""
    begin = f"Set{name}To"
    return {method[len(begin):].lower(): method for method in dir(type(target)) if method.startswith(begin)}


def set_word(target, name, word, shown):
    words = words_of(target, name)
    wanted = word.lower().replace("_", "").replace(" ", "").replace("-", "")
    fitting = [wanted] if wanted in words else [known for known in words if known.startswith(wanted)]
    if len(fitting) == 1:
        getattr(target, words[fitting[0]])()
        return
    if not words:
        raise TypeError(f"{shown} takes no word; it was given {word!r}")
    known = sorted(snake_case(method[len(f"Set{name}To"):]) for method in words.values())
    raise ValueError(f"{shown} has no {word!r}; it has {', '.join(map(repr, known))}")


def numbers_of(target, name):
    """The numbers of an enumeration with their words, {0: "fast", ...}; empty for sums of flags."""
    words = {} if name.endswith("Flags") else words_of(target, name)
    made, found = target.NewInstance(), {}
    for method in words.values():
        getattr(made, method)()
        found.setdefault(getattr(made, "Get" + name)(), snake_case(method[len(f"Set{name}To"):]))
    return dict(sorted(found.items()))


def check_number(target, name, value, shown):
    """Raises ValueError for numbers that VTK's method takes although they mean nothing."""
    may_be = ""
    numbers = numbers_of(target, name)
    if numbers and value not in numbers:
        may_be = ", ".join(f"{number} ({word!r})" for number, word in numbers.items())
    elif hasattr(target, name + "On") and value not in (0, 1):
        may_be = "0 or 1"
    elif name in NOT_NEGATIVE and value < 0:
        may_be = "0 or more"
    elif name in POSITIVE and value <= 0:
        may_be = "above 0"
    if may_be:
        raise ValueError(f"{shown} can't be {value!r}: it is {may_be}")


def is_list(value):
    return isinstance(value, Iterable) and not isinstance(value, (str, bytes))


def differs(wanted, got):
    """Whether a property was clamped."""
    if isinstance(wanted, Real) and isinstance(got, Real):
        return not math.isclose(wanted, got, rel_tol=1e-6, abs_tol=1e-12)
    return False


def set_property(target, name, value, shown):
    if isinstance(value, str) and (words_of(target, name) or isinstance(getattr(target, "Get" + name)(), Real)):
        set_word(target, name, value, shown)
        return
    if any(isinstance(number, Real) and math.isnan(number) for number in (value if is_list(value) else [value])):
        raise ValueError(f"{shown} can't be {value!r}: it is not a number")
    if isinstance(value, Real):
        check_number(target, name, value, shown)
    try:
        before = getattr(target, "Get" + name)()
        with VtkErrors() as errors:
            getattr(target, "Set" + name)(value)
    except TypeError as error:
        raise TypeError(f"{shown} can't be {value!r}: {error}") from None
    if errors:
        raise ValueError(f"{shown} can't be {value!r}: {errors}")
    got = getattr(target, "Get" + name)()
    if differs(value, got):
        getattr(target, "Set" + name)(before)
        raise ValueError(f"{shown} can't be {value!r}: the nearest is {got!r}")


def copy_properties(source, target):
    """Sets each property of `source` that is a number, a text or a list of these on an object of the same class."""
    for name in setters(source).values():
        if hasattr(source, "Get" + name) and not hasattr(vtkAlgorithm, "Set" + name):
            with contextlib.suppress(TypeError):  # a property that takes an index
                value = getattr(source, "Get" + name)()
                if isinstance(value, (Real, str, tuple)) and value != getattr(target, "Get" + name)():
                    getattr(target, "Set" + name)(value)


def set_properties(targets, properties):
    """Sets each property on the first of the objects that has it.

    properties: by VTK's names in snake case. A value of an enumeration is a number, its word or the beginning of it.
    Raises TypeError for an unknown name, with the most similar ones, and ValueError for an invalid word or number; the
    properties before it are set.
    """
    for shown, value in properties.items():
        small = shown.replace("_", "").lower()
        for target in targets:
            name = setters(target).get(small)
            if name is not None and hasattr(target, "Get" + name):
                set_property(target, name, value, shown)
                break
        else:
            near = difflib.get_close_matches(shown, property_names(targets), 3)
            hint = f"; did you mean {' or '.join(map(repr, near))}?" if near else ""
            raise TypeError(f"there is no property {shown!r}{hint}")
