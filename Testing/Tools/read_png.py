# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pixels of a PNG of 8-bit RGB or RGBA without interlacing, with Python alone."""
import struct
import zlib


def predict(left, up, corner):
    """Paeth's predictor, PNG specification 9.4."""
    p = left + up - corner
    distances = abs(p - left), abs(p - up), abs(p - corner)
    return (left, up, corner)[distances.index(min(distances))]


def read_png(path):
    """Rows from the top, each a list of (r, g, b) or (r, g, b, a)."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    position, compressed, header = 8, b"", None
    while position < len(data):
        length, kind = struct.unpack_from(">I4s", data, position)
        chunk = data[position + 8:position + 8 + length]
        header = struct.unpack(">IIBBBBB", chunk) if kind == b"IHDR" else header
        compressed += chunk if kind == b"IDAT" else b""
        position += length + 12
    width, height = header[:2]
    assert header[2:] in ((8, 2, 0, 0, 0), (8, 6, 0, 0, 0)), header
    channels = 3 if header[3] == 2 else 4
    raw, stride = zlib.decompress(compressed), channels * width
    above, rows = bytearray(stride), []
    for y in range(height):
        start = y * (stride + 1)
        method, line = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        for i in range(stride):
            left = line[i - channels] if i >= channels else 0
            corner = above[i - channels] if i >= channels else 0
            line[i] = (line[i] + (0, left, above[i], (left + above[i]) // 2,
                                  predict(left, above[i], corner))[method]) & 255
        rows.append([tuple(line[i:i + channels]) for i in range(0, stride, channels)])
        above = line
    return rows
