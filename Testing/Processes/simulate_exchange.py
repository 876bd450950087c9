# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What many processes would send each other, without running them: simulate_exchange.py [STRIDE]

The cells that rays of one picture of the golf ball cross are traced once. For each number of processes the mesh is cut
by METIS, and the cells of a ray by whose they are: so many visits, to so many bytes as Processes/SentVisits.cxx
packs. Every STRIDE-th pixel of every STRIDE-th row is traced.
"""
import pathlib
import sys

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path += [str(HERE), str(HERE.parent / "Benchmark")]

import partitions  # noqa: E402
from measure_pieces import SIZE, golf_ball, window_of  # noqa: E402
from vtktetmarch import vtkTetMarchVolumeMapper  # noqa: E402

COUNTS = (8, 64, 256, 1024)
LEAST_OPACITY = 0.05  # of the stream: all of the mesh lets a little be seen
VISIT_BYTES, COUNT_BYTES, SPAN_BYTES, PIXEL_BYTES = 32, 2, 8, 16  # of Visit, a count, a row's span, four floats


def trace(grid, stride):
    """Rows of pixels; of each pixel the cells that its ray crosses."""
    mapper = vtkTetMarchVolumeMapper()
    window = window_of(mapper, grid, LEAST_OPACITY)
    renderer = window.GetRenderers().GetFirstRenderer()
    renderer.ResetCameraClippingRange()
    window.Render()
    volume = renderer.GetVolumes().GetItemAsObject(0)
    table = vtk.vtkTable()
    rows = []
    for y in range(0, SIZE[1], stride):
        rows.append([])
        for x in range(0, SIZE[0], stride):
            mapper.TraceRay(volume, x, y, mapper.TRACE_FLOAT, table)
            column = table.GetColumnByName("CellId")
            cells = vtk_to_numpy(column).copy() if column and table.GetNumberOfRows() else np.zeros(0, dtype=int)
            rows[-1].append(cells)
    return rows


def simulate(rows, owner, processes, stride):
    """Visits, bytes sent of each process, visits merged by each."""
    sent = np.zeros(processes)
    merged = np.zeros(processes)
    visits = pixels = 0
    for number, row in enumerate(rows):
        merger = number % processes
        first = np.full(processes, len(row))
        last = np.full(processes, -1)
        for x, cells in enumerate(row):
            if not len(cells):
                continue
            pixels += 1
            owners = owner[cells]
            runs = owners[np.flatnonzero(np.r_[True, owners[1:] != owners[:-1]])]
            visits += len(runs)
            merged[merger] += len(runs)
            there, counts = np.unique(runs, return_counts=True)
            first[there] = np.minimum(first[there], x)
            last[there] = x
            far = there != merger
            sent[there[far]] += VISIT_BYTES * counts[far] * stride ** 2
        spans = np.maximum(last - first + 1, 0) * stride
        sent += (SPAN_BYTES + COUNT_BYTES * spans) * stride * (np.arange(processes) != merger)
    return visits * stride ** 2, visits / pixels, sent, merged * stride ** 2


def main():
    stride = int(sys.argv[1]) if len(sys.argv) > 1 else 4
    grid = golf_ball()
    rows = trace(grid, stride)
    lines = ["| processes | visits of a ray that meets the mesh | visits, millions | MB sent: all | busiest process "
             "| of the mean | to each process, of the picture, MB |", "|---:|---:|---:|---:|---:|---:|---:|"]
    for processes in COUNTS:
        visits, per_ray, sent, _ = simulate(rows, partitions.metis(grid, processes), processes, stride)
        picture = SIZE[0] * SIZE[1] * PIXEL_BYTES
        lines.append(f"| {processes} | {per_ray:.2f} | {visits / 1e6:.2f} | {sent.sum() / 1e6:.1f} | {sent.max() / 1e6:.3f} "
                     f"| {sent.max() / sent.mean():.1f} | {picture / 1e6:.1f} |")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
