# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Curvilinear grids, adaptive meshes, trees and curved cells in ParaView: pictures of the same cells in other grids."""
from lattices import ARRAY, blocks, source_of
from other_grids import (N, adaptive, bulging, cell_grid, curvilinear, explicit, field, hidden, trees, unstructured)
from paraview import servermanager, simple
from paraview.vtk.vtkFiltersGeometry import vtkGeometryFilter
from views import (brightness, difference, figure_of, load_plugin, mapper_of, open_view, parse_arguments, picture_of,
                   set_all, show)

SEEN = 5  # of 255, in the mean


def show_in(view, source, kind, association):
    display = show(source, view, ARRAY, association, kind + "Representation")
    simple.GetColorTransferFunction(ARRAY).RGBPoints = [0.0, 0.1, 0.2, 0.9, 9.0, 0.9, 0.8, 0.1]
    simple.GetOpacityTransferFunction(ARRAY).Points = [0.0, 0.1, 0.5, 0.0, 9.0, 0.6, 0.5, 0.0]
    display.ScalarOpacityUnitDistance = 2.0
    view.ResetCamera()
    return display


def skin(grid):
    """Its surface, which has no cells to march through."""
    surface = vtkGeometryFilter()
    surface.SetInputDataObject(grid)
    surface.Update()
    return surface.GetOutput()


def is_octree(data):
    """Leaves by themselves; their light has gradients of its own."""
    return data.IsA("vtkHyperTreeGrid") or data.IsA("vtkUniformGridAMR")


def draw(view, data, kind, association, file=None):
    source = source_of(data)
    chosen = view.GetRepresentationType(source.SMProxy, 0)
    assert chosen == kind + "Representation", f"ParaView chooses {chosen}"
    display = show_in(view, source, kind, association)
    pictures = [picture_of(view)]
    if file:
        simple.SaveScreenshot(file, view)
    assert mapper_of(display).GetClassName() == "vtkTetMarchVolumeMapper"
    assert figure_of(display, "NumberOfLatticeCells" if is_octree(data) else "NumberOfTetrahedra") > 0
    set_all(display, {"Shade": 1, "UseCropping": 1, "CroppingScale": [1.0, 1.0, 0.5]})
    pictures.append(picture_of(view))
    simple.Delete(source)
    return pictures


def check_between_leaves(view, data, kind):
    """The filter makes values of leaves those of points, between which they are continuous."""
    source = source_of(data)
    dual = servermanager.filters.TetMarchDualGrid(Input=source)
    dual.UpdatePipeline()
    assert dual.GetPointDataInformation().GetArray(ARRAY), "the filter gives no values of points"
    pictures = []
    for shown, shown_as, association in ((dual, "UnstructuredGrid", "POINTS"), (source, kind, "CELLS")):
        show_in(view, shown, shown_as, association)
        pictures.append(picture_of(view))
        simple.Hide(shown, view)
    assert brightness(pictures[0]) > SEEN, "cells between leaves are not to be seen"
    assert difference(*pictures) > 0.05, "cells between leaves look like leaves"
    simple.Delete(source)


def check_tessellator(view):
    """A filter cuts a cell that bends, by tolerances that can be set."""
    source = source_of(bulging())
    cut = servermanager.filters.TetMarchTessellator(Input=source, GeometryTolerance=1e-3)
    cut.UpdatePipeline()
    assert cut.Scalars[1] == ARRAY, "the filter chooses no scalars"
    cells = [cut.GetDataInformation().GetNumberOfCells()]
    cut.GeometryTolerance, cut.ScalarTolerance = 1, 1
    cut.UpdatePipeline()
    cells.append(cut.GetDataInformation().GetNumberOfCells())
    assert cells[0] > 100 and cells[1] == 1, f"{cells} tetrahedra"
    show_in(view, cut, "UnstructuredGrid", "POINTS")
    pictures = [picture_of(view)]
    cut.GeometryTolerance = 1e-3
    pictures.append(picture_of(view))
    shown = [brightness(picture) for picture in pictures]
    print(f"a tetrahedron that bulges: brightness {shown[0]:.1f} straight, {shown[1]:.1f} curved")
    assert shown[1] > 1.2 * shown[0] > 1, "a curved cell is not larger than a straight one"
    simple.Hide(cut, view)
    display = show_in(view, source, "UnstructuredGrid", "POINTS")
    display.TetMarchGeometryTolerance = 1e-3
    own = brightness(picture_of(view))
    assert own > 1.2 * shown[0], f"brightness {own:.1f} of the representation's own curved cells"
    simple.Delete(source)


def main():
    arguments = parse_arguments(__doc__)
    load_plugin(arguments)
    view = open_view()
    view.CameraPosition, view.CameraFocalPoint = [-20, -15, 18], [2, 4, 3]
    view.CameraViewUp = [0, 0, 1]
    whole = curvilinear((N, N, N), field)
    halves = [curvilinear((N // 2, N, N), field, (first, 0, 0)) for first in (0, N // 2)]
    mesh, leaves = adaptive()
    grid_of_trees, leaves_of_trees = trees()
    cases = {
        "curvilinear": (whole, "StructuredGrid", "POINTS", unstructured(whole)),
        "blanked": (hidden(curvilinear((N, N, N), field)), "StructuredGrid", "POINTS", hidden(unstructured(whole))),
        "blocks of it": (blocks(left=halves[0], right=halves[1]), "StructuredGrid", "POINTS", unstructured(whole)),
        "explicit": (explicit(whole), "Geometry", "POINTS", unstructured(whole)),
        "cells and a surface": (blocks(cells=halves[0], others=explicit(halves[1]), skin=skin(whole)), "Geometry",
                                "POINTS", unstructured(whole)),
        "adaptive": (mesh, "AMR", "CELLS", leaves),
        "trees": (grid_of_trees, "HyperTreeGrid", "CELLS", leaves_of_trees),
        "blocks of trees": (blocks(one=grid_of_trees), "HyperTreeGrid", "CELLS", leaves_of_trees),
    }
    if hasattr(simple, "ConvertToCellGrid"):  # ParaView 6
        cells = cell_grid(unstructured(whole))
        cases["cell grid"] = (cells, "CellGrid", "CELLS", unstructured(whole))
        cases["blocks of cell grids"] = (blocks(one=cells), "CellGrid", "CELLS", unstructured(whole))
    for name, (data, kind, association, same) in cases.items():
        file = arguments.pictures and f"{arguments.pictures}/{name}.png"
        drawn = draw(view, data, kind, association, file)
        expected = draw(view, same, "UnstructuredGrid", "POINTS" if kind == "CellGrid" else association)
        for words, picture, other in zip(("plain", "lit and cut"), drawn, expected):
            share = difference(picture, other)
            print(f"{name}, {words}: brightness {brightness(picture):.1f}, {100 * share:.2f} % of the pixels differ")
            assert brightness(picture) > SEEN, f"{name} is not to be seen"
            assert share < 0.001 or (is_octree(data) and words != "plain"), f"{name}: another picture"
        assert difference(*drawn) > 0.05, f"{name}: neither lit nor cut"
    for data, kind in ((mesh, "AMR"), (grid_of_trees, "HyperTreeGrid")):
        check_between_leaves(view, data, kind)
    check_tessellator(view)


main()
