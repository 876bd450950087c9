# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView hands to the mapper, and what it selects of it: cells, blocks, ghosts, steps of time."""
import math
import os
import tempfile

from lattices import ARRAY, blocks, lattice, source_of
from paraview import simple
from paraview.vtk.vtkIOXML import vtkXMLUnstructuredGridWriter
from views import figure_of, load_plugin, open_view, parse_arguments, picture_of, selected, set_all, show

N = 4  # cubes along each axis
PIXELS = 40  # along each of them
OPACITY = 0.5
TETRAHEDRA_OF_A_CUBE = (5, 6)


def field(x, y, z):
    return x + 0.3 * y * z


def use_functions():
    simple.GetColorTransferFunction(ARRAY).RGBPoints = [0.0, 0.1, 0.2, 0.9, 9.0, 0.9, 0.8, 0.1]
    simple.GetOpacityTransferFunction(ARRAY).Points = [0.0, OPACITY, 0.5, 0.0, 9.0, OPACITY, 0.5, 0.0]


def open_scene():
    """Looking down z, in parallel: N cubes fill the view."""
    view = open_view()
    view.ViewSize = [N * PIXELS] * 2
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = [N / 2] * 3
    view.CameraPosition = [N / 2, N / 2, 10 * N]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelScale = N / 2
    return view


def open_display(view, data, unit_distance=2.0):
    source = source_of(data)
    display = show(source, view, ARRAY)
    use_functions()
    display.ScalarOpacityUnitDistance = unit_distance
    return source, display


def cubes_across(first, last):
    """Pixels of cubes in x, all of them in y, but for their outermost pixels: left, bottom, right, top."""
    return [first * PIXELS + 2, 2, (last + 1) * PIXELS - 3, N * PIXELS - 3]


def layer(z, sizes=(N, N)):
    return {(None, cell + z * sizes[0] * sizes[1]) for cell in range(sizes[0] * sizes[1])}


def check_cells(view):
    """Hexahedra come as they are, and are found where rays have gathered the threshold's opacity."""
    source, display = open_display(view, lattice((N, N, N), field))
    unselected = picture_of(view)
    count = figure_of(display, "NumberOfTetrahedra")
    assert count in [n * N**3 for n in TETRAHEDRA_OF_A_CUBE], count
    everything = cubes_across(0, N - 1)
    for threshold in (0.0, 0.2, 0.5, 0.6):
        set_all(display, {"PickOpacityThreshold": threshold})
        depth = -math.log(1 - threshold) * display.ScalarOpacityUnitDistance / OPACITY
        found = selected(source, view, everything)
        print(f"threshold {threshold}: {len(found)} cells at a depth of {depth:.2f}")
        assert found == layer(N - 1 - int(depth)), (threshold, sorted(found))
    highlighted = picture_of(view)
    assert highlighted != unselected, "ParaView doesn't show what is selected"
    set_all(display, {"PickOpacityThreshold": 0.7})
    assert not selected(source, view, everything), "what is fainter than the threshold is selected"
    assert picture_of(view) == unselected

    set_all(display, {"PickOpacityThreshold": 0.0})
    volume = selected(source, view, cubes_across(1, 2))
    display.SetRepresentationType("Surface")
    surface = selected(source, view, cubes_across(1, 2))
    assert volume == surface and len(volume) == 2 * N, (volume, surface)
    simple.ClearSelection(source)

    # Behind what is opaque nothing is found, and what isn't drawn neither.
    display.SetRepresentationType("Tet Marching")
    wall = simple.Plane(Origin=[-1, -1, N + 1], Point1=[N / 2, -1, N + 1], Point2=[-1, N + 1, N + 1])
    simple.Show(wall, view)
    assert {cell[1] % N for cell in selected(source, view, everything)} <= set(range(N // 2, N))
    simple.Delete(wall)
    set_all(display, {"UseCropping": 1, "CroppingScale": [1.0, 1.0, 0.5]})
    assert selected(source, view, everything) == layer(N // 2 - 1)
    set_all(display, {"UseCropping": 0})
    display.Visibility = 0
    assert not selected(source, view, everything)
    simple.Delete(source)


def check_ghosts(view):
    """Duplicates are no part of the mesh, and leave the others their ids."""
    top = N * N * (N - 1)
    source, display = open_display(view, lattice((N, N, N), field, ghosts=range(top, top + N * N)), 0.01)
    found = selected(source, view, cubes_across(0, N - 1))
    assert found == layer(N - 2), sorted(found)
    assert figure_of(display, "NumberOfTetrahedra") in [n * top for n in TETRAHEDRA_OF_A_CUBE]
    simple.Delete(source)


def check_blocks(view):
    """Cut in two at x = 1, it is the same picture to the last bit."""
    source, display = open_display(view, lattice((N, N, N), field))
    whole = picture_of(view)
    faces = figure_of(display, "NumberOfBoundaryFaces")
    simple.Delete(source)

    left = lattice((1, N, N), field)
    right = lattice((N - 1, N, N), field, origin=(1, 0, 0))
    source, display = open_display(view, blocks(left=left, right=right))
    assert picture_of(view) == whole, "there is a seam between blocks"
    assert figure_of(display, "NumberOfBoundaryFaces") == faces, "blocks are not joined"
    set_all(display, {"PickOpacityThreshold": 0.0})
    in_left = {(2, cell + (N - 1) * N) for cell in range(N)}
    in_right = {(3, cell + (N - 1) * N * (N - 1)) for cell in range(N * (N - 1))}
    found = selected(source, view, cubes_across(0, N - 1))
    assert found == in_left | in_right, sorted(found)
    simple.ClearSelection(source)

    # Those that ParaView's Multi-block Inspector hides; the others keep their numbers.
    display.BlockSelectors = ["/Root/right"]
    part = picture_of(view)
    seen = sum(any(pixel) for pixel in part) / len(part)
    print(f"one of two blocks: {seen:.4f} of the picture")
    assert abs(seen - (N - 1) / N) < 0.01
    assert selected(source, view, cubes_across(0, N - 1)) == in_right
    simple.ClearSelection(source)
    display.BlockSelectors = ["/Root"]
    assert picture_of(view) == whole
    # As ParaView draws it where there is much of it and somebody interacts.
    view.LODThreshold = 0.0
    builds = figure_of(display, "MeshBuilds"), figure_of(display, "BlocksBuilds")
    set_all(display, {"MinimumImageSampleDistance": 2.0})
    view.SMProxy.InteractiveRender()
    assert figure_of(display, "UsedImageSampleDistance") == 2, "no blocks in interactive frames"
    set_all(display, {"MinimumImageSampleDistance": 1.0})
    assert picture_of(view) == whole
    assert (figure_of(display, "MeshBuilds"), figure_of(display, "BlocksBuilds")) == builds
    simple.Delete(source)


def check_no_array(view):
    """Nothing is drawn without an array, be it a grid or blocks."""
    for data in (lattice((N, N, N), field), blocks(only=lattice((N, N, N), field))):
        source, display = open_display(view, data)
        assert any(any(pixel) for pixel in picture_of(view))
        simple.ColorBy(display, None)
        assert not any(any(pixel) for pixel in picture_of(view)), "something is drawn without an array"
        simple.ColorBy(display, ("POINTS", ARRAY))
        assert any(any(pixel) for pixel in picture_of(view))
        simple.Delete(source)


def write_series(folder, factors):
    lines = []
    for step, factor in enumerate(factors):
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetFileName(f"{folder}/{step}.vtu")
        writer.SetInputData(lattice((N, N, N), lambda *point, factor=factor: factor * field(*point)))
        writer.SetDataModeToBinary()
        writer.Write()
        lines.append(f'<DataSet timestep="{step}" file="{step}.vtu"/>')
    path = os.path.join(folder, "series.pvd")
    with open(path, "w", encoding="ascii") as file:
        file.write('<VTKFile type="Collection"><Collection>' + "".join(lines) + "</Collection></VTKFile>")
    return path


def check_series(view):
    """Of a reader that hands over a new grid each step: the mesh is made once."""
    factors = [1.0, 0.4, 0.7]
    with tempfile.TemporaryDirectory() as folder:
        reader = simple.OpenDataFile(write_series(folder, factors))
        display = show(reader, view, ARRAY)
        use_functions()
        display.ScalarOpacityUnitDistance = 2.0
        pictures = []
        for step in range(len(factors)):
            view.ViewTime = step
            pictures.append(picture_of(view))
        assert len(set(map(tuple, pictures))) == len(factors), "steps look like each other"
        assert figure_of(display, "MeshBuilds") == 1, figure_of(display, "MeshBuilds")
        assert figure_of(display, "ScalarsBuilds") == len(factors)
        simple.Delete(reader)
    for factor, picture in zip(factors, pictures):
        source, _ = open_display(view, lattice((N, N, N), lambda *point, factor=factor: factor * field(*point)))
        assert picture_of(view) == picture, f"the step with {factor} is not what it should be"
        simple.Delete(source)


def main():
    load_plugin(parse_arguments(__doc__))
    view = open_scene()
    check_cells(view)
    check_ghosts(view)
    check_blocks(view)
    check_no_array(view)
    check_series(view)


main()
