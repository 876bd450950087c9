# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Statistics of the last frame, and its error."""
from .errors import VtkErrors
from .properties import snake_case
from .vtkRenderingTetMarch import vtkTetMarchFrameStatistics

PERCENTS = (50, 90, 99, 99.9)
QUANTITIES = {"error_bound": vtkTetMarchFrameStatistics.ERROR_BOUND, "cells": vtkTetMarchFrameStatistics.CELLS,
              "lookups": vtkTetMarchFrameStatistics.LOOKUPS, "true_error": vtkTetMarchFrameStatistics.TRUE_ERROR}


def mapper_of(drawn):
    """The mapper of a Figure, a vtkVolume, or a mapper itself."""
    mapper = drawn.volume if hasattr(drawn, "volume") else drawn
    mapper = mapper.GetMapper() if hasattr(mapper, "GetMapper") else mapper
    if not hasattr(mapper, "GetLastFrameStatistics"):
        raise TypeError(f"{type(drawn).__name__} has no mapper of TetMarch: give a Figure, a vtkVolume or a mapper")
    return mapper


def quantity_of(frame, quantity):
    """The measures of the pixels: a dict, or None."""
    count = frame.GetNumberOfPixels(quantity)
    if count == 0:
        return None
    return {"pixels": count, "minimum": frame.GetMinimum(quantity), "mean": frame.GetMean(quantity),
            "rms": frame.GetRootMeanSquare(quantity), "max": frame.GetMaximum(quantity),
            "percentiles": {percent: frame.GetPercentile(quantity, percent) for percent in PERCENTS}}


def statistics(drawn):
    """Statistics of the last frame of a Figure, a vtkVolume or a mapper, as a dict. See vtkTetMarchFrameStatistics.

    *_seconds, seconds: times, in seconds. *_bytes: memory. *_builds: number of runs of a stage since the mapper was
    created. number_of_*: counts. used_accuracy_level, used_shader_stage: words. used_error_tolerance: of a channel, 0
    to 1; 0: none is guaranteed. used_image_sample_distance: between rays, in pixels. budget_kept, light_complete: bool.
    error_bound, cells, lookups, true_error: over the pixels whose ray met the volume, if measured, else None: a dict
    with pixels (their number), minimum, mean, rms, max and percentiles ({50: ..., 90: ..., 99: ..., 99.9: ...}). Errors
    are of a channel, 0 to 1. The first three are measured with collect_diagnostics=True, the last by compare().
    """
    frame = mapper_of(drawn).GetLastFrameStatistics()
    found = {}
    for method in vars(vtkTetMarchFrameStatistics):
        name = method[3:]
        if method.startswith("Get") and hasattr(frame, "Set" + name):
            found[snake_case(name)] = getattr(frame, method)()
    found["used_accuracy_level"] = frame.GetUsedAccuracyLevelAsString().lower()
    found["used_shader_stage"] = frame.GetUsedShaderStageAsString().lower()
    found["budget_kept"], found["light_complete"] = frame.GetBudgetKept(), frame.GetLightComplete()
    for name, quantity in QUANTITIES.items():
        found[name] = quantity_of(frame, quantity)
    return dict(sorted(found.items()))


def compare_figure(drawn):
    """Draws a frame of a Figure and returns its error as figures.compare() does."""
    mapper = mapper_of(drawn)
    collected = mapper.GetCollectDiagnostics()
    mapper.SetCollectDiagnostics(True)
    try:
        drawn.render()
        with VtkErrors() as errors:
            compared = mapper.CompareWithGroundTruth(drawn.volume)
            drawn.renderer.GetRenderWindow().ReleaseCurrent()
        found = statistics(drawn)
    finally:
        mapper.SetCollectDiagnostics(collected)
    if not compared or errors:
        raise RuntimeError(f"the picture can't be compared: {errors or 'nothing was drawn'}")
    if found["true_error"] is None:
        raise RuntimeError("the picture can't be compared: no ray met the volume")
    return {**found["true_error"], "error_bound": found["error_bound"], "statistics": found}
