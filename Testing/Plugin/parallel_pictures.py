# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of Documentation/Processes.md: parallel_pictures.py PVBATCH PLUGIN OUT.png"""
import pathlib
import sys
import tempfile

import matplotlib
import numpy as np

import ParallelTest
import parallel_runs

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

SCENES = {"composite": "composite", "isosurface": "isosurfaces"}


def main():
    ParallelTest.PVBATCH, ParallelTest.PLUGIN, output = sys.argv[1:]
    test = ParallelTest.DrawnCase
    test.grid = parallel_runs.made_grid()
    with tempfile.TemporaryDirectory() as folder:
        test.folder = pathlib.Path(folder)
        one = test.draw("slabs", 1, tuple(SCENES))
        over = test.draw("spirals", 4, tuple(SCENES), "--pieces")
        exact = test.draw("spirals", 4, tuple(SCENES))
    figure, axes = pyplot.subplots(len(SCENES), 3, figsize=(9, 4.9))
    for row, (name, words) in zip(axes, SCENES.items()):
        for axis, pictures, title in zip(row, (one, over, exact), ("one process", "pieces over each other", "exact")):
            axis.imshow(pictures[name][::-1].astype(np.uint8))
            apart = np.abs(pictures[name] - one[name]).max()
            axis.set_title(f"{words}: {title}" + (f", up to {apart}/255 off" if pictures is not one else ""), fontsize=7)
            axis.axis("off")
    figure.tight_layout()
    figure.savefig(output, dpi=100)


if __name__ == "__main__":
    main()
