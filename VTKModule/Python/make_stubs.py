# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes types of VTK's wrapped classes, for editors and type checkers: make_stubs.py PACKAGE_FOLDER MODULE.pyi

The types are those of the docstrings that VTK's wrappers generate. If VTK's Python modules can't be imported, all names
are declared without details.
"""
import inspect
import keyword
import pathlib
import re
import sys
import textwrap

SIMPLE = {"int", "float", "str", "bool", "None", "bytes"}


class Types:
    """Translates types of docstrings, and collects the names to be imported."""

    def __init__(self, module, others):
        self.own = set(vars(module))
        self.others = others
        self.imports = set()

    def name(self, text):
        if text in SIMPLE or text in self.own:
            return text
        if text.startswith("vtk") and hasattr(self.others, text):
            self.imports.add((getattr(self.others, text).__module__, text))
            return text
        return "int" if re.fullmatch(r"[A-Z]\w*", text) else "Any"

    def translate(self, text, returned=False):
        text = text.strip()
        if text[:1] in "([" and text[-1:] in ")]":
            parts = [self.translate(part, returned) for part in re.split(r",(?![^(]*\))", text[1:-1]) if part.strip()]
            if returned:
                return f"tuple[{', '.join(parts)}]"
            element = parts[0] if len(set(parts)) == 1 else "Any"
            return f"{'MutableSequence' if text[0] == '[' else 'Sequence'}[{element}]"
        return self.name(text)


def signatures(doc):
    """(parameters, returned type) of each overload of a docstring."""
    text = re.sub(r"\n {4}", " ", doc)
    found = re.findall(r"^\w+\(([^\n]*?)\)(?: *-> *([^\n]*))?\nC\+\+:", text, re.MULTILINE)
    return [(parameters, returned or "None") for parameters, returned in found]


def parameters_of(text, types):
    """Parameters of "self, value:int, range:[float, float]"."""
    made = []
    for part in re.split(r",(?![^\[(]*[\])])", text):
        name, _, kind = part.strip().partition(":")
        default = re.search(r" ?= ?.*$", kind)
        kind = kind[:default.start()] if default else kind
        if not name:
            continue
        name = name + "_" if keyword.iskeyword(name) else name
        if name == "self":
            made.append(name)
        else:
            made.append(f"{name}: {types.translate(kind) if kind else 'Any'}{' = ...' if default else ''}")
    return made


def help_of(doc):
    """The text of a docstring without its signatures."""
    parts = re.split(r"^C\+\+:(?:.|\n {4})*\n", doc, flags=re.MULTILINE)
    return parts[-1].strip() if len(parts) > 1 else ""


def method_lines(name, doc, types):
    overloads = signatures(doc)
    if not overloads:
        return [f"def {name}(self, *arguments: Any) -> Any: ..."]
    lines = []
    for number, (text, returned) in enumerate(overloads):
        parameters = parameters_of(text, types)
        if len(overloads) > 1:
            lines.append("@overload")
        if parameters[:1] != ["self"]:
            lines.append("@staticmethod")
        lines.append(f"def {name}({', '.join(parameters)}) -> {types.translate(returned, True)}:")
        shown = help_of(doc).replace("\\", "\\\\").replace('"""', "'''") if number == 0 else ""
        lines += textwrap.indent(f'"""{shown}\n"""\n...' if shown else "...", "    ").split("\n")
    return lines


def property_lines(name, made, types):
    """A property, as VTK's classes have from 9.4 on. Its docstring names its methods."""
    found = re.match(r"read-(?:only|write), calls (\w+)(?:/(\w+))?", vars(made)[name].__doc__)
    if not found:
        return [f"{name}: Any"]
    getter, setter = found.groups()
    kind = next((types.translate(returned, True) for parameters, returned in signatures(getattr(made, getter).__doc__)
                 if parameters in ("", "self")), "Any")
    lines = ["@property", f"def {name}(self) -> {kind}: ..."]
    if setter:
        values = [[each for each in parameters_of(parameters, types) if each != "self"]
                  for parameters, _ in signatures(getattr(made, setter).__doc__)]
        value = next((given[0].partition(": ")[2] for given in values if len(given) == 1), "Any")
        lines += [f"@{name}.setter", f"def {name}(self, value: {value}) -> None: ..."]
    return lines


def class_lines(made, types):
    base = made.__mro__[1]
    lines = [f"class {made.__name__}({types.name(base.__name__)}):"]
    for name, member in sorted(vars(made).items()):
        if name.startswith("_"):
            continue
        if isinstance(member, type):
            body = [f"class {name}(int): ..."]
        elif isinstance(member, int):
            body = [f"{name}: int"]
        elif inspect.isgetsetdescriptor(member):
            body = property_lines(name, made, types)
        else:
            body = method_lines(name, member.__doc__ or "", types)
        lines += ["    " + line for line in body]
    given = ", **properties: Any" if "    @property" in lines else ""
    return lines + [f"    def __init__(self{given}) -> None: ...", ""]


def main(folder, path):
    sys.path.insert(0, str(pathlib.Path(folder).parent))
    try:
        import vtkmodules.all as others
        from vtktetmarch import vtkRenderingTetMarch as module
    except ImportError as error:
        print(f"The types of the Python package know nothing of its classes: {error}")
        unknown = "from typing import Any\n\ndef __getattr__(name: str) -> Any: ...\n"
        pathlib.Path(path).write_text(unknown, encoding="utf-8")
        return
    types = Types(module, others)
    body = []
    for name, made in sorted(vars(module).items()):
        if isinstance(made, type) and name.startswith("vtk"):
            body += class_lines(made, types)
    head = ["from typing import Any, MutableSequence, Sequence, overload", ""]
    head += [f"from {place} import {name}" for place, name in sorted(types.imports)]
    text = "\n".join([*head, "", *body])
    compile(text, str(path), "exec")
    pathlib.Path(path).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
