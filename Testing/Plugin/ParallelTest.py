# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView in several processes shows the picture of one, whatever pieces they have: ParallelTest.py PVBATCH PLUGIN"""
import json
import os
import pathlib
import socket
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path += [str(HERE.parent / "Processes"), str(HERE.parent / "Benchmark")]

import numpy as np  # noqa: E402
import vtkmodules.all as vtk  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402

import made_grids  # noqa: E402
import mpi  # noqa: E402
import partitions  # noqa: E402

PVBATCH = PLUGIN = None
MOST = 2  # of 255: how far a channel of a pixel may be off
CUBES = 9
# Partition, processes, and what of draw_parallel.py is drawn; all of it if nothing is said.
RUNS = (("spirals", 2, ()), ("spirals", 4, ()), ("spirals", 8, ("composite", "shaded", "surface")),
        ("slabs", 4, ("composite", "surface")), ("metis", 4, ("composite", "isosurface", "inside")),
        ("random_cells", 4, ("composite", "maximum")), ("only_last", 3, ("composite", "surface")),
        ("ghosts", 4, ("composite", "shaded", "cells", "inside")))


def made_grid():
    grid = made_grids.lattice(CUBES, made_grids.outside_a_hole)
    made_grids.add_array(grid.GetPointData(), "field", made_grids.waves(made_grids.points_of(grid), 1.0, 0))
    made_grids.add_array(grid.GetCellData(), "of_cells", made_grids.waves(made_grids.cell_centres_of(grid), 1.0, 0))
    return grid


def write_pieces(grid, partition, processes, folder):
    """Inline, which Debian 12's ParaView reads whatever libexpat it has."""
    ghosts = partition == "ghosts"
    owner = partitions.PARTITIONS["random_cells" if ghosts else partition](grid, processes)
    names = []
    for process in range(processes):
        piece = partitions.piece_of(grid, owner, process, ghosts)
        writer = vtk.vtkXMLUnstructuredGridWriter()
        writer.SetInputData(piece)
        names.append(f"{process}.vtu")
        writer.SetFileName(str(folder / names[-1]))
        writer.SetDataModeToBinary()
        writer.Write()
    ghost_array = '<PDataArray type="UInt8" Name="vtkGhostType"/>' if ghosts else ""
    (folder / "all.pvtu").write_text(f"""<VTKFile type="PUnstructuredGrid" version="1.0" byte_order="LittleEndian">
<PUnstructuredGrid GhostLevel="0">
<PPointData><PDataArray type="Float64" Name="field"/></PPointData>
<PCellData><PDataArray type="Float64" Name="of_cells"/>{ghost_array}</PCellData>
<PPoints><PDataArray type="Float64" Name="Points" NumberOfComponents="3"/></PPoints>
{''.join(f'<Piece Source="{name}"/>' for name in names)}
</PUnstructuredGrid></VTKFile>""")
    return folder / "all.pvtu"


def picture(file):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3].astype(int)


class ParallelTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not mpi.has_mpi():
            raise unittest.SkipTest("there is no mpiexec")
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.grid = made_grid()
        cls.of_one = cls.draw("slabs", 1, ())

    @classmethod
    def draw(cls, partition, processes, scenes, *options):
        folder = cls.folder / f"{partition}-{processes}{''.join(options)}"
        folder.mkdir()
        data = write_pieces(cls.grid, partition, processes, folder)
        command = ["mpiexec", "-n", str(processes), PVBATCH, str(HERE / "draw_parallel.py"), "--plugin", PLUGIN,
                   "--data", str(data), "--folder", str(folder), *options]
        result = subprocess.run(command + (["--scenes", *scenes] if scenes else []), text=True, timeout=400,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                env={**os.environ, **mpi.ENVIRONMENT, "PYTHONPATH": str(HERE)})
        if result.returncode != 0 or "ERR|" in result.stdout:
            raise AssertionError(f"{' '.join(command)} ended with {result.returncode}:\n{result.stdout}")
        read = json.loads((folder / "read.json").read_text())
        ghosts = partition == "ghosts"
        cells = cls.grid.GetNumberOfCells()
        if read["processes"] != processes or (read["cells"] <= cells if ghosts else read["cells"] != cells):
            raise AssertionError(f"{read} was read, but there are {cells} cells in {processes} pieces")
        cls.figures = json.loads((folder / "figures.json").read_text())
        return {file.stem: picture(file) for file in folder.glob("*.png")}

    def test_one_process_shows_something(self):
        for name, pixels in self.of_one.items():
            self.assertGreater(len(np.unique(pixels.reshape(-1, 3), axis=0)), 20, name)

    def test_exact_pictures(self):
        for partition, processes, scenes in RUNS:
            if partition == "metis" and not partitions.has_metis():
                continue
            with self.subTest(partition=partition, processes=processes):
                for name, pixels in self.draw(partition, processes, scenes).items():
                    apart = np.abs(pixels - self.of_one[name])
                    self.assertLessEqual(apart.max(), MOST, f"{name}: {np.count_nonzero(apart > MOST)} values")

    def test_figures_of_process_0(self):
        self.draw("metis" if partitions.has_metis() else "slabs", 2, ("composite",))
        for name, value in self.figures["composite"].items():
            self.assertGreater(value, 0, name)

    def test_a_client_shows_what_servers_draw(self):
        """pvserver in two processes; pvpython is the client."""
        with socket.socket() as free:
            free.bind(("", 0))
            port = free.getsockname()[1]
        folder = self.folder / "client"
        folder.mkdir()
        data = write_pieces(self.grid, "spirals", 2, folder)
        programs = pathlib.Path(PVBATCH).parent
        environment = {**os.environ, **mpi.ENVIRONMENT, "PYTHONPATH": str(HERE)}
        server = subprocess.Popen(["mpiexec", "-n", "2", programs / "pvserver", f"--server-port={port}"], env=environment,
                                  text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.addCleanup(server.stdout.close)
        self.addCleanup(server.wait, 30)
        self.addCleanup(server.terminate)
        while "Accepting" not in (line := server.stdout.readline()):
            self.assertTrue(line, "pvserver ended")
        result = subprocess.run([programs / "pvpython", HERE / "draw_parallel.py", "--plugin", PLUGIN, "--data", data,
                                 "--folder", folder, "--server", str(port), "--scenes", "composite", "surface", "moving"],
                                text=True, timeout=200, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=environment)
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertNotIn("ERR|", result.stdout)
        for name in ("composite", "surface", "moving"):
            apart = np.abs(picture(folder / f"{name}.png") - self.of_one[name])
            self.assertLessEqual(apart.max(), MOST, f"{name}: {np.count_nonzero(apart > MOST)} values")

    def test_pieces_over_each_other_differ(self):
        """So the test above can fail."""
        pixels = self.draw("spirals", 2, ("composite",), "--pieces")["composite"]
        self.assertGreater(np.abs(pixels - self.of_one["composite"]).max(), 5 * MOST)


if __name__ == "__main__":
    PVBATCH, PLUGIN = sys.argv.pop(1), sys.argv.pop(1)
    unittest.main(verbosity=2)
