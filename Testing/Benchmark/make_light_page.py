# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes LightAccuracy.md out of LightAccuracyPage.md, with tables and a chart of what measure_light.py has measured.

    make_light_page.py LIGHT.json FOLDER [--remark TEXT]

LightAccuracy.md and Charts/ go into FOLDER.
"""
import json

import light_charts as charts
from measured_page import charts_folder, parser_of, row, write_page

ASKED_FOR = (8, 2, 1)  # 1/255
OF_CELLS = "cell gradients"  # another definition


def scene_words(scene):
    return f"{scene['name']} {scene['unlit_seconds']:.3f} s"


def results_table(report):
    text = row(["scene", "effect", "way", "RMS", "99.9 %", "max", "within 2/255", "frame, s", "times unlit",
                "light moved, s"])
    text += "|---|---|---|" + "---:|" * 7 + "\n"
    for scene in report["scenes"]:
        for r in scene["results"]:
            text += row([scene["name"], r["effect"], r["way"], f"{r['rms']:.1e}", f"{r['q999']:.3f}",
                         f"{r['max']:.3f}", f"{100 * r['within']:.2f} %", f"{r['seconds']:.3f}",
                         f"{r['times_unlit']:.2f}", f"{r['first_seconds']:.3f}" if "first_seconds" in r else ""])
    return text


def cheapest(results, most):
    kept = [r for r in results if r["q999"] <= most]
    if not kept:
        return "none"
    best = min(kept, key=lambda r: r["seconds"])
    return f"{best['way']} ({best['times_unlit']:.2f})"


def cheapest_table(report):
    """The fastest way whose 99.9 % quantile keeps an error, and its time in frames without light."""
    text = row(["scene", "effect", *(f"{n}/255" for n in ASKED_FOR)]) + "|---|---|" + "---|" * len(ASKED_FOR) + "\n"
    for scene in report["scenes"]:
        for effect in report["effects"]:
            results = [r for r in scene["results"] if r["effect"] == effect and r["way"] != OF_CELLS]
            text += row([scene["name"], effect, *(cheapest(results, n / 255) for n in ASKED_FOR)])
    return text


def main():
    arguments = parser_of(__doc__, "light", "output").parse_args()
    report = json.loads(arguments.light.read_text())
    charts.draw_light(report, charts_folder(arguments.output))
    write_page(arguments.output / "LightAccuracy.md", report, arguments.remark, {
        "timed": " x ".join(map(str, report["timed_size"])),
        "stride": str(report["stride"]),
        "effects": row(["effect", "what is on"]) + "|---|---|\n"
                   + "".join(row([f"`{name}`", words]) for name, words in report["effects"].items()),
        "unlit": ", ".join(map(scene_words, report["scenes"])),
        "cheapest": cheapest_table(report),
        "results": results_table(report),
    })


if __name__ == "__main__":
    main()
