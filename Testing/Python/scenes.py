# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""A cube of tetrahedra, a window with one volume, and the pixels of what it shows."""
import vtkmodules.all as vtk

SIZE = 96
LOW, HIGH = 0.2, 0.8
GREEN, RED = (0.0, 1.0, 0.0), (1.0, 0.0, 0.0)


def constant_array(name, value, count):
    array = vtk.vtkFloatArray()
    array.SetName(name)
    array.SetNumberOfValues(count)
    array.Fill(value)
    return array


def make_grid(cubes=8):
    """The unit cube, of tetrahedra, with the arrays low and high at points and cells, and x at the points."""
    image = vtk.vtkImageData()
    image.SetDimensions(cubes + 1, cubes + 1, cubes + 1)
    image.SetSpacing(1 / cubes, 1 / cubes, 1 / cubes)
    triangulate = vtk.vtkDataSetTriangleFilter()
    triangulate.SetInputData(image)
    triangulate.Update()
    grid = triangulate.GetOutput()
    for data, count in ((grid.GetPointData(), grid.GetNumberOfPoints()),
                        (grid.GetCellData(), grid.GetNumberOfCells())):
        data.AddArray(constant_array("low", LOW, count))
        data.AddArray(constant_array("high", HIGH, count))
    x = constant_array("x", 0.0, grid.GetNumberOfPoints())
    for point in range(grid.GetNumberOfPoints()):
        x.SetValue(point, grid.GetPoint(point)[0])
    grid.GetPointData().AddArray(x)
    return grid


def make_property(unit_distance=0.25):
    """What is low is drawn green, what is high red."""
    colour = vtk.vtkColorTransferFunction()
    colour.AddRGBPoint(LOW, *GREEN)
    colour.AddRGBPoint(HIGH, *RED)
    opacity = vtk.vtkPiecewiseFunction()
    opacity.AddPoint(0.0, 0.8)
    opacity.AddPoint(1.0, 0.8)
    volume_property = vtk.vtkVolumeProperty()
    volume_property.SetColor(colour)
    volume_property.SetScalarOpacity(opacity)
    volume_property.SetScalarOpacityUnitDistance(unit_distance)
    return volume_property


class View:
    """One mapper's picture of a grid."""

    def __init__(self, mapper, grid=None, volume_property=None):
        self.mapper = mapper
        if grid:
            mapper.SetInputData(grid)
        self.volume = vtk.vtkVolume()
        self.volume.SetMapper(mapper)
        self.volume.SetProperty(volume_property or make_property())
        self.renderer = vtk.vtkRenderer()
        self.renderer.AddVolume(self.volume)
        camera = self.renderer.GetActiveCamera()
        camera.SetFocalPoint(0.5, 0.5, 0.5)
        camera.SetPosition(1.5, -2.5, 1.8)
        camera.SetViewUp(0, 0, 1)
        self.window = vtk.vtkRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetOffScreenRendering(True)
        self.window.SetSize(SIZE, SIZE)
        self.window.AddRenderer(self.renderer)

    def pixels(self):
        """(r, g, b) of each, in rows from the bottom."""
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        values = vtk.vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, SIZE - 1, SIZE - 1, 0, values, 0)
        flat = memoryview(values).tobytes()
        return [tuple(flat[i:i + 3]) for i in range(0, len(flat), 3)]

    def centre(self):
        """Whether the picture's centre is "green", "red" or "empty"."""
        red, green, blue = self.pixels()[SIZE * SIZE // 2 + SIZE // 2]
        if (red, green, blue) == (0, 0, 0):
            return "empty"
        return "green" if green > red else "red"


def covered(pixels):
    """The share of them that are not black."""
    return sum(pixel != (0, 0, 0) for pixel in pixels) / len(pixels)


def mean_difference(first, second):
    """Over the pixels that either picture covers and over r, g, b, in units of 1/255."""
    pairs = [(p, q) for p, q in zip(first, second) if p != (0, 0, 0) or q != (0, 0, 0)]
    return sum(abs(a - b) for p, q in pairs for a, b in zip(p, q)) / (3 * len(pairs))
