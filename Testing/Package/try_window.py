# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Starts a program and waits until its display shows a picture of many vivid colours: try_window.py PROGRAM ARGUMENT...

Widgets are grey; the volume isn't. Wants a display and xwd, whose output lies in window.xwd afterwards.
"""
import struct
import subprocess
import sys
import time

LONGEST = 90  # seconds
FEWEST_COLORS = 15000  # the widgets and their text have 3,000, the scan of the tests has 28,000
LEAST_CHROMA = 60  # between the channels, of 255


def colors_of(dump):
    """How many vivid ones what xwd writes has: the sizes of header and colour map, then four bytes a pixel."""
    header, colormap = struct.unpack_from(">L", dump, 0)[0], struct.unpack_from(">L", dump, 76)[0] * 12
    pixels = dump[header + colormap:]
    different = {pixels[i:i + 3] for i in range(0, len(pixels) - 3, 4)}
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
