# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""For StateTest.py: writes the states of a scene and what it shows, or reads a state, .pvsm or .py, and looks for the
same."""
from paraview import simple, smstate
from state_values import STEPS, make_scene, set_values, values_of
from two_processes import displays_of, expect_values, keep, kept_beside, main, run_code
from views import picture_of


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
    keep(folder, look_at([(view, display) for view, display, _ in scene]))


def read(path):
    if path.suffix == ".py":
        run_code(path)
    else:
        simple.LoadState(str(path))
    expected = kept_beside(path)
    found = look_at(displays_of("mesh", "wavelet"))
    for (values, pictures), (wanted_values, wanted_pictures) in zip(found, expected):
        expect_values(values, wanted_values)
        for step, (picture, wanted) in enumerate(zip(pictures, wanted_pictures)):
            assert picture == wanted, f"picture {step} of {len(wanted_pictures)} is another one"
    print(f"{path.name}: {[len(values) for values, _ in expected]} properties, {len(STEPS)} pictures of each")


main(__doc__, write, read)
