# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""How long frames of one build take beside those of another: compare_times.py BUILD OTHER [OPTION]...

Both are build folders with a Python package, so that all that they have to have in common is the public API. Each
dataset is drawn without light, in the light of one light source with shadows, and from inside. Both builds draw by
turns, a frame each of the same view; each round has new processes, lest the luck of one count for all, and the other
build begins.
"""
import argparse
import contextlib
import json
import pathlib
import statistics
import subprocess
import sys

from build_folders import HERE, environment_of, run_again_with_display
from option_types import positive

DATASETS = ("golfball", "lattice1.3m", "holes")
SCENES = {"plain": "", "lit": ", lit", "inside": ", from inside"}  # what is said of each
GOAL = 0.01  # medians may be that far apart, as a share


class Drawer:
    """The process of one build."""

    def __init__(self, build, dataset, scene, size):
        self.process = subprocess.Popen([sys.executable, HERE / "time_frames.py", dataset, scene, size],
                                        env=environment_of(build), text=True, stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE)
        self.answer()

    def answer(self):
        line = self.process.stdout.readline()
        if not line:
            sys.exit("compare_times.py: a build couldn't draw, see above")
        return line.strip()

    def draw(self, view):
        print(view, file=self.process.stdin, flush=True)
        return float(self.answer())

    def end(self):
        self.process.stdin.close()
        self.process.wait()


def measure(builds, dataset, scene, arguments):
    """Seconds of each frame of each build, without the first of a process."""
    seconds = ([], [])
    for turn in range(arguments.rounds):
        with contextlib.ExitStack() as stack:
            drawers = []
            for build in builds:
                drawers.append(Drawer(build, dataset, scene, arguments.size))
                stack.callback(drawers[-1].end)
            order = (0, 1) if turn % 2 == 0 else (1, 0)
            for view in range(arguments.frames + 1):
                for k in order:
                    took = drawers[k].draw(view)
                    if view > 0:
                        seconds[k].append(took)
    return seconds


def summary(dataset, scene, seconds):
    medians = [statistics.median(s) for s in seconds]
    ratios = [ours / other for ours, other in zip(*seconds)]
    return {
        "name": dataset + SCENES[scene],
        "mappers": [{"name": name, "frames": {"median_seconds": median, "seconds": s}}
                    for name, median, s in zip(("tetmarch", "against"), medians, seconds)],
        "against": {"count": len(ratios), "pairs": statistics.median(ratios), "medians": medians[0] / medians[1]},
    }


def line_of(result):
    ours, other = (mapper["frames"]["median_seconds"] for mapper in result["mappers"])
    against = result["against"]
    verdict = "" if abs(against["medians"] - 1) <= GOAL else f", more than {100 * GOAL:g} % apart"
    return (f"{result['name']}: {ours:.4f} s, the other build {other:.4f} s; "
            f"ratio of medians {against['medians']:.3f}, "
            f"median of ratios of {against['count']} pairs {against['pairs']:.3f}{verdict}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("build", "other"):
        parser.add_argument(name, type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--datasets", nargs="+", choices=DATASETS, default=DATASETS)
    parser.add_argument("--scenes", nargs="+", choices=SCENES, default=SCENES)
    parser.add_argument("--rounds", type=positive, default=6)
    parser.add_argument("--frames", type=positive, default=20, help="of each round, without the first")
    parser.add_argument("--size", default="512x512", metavar="WIDTHxHEIGHT")
    parser.add_argument("--output", type=pathlib.Path, metavar="FILE.json")
    arguments = parser.parse_args()
    run_again_with_display()
    results = []
    for dataset in arguments.datasets:
        for scene in arguments.scenes:
            seconds = measure((arguments.build, arguments.other), dataset, scene, arguments)
            results.append(summary(dataset, scene, seconds))
            print(line_of(results[-1]), flush=True)
    if arguments.output:
        arguments.output.write_text(json.dumps({"datasets": results}, indent=1))


if __name__ == "__main__":
    main()
