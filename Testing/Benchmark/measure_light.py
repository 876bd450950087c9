# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Accuracy and time of light, by effect and way to draw it: measure_light.py FOLDER [OPTION]...

FOLDER gets light.json, and in truths/ the ground truth of each scene and effect; a second run reads those that are
there. --picture FILE draws the picture of LightAccuracy.md instead.
"""
import argparse
import json
import pathlib
import statistics

import numpy as np
from light_effects import EFFECTS, UNLIT, WAYS, keeps_light, ways_of
from light_picture import write_picture
from light_scenes import SCENES, LightScene
from option_types import positive
from this_machine import report_of
from time_frames import LATTICES

TRUTH_TOLERANCE = 1e-5  # of the integral; that of light is the mapper's
KEPT = 2 / 255
ENOUGH_SECONDS = 2.0  # of frames of a way
(UNLIT_WAY,) = UNLIT.ways


def errors_of(picture, truth):
    """Of the worst channel of each pixel that either covers, but for the RMS, which is of all channels."""
    apart = np.abs(picture - truth[..., :3])[(truth[..., 3] > 0) | picture.any(axis=2)]
    worst = apart.max(axis=1)
    return {"rms": float(np.sqrt((apart**2).mean())), "q999": float(np.quantile(worst, 0.999)),
            "max": float(worst.max()), "within": float((worst <= KEPT).mean())}


class Truths:
    """Ground truths in files, made where there is none."""

    def __init__(self, folder, scene, name, stride):
        self.folder, self.scene, self.name, self.stride = folder / "truths", scene, name, stride
        self.folder.mkdir(parents=True, exist_ok=True)

    def stride_of(self, effect):
        return self.stride * EFFECTS[effect].coarser

    def of(self, effect, way):
        """Cell gradients are a definition of their own."""
        own = f", {way}" if WAYS[way].only == "mesh" else ""
        stride = self.stride_of(effect)
        words = f"{self.name}, {effect}{own}, {'x'.join(map(str, self.scene.picture_size))}, {stride}"
        file = self.folder / (words.replace(", ", "_").replace(" ", "-") + ".npy")
        if not file.exists():
            self.scene.apply(EFFECTS[effect], way if own else EFFECTS[effect].ways[0])
            np.save(file, self.scene.ground_truth(TRUTH_TOLERANCE, stride))
        return np.load(file)

    def errors(self, effect, way):
        truth = self.of(effect, way)
        self.scene.apply(EFFECTS[effect], way)
        return errors_of(self.scene.picture(self.stride_of(effect)), truth)


class Row:
    """One way to draw an effect."""

    def __init__(self, effect, way):
        self.effect, self.way = effect, way
        self.seconds, self.first = [], []

    def draw(self, scene):
        effect = EFFECTS.get(self.effect, UNLIT)
        scene.apply(effect, self.way)
        if keeps_light(effect, self.way):
            self.first.append(scene.seconds_after_the_light_moved())
            after = 0.0
        else:
            after = scene.seconds()  # after other settings: what little is prepared counts in short frames only
        self.seconds.append(after if after > ENOUGH_SECONDS else scene.seconds())


    def has_enough(self):
        return sum(self.seconds[1:]) > ENOUGH_SECONDS


def times_by_turns(scene, rows, frames):
    """There and back, since a machine may get slower; the first turn compiles, and does not count."""
    for turn in range(frames + 1):
        for row in rows if turn % 2 == 0 else reversed(rows):
            if not row.has_enough():
                row.draw(scene)
    for row in rows:
        del row.seconds[:1], row.first[:1]


def measure(name, options):
    scene = LightScene(name, options.size, options.timed_size)
    truths = Truths(options.folder, scene, name, options.stride)
    unlit, *rows = [Row("", UNLIT_WAY)] + [Row(effect, way) for effect in options.effects
                                           for way in ways_of(EFFECTS[effect], scene.kind)]
    results = []
    for row in rows:
        errors = truths.errors(row.effect, row.way)
        results.append({"effect": row.effect, "way": row.way, **errors})
        print(f"{name}, {row.effect}, {row.way}: RMS {errors['rms']:.1e}, 99.9 % {errors['q999']:.3f}", flush=True)
    times_by_turns(scene, [unlit, *rows], options.frames)
    for result, row in zip(results, rows):
        ratios = [lit / bare for lit, bare in zip(row.seconds, unlit.seconds)]
        result.update(seconds=statistics.median(row.seconds), times_unlit=statistics.median(ratios))
        if row.first:
            result["first_seconds"] = statistics.median(row.first)
    return scene, {"name": name, "kind": scene.kind, "unlit_seconds": statistics.median(unlit.seconds),
                   "results": results}


def size_of(text):
    width, height = (positive(n) for n in text.split("x"))
    return width, height


def options_of():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--size", type=size_of, default=(512, 512), metavar="WxH")
    parser.add_argument("--stride", type=positive, default=4, help="compare one pixel of STRIDE x STRIDE")
    parser.add_argument("--timed-size", type=size_of, default=(128, 128), metavar="WxH", help="of timed frames")
    parser.add_argument("--frames", type=positive, default=5, help="of each way, by turns, or two seconds of them")
    parser.add_argument("--scenes", nargs="+", choices=(*SCENES, *LATTICES), default=SCENES, metavar="SCENE")
    parser.add_argument("--effects", nargs="+", choices=EFFECTS, default=list(EFFECTS), metavar="EFFECT")
    parser.add_argument("--picture", type=pathlib.Path, metavar="FILE", help="draw the picture of the page instead")
    return parser.parse_args()


def main():
    options = options_of()
    if options.picture:
        write_picture(options.picture)
        return
    report = {"size": options.size, "timed_size": options.timed_size, "frames": options.frames,
              "stride": options.stride, "scenes": [],
              "effects": {name: EFFECTS[name].words for name in options.effects}}
    for name in options.scenes:
        scene, result = measure(name, options)
        report = {**report_of(scene.window), **report}
        report["scenes"].append(result)
        (options.folder / "light.json").write_text(json.dumps(report, indent=1))


if __name__ == "__main__":
    main()
