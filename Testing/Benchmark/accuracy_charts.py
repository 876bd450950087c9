# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Charts of what accuracy costs, from the JSON files of tetmarch-bench accuracy and refinement."""
import math

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import matplotlib.ticker  # noqa: E402

plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.25, "axes.axisbelow": True})

OURS = "tetmarch"
ADAPTIVE = "tetmarch-adaptive"
LEAST = 1e-7  # of what is drawn of errors; logarithms of 0 are not
# Name of a family: how its mappers begin, colour, marker.
FAMILIES = {
    "TetMarch, all levels and tolerances": (OURS, "#d62728", "o"),
    "the same, adaptive, 4/255: Default, Fast": (ADAPTIVE, "#ff7f0e", "*"),
    "projected tetrahedra": ("projected", "#1f77b4", "s"),
    "Bunyk ray caster, each integrator": ("bunyk", "#2ca02c", "^"),
    "Z-sweep": ("zsweep", "#9467bd", "v"),
    "resampled to an image, VTK's GPU ray caster": ("resample", "#7f7f7f", "D"),
}
# Of mappers in the refinement chart.
LINES = {
    "tetmarch-reference": ("TetMarch, Reference", "#d62728", "o", "-"),
    "tetmarch": ("TetMarch, Default", "#ff7f0e", "x", ":"),
    "projected": ("projected tetrahedra", "#1f77b4", "s", "-"),
    "bunyk-homogeneous": ("Bunyk, homogeneous", "#98df8a", "^", "-"),
    "bunyk-preintegration": ("Bunyk, pre-integration", "#2ca02c", "^", "--"),
    "bunyk-partial": ("Bunyk, partial pre-integration", "#006400", "^", "-."),
    "bunyk-linear": ("Bunyk, linear", "#8c9a00", "^", ":"),
    "zsweep": ("Z-sweep", "#9467bd", "v", "-"),
}


def is_ours(name):
    return name.startswith(OURS)


def is_adaptive(name):
    return name.startswith(ADAPTIVE)


def family_of(name, families):
    """The label of the family whose beginning of names is the longest that fits; None if none does."""
    fitting = [(len(prefix), label) for label, (prefix, _, _) in families.items() if name.startswith(prefix)]
    return max(fitting)[1] if fitting else None


def measured(subject):
    """(name, seconds a frame, errors) of the mappers of which there are both."""
    return [
        (m["name"], m["frames"]["median_seconds"], m["errors"])
        for m in subject["mappers"]
        if m.get("errors") and m["frames"]
    ]


def front(points):
    """Of (seconds, error), those of which no other is as good in one and better in the other; in order."""
    best = []
    for seconds, error in sorted(points):
        if not best or error < best[-1][1]:
            best.append((seconds, error))
    return best


def title(subject):
    if "dimensions" in subject:
        return f"{subject['name']} ({' x '.join(str(n) for n in subject['dimensions'])}), {subject['functions']}"
    cells = subject["tetrahedra"]
    count = f"{cells / 1e6:.1f} M" if cells >= 1e6 else f"{cells / 1e3:.0f} k"
    return f"{subject['name']} ({count} tets), {subject['functions']}"


def label_seconds(axes):
    axes.xaxis.set_major_locator(matplotlib.ticker.LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.xaxis.set_major_formatter(matplotlib.ticker.FuncFormatter(lambda x, _: f"{x:g}"))
    axes.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())


def draw_subject(axes, subject, families):
    points = [(name, seconds, max(errors["rms"], LEAST)) for name, seconds, errors in measured(subject)]
    for label, (_, color, marker) in families.items():
        of_family = sorted((s, e) for name, s, e in points if family_of(name, families) == label)
        if of_family:
            axes.plot(*zip(*of_family), marker, color=color, label=label, markersize=5)
    best = front([(s, e) for _, s, e in points])
    axes.step(*zip(*best), where="post", color="black", linewidth=0.8, label="Pareto front", zorder=1)
    axes.set(xscale="log", yscale="log", title=title(subject))
    axes.title.set_fontsize(9)
    label_seconds(axes)


def save(figure, folder, name):
    figure.savefig(folder / f"{name}.png", dpi=110, bbox_inches="tight")
    plt.close(figure)


def add_legend(figure, axes, columns):
    handles, labels = axes.get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=columns, frameon=False, bbox_to_anchor=(0.5, 1.0))


def draw_time(report, folder, name="accuracy", families=FAMILIES):
    """Error over time of all subjects: a row a dataset, a column a set of functions."""
    datasets = list(dict.fromkeys(s["name"] for s in report["datasets"]))
    functions = list(dict.fromkeys(s["functions"] for s in report["datasets"]))
    figure, grid = plt.subplots(
        len(datasets), len(functions), figsize=(4 * len(functions), 2.9 * len(datasets)), squeeze=False
    )
    for axes in grid.flat:
        axes.set_visible(False)
    for subject in report["datasets"]:
        axes = grid[datasets.index(subject["name"])][functions.index(subject["functions"])]
        axes.set_visible(bool(measured(subject)))
        if measured(subject):
            draw_subject(axes, subject, families)
    for axes in grid[-1]:
        axes.set_xlabel("seconds a frame")
    for row in grid:
        row[0].set_ylabel("RMS error")
    figure.tight_layout()
    add_legend(figure, grid[0][0], 3)
    save(figure, folder, name)


def draw_overview(report, folder, wanted):
    """The subjects (dataset, functions) of the README's chart, as far as they were measured."""
    chosen = [s for s in report["datasets"] if (s["name"], s["functions"]) in wanted and measured(s)]
    if not chosen:
        return
    figure, grid = plt.subplots(1, len(chosen), figsize=(3.6 * len(chosen), 3.1), squeeze=False)
    for axes, subject in zip(grid[0], chosen):
        draw_subject(axes, subject, FAMILIES)
        axes.set_xlabel("seconds a frame")
    grid[0][0].set_ylabel("RMS error of a channel, 0..1")
    figure.tight_layout()
    add_legend(figure, grid[0][0], 3)
    save(figure, folder, "overview")


def draw_lookups(report, folder):
    """Error over lookups a cell, of our levels and tolerances."""
    functions = list(dict.fromkeys(s["functions"] for s in report["datasets"]))
    figure, grid = plt.subplots(1, len(functions), figsize=(3.6 * len(functions), 3.1), squeeze=False, sharey=True)
    for axes, name in zip(grid[0], functions):
        for subject in (s for s in report["datasets"] if s["functions"] == name):
            points = sorted(
                (e["lookups_per_cell"], max(e["rms"], LEAST))
                for n, _, e in measured(subject)
                if is_ours(n) and not is_adaptive(n)
            )
            if points:
                axes.plot(*zip(*points), "o-", markersize=4, linewidth=0.8, label=subject["name"])
        axes.set(yscale="log", title=name, xlabel="lookups a cell")
    grid[0][0].set_ylabel("RMS error")
    figure.tight_layout()
    add_legend(figure, grid[0][0], 5)
    save(figure, folder, "lookups")


def refinement(report):
    """{mapper: [(width of a cube, RMS error)]}, coarse first."""
    lines = {}
    for subject in report["datasets"]:
        width = 1.0 / int(subject["name"].split(":")[1])
        for name, _, errors in measured(subject):
            lines.setdefault(name, []).append((width, errors["rms"]))
    return {name: sorted(points, reverse=True) for name, points in lines.items()}


def slopes(points):
    """Observed orders from each mesh to the next finer one."""
    return [
        math.log(e0 / e1) / math.log(h0 / h1) for (h0, e0), (h1, e1) in zip(points, points[1:])
    ]


def draw_refinement(report, folder):
    figure, axes = plt.subplots(figsize=(6.5, 4.2))
    lines = refinement(report)
    for name, (label, color, marker, style) in LINES.items():
        if len(lines.get(name, [])) > 1:
            order = slopes(lines[name])[-1]
            axes.plot(
                *zip(*lines[name]), style, marker=marker, color=color, markersize=5,
                label=f"{label}: {order:.2f}",
            )
    widths = sorted({h for points in lines.values() for h, _ in points})
    if OURS in lines:
        h0, e0 = lines[OURS][0]
        axes.plot(widths, [1.5 * e0 * (h / h0) ** 2 for h in widths], color="black", linewidth=0.8, label="slope 2")
    axes.set(
        xscale="log", yscale="log", xlabel="width of a cube of six tetrahedra (edge of the domain: 1)",
        ylabel="RMS error against the field itself",
    )
    axes.legend(title="observed order, last two meshes", fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
    save(figure, folder, "refinement")
