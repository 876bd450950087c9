# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""For StateTest.py: traces what somebody does with a mesh and an image, or runs that trace and looks for the same.

--trace: of a folder, where to write; of the file in it, what to run.
"""
import contextlib
import pathlib
import pickle

from paraview import simple, smtrace
from state_values import make_scene, set_values, values_of
from views import REPRESENTATION, load_plugin, parse_arguments, picture_of

EXPECTED = "expected.pickle"
# So that there is more to see.
SETTLED = {"ViewMode": "Picture", "BlendMode": "Composite", "ErrorBudget": 0.0, "FrameTimeBudget": 0.0}


@contextlib.contextmanager
def traced(proxy):
    """As the panels of ParaView's window trace the properties that they change."""
    item = smtrace.PropertiesModified(proxy.SMProxy)
    yield
    item.finalize()


def look_at(scene):
    return [(values_of(display), b"".join(picture_of(view))) for view, display, _ in scene]


def write(folder):
    smtrace.start_trace()
    scene = make_scene(traced)
    for _, display, values in scene:
        with traced(display):
            set_values(display, {**values, **SETTLED})
    trace = smtrace.stop_trace()
    found = look_at(scene)
    assert all(len(set(picture)) > 50 for _, picture in found), "there is next to nothing to see"
    (folder / "trace.py").write_text(trace)
    (folder / EXPECTED).write_bytes(pickle.dumps(found))


def read(path):
    exec(compile(path.read_text(), str(path), "exec"), {"__name__": "__main__"})
    views = simple.GetRenderViews()
    assert len(views) == 2, f"{len(views)} views"
    expected = pickle.loads((path.parent / EXPECTED).read_bytes())
    for name, (values, picture) in zip(("mesh", "wavelet"), expected):
        source = simple.FindSource(name)
        (view, display), = [(view, display) for view in views for display in view.Representations
                            if getattr(display, "Input", None) == source]
        assert display.Representation == REPRESENTATION, display.Representation
        found = values_of(display)
        other = {key: (value, found[key]) for key, value in values.items() if found[key] != value}
        assert not other, f"traced and run: {other}"
        assert b"".join(picture_of(view)) == picture, f"the traced code draws another picture of the {name}"
    print(f"{path.name}: the pictures of {len(expected)} views")


def main():
    arguments = parse_arguments(__doc__, "trace")
    load_plugin(arguments)
    path = pathlib.Path(arguments.trace)
    if path.is_dir():
        write(path)
    else:
        read(path)


main()
