# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Animations over the time steps of a mesh and of an image: where values alone change, only they are prepared and
loaded."""
import math
import pathlib
import tempfile

from paraview import simple
from series import SIDE, Shown, make_grid, write_steps
from views import load_plugin, parse_arguments, picture_of

STEPS = 4
POINTS = (SIDE + 1) ** 3
# Bytes of a point in the GPU's memory: of a mesh it is loaded with its coordinates, of an image it is its value.
BYTES = {"vtu": 16, "vti": 4}


def wave(step):
    """Of the same range in every step, so that tables of functions are the same, too."""
    def value(x, y, z):
        corner = x + y + z
        return 0.0 if corner == 0 else 2.0 if corner == 3 * SIDE else 1 + 0.5 * math.sin(x + step) * math.cos(y * z)
    return value


def check_values(kind, folder):
    shown = Shown(kind, write_steps(kind, folder, [make_grid(kind, wave(step)) for step in range(STEPS)]))
    pictures = {}
    counts = None
    for step in [*range(STEPS), *range(STEPS)]:
        shown.scene.AnimationTime = step
        picture = picture_of(shown.view)
        assert pictures.setdefault(step, picture) == picture, f"step {step} is drawn in two ways"
        before, counts = counts, {name: shown.figure(name) for name in ("MeshBuilds", "ScalarsBuilds", "UploadedBytes")}
        assert counts["MeshBuilds"] == 1, f"{kind}, step {step}: the mesh was prepared {counts} times"
        if before:
            loaded = counts["UploadedBytes"] - before["UploadedBytes"]
            assert counts["ScalarsBuilds"] == before["ScalarsBuilds"] + 1
            assert loaded == BYTES[kind] * POINTS, f"step {step}: {loaded} bytes are loaded for {POINTS} points"
    assert len(set(map(tuple, pictures.values()))) == STEPS, "time steps look alike"
    print(f"{kind}: {STEPS} steps, each {BYTES[kind]} bytes a point; in all {counts}")
    check_properties(shown)


def check_properties(shown):
    """Animated properties leave mesh and values alone."""
    counts = {name: shown.figure(name) for name in ("MeshBuilds", "ScalarsBuilds")}
    track = simple.GetAnimationTrack("TetMarchCroppingOrigin", index=0, proxy=shown.display)
    track.KeyFrames = [simple.CompositeKeyFrame(KeyTime=0, KeyValues=[0.0]),
                       simple.CompositeKeyFrame(KeyTime=1, KeyValues=[SIDE / 2])]
    shown.display.TetMarchUseCropping = 1
    shown.display.TetMarchCroppingScale = [0.5, 1.0, 1.0]
    pictures = []
    for step in range(STEPS):
        shown.scene.AnimationTime = step
        pictures.append(picture_of(shown.view))
        expected = step / (STEPS - 1) * SIDE / 2
        assert abs(shown.display.TetMarchCroppingOrigin[0] - expected) < 1e-12
    assert len(set(map(tuple, pictures))) == STEPS
    assert shown.figure("MeshBuilds") == counts["MeshBuilds"]
    assert shown.figure("ScalarsBuilds") == counts["ScalarsBuilds"] + STEPS
    simple.Delete(track)
    shown.close()


def check_blocks(kind, folder):
    """Those of a mesh are joined to one, those of images are prepared one by one: once either way."""
    series = []
    for name, origin in (("first", (0, 0, 0)), ("second", (SIDE, 0, 0))):
        pathlib.Path(folder, name).mkdir(exist_ok=True)
        grids = [make_grid(kind, wave(step), origin) for step in range(STEPS)]
        series.append(write_steps(kind, f"{folder}/{name}", grids))
    shown = Shown(kind, *series)
    pictures = []
    for step in range(STEPS):
        shown.scene.AnimationTime = step
        pictures.append(picture_of(shown.view))
        assert shown.figure("MeshBuilds") == (1 if kind == "vtu" else 2), f"step {step} of {kind}: prepared again"
    assert len(set(map(tuple, pictures))) == STEPS
    shown.close()


def check_points(folder):
    """Where points move, a mesh is prepared again, once a step. Of images ParaView takes all steps to lie alike."""
    grids = [make_grid("vtu", wave(0)) for _ in range(2)]
    grids[1].GetPoints().SetPoint(0, -1.0, -1.0, -1.0)
    shown = Shown("vtu", write_steps("vtu", folder, grids))
    shown.scene.AnimationTime = 0
    picture_of(shown.view)
    builds = shown.figure("MeshBuilds")
    for step in (1, 0, 1):
        shown.scene.AnimationTime = step
        builds += 1
        for _ in range(2):
            picture_of(shown.view)
            found = shown.figure("MeshBuilds")
            assert found == builds, f"step {step}: {found} preparations instead of {builds}"
    shown.close()


def main():
    load_plugin(parse_arguments(__doc__))
    with tempfile.TemporaryDirectory() as folder:
        for kind in ("vtu", "vti"):
            check_values(kind, folder)
            check_blocks(kind, folder)
        check_points(folder)


main()
