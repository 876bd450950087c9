# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of options that are no feature of a variant: levels of accuracy, views, kinds of input, ways to draw."""
import numpy as np
import vtkmodules.all as vtk
import made_grids as grids
from picture_window import call
from variant_scenes import ARRAY, VariantScene
from vtktetmarch import vtkTetMarchProjectedTetrahedraMapper

PLAIN = "POINT_SCALARS ENTRY_LISTS ADAPTIVE"
LIT = PLAIN + " SHADING SINGLE_LIGHT CAST_SHADOWS OPAQUE_DEPTH"
CELL_TYPES = {"hexahedra": vtk.VTK_HEXAHEDRON, "wedges": vtk.VTK_WEDGE, "pyramids": vtk.VTK_PYRAMID,
              "quadratic": vtk.VTK_QUADRATIC_TETRA}


def scene_of(features):
    return VariantScene(frozenset(features.split()), 0)


def with_call(features, method, *arguments):
    """The mapper's scene after one call."""
    scene = scene_of(features)
    call(scene.mapper, method, *arguments)
    return scene


def blocks():
    """Two halves of the cube, as blocks that share a face."""
    scene = scene_of(PLAIN)
    tree = vtk.vtkMultiBlockDataSet()
    middles = grids.cell_centres_of(scene.grid)[:, 0]
    for i, inside in enumerate((middles < 0.5, middles >= 0.5)):
        extract = vtk.vtkExtractCells()
        extract.SetInputData(scene.grid)
        ids = vtk.vtkIdList()
        for cell in np.flatnonzero(inside):
            ids.InsertNextId(int(cell))
        extract.SetCellList(ids)
        extract.Update()
        tree.SetBlock(i, extract.GetOutput())
    scene.mapper.SetInputDataObject(tree)
    return scene


def cells_of(cell_type):
    """A lattice of another type of cells, which the mapper cuts into tetrahedra."""
    scene = scene_of(PLAIN)
    source = vtk.vtkCellTypeSource()
    source.SetCellType(cell_type)
    source.SetBlocksDimensions(3, 3, 3)
    source.Update()
    grid = source.GetOutput()
    places = grids.points_of(grid) / 3
    grid.SetPoints(grids.grid_of(places, np.empty((0, 4), dtype=np.int64)).GetPoints())
    grids.add_array(grid.GetPointData(), ARRAY, grids.waves(places))
    scene.mapper.SetInputData(grid)
    return scene


def far_plane():
    """The far plane cuts the cube."""
    scene = scene_of(PLAIN)
    camera = scene.renderer.GetActiveCamera()
    camera.SetClippingRange(0.1, camera.GetDistance())
    return scene


def sheared():
    scene = scene_of(LIT)
    matrix = vtk.vtkMatrix4x4()
    for row, values in enumerate(((-0.9, 0.2, 0.0, 1.0), (0.1, 1.1, 0.0, 0.0), (0.0, 0.3, 0.7, 0.1))):
        for column, value in enumerate(values):
            matrix.SetElement(row, column, value)
    scene.volume.SetUserMatrix(matrix)
    scene.renderer.ResetCameraClippingRange()
    return scene


def projected():
    """The mapper that is made where vtkProjectedTetrahedraMapper is asked for."""
    scene = scene_of(PLAIN)
    scene.mapper = vtkTetMarchProjectedTetrahedraMapper()
    scene.mapper.SetInputData(scene.grid)
    scene.mapper.SetScalarModeToUsePointFieldData()
    scene.mapper.SelectScalarArray(ARRAY)
    scene.volume.SetMapper(scene.mapper)
    return scene


def moved_points(scene):
    points = grids.points_of(scene.grid)
    points += 0.05 * np.sin(3 * points[:, ::-1])
    scene.grid.SetPoints(grids.grid_of(points, np.empty((0, 4), dtype=np.int64)).GetPoints())


def edited_opacities(scene):
    scene.property.GetScalarOpacity(0).AddPoint(0.45, 0.9)


def moved_light(scene):
    scene.renderer.GetLights().GetItemAsObject(0).SetPosition(-1.0, -2.0, 1.0)


def other_scalars(scene):
    grids.add_array(scene.grid.GetPointData(), "other", grids.waves(grids.points_of(scene.grid), 0.6, 2.0))
    scene.mapper.SelectScalarArray("other")


def option_scenes():
    """{name: (makes the scene, what changes after a first frame or None)}."""
    scenes = {}

    def add(name, make, change=None):
        scenes[name] = (make, change)

    for level in ("Fast", "Default", "Accurate", "Reference"):
        add(f"level {level}", lambda level=level: with_call(LIT, f"SetAccuracyLevelTo{level}"))
    for tolerance in (32, 1024):
        add(f"tolerance 1/{tolerance}", lambda t=tolerance: with_call(PLAIN, "SetErrorTolerance", 1 / t))
    add("law Structured", lambda: with_call(PLAIN, "SetOpacityLawToStructured"))
    for view in ("ErrorBound", "Cells", "Lookups", "BoundaryFaces", "BoundaryCoordinates"):
        add(f"view {view}", lambda view=view: with_call(PLAIN + " BVH OPAQUE_DEPTH", f"SetViewModeTo{view}"))
    for distance in (2.0, 3.5):
        add(f"sample distance {distance}", lambda d=distance: with_call(LIT, "SetImageSampleDistance", d))
    # More draws than rows of tiles: as many as the mapper ever makes.
    add("tiles", lambda: with_call(LIT, "SetMaxDrawTimeInSeconds", 1e-9))
    add("reach", lambda: with_call(LIT, "SetGlobalIlluminationReach", 0.4))
    add("magnitude", lambda: with_call(PLAIN + " DIRECT_COLOR", "SetVectorModeToMagnitude"))
    add("component", lambda: with_call(PLAIN + " DIRECT_COLOR", "SetVectorModeToComponent"))
    add("blocks", blocks)
    for name, cell_type in CELL_TYPES.items():
        add(f"cells {name}", lambda cell_type=cell_type: cells_of(cell_type))
    add("far plane", far_plane)
    add("sheared", sheared)
    add("projected", projected)
    for change in (moved_points, edited_opacities, moved_light, other_scalars):
        add(f"then {change.__name__}", lambda: scene_of(LIT), change)
    return scenes
