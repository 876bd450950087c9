#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Web pages of scenes: time of a frame beside the mapper's, images beside vtk.js, and the time of the first frame.

    measure_web.py FOLDER [OPTION]...

FOLDER gets web.json, web.md and the pages. All draw without a GPU; frames are complete, of 900 x 600 pixels.
"""
import argparse
import json
import pathlib
import statistics
import sys
import tempfile

import vtkjs_page
from option_types import positive
from this_machine import report_of
from web_scenes import SCENES, Scene, errors_of
from web_tables import text_of

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "Testing/Web"))
from browsers import BROWSERS, browser  # noqa: E402

PARTS = ("frames", "images", "openings")
DRAWN_BY = "chromium", "llvmpipe"
OPENED = ("golf ball", "scan")
IMAGE = "scan"
LEVELS = ("fast", "default", "accurate")
SAMPLES = (1, 2, 4)  # per voxel
DEGREES = 0.2  # that the camera turns from frame to frame
SECONDS = 300
FRAME = """const {viewer} = document.querySelector("canvas");
    viewer.camera.azimuth(arguments[0]);
    viewer.camera.resetClippingRange(viewer.bounds);
    const begun = performance.now();
    viewer.draw();
    return viewer.complete.then(() => performance.now() - begun)"""
LONGEST_TILE = "return document.querySelector('canvas').viewer.frames.tiles.longest"
LEVEL = """const {viewer} = document.querySelector("canvas");
    viewer.level = {name: arguments[0], tolerance: 1 / 255};
    return viewer.complete.then(() => {})"""
FUNCTIONS = "return document.querySelector('canvas').viewer.functions(0)"


def say(text):
    print(text, flush=True)


def page_of(name, folder):
    return folder / (name.replace(", ", "_").replace(" ", "_") + ".html")


def show(opened, page, fragment="bare"):
    opened.open(page, fragment)
    opened.wait_title("ready", SECONDS)


def frames_by_turns(scene, opened, count):
    """Milliseconds of the mapper's frames, of the page's and of their longest tiles; the first of each is left out."""
    mapper, page, tiles = [], [], []
    turns = (lambda: mapper.append(scene.milliseconds(DEGREES))), (lambda: page.append(opened.run(FRAME, DEGREES)))
    for i in range(count + 1):
        for turn in turns if i % 2 == 0 else turns[::-1]:
            turn()
        tiles.append(opened.run(LONGEST_TILE))
    return mapper[1:], page[1:], tiles[1:]


def measure_frames(scenes, folder, count):
    measured = []
    with browser(*DRAWN_BY) as opened:
        for name, scene in scenes.items():
            opened.size(*scene.figure.size)
            show(opened, page_of(name, folder))
            mapper, page, tiles = frames_by_turns(scene, opened, count)
            ratios = statistics.quantiles([b / a for a, b in zip(mapper, page)], n=4, method="inclusive")
            measured.append({"name": name, "mapper_ms": mapper, "page_ms": page, "longest_tile_ms": tiles,
                             "ratio_quartiles": ratios})
            say(f"{name}: mapper {statistics.median(mapper):.0f} ms, page {statistics.median(page):.0f} ms, "
                f"ratio {ratios[1]:.2f}")
    return measured


class OurPage:
    def __init__(self, level, folder):
        self.name, self.page, self.level = f"page, {level}", page_of(IMAGE, folder), level

    def show(self, opened):
        show(opened, self.page)
        opened.run(LEVEL, self.level)

    def milliseconds(self, opened):
        return opened.run(FRAME, DEGREES)

    def picture(self, opened):
        return opened.png()


class RivalPage:
    def __init__(self, samples, figure, functions, script, folder):
        self.name, self.page = f"vtk.js, {1 / samples:g} voxel", folder / f"vtkjs{samples}.html"
        vtkjs_page.write_page(self.page, script, vtkjs_page.scene_of(figure, functions, samples))

    def show(self, opened):
        show(opened, self.page, "")

    def milliseconds(self, opened):
        return opened.run("return frame(arguments[0])", DEGREES)

    def picture(self, opened):
        return opened.pixels("return picture()")


def measure_images(folder, count, rounds):
    """Each page draws some frames, then the next one; several rounds."""
    scene = Scene(IMAGE)
    truth = scene.ground_truth()
    with tempfile.TemporaryDirectory() as temporary, browser(*DRAWN_BY) as opened:
        opened.size(*scene.figure.size)
        pages = [OurPage(level, folder) for level in LEVELS]
        script = vtkjs_page.install(pathlib.Path(temporary))
        if script is not None:
            show(opened, pages[0].page)
            functions = opened.run(FUNCTIONS)
            pages += [RivalPage(n, scene.figure, functions, script, pathlib.Path(temporary)) for n in SAMPLES]
        measured = {page: {"name": page.name, "ms": []} for page in pages}
        for _ in range(rounds):
            for page, row in measured.items():
                page.show(opened)
                row.update(errors_of(page.picture(opened), truth))
                page.milliseconds(opened)
                row["ms"] += [page.milliseconds(opened) for _ in range(count)]
    for row in measured.values():
        say(f"{row['name']}: {statistics.median(row['ms']):.0f} ms, RMS {row['rms']:.2g}, 99.9 % {row['q999']:.2g}")
    return list(measured.values())


def measure_openings(scenes, folder, count):
    """Each opening is that of a browser that has just been started, with nothing in its caches."""
    measured = []
    for which in BROWSERS:
        for name in OPENED:
            seconds = []
            for _ in range(count):
                with browser(*which) as opened:
                    opened.size(*scenes[name].figure.size)
                    opened.open(page_of(name, folder), "bare")
                    seconds.append(opened.wait_title("ready", SECONDS))
            measured.append({"name": name, "browser": which[0], "driver": which[1], "seconds": seconds})
            say(f"{name} in {' '.join(which)}: {statistics.median(seconds):.2f} s")
    return measured


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--parts", nargs="+", choices=PARTS, default=PARTS)
    parser.add_argument("--scenes", nargs="+", choices=list(SCENES), default=list(SCENES), help="of the frames")
    parser.add_argument("--frames", type=positive, default=21, help="of each scene")
    parser.add_argument("--rounds", type=positive, default=3, help="of pages of the image, each with --frames / 3")
    parser.add_argument("--openings", type=positive, default=5)
    arguments = parser.parse_args()
    folder = arguments.folder
    folder.mkdir(parents=True, exist_ok=True)
    scenes = {name: Scene(name) for name in SCENES}
    for name, scene in scenes.items():
        scene.write_page(str(page_of(name, folder)))
    report = report_of(next(iter(scenes.values())).window)
    report["page_bytes"] = {name: page_of(name, folder).stat().st_size for name in SCENES}
    if "frames" in arguments.parts:
        report["frames"] = measure_frames({name: scenes[name] for name in arguments.scenes}, folder, arguments.frames)
    if "images" in arguments.parts:
        report["images"] = measure_images(folder, max(1, arguments.frames // 3), arguments.rounds)
    if "openings" in arguments.parts:
        report["openings"] = measure_openings(scenes, folder, arguments.openings)
    (folder / "web.json").write_text(json.dumps(report, indent=1))
    (folder / "web.md").write_text(text_of(report))
    say(f"\n{text_of(report)}\nwrote {folder / 'web.json'} and {folder / 'web.md'}")


if __name__ == "__main__":
    main()
