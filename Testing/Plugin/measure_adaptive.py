# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""An adaptive mesh in ParaView, drawn exactly and resampled: measure_adaptive.py --plugin TetMarch.so [OPTION]...

Run by pvpython. Cells are refined twice around a shell; of the coarsest level there are N along each edge (24). Or the
mesh is that of a .vthb, with an array of cells over a range of its values. Prints a table: seconds to the first frame
and of a frame, and the difference from the picture at the accuracy level Reference (RMS of a channel, 8 bits).
"""
import argparse
import math
import pathlib
import statistics
import sys
import time

from lattices import ARRAY, source_of
from paraview import simple
from views import load_plugin, open_view, picture_of

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "Benchmark"))
from write_leaves import LEVELS, adaptive


class Shell:
    """In the unit cube."""
    array, low, high = ARRAY, 0.0, 1.0

    def __init__(self, cells):
        self.mesh, self.cells = adaptive(cells)
        self.finest = cells << (LEVELS - 1)

    def source(self):
        return source_of(self.mesh)


class File:
    """All levels of a .vthb."""

    def __init__(self, path, array, low, high):
        self.path, self.array, self.low, self.high = path, array, low, high
        self.finest = 256  # samples, as far as the finest cells would take too many
        source = self.source()
        self.cells = source.GetDataInformation().GetNumberOfCells()
        simple.Delete(source)

    def source(self):
        source = simple.OpenDataFile(self.path)
        source.DefaultNumberOfLevels = 100
        source.UpdatePipeline()
        return source


def use_functions(data):
    def at(share):
        return data.low + share * (data.high - data.low)

    simple.GetColorTransferFunction(data.array).RGBPoints = [
        at(0.0), 0.1, 0.2, 0.9, at(0.5), 0.9, 0.9, 0.9, at(1.0), 0.8, 0.1, 0.1]
    simple.GetOpacityTransferFunction(data.array).Points = [
        at(0.0), 0.0, 0.5, 0.0, at(0.2), 0.02, 0.5, 0.0, at(1.0), 0.8, 0.5, 0.0]


def draw(data, kind, prepare, frames):
    """(seconds to the first frame, median seconds of a frame, picture)"""
    view = open_view()
    view.ViewSize = [512, 512]
    source = data.source()
    bounds = source.GetDataInformation().GetBounds()
    size = bounds[1] - bounds[0]
    view.CameraPosition = [low + size * a for low, a in zip(bounds[::2], (1.6, -1.9, 1.4))]
    view.CameraFocalPoint = [low + size * 0.5 for low in bounds[::2]]
    view.CameraViewUp = [0, 0, 1]
    begin = time.perf_counter()
    display = simple.Show(source, view, "AMRRepresentation")
    simple.ColorBy(display, ("CELLS", data.array))
    use_functions(data)
    display.SetRepresentationType(kind)
    display.ScalarOpacityUnitDistance = 0.05 * size
    prepare(display)
    picture = picture_of(view)
    first = time.perf_counter() - begin
    seconds = []
    for _ in range(frames):
        view.SMProxy.GetActiveCamera().Azimuth(1)
        begin = time.perf_counter()
        picture_of(view)
        seconds.append(time.perf_counter() - begin)
    simple.Delete(source)
    simple.Delete(view)
    return first, statistics.median(seconds), picture


def rms(picture, reference):
    squares = [(a - b) ** 2 for p, q in zip(picture, reference) for a, b in zip(p, q)]
    return math.sqrt(sum(squares) / len(squares)) / 255


def with_level(level):
    return "Tet Marching", lambda display: setattr(display, "TetMarchAccuracyLevel", level)


def resampled(*samples):
    return "Volume", lambda display: setattr(display, "NumberOfSamples", samples)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", required=True)
    parser.add_argument("--pictures", help="is not used")
    parser.add_argument("--cells", type=int, default=24)
    parser.add_argument("--frames", type=int, default=5)
    parser.add_argument("--file", nargs=4, metavar=("FILE", "ARRAY", "LOW", "HIGH"), help="instead of the shell")
    arguments = parser.parse_args()
    load_plugin(arguments)
    if arguments.file:
        path, array, *ends = arguments.file
        data = File(path, array, *map(float, ends))
    else:
        data = Shell(arguments.cells)
    ways = {
        "TetMarch, Reference": with_level("Reference"),
        "TetMarch, Default": with_level("Default"),
        "ParaView's Volume, 64 x 128 x 64 samples (its default)": resampled(64, 128, 64),
        f"ParaView's Volume, {data.finest}^3 samples": resampled(*[data.finest] * 3),
    }
    print(f"{data.cells} cells\n\n| drawn by | first frame, s | frame, s | RMS |\n|---|---:|---:|---:|")
    reference = None
    for name, (kind, prepare) in ways.items():
        first, frame, picture = draw(data, kind, prepare, arguments.frames)
        reference = reference or picture
        print(f"| {name} | {first:.2f} | {frame:.3f} | {rms(picture, reference):.1e} |", flush=True)


main()
