# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""An adaptive mesh beside an image of its finest cells: measure_leaves.py FOLDER [--cells N] [--size WxH] [--frames N]

Cells are refined twice around a shell; of the coarsest level there are N along each edge (32). Draws it by turns with
values that are constant in each leaf, in an octree and in hexahedra, and linear between leaves, and the function in all
cells of the finest size by our and VTK's mappers of images. It writes FOLDER/leaves.md: seconds to the first frame and
of a frame, nanoseconds for a crossed cell, bytes of our mappers on the GPU, and the difference from the picture of the
function, in cells of a quarter of the finest size.
"""
import time

import numpy as np
import vtkmodules.all as vtk
from measure_pixels import picture_of
from measured_page import grid_options, row
from time_frames import ENOUGH_FOR_ONE_DRAW, Frames, median_seconds
from vtktetmarch import vtkTetMarchDualGrid, vtkTetMarchSmartVolumeMapper, vtkTetMarchVolumeMapper
from write_leaves import LEVELS, adaptive, block_of

FINER = 4  # cells of the true picture along a finest cell


def without_limits(mapper):
    mapper.SetMaxDrawTimeInSeconds(ENOUGH_FOR_ONE_DRAW)
    mapper.AutoAdjustSampleDistancesOff()
    return mapper


def constant(mesh, _image):
    mapper = vtkTetMarchVolumeMapper()
    mapper.SetInputDataObject(mesh)
    return without_limits(mapper)


def hexahedra(mesh, _image):
    """In blocks of a tree, where cells below finer ones are marked."""
    vtk.vtkAMRUtilities.BlankCells(mesh)
    blocks = vtk.vtkMultiBlockDataSet()
    for level in range(mesh.GetNumberOfLevels()):
        for number in range(mesh.GetNumberOfDataSets(level)):
            blocks.SetBlock(blocks.GetNumberOfBlocks(), mesh.GetDataSet(level, number))
    return constant(blocks, None)


def between_centers(mesh, _image):
    dual = vtkTetMarchDualGrid()
    dual.SetInputDataObject(mesh)
    mapper = vtkTetMarchVolumeMapper()
    mapper.SetInputConnection(dual.GetOutputPort())
    return without_limits(mapper)


def our_image(_mesh, image):
    mapper = vtkTetMarchSmartVolumeMapper()
    mapper.SetInputData(image)
    return without_limits(mapper)


def constant_image(mesh, image):
    return our_image(mesh, image)


def image_of_vtk(_mesh, image):
    mapper = vtk.vtkOpenGLGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    mapper.SetAutoAdjustSampleDistances(False)
    mapper.SetSampleDistance(image.GetSpacing()[0] / 2)
    return mapper


WAYS = {
    "constant in each leaf": constant,
    "the same in hexahedra": hexahedra,
    "linear between leaves (vtkTetMarchDualGrid)": between_centers,
    "the image of finest cells, constant": constant_image,
    "the same, trilinear": our_image,
    "the same by vtkOpenGLGPUVolumeRayCastMapper, two samples a cell": image_of_vtk,
}


class LeafFrames(Frames):
    def __init__(self, make, mesh, image, size):
        begin = time.perf_counter()
        mapper = make(mesh, image)
        self.show(mapper, size)
        colors, opacities = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
        for scalar, *rgb in ((0.0, 0.1, 0.2, 0.9), (0.5, 0.9, 0.9, 0.9), (1.0, 0.8, 0.1, 0.1)):
            colors.AddRGBPoint(scalar, *rgb)
        for scalar, opacity in ((0.0, 0.0), (0.2, 0.02), (1.0, 0.8)):
            opacities.AddPoint(scalar, opacity)
        self.use_functions(colors, opacities, 0.05)
        interpolation = vtk.VTK_NEAREST_INTERPOLATION if make is constant_image else vtk.VTK_LINEAR_INTERPOLATION
        self.volume.GetProperty().SetInterpolationType(interpolation)
        self.camera.SetFocalPoint(0.5, 0.5, 0.5)
        self.camera.SetPosition(1.6, -1.9, 1.4)
        self.camera.SetViewUp(0, 0, 1)
        self.first_position = self.camera.GetPosition()
        self.seconds(0)
        self.first = time.perf_counter() - begin


def crossed_cells(frames):
    """Of a frame; None of another mapper."""
    mapper = frames.volume.GetMapper()
    if not hasattr(mapper, "CollectDiagnosticsOn"):
        return None
    mapper.CollectDiagnosticsOn()
    frames.seconds(0)
    return mapper.GetLastFrameStatistics().GetNumberOfCrossedCells()


def measure(cells, size, rounds):
    mesh, leaves = adaptive(cells)
    finest = cells << (LEVELS - 1)
    image = block_of(vtk.vtkImageData, 1 / finest, [0, 0, 0], finest)
    true = LeafFrames(our_image, mesh, block_of(vtk.vtkImageData, 1 / (FINER * finest), [0, 0, 0], FINER * finest), size)
    reference = picture_of(true.window)
    frames = {name: LeafFrames(make, mesh, image, size) for name, make in WAYS.items()}
    errors = {name: np.sqrt(((picture_of(each.window) - reference)**2).mean()) for name, each in frames.items()}
    medians = median_seconds(frames, rounds)
    text = ""
    for name, each in frames.items():
        mapper = each.volume.GetMapper()
        ours = hasattr(mapper, "GetLastFrameStatistics")
        bytes_of_gpu = mapper.GetLastFrameStatistics().GetGPUMemoryBytes() / leaves if ours else 0
        crossed = crossed_cells(each)
        text += row([name, f"{each.first:.2f}", f"{medians[name]:.3f}",
                     f"{1e9 * medians[name] / crossed:.1f}" if crossed else "",
                     f"{bytes_of_gpu:.0f}" if ours else "", f"{errors[name]:.1e}"])
    head = row(["drawn", "first frame, s", "frame, s", "a crossed cell, ns", "bytes a leaf", "RMS"])
    return f"{leaves:,} leaves; the image has {finest}^3 cells\n\n{head}|---|{'---:|' * 5}\n{text}"


def main():
    options = grid_options(__doc__, "--cells", 32)
    text = measure(options.cells, options.size, options.frames)
    (options.folder / "leaves.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
