# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws every hard case by every mapper and writes Documentation/HardCases.md out of HardCasesPage.md.

Each picture is drawn in a process of its own, which a mapper may bring down or keep for ever. The figures of rays
are those that `tetmarch stress` has left in BUILD/stress.json.
"""
import argparse
import concurrent.futures
import json
import pathlib
import signal
import subprocess
import tempfile

import matplotlib.image
import numpy

HERE = pathlib.Path(__file__).resolve().parent
PICTURES = HERE / "Pictures"
OTHERS = ["projected", "bunyk", "zsweep"]
MAPPERS = ["ground-truth", "tetmarch"] + OTHERS
NAMES = {
    "tetmarch": "TetMarch",
    "projected": "projected tetrahedra",
    "bunyk": "Bunyk ray caster",
    "zsweep": "Z-sweep",
}
PATIENCE = 60  # seconds for one picture
GAP = 3  # pixels between the pictures of a row


def draw(tool, case, mapper, folder):
    """What tetmarch-draw-hard-case says, or {"failed": how}."""
    file = folder / f"{case}-{mapper}.png"
    try:
        done = subprocess.run(
            [tool, case, mapper, file], capture_output=True, text=True, timeout=PATIENCE
        )
    except subprocess.TimeoutExpired:
        return {"failed": f"not done after {PATIENCE} s"}
    if done.returncode < 0:
        return {"failed": f"crash ({signal.Signals(-done.returncode).name})"}
    if done.returncode > 0:
        return {"failed": done.stderr.strip().splitlines()[-1]}
    return {**json.loads(done.stdout), "file": file}


def strip(drawings):
    """The pictures side by side; red where there is none."""
    found = [matplotlib.image.imread(d["file"])[..., :3] if "file" in d else None for d in drawings]
    height, width = next(p.shape[:2] for p in found if p is not None)
    gap = numpy.ones((height, GAP, 3))
    parts = []
    for picture in found:
        if picture is None:
            picture = numpy.broadcast_to([0.6, 0.0, 0.0], (height, width, 3))
        parts += [picture, gap]
    return numpy.concatenate(parts[:-1], axis=1)


def verdict(drawing):
    if "failed" in drawing:
        return drawing["failed"]
    share = drawing["wrong"] / drawing["pixels"]
    if share == 0:
        return "right"
    text = f"{100 * share:.2g} % wrong" if share < 0.995 else "all wrong"
    return text + ("" if drawing["messages"] else ", silent")


def row(case, what, drawings, rays):
    failures = sum(
        rays[k] for k in ("lost", "guarded", "refused", "not_finite", "negative", "out_of_bound", "not_the_answer")
    )
    error = f"{rays['worst_generic_error']:.1g}" if rays["group"] != "optics" else ""
    cells = [
        f"![{case}](../Testing/HardCases/Pictures/{case}.png)",
        f"**{case}**: {what}",
        f"{rays['rays'] / 1e6:.3g} M",
        str(failures),
        error,
        verdict(drawings["tetmarch"]),
        *(verdict(drawings[m]) for m in OTHERS),
    ]
    return "| " + " | ".join(cells) + " |"


def summary(results):
    """How many cases each mapper draws right."""
    lines = ["| mapper | right | wrong pixels | of them without a word | crashes or hangs |", "|---|---:|---:|---:|---:|"]
    for mapper in MAPPERS[1:]:
        drawings = [drawings[mapper] for drawings in results.values()]
        failed = sum("failed" in d for d in drawings)
        wrong = [d for d in drawings if d.get("wrong", 0) > 0]
        silent = sum(not d["messages"] for d in wrong)
        right = len(drawings) - failed - len(wrong)
        lines.append(f"| {NAMES[mapper]} | {right} | {len(wrong)} | {silent} | {failed} |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--case", help="draw only this one, and write no page")
    options = parser.parse_args()

    tools = options.build / "bin"
    listed = subprocess.run([tools / "tetmarch-hard-cases", "list"], capture_output=True, text=True, check=True)
    cases = []
    for line in listed.stdout.splitlines():
        group, name, _, what = line.split("\t")
        cases.append((group, name, what))
    if options.case:
        cases = [c for c in cases if c[1] == options.case]
    rays = {r["case"]: r for r in json.loads((options.build / "stress.json").read_text())["cases"]}

    PICTURES.mkdir(exist_ok=True)
    results = {}
    with tempfile.TemporaryDirectory() as name, concurrent.futures.ThreadPoolExecutor(2) as pool:
        draw_tool = tools / "tetmarch-draw-hard-case"
        folder = pathlib.Path(name)
        futures = {(c[1], m): pool.submit(draw, draw_tool, c[1], m, folder) for c in cases for m in MAPPERS}
        for _, case, _ in cases:
            drawings = {m: futures[case, m].result() for m in MAPPERS}
            matplotlib.image.imsave(PICTURES / f"{case}.png", strip(list(drawings.values())))
            print(case, {m: verdict(drawings[m]) for m in MAPPERS[1:]}, flush=True)
            results[case] = drawings
    if options.case:
        return

    page = (HERE / "HardCasesPage.md").read_text()
    head = (
        "| double precision, TetMarch, projected, Bunyk, Z-sweep | case | rays | failures | worst length error | "
        + " | ".join(NAMES.values())
        + " |\n|---|---|---:|---:|---:|---|---|---|---|\n"
    )
    for group in dict.fromkeys(c[0] for c in cases):
        rows = [row(c[1], c[2], results[c[1]], rays[c[1]]) for c in cases if c[0] == group]
        page = page.replace(f"@{group}-group@", head + "\n".join(rows))
    page = page.replace("@summary@", summary(results))
    page = page.replace("@rays@", f"{sum(r['rays'] for r in rays.values()):,}".replace(",", " "))
    page = page.replace("@cases@", str(len(cases)))
    (HERE.parents[1] / "Documentation" / "HardCases.md").write_text(page)


if __name__ == "__main__":
    main()
