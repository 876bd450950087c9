# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Starts a program and waits until its display shows a picture of many vivid colours: try_window.py PROGRAM ARGUMENT...

Widgets are grey; the volume isn't. Wants a display and xwd, whose output lies in window.xwd afterwards.
"""
import struct
import subprocess
import sys
import time

LONGEST = 600  # seconds
FEWEST_COLORS = 5000  # the widgets have 20, the scan of the tests has 18,000
LEAST_CHROMA = 60  # between the channels, of 255


def colors_of(dump):
    """How many vivid ones what xwd writes has: a header of big-endian numbers, a colour map, lines of pixels."""
    header = struct.unpack_from(">25L", dump)
    size, width, height, pixel_bits, line_bytes, colormap_entries = (header[i] for i in (0, 4, 5, 11, 12, 19))
    step, begin = pixel_bits // 8, size + 12 * colormap_entries
    different = set()
    for line in range(begin, begin + height * line_bytes, line_bytes):
        different.update(dump[i:i + 3] for i in range(line, line + width * step, step))
    return sum(max(color) - min(color) >= LEAST_CHROMA for color in different)


program = subprocess.Popen(sys.argv[1:])
end, colors = time.monotonic() + LONGEST, 0
try:
    while colors < FEWEST_COLORS and program.poll() is None and time.monotonic() < end:
        time.sleep(0.5)
        screen = subprocess.run(["xwd", "-root", "-silent"], check=True, capture_output=True).stdout
        colors = colors_of(screen)
    if colors < FEWEST_COLORS:
        sys.exit(f"{sys.argv[1]} showed nothing: {colors} colours, exit status {program.poll()}")
    with open("window.xwd", "wb") as file:
        file.write(screen)
finally:
    program.kill()
    program.wait()
