# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes Structured.md out of StructuredPage.md, with tables and a chart of what tetmarch-bench structured measured.

    make_structured_page.py STRUCTURED.json FOLDER [--remark TEXT]

Beside STRUCTURED.json its table in Markdown, STRUCTURED.md, is looked for. Structured.md and Charts/ go into FOLDER.
"""
import json

import accuracy_charts as charts
from measured_page import charts_folder, measured_table, parser_of, row, write_page

# Name of a family: how its mappers begin, colour, marker.
FAMILIES = {
    "TetMarch: Fast, Default, Accurate": ("tetmarch", "#d62728", "o"),
    "the same, adaptive, 4/255: Fast, Default": (charts.ADAPTIVE, "#ff7f0e", "*"),
    "VTK's GPU mapper, 1, 2, 4, 10 samples a voxel": ("gpu:", "#1f77b4", "s"),
    "the same with jitter": ("gpu-jitter:", "#17becf", "^"),
    "the same of stored scalars, 2 samples": ("gpu-stored:", "#9467bd", "v"),
    "VTK's fixed-point mapper": ("fixed-point", "#7f7f7f", "D"),
}
LEVELS = ("tetmarch", charts.ADAPTIVE)
RIVALS = ("gpu:2", "fixed-point")


def figures_of(subject):
    """{mapper: (seconds, RMS error)}."""
    return {name: (seconds, max(errors["rms"], charts.LEAST)) for name, seconds, errors in charts.measured(subject)}


def ratio(value):
    return f"{value:.2g}" if value < 10 else f"{value:.0f}"


def against(figures, level, rival):
    """One of ours beside a rival: times as fast, times as accurate."""
    if rival not in figures:
        return ["", ""]
    return [ratio(figures[rival][i] / figures[level][i]) for i in (0, 1)]


def on_front(figures):
    """The mappers that are not ours and that nothing beats in both time and error."""
    best = charts.front(list(figures.values()))
    return ", ".join(name for name, point in figures.items() if point in best and not charts.is_ours(name)) or "none"


def rivals_table(report):
    heads = [f"{head} as `{rival}`" for rival in RIVALS for head in ("times as fast", "times as accurate")]
    text = row(["volume", "functions", "mapper", *heads, "rivals on the front"])
    text += "|---|---|---|" + "---:|" * len(heads) + "---|\n"
    for subject in report["datasets"]:
        figures = figures_of(subject)
        for level in (name for name in LEVELS if name in figures):
            ratios = [cell for rival in RIVALS for cell in against(figures, level, rival)]
            text += row([subject["name"], subject["functions"], f"`{level}`", *ratios, on_front(figures)])
    return text


def volumes_table(report):
    text = row(["volume", "points", "stored as"]) + "|---|---|---|\n"
    shown = {s["name"]: s for s in report["datasets"]}
    for name, subject in shown.items():
        text += row([f"`{name}`", " x ".join(str(n) for n in subject["dimensions"]), subject["scalar_type"]])
    return text


def main():
    arguments = parser_of(__doc__, "structured", "output").parse_args()
    report = json.loads(arguments.structured.read_text())
    charts.draw_time(report, charts_folder(arguments.output), "structured", FAMILIES)
    write_page(arguments.output / "Structured.md", report, arguments.remark, {
        "enough": f"{report['enough_seconds']:g}",
        "stride": str(report["stride"]),
        "volumes": volumes_table(report),
        "rivals": rivals_table(report),
        "everything": measured_table(arguments.structured),
    })


if __name__ == "__main__":
    main()
