# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Chart of light's accuracy against time, from the JSON file of measure_light.py."""
import math

from accuracy_charts import label_seconds, plt, save

COLORS = {"shading": "#1f77b4", "highlights": "#17becf", "shadows": "#d62728", "scattering": "#ff7f0e",
          "occlusion": "#2ca02c", "opaque-shadows": "#9467bd", "gradient-opacity": "#8c564b"}
# By how the name of a way begins, the longest that fits: marker, size, label.
MARKERS = {"at vertices": ("o", 5, "light kept at vertices or nodes"),
           "at vertices, accurate": ("P", 5, "the same, level Accurate"),
           "cell gradients": ("h", 5, "gradients of cells"),
           "along rays": ("^", 5, "shadows along rays"),
           "tolerance": (".", 7, "LightTolerance 8/255 to 1/255"),
           "VTK": ("s", 4, "VTK's GPU mapper, 1 and 4 samples a voxel")}
LEAST = 1e-6  # of what is drawn; logarithms of 0 are not


def family_of(way):
    return max((begin for begin in MARKERS if way.startswith(begin)), key=len)


def draw_effect(axes, results, color):
    points = [(r["seconds"], max(r["rms"], LEAST), r["way"]) for r in results]
    for seconds, rms, way in points:
        marker, size, _ = MARKERS[family_of(way)]
        axes.plot(seconds, rms, marker, color=color, markersize=size, markeredgewidth=0.5, markeredgecolor="white")
    tolerances = [(seconds, rms) for seconds, rms, way in points if way.startswith("tolerance")]
    if tolerances:
        axes.plot(*zip(*tolerances), "-", color=color, linewidth=1)


def draw_scene(axes, scene):
    for effect, color in COLORS.items():
        draw_effect(axes, [r for r in scene["results"] if r["effect"] == effect], color)
    axes.axvline(scene["unlit_seconds"], color="black", linewidth=0.8, linestyle=":")
    axes.set(title=scene["name"], xscale="log", yscale="log", xlabel="seconds a frame")
    label_seconds(axes)


def add_legend(figure, report):
    drawn = {family_of(r["way"]) for scene in report["scenes"] for r in scene["results"]}
    lines = [plt.Line2D([], [], color=COLORS[e], linewidth=4, label=words) for e, words in report["effects"].items()]
    lines += [plt.Line2D([], [], color="gray", marker=marker, markersize=size, linestyle="", label=label)
              for family, (marker, size, label) in MARKERS.items() if family in drawn]
    lines.append(plt.Line2D([], [], color="black", linewidth=0.8, linestyle=":", label="a frame without light"))
    figure.legend(handles=lines, loc="upper center", ncol=3, fontsize=8, frameon=False, bbox_to_anchor=(0.5, 0.0))


def draw_light(report, folder):
    scenes = report["scenes"]
    columns = min(2, len(scenes))
    rows = math.ceil(len(scenes) / columns)
    figure, panels = plt.subplots(rows, columns, figsize=(5 * columns, 3.8 * rows), squeeze=False)
    for axes in panels.flat[len(scenes):]:
        axes.set_visible(False)
    for axes, scene in zip(panels.flat, scenes):
        draw_scene(axes, scene)
    for row in panels:
        row[0].set_ylabel("RMS error of the picture")
    figure.tight_layout()
    add_legend(figure, report)
    save(figure, folder, "light")
