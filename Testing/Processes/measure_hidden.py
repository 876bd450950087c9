# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is saved of pieces that others hide: measure_hidden.py FOLDER, or, by mpiexec, FOLDER PARTITION DEGREES

The golf ball, so dense that its crust is opaque, in frames between which the camera turns by so many degrees. Writes
figures of each frame and a table.
"""
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path += [str(HERE), str(HERE.parent / "Benchmark")]

import measure_pieces  # noqa: E402
import mpi  # noqa: E402

FRAMES = 3
OPACITY, UNIT_DISTANCE = 0.9, 0.02
CASES = (("crust", 2, 0), ("crust", 2, 1), ("crust", 4, 1), ("random_cells", 4, 0), ("random_cells", 4, 1))


def draw(folder, partition, degrees):
    from mpi4py import MPI  # noqa: F401, which begins MPI, and ends it
    from vtkmodules.vtkParallelMPI import vtkMPIController

    import draw_pieces
    import partitions
    controller = vtkMPIController()
    controller.Initialize()
    rank, processes = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
    grid = measure_pieces.golf_ball()
    piece = partitions.piece_of(grid, partitions.PARTITIONS[partition](grid, processes), rank)
    picture = draw_pieces.Picture.__new__(draw_pieces.Picture)
    picture.controller, picture.mapper = controller, draw_pieces.Mapper()
    picture.mapper.SetController(controller)
    picture.window = measure_pieces.window_of(picture.mapper, piece, OPACITY)
    renderer = picture.window.GetRenderers().GetFirstRenderer()
    renderer.GetVolumes().GetItemAsObject(0).GetProperty().SetScalarOpacityUnitDistance(UNIT_DISTANCE)
    picture.mapper.ShareBounds()
    renderer.ResetCameraClippingRange()
    figures = []
    for _ in range(FRAMES):
        picture.draw()
        figures.append(picture.figures())
        renderer.GetActiveCamera().Azimuth(degrees)
    if rank == 0:
        (folder / f"{partition}-{processes}-{degrees}.json").write_text(json.dumps(figures))


def report(folder):
    folder.mkdir(parents=True, exist_ok=True)
    lines = ["| partition | processes | degrees a frame | frame | visits, thousands: process 0 | the others | MB sent: all "
             "| slowest march of the others, s |", "|---|---:|---:|---:|---:|---:|---:|---:|"]
    for partition, count, degrees in CASES:
        mpi.run(count, "measure_hidden.py", folder, partition, degrees)
        figures = json.loads((folder / f"{partition}-{count}-{degrees}.json").read_text())
        for number, frame in enumerate(figures, 1):
            visits = [v / 1000 for v in frame["NumberOfVisits"]]
            lines.append(f"| {partition} | {count} | {degrees} | {number} | {visits[0]:.0f} | {sum(visits[1:]):.0f} "
                         f"| {sum(frame['SentBytes']) / 1e6:.1f} | {max(frame['MarchSeconds'][1:]):.2f} |")
    (folder / "table.md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    if len(sys.argv) > 2:
        draw(pathlib.Path(sys.argv[1]), sys.argv[2], int(sys.argv[3]))
    else:
        report(pathlib.Path(sys.argv[1]))
