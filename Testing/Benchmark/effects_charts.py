# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Chart of what effects cost, from the JSON file of tetmarch-bench effects."""
import matplotlib.ticker

from accuracy_charts import plt, save

COLORS = ("#d62728", "#1f77b4", "#2ca02c", "#9467bd", "#7f7f7f")
STAGES = (("gradients", ""), ("light", "////"))  # done once; hatched: light at vertices


def measured(dataset):
    """{name: effect} of those that were drawn."""
    return {e["name"]: e for e in dataset["effects"] if e["base_ratio"]}


def names_of(report):
    return list(dict.fromkeys(name for d in report["datasets"] for name in measured(d)))


def draw_frames(axes, places, effects, height, color, label):
    """Bars from the base frame to the medians of ratios to it, with the range of all turns."""
    ratios = [e["base_ratio"] for e in effects]
    medians = [r["median"] for r in ratios]
    ranges = [[r["median"] - r["min"] for r in ratios], [r["max"] - r["median"] for r in ratios]]
    axes.barh(places, [m - 1.0 for m in medians], height, left=1.0, color=color, label=label, xerr=ranges,
              error_kw={"elinewidth": 0.8})
    for place, ratio in zip(places, ratios):
        axes.annotate(f"{ratio['median']:.2f}", (ratio["max"], place), xytext=(3, 0), textcoords="offset points",
                      va="center", fontsize=7)


def draw_stages(axes, places, effects, height, color):
    left = [0.0] * len(effects)
    for stage, hatch in STAGES:
        widths = [e.get(f"{stage}_base_frames", 0.0) for e in effects]
        axes.barh(places, widths, height, left=left, color=color, hatch=hatch, edgecolor="white", linewidth=0)
        left = [a + b for a, b in zip(left, widths)]


def draw_effects(report, folder):
    names = names_of(report)
    datasets = [d for d in report["datasets"] if measured(d)]
    if not datasets:
        return
    figure, (frames, stages) = plt.subplots(
        1, 2, figsize=(10.5, 0.9 + 0.45 * len(names)), sharey=True, width_ratios=(3, 2)
    )
    height = 0.8 / len(datasets)
    for i, dataset in enumerate(datasets):
        of_dataset = measured(dataset)
        shown = [name for name in names if name in of_dataset]
        places = [names.index(name) + (i - 0.5 * (len(datasets) - 1)) * height for name in shown]
        effects = [of_dataset[name] for name in shown]
        color = COLORS[i % len(COLORS)]
        draw_frames(frames, places, effects, height, color, dataset["name"])
        draw_stages(stages, places, effects, height, color)
    frames.axvline(1.0, color="black", linewidth=0.8)
    frames.set(xscale="log", xlabel="a frame, in base frames", yticks=range(len(names)), yticklabels=names)
    low, high = frames.get_xlim()
    frames.set_xlim(min(low, 0.9), 1.3 * high)  # room for the numbers
    frames.xaxis.set_major_locator(matplotlib.ticker.LogLocator(subs=(1.0, 2.0, 5.0)))
    frames.xaxis.set_major_formatter(matplotlib.ticker.FuncFormatter(lambda x, _: f"{x:g}"))
    frames.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
    frames.invert_yaxis()
    frames.legend(fontsize=8)
    stages.set_xlabel("once, in base frames: gradients, light (hatched)")
    figure.tight_layout()
    save(figure, folder, "effects")
