# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""How far two pictures are apart, in steps of 1/255: compare.py A.png B.png [DIFFERENCE.png]

The third picture is |A - B| times 64: a difference of 4 steps is white.
"""
import dataclasses
import sys

import numpy as np
from PIL import Image

GAIN = 64


@dataclasses.dataclass
class Difference:
    """The difference of a pixel is that of its worst channel; the RMS is over all channels."""
    most: int
    rms: float
    over: int  # pixels that differ by more than 2 steps
    worst: tuple  # column and row from the top of the pixel that differs most

    def __str__(self):
        return f"max {self.most}/255 at {self.worst}, RMS {self.rms:.3f}/255, {self.over} pixels above 2/255"


def read(path):
    return np.array(Image.open(path).convert("RGB"))


def distances(a, b):
    if a.shape != b.shape:
        raise ValueError(f"The pictures differ in size: {a.shape[1]} x {a.shape[0]} and {b.shape[1]} x {b.shape[0]}")
    return np.abs(a.astype(int) - b)


def compare(a, b):
    """The Difference of two arrays of (height, width, 3) bytes."""
    apart = distances(a, b)
    pixels = apart.max(axis=2)
    row, column = np.unravel_index(pixels.argmax(), pixels.shape)
    return Difference(int(pixels.max()), float(np.sqrt(np.mean(apart ** 2.0))), int((pixels > 2).sum()),
                      (int(column), int(row)))


def picture_of_difference(a, b):
    return np.minimum(GAIN * distances(a, b), 255).astype(np.uint8)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__.splitlines()[0])
    pictures = [read(path) for path in sys.argv[1:3]]
    print(compare(*pictures))
    if len(sys.argv) == 4:
        Image.fromarray(picture_of_difference(*pictures)).save(sys.argv[3])
