# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pixels of a window as arrays, and as PNG."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkJPEGWriter, vtkPNGWriter

from .files import write_file


def pixels_of(window, transparent):
    """The rendered picture, (height, width, 3 or 4) bytes, the uppermost row first, not premultiplied."""
    width, height = window.GetSize()
    taken = vtkUnsignedCharArray()
    read = window.GetRGBACharPixelData if transparent else window.GetPixelData
    read(0, 0, width - 1, height - 1, 0, taken, 0)
    window.ReleaseCurrent()
    pixels = vtk_to_numpy(taken).reshape(height, width, 4 if transparent else 3)[::-1]
    return unmultiplied(pixels) if transparent else pixels.copy()


def unmultiplied(pixels):
    """Converts premultiplied colours of the window to those of PNG."""
    opacity = pixels[:, :, 3:].astype(np.float64)
    color = np.divide(255 * pixels[:, :, :3].astype(np.float64), opacity, where=opacity > 0,
                      out=np.zeros(pixels.shape[:2] + (3,)))
    return np.concatenate([np.minimum(np.rint(color), 255), opacity], axis=2).astype(np.uint8)


def encoded(pixels, writer):
    """A file of such pixels, as a vtkImageWriter that can write to memory makes it."""
    height, width, channels = pixels.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    values = numpy_to_vtk(np.ascontiguousarray(pixels[::-1]).reshape(-1, channels), deep=True)
    image.GetPointData().SetScalars(values)
    writer.SetInputData(image)
    writer.WriteToMemoryOn()
    writer.Write()
    return vtk_to_numpy(writer.GetResult()).tobytes()


def png_bytes(pixels):
    """A PNG file of such pixels."""
    return encoded(pixels, vtkPNGWriter())


def jpeg_bytes(pixels, quality=85):
    """A JPEG file of such pixels, which have 3 channels. quality: 0 to 100."""
    writer = vtkJPEGWriter()
    writer.SetQuality(quality)
    return encoded(pixels, writer)


def write_png(pixels, path):
    """Writes a file that is complete once it has its name: see write_file()."""
    write_file(png_bytes(pixels), path)
