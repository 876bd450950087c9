#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""How the time of a frame grows with the mesh: a table and a chart.

    growth_chart.py FOLDER REPORT.json...

The reports are those of tetmarch-bench for lattices of several sizes. FOLDER gets growth.md and growth.png.
"""
import argparse
import json
import math
import pathlib

from accuracy_charts import FAMILIES, plt, save
from measured_page import machine, row

STYLES = {name: {"color": color, "marker": marker} for name, color, marker in FAMILIES.values()}
LEAST_TETRAHEDRA = 1e5  # below, what each pixel costs whatever the mesh is counts more


def measured(reports):
    """{mapper: [(tetrahedra, seconds a frame)]} by ascending size."""
    found = {}
    for report in reports:
        for dataset in report["datasets"]:
            for mapper in dataset["mappers"]:
                if mapper["frames"]:
                    point = (dataset["tetrahedra"], mapper["frames"]["median_seconds"])
                    found.setdefault(mapper["name"], []).append(point)
    return {name: sorted(points) for name, points in found.items()}


def exponent(points):
    """Of the power of the size that fits best by least squares of logarithms; None of fewer than two sizes."""
    logs = [(math.log(n), math.log(t)) for n, t in points if n >= LEAST_TETRAHEDRA]
    if len({x for x, _ in logs}) < 2:
        return None
    x_mean = sum(x for x, _ in logs) / len(logs)
    y_mean = sum(y for _, y in logs) / len(logs)
    return sum((x - x_mean) * (y - y_mean) for x, y in logs) / sum((x - x_mean) ** 2 for x, _ in logs)


def label_of(name, points):
    power = exponent(points)
    return name if power is None else f"{name}: $N^{{{power:.2f}}}$"


def table_of(found):
    sizes = sorted({n for points in found.values() for n, _ in points})
    text = row(["tetrahedra"] + [f"{name}, s" for name in found]) + "|---:|" + "---:|" * len(found) + "\n"
    for size in sizes:
        times = [dict(points).get(size) for points in found.values()]
        text += row([f"{size:,}"] + ["" if t is None else f"{t:.3g}" for t in times])
    powers = [exponent(points) for points in found.values()]
    return text + row(["exponent"] + ["" if p is None else f"{p:.2f}" for p in powers])


def draw(found, folder):
    figure, axes = plt.subplots(figsize=(6.5, 4.2))
    for name, points in found.items():
        axes.plot(*zip(*points), label=label_of(name, points), **STYLES.get(name, {"marker": "D"}))
    axes.set(xscale="log", yscale="log", xlabel="tetrahedra, N", ylabel="a frame, s")
    axes.legend(fontsize=8)
    figure.tight_layout()
    save(figure, folder, "growth")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("reports", type=pathlib.Path, nargs="+")
    arguments = parser.parse_args()
    reports = [json.loads(path.read_text()) for path in arguments.reports]
    found = measured(reports)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    page = arguments.folder / "growth.md"
    page.write_text(f"{machine(reports[0])}\n\n{table_of(found)}")
    draw(found, arguments.folder)
    print(f"wrote {page} and the chart beside it")


if __name__ == "__main__":
    main()
