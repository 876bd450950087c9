# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws all scenes with the vtktetmarch that Python finds: draw_pictures.py VARIANTS OUT.npz EVERY WORDS STAGE

compare_pictures.py runs this with the build that is asked for. VARIANTS is a file of what tetmarch-variants printed; of
every EVERY scenes with WORDS in their names one is drawn, and its name printed. A scene that the build refuses has the
error instead of arrays. STAGE is the shader stage, or empty: as the mapper chooses.
"""
import pathlib
import sys

import numpy as np
import vtktetmarch
from option_scenes import LIT, PLAIN, option_scenes, scene_of
from picture_window import PictureWindow, Refused
from this_machine import driver_of
from variant_scenes import VariantScene


def picture_of_variant(window, features, number):
    scene = VariantScene(features, number)
    window.show(scene)
    # Peeling draws into framebuffers of its own, so what it leaves is bytes.
    if "PEELED" in features:
        return {"bytes": window.bytes()}
    arrays = {"floats": window.floats(scene)}
    if "DIAGNOSTICS" in features:
        arrays["diagnostic floats"], arrays["counts"] = window.diagnostics(scene)
    return arrays


def picks_of_variant(window, features, number):
    scene = VariantScene(features, number)
    scene.mapper.SetPickOpacityThreshold(scene.one_of(0.1, 0.0, 0.25))
    window.show(scene)
    return {"picks": window.picks(scene)}


def picture_of_options(window, make, change):
    scene = make()
    window.show(scene)
    arrays = {"bytes": window.bytes(), "floats": window.floats(scene)}
    if change:
        change(scene)
        arrays["bytes after"] = window.bytes()
    return arrays


def ground_truth(window, features):
    scene = scene_of(features)
    window.show(scene)
    window.bytes()
    return {"ground truth": window.ground_truth(scene)}


def all_scenes(variants):
    """(name, function of a window that gives arrays) of each."""
    draws = {"picture": picture_of_variant, "pick": picks_of_variant}
    for number, line in enumerate(variants.read_text().splitlines()):
        kind, *features = line.split()
        yield f"{number} {line}", lambda w, d=draws[kind], f=frozenset(features), n=number: d(w, f, n)
    for name, (make, change) in option_scenes().items():
        yield name, lambda w, m=make, c=change: picture_of_options(w, m, c)
    for features in (PLAIN, LIT, PLAIN + " COLOR_AND_OPACITY", PLAIN + " ISOSURFACES CLIPPED"):
        yield f"ground truth {features}", lambda w, f=features: ground_truth(w, f)


def main():
    variants, output, every, words, stage = sys.argv[1:]
    scenes = [(name, draw) for name, draw in all_scenes(pathlib.Path(variants)) if words in name]
    with PictureWindow() as window:
        window.window.Render()
        arrays = {"driver": np.array(driver_of(window.window)), "build": np.array(str(vtktetmarch.__file__))}
    for name, draw in scenes[::int(every)]:
        print(name, flush=True)
        try:
            with PictureWindow(stage) as window:
                arrays.update({f"{name}: {kind}": array for kind, array in draw(window).items()})
        except (Refused, AttributeError, TypeError) as error:
            arrays[f"{name}: refused"] = np.array(str(error))
    np.savez_compressed(output, **arrays)


if __name__ == "__main__":
    main()
