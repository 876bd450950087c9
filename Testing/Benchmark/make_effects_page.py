# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes Effects.md out of EffectsPage.md, with tables and a chart of what tetmarch-bench effects has measured.

    make_effects_page.py EFFECTS.json FOLDER [--against AGAINST.json] [--remark TEXT]

AGAINST.json is of tetmarch-bench --against. Effects.md and Charts/ go into FOLDER.
"""
import json
import pathlib

import effects_charts as charts
from measured_page import charts_folder, parser_of, row, write_page

# What was aimed at: effect, figure, at most so many times, in words.
TARGETS = (
    ("headlight", "base_ratio", 1.5, "shading by the headlight, base frames"),
    ("one-light", "base_ratio", 1.5, "shading by one light, base frames"),
    ("vertex-shadows", "on_ratio", 1.15, "shadows at vertices, shaded frames"),
    ("occlusion", "on_ratio", 1.15, "ambient occlusion, shaded frames"),
    ("shadows-occlusion", "on_ratio", 1.15, "both, shaded frames"),
    ("vertex-shadows", "light_base_frames", 3.0, "one light at vertices, once, base frames"),
)
AGAINST_TARGET = 1.02


def number(value, pattern="{:.2f}"):
    return "" if value is None else pattern.format(value)


def ratio(summary):
    """Median, and what all turns lie between."""
    return f"{summary['median']:.2f} ({summary['min']:.2f}-{summary['max']:.2f})" if summary else ""


def stage(effect, name):
    if f"{name}_seconds" not in effect:
        return ""
    return f"{effect[f'{name}_seconds']:.3f} ({effect[f'{name}_base_frames']:.2f})"


def effects_table(report):
    text = row(["dataset", "effect", "frame, s", "times base (range)", "on", "times that (range)", "gradients, s",
                "light, s", "first frame, s", "more on the GPU, MB", "turns"])
    text += "|---|---|---:|---:|---|---:|---:|---:|---:|---:|---:|\n"
    for dataset in report["datasets"]:
        if dataset["base"]:
            text += row([dataset["name"], "base", f"{dataset['base']['median_seconds']:.3f}"] + [""] * 6
                        + [f"{dataset['base_gpu_bytes'] / 1e6:.1f} in all", str(len(dataset["base"]["seconds"]))])
        for name, e in charts.measured(dataset).items():
            text += row(
                [
                    dataset["name"], name, f"{e['frames']['median_seconds']:.3f}", ratio(e["base_ratio"]), e["on"],
                    ratio(e["on_ratio"]), stage(e, "gradients"), stage(e, "light"),
                    f"{e['first_frame']['median_seconds']:.3f}", f"{e['gpu_bytes_more'] / 1e6:.1f}", str(e["turns"]),
                ]
            )
    return text


def verdict(value, most):
    if value is None:
        return ""
    return f"{value:.2f}" + ("" if value <= most else ": missed")


def figure(dataset, effect, key):
    value = charts.measured(dataset).get(effect, {}).get(key)
    return value["median"] if isinstance(value, dict) else value


def targets_table(report, against):
    datasets = report["datasets"]
    text = row(["target", "at most"] + [d["name"] for d in datasets]) + "|---|---:|" + "---:|" * len(datasets) + "\n"
    for effect, key, most, words in TARGETS:
        text += row([words, f"{most:g}"] + [verdict(figure(d, effect, key), most) for d in datasets])
    if against:
        pairs = {d["name"]: d.get("against", {}).get("pairs") for d in against["datasets"]}
        found = [pairs.get(d["name"]) for d in datasets]
        text += row(["nothing on, frames of a build without effects", f"{AGAINST_TARGET:g}"]
                    + [number(f, "{:.3f}") + (": missed" if f and f > AGAINST_TARGET else "") for f in found])
    return text


def against_table(against):
    if not against:
        return "Not measured in this run."
    text = row(["dataset", "this build, s", "the other, s", "median of ratios of pairs", "ratio of medians", "pairs"])
    text += "|---|---:|---:|---:|---:|---:|\n"
    for dataset in (d for d in against["datasets"] if "against" in d):
        seconds = {m["name"]: m["frames"]["median_seconds"] for m in dataset["mappers"] if m["frames"]}
        compared = dataset["against"]
        text += row([dataset["name"], f"{seconds['tetmarch']:.4f}", f"{seconds['against']:.4f}",
                     f"{compared['pairs']:.3f}", f"{compared['medians']:.3f}", str(compared["count"])])
    return text


def what_table(report):
    effects = {e["name"]: e["what"] for d in report["datasets"] for e in d["effects"]}
    text = row(["effect", "what is on"]) + "|---|---|\n"
    return text + "".join(row([f"`{name}`", what]) for name, what in effects.items())


def main():
    parser = parser_of(__doc__, "effects", "output")
    parser.add_argument("--against", type=pathlib.Path)
    arguments = parser.parse_args()
    report = json.loads(arguments.effects.read_text())
    against = json.loads(arguments.against.read_text()) if arguments.against else None
    charts.draw_effects(report, charts_folder(arguments.output))
    write_page(arguments.output / "Effects.md", report, arguments.remark, {
        "rounds": str(report["rounds"]),
        "what": what_table(report),
        "targets": targets_table(report, against),
        "effects": effects_table(report),
        "against": against_table(against),
    })


if __name__ == "__main__":
    main()
