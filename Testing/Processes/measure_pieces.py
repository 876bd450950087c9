# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What it takes to draw the golf ball in several processes: measure_pieces.py FOLDER, or, by mpiexec, FOLDER PARTITION

Without a partition it runs itself with every partition in 1, 2, 4 and 8 processes, and writes pictures and a table.
"""
import json
import pathlib
import sys

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path += [str(HERE), str(HERE.parent / "Benchmark")]

import mpi  # noqa: E402

SIZE = (512, 512)
FRAMES = 5
FRAMES_OF_RANDOM = 1  # of the worst case, which takes long
COUNTS = (2, 4, 8)
PARTITIONS = ("slabs", "metis", "spirals", "shells", "random_cells")


def golf_ball():
    import vtkmodules.all as vtk
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(HERE.parent.parent / "Data/golfball_small.vtu"))
    reader.Update()
    return reader.GetOutput()


def window_of(mapper, grid, least_opacity=0.0):
    """The wake, seen from outside."""
    import vtkmodules.all as vtk
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("vorticity_mag")
    mapper.SetInputData(grid)
    volume = vtk.vtkVolume()
    volume.SetMapper(mapper)
    colors, opacities = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
    for point in ((0.2, 0.1, 0.2, 0.8), (2.0, 0.9, 0.9, 0.9), (6.0, 0.8, 0.1, 0.1)):
        colors.AddRGBPoint(*point)
    opacities.AddPoint(0.2, least_opacity)
    opacities.AddPoint(6.0, 0.9)
    volume.GetProperty().SetColor(colors)
    volume.GetProperty().SetScalarOpacity(opacities)
    volume.GetProperty().SetScalarOpacityUnitDistance(0.2)
    renderer = vtk.vtkRenderer()
    renderer.AddVolume(volume)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.3, -13.0, 4.5)
    camera.SetFocalPoint(1.75, 0, -0.02)
    camera.SetViewAngle(11.0)
    camera.SetViewUp(0, 0, 1)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    return window


def draw(folder, partition, exact):
    from mpi4py import MPI  # noqa: F401, which begins MPI, and ends it
    from vtkmodules.vtkParallelMPI import vtkMPIController

    import draw_pieces
    import partitions
    controller = vtkMPIController()
    controller.Initialize()
    rank, processes = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
    grid = golf_ball()
    piece = partitions.piece_of(grid, partitions.PARTITIONS[partition](grid, processes), rank)
    mapper = draw_pieces.Mapper()
    if exact:
        mapper.SetController(controller)
    window = window_of(mapper, piece)
    mapper.ShareBounds()
    window.GetRenderers().GetFirstRenderer().ResetCameraClippingRange()
    figures = []
    picture = draw_pieces.Picture.__new__(draw_pieces.Picture)
    picture.controller, picture.mapper, picture.window = controller, mapper, window
    for _ in range(1 + (FRAMES_OF_RANDOM if partition == "random_cells" else FRAMES)):
        pixels = picture.draw()
        figures.append(picture.figures())
    if rank == 0:
        name = f"{partition}-{processes}{'' if exact else '-pieces'}"
        np.savez(folder / name, pixels=pixels, figures=json.dumps(figures[1:]))


def median(figures, name, of_processes):
    return float(np.median([of_processes(frame[name]) for frame in figures]))


def report(folder):
    folder.mkdir(parents=True, exist_ok=True)
    mpi.run(1, "measure_pieces.py", folder, "slabs", "1")
    one = np.load(folder / "slabs-1.npz")["pixels"].astype(int)
    lines = ["| partition | processes | visits, millions | MB sent: all | busiest | march, s | exchange, s | merge, s "
             "| spread, s | largest difference, of 255 |", "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|"]
    for partition in PARTITIONS:
        for count in COUNTS:
            if not (folder / f"{partition}-{count}.npz").exists():
                mpi.run(count, "measure_pieces.py", folder, partition, "1", seconds=900)
            with np.load(folder / f"{partition}-{count}.npz") as drawn:
                apart = np.abs(drawn["pixels"].astype(int) - one).max()
                figures = json.loads(str(drawn["figures"]))
            seconds = [median(figures, f"{stage}Seconds", max) for stage in ("March", "Exchange", "Merge", "Spread")]
            lines.append(f"| {partition} | {count} | {median(figures, 'NumberOfVisits', sum) / 1e6:.2f} "
                         f"| {median(figures, 'SentBytes', sum) / 1e6:.1f} | {median(figures, 'SentBytes', max) / 1e6:.1f} | "
                         + " | ".join(f"{s:.3f}" for s in seconds) + f" | {apart} |")
    (folder / "table.md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1])
    if len(sys.argv) > 2:
        draw(target, sys.argv[2], sys.argv[3] == "1")
    else:
        report(target)
