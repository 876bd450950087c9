# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of files and of screens as numbers: height, width, 3 (red, green, blue, of 255)."""
import struct

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy


def read_png(file):
    """Rows from the bottom."""
    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3].astype(int)


def read_xwd(content):
    """Of what xwd writes, and Xvfb into the file of its frame buffer: rows from the top, as bytes."""
    header = struct.unpack(">25I", content[:100])
    width, height, stride, pixel = header[4], header[5], header[12], header[11] // 8
    begin = header[0] + 12 * header[19]  # after the header and the colour map
    lines = np.frombuffer(content, np.uint8, height * stride, begin).reshape(height, stride)
    return lines[:, : width * pixel].reshape(height, width, pixel)[:, :, 2::-1]
