# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Blend modes, cropping, NaN and the distance of rays, on cubes of which the picture is known.

They are hexahedra, an image or a rectilinear grid, as --grid says: properties and pictures are the same.
"""
import math

from lattices import ARRAY, image, lattice, rectilinear, source_of
from paraview import simple
from views import (figure_of, figures_of, load_plugin, mapper_of, open_view, parse_arguments, picture_of, set_all,
                   show)

N = 4  # cubes along each axis
PIXELS = 40  # along each of them
OPACITY = 0.5
UNIT_DISTANCE = 8.0
ROUNDING = 1  # of 255
PLANES = [0.0, 1.25, 2.0, 2.75, 4.0]  # of a rectilinear grid, along each axis

GRIDS = {
    "unstructured": (lambda value: lattice((N, N, N), value), "UnstructuredGridRepresentation"),
    "image": (lambda value: image((N, N, N), value), "UniformGridRepresentation"),
    "rectilinear": (lambda value: rectilinear([PLANES] * 3, value), "UniformGridRepresentation"),
}


def look_along(view, axis):
    """From the positive end, in parallel: N cubes fill the view."""
    up = (0, 0, 1) if axis != 2 else (0, 1, 0)
    middle = [N / 2] * 3
    view.ViewSize = [N * PIXELS] * 2
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = middle
    view.CameraPosition = [m + (10 * N if i == axis else 0) for i, m in enumerate(middle)]
    view.CameraViewUp = up
    view.CameraParallelScale = N / 2


def use_functions(opacity=OPACITY):
    """From green to red over the range, of the same opacity everywhere."""
    colours = simple.GetColorTransferFunction(ARRAY)
    colours.ColorSpace = "RGB"
    colours.RGBPoints = [0.0, 0.0, 1.0, 0.0, float(N), 1.0, 0.0, 0.0]
    colours.NanColor = [0.0, 0.0, 1.0]
    colours.NanOpacity = 1.0
    simple.GetOpacityTransferFunction(ARRAY).Points = [0.0, opacity, 0.5, 0.0, float(N), opacity, 0.5, 0.0]


class Cubes:
    """Their value is the place along x."""

    def __init__(self, arguments):
        self.folder = arguments.pictures
        self.view = open_view()
        self.grid, self.kind = GRIDS[arguments.grid]
        self.source, self.display = self.show(lambda x, y, z: x)
        use_functions()
        look_along(self.view, 0)

    def show(self, value):
        source = source_of(self.grid(value))
        display = show(source, self.view, ARRAY, kind=self.kind)
        display.ScalarOpacityUnitDistance = UNIT_DISTANCE
        display.TetMarchOpacityLaw = "Unstructured"
        return source, display

    def set(self, **properties):
        set_all(self.display, properties)
        picture = picture_of(self.view)
        if self.folder:
            name = "-".join(str(value).replace(" ", "") for value in properties.values())
            simple.SaveScreenshot(f"{self.folder}/{name}.png", self.view)
        return picture

    def expect_even(self, colour, **properties):
        """All pixels of that colour, 0 to 1."""
        expected = [255 * c for c in colour]
        found = set(self.set(**properties))
        worst = max(abs(a - b) for pixel in found for a, b in zip(pixel, expected))
        print(f"{properties}: {sorted(found)} instead of {expected}")
        assert worst <= ROUNDING, properties

    def expect_share(self, share, middle, **properties):
        """Of the pixels in which anything is seen, and whether the middle is one of them."""
        picture = self.set(**properties)
        seen = [any(pixel) for pixel in picture]
        row = N * PIXELS
        print(f"{properties}: {sum(seen) / len(seen):.4f} of the picture")
        assert abs(sum(seen) / len(seen) - share) < 2.0 / row, properties
        assert seen[row // 2 * row + row // 2] == middle, properties


def check_blend_modes(cubes):
    """Along x the values of each ray go from 0 to N, evenly."""
    transmittance = math.exp(-OPACITY / UNIT_DISTANCE * N)
    kappa = OPACITY / UNIT_DISTANCE
    # Of the depth s below the top, red falls as 1 - s / N: the integral of kappa exp(-kappa s) (1 - s / N).
    red = 1 - (1 - transmittance) / (kappa * N)
    cubes.expect_even((red, 1 - transmittance - red, 0), BlendMode="Composite")
    cubes.expect_even((OPACITY, 0, 0), BlendMode="Maximum Intensity")
    cubes.expect_even((0, OPACITY, 0), BlendMode="Minimum Intensity")
    cubes.expect_even([OPACITY / 2] * 3, BlendMode="Average Intensity")
    # Only the half that is less than N / 2, whose mean is N / 4.
    cubes.expect_even([OPACITY / 4] * 3, AverageIPScalarRange=[0.0, N / 2])
    cubes.expect_even([OPACITY / 2 * N / UNIT_DISTANCE] * 3, BlendMode="Additive")
    high, low = 0.7, 0.3
    cubes.expect_even((high * OPACITY, low * OPACITY, 0), BlendMode="Isosurface", IsosurfaceValues=[high * N])
    # The nearer one first.
    behind = OPACITY * (1 - OPACITY)
    cubes.expect_even((high * OPACITY + low * behind, low * OPACITY + high * behind, 0),
                      IsosurfaceValues=[low * N, high * N])
    cubes.expect_even((0, 0, 0), IsosurfaceValues=[])
    cubes.set(BlendMode="Composite")


def check_cropping(cubes):
    """Seen along z, planes in 1 and 3 along each axis."""
    look_along(cubes.view, 2)
    whole = cubes.set(UseCropping=0)
    assert cubes.set(UseCropping=1) == whole, "the whole box crops something"
    cubes.expect_share(0.5, False, CroppingScale=[0.5, 1.0, 1.0])
    cubes.expect_share(0.5, True, CroppingOrigin=[1.0, 0.0, 0.0])
    cubes.expect_share(0.25, False, CroppingScale=[0.25, 1.0, 1.0], CroppingOrigin=[3.0, 0.0, 0.0])
    cubes.expect_share(0.25, False, CroppingScale=[-0.25, 1.0, 1.0], CroppingOrigin=[1.0, 0.0, 0.0])
    mapper = mapper_of(cubes.display)
    by_vtk = hasattr(mapper, "GetCroppingRegionPlanes")  # whose mapper of images has them
    planes = list(mapper.GetCroppingRegionPlanes()) if by_vtk else figures_of(cubes.display, "CroppingRegionPlanes")
    assert planes == [0, 1, 0, N, 0, N], planes
    cubes.expect_share(0.25, True, CroppingScale=[0.5] * 3, CroppingOrigin=[1.0] * 3)
    # Along z, what regions there are seen through each other.
    cubes.expect_share(1.0, True, CroppingRegionFlags="Fence")
    cubes.expect_share(0.25, False, CroppingRegionFlags="Inverted Fence")
    cubes.expect_share(0.75, True, CroppingRegionFlags="Cross")
    cubes.expect_share(0.75, False, CroppingRegionFlags="Inverted Cross")
    assert cubes.set(UseCropping=0, CroppingRegionFlags="Box") == whole
    look_along(cubes.view, 0)


def check_nan(cubes):
    """A point in the corner of eight cubes that has no value."""
    cubes.display.Visibility = 0
    odd, display = cubes.show(lambda x, y, z: math.nan if x == y == z == N / 2 else x)
    picture = picture_of(cubes.view)
    assert not any(pixel[2] for pixel in picture), "cells without a value are drawn, and not asked for"
    display.TetMarchDrawNanCells = 1
    drawn = picture_of(cubes.view)
    share = sum(pixel[2] > 0 for pixel in drawn) / len(drawn)
    print(f"NaN cells: {share:.4f} of the picture")
    # Of the squares around it, what the cells or the tetrahedra that touch it cover.
    assert 2 / N**2 <= share <= 4 / N**2, "cells around a NaN don't have the colour of NaN"
    simple.Delete(odd)
    cubes.display.Visibility = 1


def check_distance_of_rays(cubes):
    """By hand, then as ParaView's interactive frames ask for it."""
    fine = cubes.set(AutoAdjustSampleDistances=0)
    cubes.set(ImageSampleDistance=4.0)
    assert figure_of(cubes.display, "UsedImageSampleDistance") == 4
    assert cubes.set(ImageSampleDistance=1.0, AutoAdjustSampleDistances=1) == fine
    assert figure_of(cubes.display, "UsedImageSampleDistance") == 1

    look_along(cubes.view, 0)
    set_all(cubes.display, {"MaximumImageSampleDistance": 3.0, "MinimumImageSampleDistance": 3.0})
    picture_of(cubes.view)
    assert figure_of(cubes.display, "UsedImageSampleDistance") == 3
    set_all(cubes.display, {"MinimumImageSampleDistance": 1.0})
    # Frames that take too long: a ray to three lights from each point of a ray.
    size = list(cubes.view.ViewSize)
    cubes.view.ViewSize = [400, 400]
    cubes.display.TetMarchShade = 1
    cubes.display.TetMarchAccuracyLevel = "Reference"
    cubes.display.TetMarchShadowMethod = "Along Rays"
    for threshold in (1e6, 0.0):  # megabytes, from which on ParaView has representations draw their LOD
        cubes.view.LODThreshold = threshold
        still = picture_of(cubes.view)
        builds = figure_of(cubes.display, "MeshBuilds")
        for _ in range(2):
            cubes.view.SMProxy.InteractiveRender()
        used = figure_of(cubes.display, "UsedImageSampleDistance")
        lod = bool(cubes.view.GetClientSideObject().GetUsedLODForLastRender())
        print(f"interactive frames: rays {used} pixels apart, level of detail: {lod}")
        assert lod == (threshold == 0.0)
        assert 1 < used <= 3, "interactive frames cast all rays"
        assert picture_of(cubes.view) == still, "interactive frames leave something behind"
        assert figure_of(cubes.display, "UsedImageSampleDistance") == 1
        assert figure_of(cubes.display, "MeshBuilds") == builds, "interactive frames prepare the mesh anew"
    cubes.display.TetMarchShadowMethod = "Off"
    cubes.display.TetMarchAccuracyLevel = "Default"
    cubes.display.TetMarchShade = 0
    cubes.view.ViewSize = size


def check_limits(cubes):
    """Numbers that no picture shows."""
    for name, value in (("LightTimeBudget", 0.25), ("PickOpacityThreshold", 0.75), ("MaxMemoryInBytes", 1 << 33)):
        set_all(cubes.display, {name: value})
        picture_of(cubes.view)
        assert figure_of(cubes.display, name) == value, name


def main():
    arguments = parse_arguments(__doc__, "grid")
    load_plugin(arguments)
    cubes = Cubes(arguments)
    check_blend_modes(cubes)
    check_cropping(cubes)
    check_nan(cubes)
    check_distance_of_rays(cubes)
    check_limits(cubes)


main()
