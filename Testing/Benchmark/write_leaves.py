# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""An adaptive mesh, refined twice around a thin shell: write_leaves.py FILE.vthb [--cells N] [--side N]

writes one of N cells of the coarsest level along each edge (128), in blocks of twice as many cells of each finer level
as SIDE (16) along theirs: 22.5 million leaves.
"""
import argparse

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk

LEVELS = 3
RADIUS = 0.35


def value_at(centers):
    """1 on the shell and less away from it, exp(-(d / 0.02)^2) for a distance of d; waves of 0.2 at most."""
    x, y, z = np.moveaxis(centers, -1, 0)
    distance = np.linalg.norm(centers - 0.5, axis=-1) - RADIUS
    return 0.8 * np.exp(-(distance / 0.02)**2) + 0.1 + 0.1 * np.sin(20 * x) * np.cos(15 * y + 10 * z)


def block_of(kind, width, low, count):
    """Cells with the value at their centres, from cell `low` on."""
    block = kind()
    block.SetDimensions([count + 1] * 3)
    block.SetOrigin([width * a for a in low])
    block.SetSpacing([width] * 3)
    axes = [width * (a + np.arange(count) + 0.5) for a in low[::-1]]
    values = np.concatenate([value_at(np.stack(np.meshgrid([z], *axes[1:], indexing="ij")[::-1], axis=-1)).ravel()
                             for z in axes[0]])
    array = numpy_to_vtk(values.astype(np.float32), deep=True)
    array.SetName("f")
    block.GetCellData().SetScalars(array)
    return block


def meets_shell(low, width, side):
    low = np.array(low) * width
    high = low + side * width
    nearest = np.linalg.norm(np.clip(0.5, low, high) - 0.5)
    farthest = np.linalg.norm(np.maximum(0.5 - low, high - 0.5))
    return nearest <= RADIUS <= farthest


def refined(boxes, width, side):
    """Low corners, on the next level, of the blocks of these boxes (low, count) that the shell passes through."""
    return [[2 * (a + side * i) for a, i in zip(low, place)] for low, count in boxes
            for place in np.ndindex(*[count // side] * 3)
            if meets_shell([a + side * i for a, i in zip(low, place)], width, side)]


def adaptive(coarsest, side=4):
    """The mesh, and the number of its leaves; blocks of `side` cells of a level along an edge are refined."""
    widths = [1 / (coarsest << level) for level in range(LEVELS)]
    boxes = [[([0, 0, 0], coarsest)]]
    for width in widths[:-1]:
        boxes.append([(low, 2 * side) for low in refined(boxes[-1], width, side)])
    mesh = vtk.vtkOverlappingAMR()
    mesh.Initialize(LEVELS, [len(each) for each in boxes])
    mesh.SetOrigin([0, 0, 0])
    mesh.SetGridDescription(vtk.VTK_XYZ_GRID)
    for level, (width, each) in enumerate(zip(widths, boxes)):
        mesh.SetSpacing(level, [width] * 3)
        for number, (low, count) in enumerate(each):
            mesh.SetAMRBox(level, number, vtk.vtkAMRBox(low, [a + count - 1 for a in low]))
            mesh.SetDataSet(level, number, block_of(vtk.vtkUniformGrid, width, low, count))
    hidden = sum(len(each) for each in boxes[1:]) * side**3  # below finer ones
    return mesh, sum(count**3 for each in boxes for _, count in each) - hidden


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file")
    parser.add_argument("--cells", type=int, default=128)
    parser.add_argument("--side", type=int, default=16)
    options = parser.parse_args()
    mesh, leaves = adaptive(options.cells, options.side)
    writer = vtk.vtkXMLUniformGridAMRWriter()
    writer.SetFileName(options.file)
    writer.SetInputDataObject(mesh)
    if not writer.Write():
        raise SystemExit(f"{options.file} can't be written")
    print(f"{leaves:,} leaves")


if __name__ == "__main__":
    main()
