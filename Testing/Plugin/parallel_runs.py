# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What tests of ParaView in several processes have in common: a grid in pieces, and runs of pvbatch."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path += [str(HERE.parent / "Processes"), str(HERE.parent / "Benchmark")]

import vtkmodules.all as vtk  # noqa: E402

import made_grids  # noqa: E402
import mpi  # noqa: E402
import partitions  # noqa: E402

CUBES = 9


def environment(folder):
    """A home of its own: ParaView keeps there what settings were changed, and reads it in the next run."""
    cache = os.environ.get("XDG_CACHE_HOME", str(pathlib.Path.home() / ".cache"))
    return {**os.environ, **mpi.ENVIRONMENT, "PYTHONPATH": str(HERE), "HOME": str(folder), "XDG_CACHE_HOME": cache,
            "XDG_CONFIG_HOME": str(folder)}


def run_batch(folder, pvbatch, processes, script, *arguments, seconds=1000):
    """Returns what was printed. A process that waits for ever, or fails, is an error."""
    command = ["mpiexec", "-n", str(processes), pvbatch, str(HERE / script), *map(str, arguments)]
    result = subprocess.run(command, text=True, timeout=seconds, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            env=environment(folder))
    if result.returncode != 0:
        raise AssertionError(f"{' '.join(command)} ended with {result.returncode}:\n{result.stdout}")
    return result.stdout


class ParallelCase(unittest.TestCase):
    """With a grid, and a folder for its pieces and pictures."""

    @classmethod
    def setUpClass(cls):
        if not mpi.has_mpi():
            raise unittest.SkipTest("there is no mpiexec")
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.grid = made_grid()


def made_grid():
    grid = made_grids.lattice(CUBES, made_grids.outside_a_hole)
    made_grids.add_array(grid.GetPointData(), "field", made_grids.waves(made_grids.points_of(grid), 1.0, 0))
    made_grids.add_array(grid.GetCellData(), "of_cells", made_grids.waves(made_grids.cell_centres_of(grid), 1.0, 0))
    return grid


def write_inline(grid, file):
    """As Debian 12's ParaView reads it whatever libexpat it has."""
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetInputData(grid)
    writer.SetFileName(str(file))
    writer.SetDataModeToBinary()
    writer.Write()


def write_pieces(grid, partition, processes, folder):
    ghosts = partition == "ghosts"
    owner = partitions.PARTITIONS["random_cells" if ghosts else partition](grid, processes)
    names = []
    for process in range(processes):
        piece = partitions.piece_of(grid, owner, process, ghosts)
        names.append(f"{process}.vtu")
        write_inline(piece, folder / names[-1])
    ghost_array = '<PDataArray type="UInt8" Name="vtkGhostType"/>' if ghosts else ""
    (folder / "all.pvtu").write_text(f"""<VTKFile type="PUnstructuredGrid" version="1.0" byte_order="LittleEndian">
<PUnstructuredGrid GhostLevel="0">
<PPointData><PDataArray type="Float64" Name="field"/></PPointData>
<PCellData><PDataArray type="Float64" Name="of_cells"/>{ghost_array}</PCellData>
<PPoints><PDataArray type="Float64" Name="Points" NumberOfComponents="3"/></PPoints>
{''.join(f'<Piece Source="{name}"/>' for name in names)}
</PUnstructuredGrid></VTKFile>""")
    return folder / "all.pvtu"
