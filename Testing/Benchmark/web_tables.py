# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables in Markdown of what measure_web.py measured."""
import statistics

from measured_page import machine, row

STEPS = 255  # errors are in units of 1/255


def median(numbers, digits=0):
    return f"{statistics.median(numbers):.{digits}f}"


def frames_table(measured):
    text = row(["scene", "mapper, ms", "page, ms", "ratio", "quartiles", "longest tile, ms"])
    text += "|---|" + "---:|" * 5 + "\n"
    for scene in measured:
        low, middle, high = scene["ratio_quartiles"]
        text += row([scene["name"], median(scene["mapper_ms"]), median(scene["page_ms"]), f"{middle:.2f}",
                     f"{low:.2f} to {high:.2f}", median(scene["longest_tile_ms"])])
    return text


def images_table(measured):
    text = row(["scan drawn by", "ms", "RMS error, 1/255", "99.9 % quantile, 1/255"]) + "|---|---:|---:|---:|\n"
    for page in measured:
        text += row([page["name"], median(page["ms"]), f"{STEPS * page['rms']:.2f}", f"{STEPS * page['q999']:.1f}"])
    return text


def openings_table(measured):
    """A row per browser, a column per scene."""
    names = list(dict.fromkeys(opening["name"] for opening in measured))
    text = row(["browser", *(f"{name}, s" for name in names)]) + "|---|" + "---:|" * len(names) + "\n"
    for which in dict.fromkeys((opening["browser"], opening["driver"]) for opening in measured):
        seconds = {opening["name"]: opening["seconds"] for opening in measured
                   if (opening["browser"], opening["driver"]) == which}
        text += row([f"{which[0].capitalize()}, {which[1]}", *(median(seconds[name], 2) for name in names)])
    return text


TABLES = {"frames": frames_table, "images": images_table, "openings": openings_table}


def text_of(report):
    tables = [make(report[part]) for part, make in TABLES.items() if part in report]
    return "\n".join([f"{machine(report)}; load {report['load']:.1f} at the beginning\n", *tables])
