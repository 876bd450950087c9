# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes bonsai_small.vti: each value is the mean of 2 x 2 x 2 values of the scan, rounded.

    make_bonsai_small.py BONSAI.vti OUTPUT.vti

BONSAI.vti is data/vti/bonsai.vti of Kitware's vtk-js-datasets.
"""
import hashlib
import pathlib
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter

SIZE = 256
SHA256 = "7129989b41b2197a73b68f66b3b889d9dc7ab6ef08dbdcfb61ca9cdf9f0981dc"


def read_scan(path):
    """The values by z, y, x."""
    if hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest() != SHA256:
        sys.exit(f"{path} is another file than the one that bonsai_small.vti was made of")
    reader = vtkXMLImageDataReader()
    reader.SetFileName(path)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(SIZE, SIZE, SIZE)


def halve(values):
    half = SIZE // 2
    means = values.reshape(half, 2, half, 2, half, 2).mean(axis=(1, 3, 5))
    return numpy.rint(means).astype(numpy.uint8)


def write_image(values, path):
    """In units of the scan: its voxels are 1 apart, and the first one is the origin."""
    image = vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.SetOrigin(0.5, 0.5, 0.5)
    image.SetSpacing(2, 2, 2)
    array = numpy_to_vtk(values.ravel())
    array.SetName("density")
    image.GetPointData().SetScalars(array)
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.SetCompressorTypeToZLib()
    writer.SetCompressionLevel(9)
    writer.Write()


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    write_image(halve(read_scan(sys.argv[1])), sys.argv[2])
