# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Three axes with coordinates, each along an edge of the silhouette of a box, as tetmarch-render draws them.

Nothing of the box lies before or behind them, so they are drawn in two dimensions.
"""
import numpy as np

from .overlay import LETTER, Overlay, round_values, scale_of

LABELS = 70  # pixels of a picture of 1024 x 768, how far labels reach away from the box
CORNERS = np.array([[corner >> axis & 1 for axis in range(3)] for corner in range(8)])


def room_of(size, bar):
    """The share of a picture that labels along two sides leave to the box; bar: the scalar bar's share of the width."""
    return max(0.2, 1 - 2 * LABELS * scale_of(size) / min((1 - bar) * size[0], size[1]))


def projected(points, camera, size):
    """(points, 2) pixels from the lower left; None if some point is behind the camera."""
    matrix = camera.GetCompositeProjectionTransformMatrix(size[0] / size[1], -1, 1)
    matrix = np.array([[matrix.GetElement(i, k) for k in range(4)] for i in range(4)])
    clip = points @ matrix[:, :3].T + matrix[:, 3]
    return (clip[:, :2] / clip[:, 3:] + 1) / 2 * size if (clip[:, 3] > 0).all() else None


def find_edge(shown, axis, shortest):
    """(corner, unit vector along, unit vector outwards, length) of an edge of the silhouette, or None.

    shown: the pixels of the box's corners. Edges below the box are preferred, then those on its left.
    """
    found = []
    for corner in range(8):
        along = shown[corner | 1 << axis] - shown[corner]
        length = np.hypot(*along)
        if corner >> axis & 1 or length < shortest:
            continue
        along = along / length
        sides = (shown - shown[corner]) @ (-along[1], along[0])
        side = 1 if sides.min() > -0.01 else -1 if sides.max() < 0.01 else 0
        outwards = side * np.array((along[1], -along[0]))
        if side:
            found.append((-outwards[1] - 0.5 * outwards[0], corner, along, outwards, length))
    return max(found, key=lambda edge: edge[0])[1:] if found else None


class BoxAxes(Overlay):
    """The axes of a volume's box. titles: of x, y and z."""

    def __init__(self, renderer, volume, titles):
        super().__init__(renderer)
        self.volume = volume
        self.titles = titles

    def lay_out(self, renderer):
        """For the next frame of a renderer. No axes are drawn while some of the box is behind the camera."""
        ends = np.reshape(self.volume.GetBounds(), (3, 2))
        corners = np.where(CORNERS, ends[:, 1], ends[:, 0])
        shown = projected(corners, renderer.GetActiveCamera(), renderer.GetSize())
        for axis in range(3) if shown is not None else ():
            edge = find_edge(shown, axis, 20 * scale_of(renderer.GetSize()))
            if edge is not None:
                self._add_axis(renderer, axis, ends[axis], corners[edge[0]], *edge[1:])

    def _add_axis(self, renderer, axis, ends, corner, along, outwards, length):
        scale = scale_of(renderer.GetSize())
        size, tick, gap = 15 * scale, 6 * scale, 5 * scale
        spacing = 4 * size * abs(along[0]) + 2 * size * abs(along[1])
        values = round_values(*ends, int(length / spacing))
        labels = [f"{value:.10g}" for value in values]
        size = min([size] + [4 * size / (LETTER * len(label)) for label in labels])
        places = np.repeat([corner], len(values) + 2, axis=0)
        places[:, axis] = [*ends, *values]
        points = projected(places, renderer.GetActiveCamera(), renderer.GetSize())
        self.add_line(points[0], points[1])
        reach = 0
        for point, label in zip(points[2:], labels):
            self.add_line(point, point + tick * outwards)
            half = (LETTER * size * len(label) * abs(outwards[0]) + size * abs(outwards[1])) / 2
            self.add_text(label, size, point + (tick + gap + half) * outwards)
            reach = max(reach, 2 * half)
        title, size = self.titles[axis], 18 * scale
        half = size * (LETTER * len(title) * abs(outwards[0]) + abs(outwards[1])) / 2
        middle = points[0] + 0.5 * length * along
        self.add_text(title, size, middle + (tick + reach + 2 * gap + half) * outwards)
