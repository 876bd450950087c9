# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""For StateTest.py: writes the states of a scene and what it shows, or reads a state and looks for the same.

--state: of a folder, where to write; of a file in it, .pvsm or .py, what to read.
"""
import pathlib
import pickle

from paraview import simple, smstate
from state_values import STEPS, make_scene, set_values, values_of
from views import load_plugin, parse_arguments, picture_of

EXPECTED = "expected.pickle"


def look_at(scene):
    """Of each display its values and the picture, then the pictures after some other values are set."""
    found = []
    for view, display in scene:
        values = values_of(display)
        pictures = []
        for step in STEPS:
            set_values(display, step)
            pictures.append(b"".join(picture_of(view)))
        assert len(set(pictures)) == len(STEPS), "two of the pictures don't differ"
        found.append((values, pictures))
    return found


def write(folder):
    scene = make_scene()
    for _, display, values in scene:
        before = values_of(display)
        assert set(before) == set(values), f"state_values.py: {set(before) ^ set(values)}"
        set_values(display, values)
        same = [name for name in values if values[name] == before[name]]
        assert not same and values_of(display) == values, f"the values of {same} are the defaults"
    simple.SaveState(str(folder / "state.pvsm"))
    (folder / "state.py").write_text(smstate.get_state())
    found = look_at([(view, display) for view, display, _ in scene])
    (folder / EXPECTED).write_bytes(pickle.dumps(found))


def read(path):
    if path.suffix == ".py":
        exec(compile(path.read_text(), str(path), "exec"), {"__name__": "__main__"})
    else:
        simple.LoadState(str(path))
    scene = []
    for name in ("mesh", "wavelet"):
        source = simple.FindSource(name)
        shown = [(view, display) for view in simple.GetRenderViews() for display in view.Representations
                 if getattr(display, "Input", None) == source]
        assert len(shown) == 1, f"{name} is shown in {len(shown)} views"
        scene += shown
    expected = pickle.loads((path.parent / EXPECTED).read_bytes())
    for (values, pictures), (wanted_values, wanted_pictures) in zip(look_at(scene), expected):
        other = {name: (value, values.get(name)) for name, value in wanted_values.items() if values.get(name) != value}
        assert not other, f"saved and restored: {other}"
        for step, (picture, wanted) in enumerate(zip(pictures, wanted_pictures)):
            assert picture == wanted, f"picture {step} of {len(wanted_pictures)} is another one"
    print(f"{path.name}: {[len(values) for values, _ in expected]} properties, {len(STEPS)} pictures of each")


def main():
    arguments = parse_arguments(__doc__, "state")
    load_plugin(arguments)
    path = pathlib.Path(arguments.state)
    if path.is_dir():
        write(path)
    else:
        read(path)


main()
