# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ways to share the cells of a grid out among processes: an array with the process of each cell."""
import pathlib
import shutil
import subprocess
import tempfile

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

GHOSTS = "vtkGhostType"
DUPLICATE = 1  # vtkDataSetAttributes::DUPLICATECELL


def centres_of(grid):
    centres = vtk.vtkCellCenters()
    centres.SetInputData(grid)
    centres.Update()
    return vtk_to_numpy(centres.GetOutput().GetPoints().GetData()).astype(float)


def normalized_centres(grid):
    """0..1 along each axis."""
    centres = centres_of(grid)
    low, high = centres.min(axis=0), centres.max(axis=0)
    return (centres - low) / np.maximum(high - low, 1e-30)


def slabs(grid, processes):
    """Equally many cells, along x: their boxes hardly overlap."""
    order = np.argsort(centres_of(grid)[:, 0], kind="stable")
    owner = np.empty(len(order), dtype=int)
    owner[order] = np.arange(len(order)) * processes // len(order)
    return owner


def spirals(grid, processes):
    """Arms that are wound round each other, and twisted along z."""
    x, y, z = (normalized_centres(grid) - 0.5).T
    turn = np.arctan2(y, x) / (2 * np.pi) + 3 * np.hypot(x, y) + z
    return np.floor((turn - np.floor(turn)) * processes).astype(int) % processes


def shells(grid, processes):
    """Pieces inside one another."""
    far = np.abs(normalized_centres(grid) - 0.5).max(axis=1)
    return np.minimum((far * 2 * processes).astype(int), processes - 1)


def random_cells(grid, processes):
    """Each cell anywhere: the worst case."""
    return np.random.RandomState(5).randint(0, processes, grid.GetNumberOfCells())


def crust(grid, processes):
    """Process 0 has what is seen of the sides towards a viewer in front, to the right and above, the others slabs
    behind that."""
    x, y, z = normalized_centres(grid).T
    owner = np.zeros(len(x), dtype=int)
    behind = np.flatnonzero((x < 0.8) & (y > 0.2) & (z < 0.8))
    if processes > 1:
        order = behind[np.argsort(x[behind], kind="stable")]
        owner[order] = 1 + np.arange(len(order)) * (processes - 1) // len(order)
    return owner


def only_last(grid, processes):
    """All processes but the last are empty."""
    return np.full(grid.GetNumberOfCells(), processes - 1)


def has_metis():
    return shutil.which("mpmetis") is not None


def metis(grid, processes):
    """By the graph of neighbouring cells (Karypis and Kumar, "A fast and high quality multilevel scheme for
    partitioning irregular graphs", 1998); of tetrahedra alone."""
    if processes == 1:
        return np.zeros(grid.GetNumberOfCells(), dtype=int)
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4) + 1
    with tempfile.TemporaryDirectory() as folder:
        mesh = pathlib.Path(folder) / "mesh"
        np.savetxt(mesh, cells, fmt="%d", header=str(len(cells)), comments="")
        subprocess.run(["mpmetis", "-gtype=dual", "-ncommon=3", mesh, str(processes)], check=True,
                       stdout=subprocess.DEVNULL)
        return np.loadtxt(f"{mesh}.epart.{processes}", dtype=int)


PARTITIONS = {f.__name__: f for f in (slabs, spirals, shells, random_cells, crust, only_last, metis)}


def neighbours_of(grid, own):
    """The cells that share a point with one of these, without these."""
    points = np.zeros(grid.GetNumberOfPoints(), dtype=bool)
    offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    connectivity = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    of_cell = np.repeat(np.arange(grid.GetNumberOfCells()), np.diff(offsets))
    points[connectivity[own[of_cell]]] = True
    touched = np.zeros(grid.GetNumberOfCells(), dtype=bool)
    touched[of_cell[points[connectivity]]] = True
    return touched & ~own


def piece_of(grid, owner, process, ghosts=False):
    """The cells of one process; with a layer of ghosts, if these are asked for."""
    own = owner == process
    ghost = neighbours_of(grid, own) if ghosts and own.any() else np.zeros_like(own)
    extract = vtk.vtkExtractCells()
    ids = vtk.vtkIdList()
    for cell in np.flatnonzero(own | ghost):
        ids.InsertNextId(int(cell))
    extract.SetCellList(ids)
    extract.SetInputData(grid)
    extract.Update()
    piece = vtk.vtkUnstructuredGrid()
    piece.DeepCopy(extract.GetOutput())
    if ghosts and own.any():
        marks = np.where(ghost, DUPLICATE, 0)[np.flatnonzero(own | ghost)].astype(np.uint8)
        old = grid.GetCellData().GetArray(GHOSTS)
        if old:
            marks |= vtk_to_numpy(old)[np.flatnonzero(own | ghost)]
        array = numpy_to_vtk(marks, deep=True)
        array.SetName(GHOSTS)
        piece.GetCellData().RemoveArray(GHOSTS)
        piece.GetCellData().AddArray(array)
    return piece
