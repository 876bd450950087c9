# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Accuracy against time: how wrong a picture is, measured, and what it takes to be less wrong."""
import matplotlib
import vtktetmarch

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

figure = vtktetmarch.figure("Data/golfball_small.vtu", "vorticity_mag", range=(0, 8), cmap="inferno",
                            opacity=[(0.5, 0), (8, 1)], unit_distance=0.3, size=(360, 240))
levels: dict[str, dict] = {"fast": dict(accuracy_level="fast")}
for power in (4, 6, 8, 10, 12, 14):
    levels[f"1/{2**power}"] = dict(accuracy_level="default", error_tolerance=2.0**-power)

milliseconds, errors = [], []
for level in levels.values():
    vtktetmarch.configure(figure.volume, **level)
    milliseconds.append(1000 * min(figure.render().statistics()["seconds"] for _ in range(20)))
    errors.append(figure.compare()["rms"])

with plt.style.context("dark_background"):
    chart, axes = plt.subplots(figsize=(7, 4.2))
    axes.semilogy(milliseconds[1:], errors[1:], color="0.4", zorder=1)
    axes.scatter(milliseconds, errors, c=range(len(levels)), cmap="plasma", s=70, zorder=2)
    for name, x, y in zip(levels, milliseconds, errors):
        axes.annotate(name, (x, y), xytext=(8, -14 if name == "fast" else 6), textcoords="offset points")
    axes.set(xlabel="milliseconds a frame", ylabel="RMS error of a channel (0 to 1)", title="Error tolerances")
    axes.margins(x=0.2, y=0.12)
    chart.savefig("accuracy.png", dpi=120, bbox_inches="tight")
