# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lines, rectangles and text over the scene, in pixels from the lower left; sizes and colours as tetmarch-render's."""
import math
import weakref

from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor2D, vtkPolyDataMapper2D, vtkPropAssembly, vtkTextActor

GREY = 0.5, 0.5, 0.5  # legible on bright and dark
LETTER = 0.56  # the width of a digit, of the size of text


def round_values(low, high, most):
    """At most `most` multiples of 1, 2 or 5 times a power of ten, from low to high."""
    if not low < high or most < 1:
        return []
    power = 10.0 ** math.floor(math.log10((high - low) / most))
    for step in (factor * power for factor in (1, 2, 5, 10, 20)):
        first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
        if last - first < most:
            return [i * step for i in range(first, last + 1)]
    return []


def scale_of(size):
    """By how much text and lines are larger than in a picture of 1024 x 768."""
    return max(0.5, min(size[0] / 1024, size[1] / 768))


def is_transparent(renderer):
    """Whether pictures have an alpha channel in place of the background."""
    return renderer.GetBackgroundAlpha() == 0


def color_of_text(renderer):
    """White on dark, black on bright, grey where that isn't known."""
    if is_transparent(renderer):
        return GREY
    lightness = sum(weight * part for weight, part in zip((0.2126, 0.7152, 0.0722), renderer.GetBackground()))
    return (0.0,) * 3 if lightness > 0.5 else (1.0,) * 3


class Overlay:
    """What is drawn anew before each frame of a renderer, while the object lives: lay_out(renderer) adds to it."""

    def __init__(self, renderer):
        self.prop = vtkPropAssembly()
        renderer.AddViewProp(self.prop)
        weak = weakref.ref(self)

        def before_frame(drawn, _event):
            alive = weak()
            if alive is not None:
                alive._clear(drawn)
                alive.lay_out(drawn)

        renderer.AddObserver("StartEvent", before_frame)

    def lay_out(self, renderer):
        """Adds lines, rectangles and text for the renderer's size, camera and background."""
        raise NotImplementedError

    def _clear(self, renderer):
        for part in list(self.prop.GetParts()):
            self.prop.RemovePart(part)
        self.color = color_of_text(renderer)
        self._rectangles, self._lines = (self._add_layer(scale_of(renderer.GetSize())) for _ in range(2))
        self._lines.SetLines(vtkCellArray())
        self._rectangles.SetPolys(vtkCellArray())
        colors = vtkUnsignedCharArray()
        colors.SetNumberOfComponents(4)
        self._rectangles.GetCellData().SetScalars(colors)

    def _add_layer(self, scale):
        data = vtkPolyData()
        data.SetPoints(vtkPoints())
        mapper = vtkPolyDataMapper2D()
        mapper.SetInputData(data)
        actor = vtkActor2D()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(self.color)
        actor.GetProperty().SetLineWidth(1.5 * scale)
        self.prop.AddPart(actor)
        return data

    def add_line(self, *ends):
        """A line from one (x, y) to another."""
        ids = [self._lines.GetPoints().InsertNextPoint(*end, 0) for end in ends]
        self._lines.GetLines().InsertNextCell(2, ids)

    def add_rectangle(self, low, high, rgba):
        """Below lines and text, and over the rectangles before it."""
        corners = (low, (high[0], low[1]), high, (low[0], high[1]))
        ids = [self._rectangles.GetPoints().InsertNextPoint(*corner, 0) for corner in corners]
        self._rectangles.GetPolys().InsertNextCell(4, ids)
        self._rectangles.GetCellData().GetScalars().InsertNextTuple([round(255 * part) for part in rgba])

    def add_text(self, text, size, place, color=None, left=False):
        """Text about its centre, or the middle of its left side."""
        actor = vtkTextActor()
        actor.SetInput(text)
        actor.SetTextScaleModeToNone()
        style = actor.GetTextProperty()
        style.SetFontSize(max(6, round(size)))
        style.SetColor(color or self.color)
        style.SetVerticalJustificationToCentered()
        if left:
            style.SetJustificationToLeft()
        else:
            style.SetJustificationToCentered()
        actor.SetPosition(math.floor(place[0]), math.floor(place[1]))
        self.prop.AddPart(actor)
