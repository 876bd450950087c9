# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Input of which nothing can be drawn: one message a cause, and the picture of before when the input is good again."""
import pathlib
import tempfile

from lattices import ARRAY, at_points, blocks, source_of
from messages import Messages
from paraview import simple
from paraview.vtk import (VTK_QUAD, vtkImageData, vtkMultiBlockDataSet, vtkStringArray, vtkUnstructuredGrid)
from series import KINDS, Shown, make_grid, write_steps
from views import REPRESENTATION, load_plugin, make_plain, parse_arguments, picture_of, show

N = 4
FRAMES = 3
NO_CELLS = "The data has no cells, so Tet Marching draws nothing."
NOT_SOLID = "None of the 4 cells of the data is three-dimensional"
NO_ARRAY = f'has no array named "{ARRAY}" in the point data, so nothing is drawn'
FLAT_IMAGE = "a volume has at least 2 along each axis"
FLAT = {"vtu": NOT_SOLID, "vts": NOT_SOLID, "vti": FLAT_IMAGE}
SOME_BLOCKS = f'Blocks without array named "{ARRAY}" in the point data are not drawn: "a"'
NOT_CHOSEN = "the data has a solid color. Choose an array under Coloring."
NOTHING_TO_CHOOSE = "the data has neither point nor cell arrays"


def sum_of(x, y, z):
    return x + y + z


def good(kind):
    return KINDS[kind][0]((N, N, N), sum_of)


def without_arrays(kind):
    data = good(kind)
    data.GetPointData().Initialize()
    return data


def array_renamed(kind):
    data = good(kind)
    data.GetPointData().GetArray(0).SetName("other")
    return data


def of_strings(kind):
    data = without_arrays(kind)
    strings = vtkStringArray()
    strings.SetName(ARRAY)
    strings.SetNumberOfValues(data.GetNumberOfPoints())
    data.GetPointData().AddArray(strings)
    return data


def empty(kind):
    return good(kind).NewInstance()


def flat(kind):
    if kind == "vti":
        data = vtkImageData()
        data.SetDimensions(N + 1, N + 1, 1)
        return at_points(data, sum_of)
    if kind == "vts":
        return KINDS[kind][0]((N, 1, 0), sum_of)
    data = vtkUnstructuredGrid()
    data.ShallowCopy(good(kind))
    data.Reset()
    for first in range(N):
        data.InsertNextCell(VTK_QUAD, 4, [first, first + 1, first + N + 2, first + N + 1])
    return data


def good_blocks(kind):
    return blocks(a=good(kind), b=KINDS[kind][0]((2, 2, 2), sum_of, (5, 0, 0)))


CAUSES = ((without_arrays, NO_ARRAY), (array_renamed, NO_ARRAY), (of_strings, NO_ARRAY), (empty, NO_CELLS),
          (flat, FLAT))
CAUSES_OF_BLOCKS = ((lambda kind: blocks(a=empty(kind), b=empty(kind)), NO_CELLS),
                    (lambda kind: vtkMultiBlockDataSet(), NO_CELLS),
                    (lambda kind: blocks(a=without_arrays(kind), b=good(kind)), SOME_BLOCKS))


class Stage:
    def __init__(self):
        self.messages = Messages()
        self.view = simple.CreateView("RenderView")
        make_plain(self.view)
        self.view.ViewSize = [200, 160]

    def look(self, message=None):
        """Some frames, of which the first brings that message, and the others none; the picture."""
        pictures = []
        for frame in range(FRAMES):
            self.view.SMProxy.StillRender()
            pictures.append(picture_of(self.view))
            said = self.messages.take()
            if message and frame == 0:
                assert len(said) == 1 and message in said[0], f"{message}: {said}"
            else:
                assert not said, said
        assert pictures.count(pictures[0]) == FRAMES
        return pictures[0]

    def replace(self, source, data):
        source.GetClientSideObject().SetOutput(data)
        source.SMProxy.MarkModified(None)
        source.UpdatePipeline()

    def check_changes(self, kind, make, causes):
        """Each cause after good input, and before it."""
        source = source_of(make(kind))
        display = show(source, self.view, ARRAY, kind=KINDS[kind][2])
        simple.ResetCamera(self.view)
        picture = self.look()
        assert len(set(picture)) > 100
        for cause, message in causes:
            self.replace(source, cause(kind))
            bad = self.look(message if isinstance(message, str) else message[kind])
            assert len(set(bad)) == 1 or message is SOME_BLOCKS, "something is drawn"
            self.replace(source, make(kind))
            assert self.look() == picture, f"after {message} the picture is another one"
        simple.ColorBy(display, None)
        assert len(set(self.look(NOT_CHOSEN))) == 1
        simple.ColorBy(display, ("POINTS", ARRAY))
        assert self.look() == picture
        simple.Delete(source)

    def check_first(self, kind):
        """What is bad from the beginning."""
        for cause, message in ((without_arrays, NOTHING_TO_CHOOSE), (empty, NO_CELLS),
                               (flat, FLAT[kind])):
            source = source_of(cause(kind))
            display = simple.Show(source, self.view, KINDS[kind][2])
            display.SetRepresentationType(REPRESENTATION)
            assert len(set(self.look(message))) == 1
            self.replace(source, good(kind))
            simple.ColorBy(display, ("POINTS", ARRAY))
            assert len(set(self.look())) > 100
            simple.Delete(source)


    def check_surface(self):
        """ParaView has one representation for surfaces and grids that have no other."""
        source = simple.Sphere()
        display = show(source, self.view, "Normals", kind="GeometryRepresentation")
        assert len(set(self.look("cells of the data is three-dimensional"))) == 1, "something is drawn"
        display.SetRepresentationType("Surface")
        simple.ResetCamera(self.view)
        assert len(set(self.look())) > 10, "the surface is not drawn"
        simple.Delete(source)


def check_files(messages, kind, folder):
    """A series of which a step has lost its array, and another can't be read."""
    grids = [make_grid(kind, sum_of) for _ in range(4)]
    grids[1].GetPointData().GetArray(0).SetName("other")
    names = write_steps(kind, folder, grids)
    path = pathlib.Path(names[2])
    whole = path.read_bytes()
    path.write_bytes(whole[: len(whole) // 2])
    shown = Shown(kind, names)
    shown.scene.AnimationTime = 0
    picture = picture_of(shown.view)
    assert len(set(picture)) > 100 and not messages.take()
    for step in (1, 0, 1, 3, 2, 3, 0):
        shown.scene.AnimationTime = step
        pictures = [picture_of(shown.view) for _ in range(FRAMES)]
        said = messages.take()
        if step == 1:
            assert len(said) == 1 and NO_ARRAY in said[0], said
            assert len(set(pictures[0])) == 1
        elif step == 2:
            print(f"{kind}: a file that can't be read: {said}")
            ours = [text for text in said if "TetMarch" in text]
            assert len(ours) <= 1 and any(f"step2.{kind}" in text or "XML" in text for text in said), said
        else:
            assert not said, said
            assert pictures[0] == picture, f"{kind}: step {step} is another picture"
    shown.close()


def main():
    load_plugin(parse_arguments(__doc__))
    stage = Stage()
    stage.check_surface()
    for kind in KINDS:
        stage.check_changes(kind, good, CAUSES)
        stage.check_changes(kind, good_blocks, CAUSES_OF_BLOCKS)
        stage.check_first(kind)
        with tempfile.TemporaryDirectory() as folder:
            check_files(stage.messages, kind, folder)


main()
