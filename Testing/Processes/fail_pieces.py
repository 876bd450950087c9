# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Something is wrong in one process, or in all: mpiexec -n N fail_pieces.py CASE

Each process prints a line: its number, whether the frame shows the volume, and after the fault is mended once more.
What process 0 tells of it is an error of VTK.
"""
import sys

import numpy as np
from mpi4py import MPI  # noqa: F401, which begins MPI, and ends it
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction, vtkPlane
from vtkmodules.vtkParallelMPI import vtkMPIController

import draw_pieces
import made_grids

FAULTY = 1  # the process in which something is wrong


def without_array(picture):
    data = picture.mapper.GetInput().GetPointData()
    array = data.GetArray(draw_pieces.SCALARS)
    data.RemoveArray(draw_pieces.SCALARS)
    return lambda: data.AddArray(array)


def other_kind(picture):
    """Of three components, of which the magnitude is drawn; then all of them."""
    data = picture.mapper.GetInput().GetPointData()
    array = data.GetArray(draw_pieces.SCALARS)
    data.RemoveArray(draw_pieces.SCALARS)
    made_grids.add_array(data, draw_pieces.SCALARS, np.random.RandomState(1).rand(array.GetNumberOfTuples(), 2))
    picture.mapper.SetVectorModeToAllComponents()

    def mend():
        data.RemoveArray(draw_pieces.SCALARS)
        data.AddArray(array)
        picture.mapper.SetVectorModeToDisabled()
    return mend


def short_of_memory(picture):
    picture.mapper.SetMaxMemoryInBytes(1000)
    return lambda: picture.mapper.SetMaxMemoryInBytes(0)


def bad_points(picture):
    grid = picture.mapper.GetInput()
    place = grid.GetPoint(0)
    grid.GetPoints().SetPoint(0, float("nan"), 0, 0)
    grid.GetPoints().Modified()

    def mend():
        grid.GetPoints().SetPoint(0, *place)
        grid.GetPoints().Modified()
        grid.Modified()
    return mend


def other_window(picture):
    picture.window.SetSize(100, 80)
    return lambda: picture.window.SetSize(*draw_pieces.SIZE)


def aborted(picture):
    """By an observer of progress, while the mesh is prepared."""
    def stop(*_):
        picture.window.SetAbortRender(1)
    tag = picture.mapper.AddObserver("ProgressEvent", stop)

    def mend():
        picture.mapper.RemoveObserver(tag)
        picture.window.SetAbortRender(0)
    return mend


def aborted_while_marching(picture):
    """Of a picture whose mesh is there: at the third visit of the rays, in their second turn."""
    picture.mapper.SetMaxDrawTimeInSeconds(1e-9)  # many small tiles, between which it tells its progress
    shares = []

    def stop(*_):
        shares.append(picture.mapper.GetProgress())
        visits = 1 + sum(second < first for first, second in zip(shares, shares[1:]))
        if visits > 2:
            picture.window.SetAbortRender(1)
    tag = picture.mapper.AddObserver("ProgressEvent", stop)

    def mend():
        if not picture.window.GetAbortRender():
            raise AssertionError(f"the rays had no third visit: {shares}")
        picture.mapper.RemoveObserver(tag)
        picture.window.SetAbortRender(0)
    return mend


def nothing_finite(picture):
    """In any process."""
    data = picture.mapper.GetInput().GetPointData()
    array = data.GetArray(draw_pieces.SCALARS)
    data.RemoveArray(draw_pieces.SCALARS)
    made_grids.add_array(data, draw_pieces.SCALARS, np.full(array.GetNumberOfTuples(), np.nan))

    def mend():
        data.RemoveArray(draw_pieces.SCALARS)
        data.AddArray(array)
    return mend


def no_opacity(picture):
    of_volume = picture.volume.GetProperty()
    before = of_volume.GetScalarOpacity()
    clear = vtkPiecewiseFunction()
    clear.AddPoint(0, 0)
    of_volume.SetScalarOpacity(clear)
    return lambda: of_volume.SetScalarOpacity(before)


def clipped_away(picture):
    plane = vtkPlane()
    plane.SetOrigin(1e3, 0, 0)
    picture.mapper.AddClippingPlane(plane)
    plane.SetNormal(1, 0, 0)
    return picture.mapper.RemoveAllClippingPlanes


def bad_view(picture):
    picture.mapper.SetViewModeToCells()
    return picture.mapper.SetViewModeToPicture


CASES = {f.__name__: f for f in (without_array, other_kind, short_of_memory, bad_points, other_window, aborted,
                                 aborted_while_marching, nothing_finite, no_opacity, clipped_away, bad_view)}
OF_ALL = ("nothing_finite", "no_opacity", "clipped_away")
OF_A_SECOND_PICTURE = ("aborted_while_marching",)


def shows_volume(pixels):
    return len(np.unique(pixels.reshape(-1, 4), axis=0)) > 1


def main():
    controller = vtkMPIController()
    controller.Initialize()
    rank = controller.GetLocalProcessId()
    picture = draw_pieces.Picture({}, controller)
    case = sys.argv[1]
    if case in OF_A_SECOND_PICTURE:
        picture.draw()
    mend = CASES[case](picture) if rank == FAULTY or case in OF_ALL else lambda: None
    broken = [shows_volume(picture.draw()) for _ in range(2)]
    mend()
    mended = shows_volume(picture.draw())
    print(f"process {rank}: {broken[0]} {broken[1]} {mended}", flush=True)


if __name__ == "__main__":
    main()
