# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes Accuracy.md out of AccuracyPage.md, with tables and charts of what tetmarch-bench has measured.

    make_accuracy_page.py ACCURACY.json REFINEMENT.json FOLDER [--remark TEXT]

Beside ACCURACY.json its table in Markdown, ACCURACY.md, is looked for. Accuracy.md and Charts/ go into FOLDER.
"""
import json

import accuracy_charts as charts
from measured_page import charts_folder, measured_table, parser_of, row, write_page

# Shown in the README: one subject of each kind of functions, from a small mesh to a large one.
OVERVIEW = {("golfball", "smooth"), ("front1.3m", "spikes"), ("golfball-medium", "ramp")}


def least(ratios):
    """Of (ratio, name): as text. Without a setting of ours to compare with the ratio is 0."""
    if not ratios:
        return ""
    ratio, name = min(ratios)
    return f"{ratio:.{1 if ratio < 10 else 0}f} ({name})" if ratio > 0 else f"none is ({name})"


def against_rivals(subject):
    """A row of the table: our levels beside the rivals that do best; nothing if either is lacking."""
    points = charts.measured(subject)
    ours = [(s, e["rms"]) for name, s, e in points if charts.is_ours(name)]
    rivals = [(s, e["rms"], name) for name, s, e in points if not charts.is_ours(name)]
    if not ours or not rivals:
        return None
    # For each rival the cheapest of our levels that is as accurate, and the most accurate that is as fast.
    faster = [(max((seconds / s for s, e in ours if e <= rms), default=0.0), name) for seconds, rms, name in rivals]
    better = [(max((rms / e for s, e in ours if s <= seconds), default=0.0), name) for seconds, rms, name in rivals]
    best = charts.front(ours + [(s, e) for s, e, _ in rivals])
    alien = [name for s, e, name in rivals if (s, e) in best]

    def split(ratios):
        images = [r for r in ratios if r[1].startswith("resample")]
        return least([r for r in ratios if r not in images]), least(images)

    return row([subject["name"], subject["functions"], *split(faster), *split(better), ", ".join(alien) or "none"])


def rivals_table(report):
    text = row(["dataset", "functions", "times as fast: mesh", "image", "times as accurate: mesh", "image",
                "rivals on the front"]) + "|---|---|---:|---:|---:|---:|---|\n"
    rows = [against_rivals(s) for s in report["datasets"]]
    return text + "".join(r for r in rows if r)


def levels_table(report):
    """Our levels: errors and time beside that of the cheapest level."""
    text = row(["dataset", "functions", "level", "frame, s", "times Fast", "RMS", "99.9 %", "max", "bound, max",
                "lookups/cell"]) + "|---|---|---|---:|---:|---:|---:|---:|---:|---:|\n"
    for subject in report["datasets"]:
        points = [p for p in charts.measured(subject) if charts.is_ours(p[0])]
        fast = next((s for name, s, _ in points if name == "tetmarch-fast"), None)
        for name, seconds, e in points:
            text += row(
                [
                    subject["name"], subject["functions"], name, f"{seconds:.3f}",
                    f"{seconds / fast:.2f}" if fast else "", f"{e['rms']:.1e}", f"{e['p999']:.1e}",
                    f"{e['max']:.1e}", "none" if charts.is_adaptive(name) else f"{e['bound_max']:.1e}",
                    f"{e['lookups_per_cell']:.2f}",
                ]
            )
    return text


def orders_table(report):
    lines = charts.refinement(report)
    if not lines:
        return ""
    longest = max(lines.values(), key=len)
    steps = [f"1/{round(1 / h0)} to 1/{round(1 / h1)}" for (h0, _), (h1, _) in zip(longest, longest[1:])]
    text = row(["mapper", "RMS, finest mesh"] + [f"order, {s}" for s in steps])
    text += "|---|---:|" + "---:|" * len(steps) + "\n"
    for name, points in lines.items():
        orders = [f"{s:.2f}" for s in charts.slopes(points)]
        text += row([name, f"{points[-1][1]:.1e}"] + [""] * (len(steps) - len(orders)) + orders)
    return text


def main():
    arguments = parser_of(__doc__, "accuracy", "refinement", "output").parse_args()
    accuracy = json.loads(arguments.accuracy.read_text())
    refinement = json.loads(arguments.refinement.read_text())
    folder = charts_folder(arguments.output)
    charts.draw_time(accuracy, folder)
    charts.draw_overview(accuracy, folder, OVERVIEW)
    charts.draw_lookups(accuracy, folder)
    charts.draw_refinement(refinement, folder)
    write_page(arguments.output / "Accuracy.md", accuracy, arguments.remark, {
        "rivals": rivals_table(accuracy),
        "levels": levels_table(accuracy),
        "orders": orders_table(refinement),
        "everything": measured_table(arguments.accuracy),
    })


if __name__ == "__main__":
    main()
