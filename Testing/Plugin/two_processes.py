# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scripts that are run twice: in one process they write files into a folder, in another they read one of them."""
import pathlib
import pickle

from paraview import simple
from views import load_plugin, parse_arguments

EXPECTED = "expected.pickle"


def keep(folder, found):
    (folder / EXPECTED).write_bytes(pickle.dumps(found))


def kept_beside(path):
    return pickle.loads((path.parent / EXPECTED).read_bytes())


def run_code(path):
    exec(compile(path.read_text(), str(path), "exec"), {"__name__": "__main__"})


def displays_of(*names):
    """[(view, display), ...] of these sources, each of which is shown in one view."""
    found = []
    for name in names:
        source = simple.FindSource(name)
        shown = [(view, display) for view in simple.GetRenderViews() for display in view.Representations
                 if getattr(display, "Input", None) == source]
        assert len(shown) == 1, f"{name} is shown in {len(shown)} views"
        found += shown
    return found


def expect_values(found, expected):
    other = {name: (value, found.get(name)) for name, value in expected.items() if found.get(name) != value}
    assert not other, f"other values than before: {other}"


def main(description, write, read):
    """By the argument --path: of a folder, where to write; of a file in it, what to read."""
    arguments = parse_arguments(description, "path")
    load_plugin(arguments)
    path = pathlib.Path(arguments.path)
    if path.is_dir():
        write(path)
    else:
        read(path)
