# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A bar at the right of the picture with the colours of values, as tetmarch-render draws it."""
from .overlay import LETTER, Overlay, is_transparent, round_values, scale_of
from .vtkRenderingTetMarch import vtkTetMarchLegend, vtkTetMarchSettings

COLORS = 256
PLATE = 0.1, 0.1, 0.1, 0.75  # behind the bar, where the background isn't known
WHITE = 1.0, 1.0, 1.0


def share_of(size):
    """The bar's share of the picture's width."""
    return min(0.4, 150 * scale_of(size) / size[0])


class ScalarBar(Overlay):
    """The bar of a volume's colours; the legend of a view that draws a measure in its place."""

    def __init__(self, renderer, volume, title):
        super().__init__(renderer)
        self.volume = volume
        self.title = title
        legend = vtkTetMarchLegend()
        legend.SetMapper(volume.GetMapper())
        renderer.AddViewProp(legend)

    def lay_out(self, renderer):
        """For the next frame of a renderer."""
        if self.volume.GetMapper().GetSettings().GetViewMode() != vtkTetMarchSettings.VIEW_PICTURE:
            return
        width, height = size = renderer.GetSize()
        scale = scale_of(size)
        margin, thickness, tick = 10 * scale, 22 * scale, 5 * scale
        left, right = (1 - share_of(size)) * width + margin, width - margin
        bottom = max(0.12 * height, 2 * margin)
        top = max(bottom + 1, min(0.84 * height, height - 54 * scale))
        color = None
        if is_transparent(renderer):
            color = WHITE
            self.add_rectangle((left - margin, bottom - margin), (width, top + 45 * scale), PLATE)
        function = self.volume.GetProperty().GetRGBTransferFunction()
        low, high = function.GetRange()
        for i in range(COLORS):
            self.add_rectangle((left, bottom + (top - bottom) * i / COLORS),
                               (left + thickness, bottom + (top - bottom) * (i + 1) / COLORS),
                               (*function.GetColor(low + (high - low) * (i + 0.5) / COLORS), 1))
        most = max(1, int((top - bottom) / max(45 * scale, (top - bottom) / 10)))
        values = round_values(low, high, most)
        labels = [f"{value:.10g}" for value in values]
        beside = left + thickness + 2 * tick
        letters = min([15 * scale] + [(width - margin / 2 - beside) / (LETTER * len(label)) for label in labels])
        for value, label in zip(values, labels):
            y = bottom + (top - bottom) * (value - low) / (high - low)
            self.add_line((left + thickness, y), (left + thickness + tick, y))
            self.add_text(label, letters, (beside, y), color, left=True)
        letters = min(18 * scale, (right - left) / (LETTER * max(len(self.title), 1)))
        self.add_text(self.title, letters, (left, top + 27 * scale), color, left=True)
