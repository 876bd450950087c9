# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a raw file of SIZE^3 bytes: waves in a ball, thicker to its middle.

    make_image.py SIZE WAVES_SIZExSIZExSIZE_uint8.raw
"""
import sys

import numpy


def make_slice(x, z):
    """The values at the height z, by y, x; coordinates are -1 to 1."""
    across = numpy.hypot(x[:, None], x[None, :])
    radius = numpy.hypot(across, z)
    waves = 0.5 + 0.5 * numpy.cos(12 * across + 21 * z)
    return (255 * waves * numpy.exp(-8 * (radius - 0.6) ** 2) * (radius < 0.95)).astype(numpy.uint8)


def write_image(size, path):
    x = numpy.linspace(-1, 1, size, dtype=numpy.float32)
    with open(path, "wb") as file:
        for z in x:
            file.write(make_slice(x, z).tobytes())


if __name__ == "__main__":
    if len(sys.argv) != 3 or not sys.argv[1].isdigit():
        sys.exit(__doc__)
    write_image(int(sys.argv[1]), sys.argv[2])
