# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""For StateTest.py: traces what somebody does with a mesh and an image, or runs that trace and looks for the same."""
import contextlib

from paraview import smtrace
from state_values import make_scene, set_values, values_of
from two_processes import displays_of, expect_values, keep, kept_beside, main, run_code
from views import REPRESENTATION, picture_of

# So that there is more to see.
SETTLED = {"ViewMode": "Picture", "BlendMode": "Composite", "ErrorBudget": 0.0, "FrameTimeBudget": 0.0}


@contextlib.contextmanager
def traced(proxy):
    """As the panels of ParaView's window trace the properties that they change."""
    item = smtrace.PropertiesModified(proxy.SMProxy)
    yield
    item.finalize()


def look_at(scene):
    return [(values_of(display), b"".join(picture_of(view))) for view, display in scene]


def write(folder):
    smtrace.start_trace()
    scene = make_scene(traced)
    for _, display, values in scene:
        with traced(display):
            set_values(display, {**values, **SETTLED})
    trace = smtrace.stop_trace()
    found = look_at([(view, display) for view, display, _ in scene])
    assert all(len(set(picture)) > 50 for _, picture in found), "there is next to nothing to see"
    (folder / "trace.py").write_text(trace)
    keep(folder, found)


def read(path):
    run_code(path)
    scene = displays_of("mesh", "wavelet")
    expected = kept_beside(path)
    for (_, display), (values, picture), (wanted, wanted_picture) in zip(scene, look_at(scene), expected):
        assert display.Representation == REPRESENTATION, display.Representation
        expect_values(values, wanted)
        assert picture == wanted_picture, "the traced code draws another picture"
    print(f"{path.name}: the pictures of {len(expected)} views")


main(__doc__, write, read)
