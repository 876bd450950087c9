# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A grid drawn region by region, as the plugin does after ParaView has redistributed the cells, is the whole picture.

Regions are boxes of a k-d tree. Each has all cells that reach into it, and rays end at its planes."""
import unittest

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

import mpi
import partitions

# Bounds, nearest first: the cameras are at large x and small y.
REGIONS = ((0.53, 1, 0, 0.41, 0, 1), (0.53, 1, 0.41, 1, 0, 1), (0, 0.53, 0, 0.62, 0, 1), (0, 0.53, 0.62, 1, 0, 1))
NAMES = ("composite", "hexahedra", "cells", "isosurface", "parallel", "nan", "components")
MOST = 2  # of 255: how far a channel of a pixel may be off


def cells_in(grid, region):
    """Those that reach into the region, by their boxes."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    begins = vtk_to_numpy(grid.GetCells().GetOffsetsArray())[:-1]
    low = np.minimum.reduceat(points[corners], begins)
    high = np.maximum.reduceat(points[corners], begins)
    bounds = np.array(region).reshape(3, 2)
    return ((low <= bounds[:, 1]) & (high >= bounds[:, 0])).all(axis=1)


def add_planes(mapper, region):
    """Where another region begins: not on the faces of the unit cube, over which the grids may reach."""
    for face, bound in enumerate(region):
        if bound not in (0, 1):
            plane = vtk.vtkPlane()
            plane.SetOrigin(*(bound if axis == face // 2 else 0.5 for axis in range(3)))
            plane.SetNormal(*((1 if face % 2 == 0 else -1) if axis == face // 2 else 0 for axis in range(3)))
            mapper.AddClippingPlane(plane)


def draw(name, region=None):
    """Premultiplied red, green, blue and opacity, of 255, and the number of cells."""
    from draw_pieces import SCENES, Picture  # which needs MPI

    picture = Picture({**SCENES[name], "partition": "slabs"}, vtk.vtkDummyController())
    picture.renderer.SetBackground(0, 0, 0)
    picture.window.SetAlphaBitPlanes(1)
    grid = picture.mapper.GetInput()
    if region:
        inside = np.where(cells_in(grid, region), 0, 1)
        grid = partitions.piece_of(grid, inside, 0)
        picture.mapper.SetInputData(grid)
        add_planes(picture.mapper, region)
    pixels = picture.draw().astype(float)
    picture.window.Finalize()
    return pixels, grid.GetNumberOfCells()


@unittest.skipUnless(mpi.has_mpi(), "there is no MPI")
class RegionsTest(unittest.TestCase):
    def test_regions_over_each_other_are_the_picture(self):
        for name in NAMES:
            whole, cells = draw(name)
            over = np.zeros_like(whole)
            drawn = 0
            for region in REGIONS:
                pixels, cells_of_region = draw(name, region)
                over += (1 - over[:, :, 3:] / 255) * pixels
                drawn += cells_of_region
            with self.subTest(name):
                self.assertGreater(len(np.unique(whole.reshape(-1, 4), axis=0)), 20)
                self.assertGreater(drawn, cells, "no cell lies in two regions")
                self.assertLessEqual(np.abs(over - whole).max(), MOST)


if __name__ == "__main__":
    unittest.main(verbosity=2)
