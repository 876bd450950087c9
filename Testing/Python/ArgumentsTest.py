# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments of wrong types, that are not numbers, or too many: the exception names the argument."""
import math
import os
import unittest

import numpy as np
import vtkmodules.all as vtk

import first_data
import vtktetmarch

NAN, INFINITE = math.nan, math.inf
SIZE = (40, 30)
MESH = os.path.join(first_data.DATA, "golfball_small.vtu")
# Argument of volume(), wrong value, exception, what it says.
VOLUME = (
    ("array", 5, TypeError, "array is a name, not 5"),
    ("association", ["points"], ValueError, "association is 'points', 'cells' or None, not"),
    ("association", 1, ValueError, "association is"),
    ("component", 1.0, ValueError, "component is a number from 0, 'magnitude' or None, not 1.0"),
    ("component", "first", ValueError, "component is"),
    ("component", True, ValueError, "component is"),
    ("range", "auto", TypeError, r"range \(low, high\) has 2 numbers, not 'auto'"),
    ("range", 3, TypeError, r"range \(low, high\)"),
    ("range", (0, 1, 2), ValueError, r"range \(low, high\) has 2 numbers, not 3"),
    ("range", (0, NAN), ValueError, r"range \(low, high\) is a finite number, not nan"),
    ("range", (0, INFINITE), ValueError, r"range \(low, high\)"),
    ("range", ("0", "1"), TypeError, r"range \(low, high\) is a number, not '0'"),
    ("range", (1, 1), ValueError, "low < high"),
    ("unit_distance", "thick", TypeError, "unit_distance is a number, not 'thick'"),
    ("unit_distance", NAN, ValueError, "unit_distance is a finite number"),
    ("unit_distance", INFINITE, ValueError, "unit_distance is a finite number"),
    ("unit_distance", -1, ValueError, "unit_distance is above 0, not -1"),
    ("cmap", 5, TypeError, "cmap is a name, a list of colours or a vtkColorTransferFunction, not 5"),
    ("cmap", "no such", ValueError, "cmap has no 'no such'"),
    ("cmap", [5], TypeError, "each colour of cmap, unless it is a text, has 3 numbers, not 5"),
    ("cmap", [(0, 0, NAN)], ValueError, "each colour of cmap.* is a finite number"),
    ("cmap", [("a", "b", "c")], TypeError, "each colour of cmap.* is a number, not 'a'"),
    ("cmap", [(NAN, "red")], ValueError, "value of a colour of cmap is a finite number"),
    ("cmap", [("low", "red")], TypeError, "value of a colour of cmap is a number, not 'low'"),
    ("opacity", [0.1, "x"], TypeError, "each of opacity, as the first one, is a number, not 'x'"),
    ("opacity", [0.1, 1.2], ValueError, "opacity is 0 to 1, not 1.2"),
    ("opacity", [(0, 1), 0.5], TypeError, r"pair \(value, opacity\) of opacity has 2 numbers, not 0.5"),
    ("opacity", str, TypeError, "opacity as a function returns a number, not"),
    ("opacity", lambda value: 2 + value, ValueError, "opacity is 0 to 1, not"),
    ("opacity", [(0, 1, 2)], ValueError, "of opacity has 2 numbers, not 3"),
    ("opacity", [(0, "x")], TypeError, "of opacity is a number, not 'x'"),
    ("opacity", [(NAN, 0.5)], ValueError, "of opacity is a finite number"),
    ("opacity", NAN, ValueError, "of opacity is a finite number"),
    ("opacity", vtk.vtkColorTransferFunction(), TypeError, "opacity is 'linear', a number"),
    ("gradient_opacity", 2, ValueError, "gradient_opacity is 0 to 1, not 2"),
    ("gradient_opacity", "steep", ValueError, "gradient_opacity is 'linear'"),
    ("isosurface_values", "0.5", TypeError, "isosurface_values is a list of values, not '0.5'"),
    ("isosurface_values", [0.5, NAN], ValueError, "isosurface_values is a finite number, not nan"),
    ("isosurface_values", None, TypeError, "isosurface_values is a list"),
    ("clipping_planes", vtk.vtkPlane(), TypeError, "clipping_planes is a list"),
    ("clipping_planes", [((0, 0, 0), (0, 0, 0))], ValueError, "normal of each of clipping_planes has a direction"),
    ("clipping_planes", [((0, 0, 0), (0, 1))], ValueError, "normal of each of clipping_planes has 3 numbers, not 2"),
    ("clipping_planes", [((0, NAN, 0), (0, 0, 1))], ValueError, "point of each of clipping_planes is a finite number"),
    ("shade", 5, ValueError, "shade can't be 5: it is 0 or 1"),
    ("visibility", -1, ValueError, "visibility can't be -1: it is 0 or 1"),
    ("blend_mode", -1, ValueError, r"blend_mode can't be -1: it is 0 \('composite'\), 1 \('maximum_intensity'\), "),
    ("scalar_mode", 99, ValueError, "scalar_mode can't be 99: it is 0 .*, 4"),
    ("ambient", -0.1, ValueError, "ambient can't be -0.1: it is 0 or more"),
    ("scalar_opacity_unit_distance", 0, ValueError, "scalar_opacity_unit_distance can't be 0: it is above 0"),
    ("component_weight", 0.5, TypeError, "component_weight can't be 0.5"),
    ("error_tolerance", NAN, ValueError, "error_tolerance can't be nan: it is not a number"),
    ("error_tolerance", np.float32(NAN), ValueError, "error_tolerance can't be"),
    ("error_tolerance", None, TypeError, "error_tolerance can't be None"),
    ("view_range", (0, NAN), ValueError, r"view_range can't be \(0, nan\): it is not a number"),
    ("view_range", (0, 1, 2), TypeError, "view_range can't be"),
    ("cropping_region_planes", np.full(6, NAN), ValueError, "cropping_region_planes can't be"),
    ("cropping_region_planes", (0, 1, 0, 1), TypeError, "cropping_region_planes can't be"),
    ("scalar_opacity_unit_distance", NAN, ValueError, "scalar_opacity_unit_distance can't be nan"),
    ("shade", "yes", TypeError, "shade takes no word; it was given 'yes'"),
    ("position", "left", TypeError, "position can't be 'left'"),
    ("pickable", None, TypeError, "pickable can't be None"),
)
FIGURE = (
    ("size", "big", TypeError, r"size \(width, height\) has 2 numbers, not 'big'"),
    ("size", 300, TypeError, r"size \(width, height\)"),
    ("size", (1, 2, 3), ValueError, r"size \(width, height\) has 2 numbers, not 3"),
    ("size", (NAN, 30), ValueError, r"size \(width, height\) is a finite number"),
    ("size", ("40", "30"), TypeError, r"size \(width, height\) is a number"),
    ("size", (0, 30), ValueError, "1 to 16384"),
    ("background", 0.5, TypeError, "background, unless it is a text, has 3 numbers, not 0.5"),
    ("background", "no such", ValueError, "background is .*; there is no colour 'no such'"),
    ("background", (0, 0, 2), ValueError, "background is a text or three numbers, 0 to 1"),
    ("transparent", "yes", TypeError, "transparent is True or False, not 'yes'"),
    ("transparent", 2, TypeError, "transparent is True or False, not 2"),
    ("camera", 3, TypeError, "camera is 'iso', 'x', '-x', .*, a dict or a vtkCamera, not 3"),
    ("camera", "up", ValueError, "camera is 'iso', .*, not 'up'"),
    ("camera", np.zeros(3), TypeError, "camera is 'iso'"),
    ("camera", {1: 2}, TypeError, "camera has no 1"),
    ("camera", {"position": (0, 0)}, ValueError, "camera's position has 3 numbers, not 2"),
    ("camera", {"position": (0, 0, NAN)}, ValueError, "camera's position is a finite number"),
    ("camera", {"view_up": "z"}, TypeError, "camera's view_up has 3 numbers, not 'z'"),
    ("camera", {"azimuth": "left"}, TypeError, "camera's azimuth is a number"),
    ("camera", {"elevation": NAN}, ValueError, "camera's elevation is a finite number"),
    ("camera", {"zoom": 0}, ValueError, "camera's zoom is above 0"),
    ("camera", {"parallel_scale": -1}, ValueError, "camera's parallel_scale is above 0"),
    ("camera", {"view_angle": 180}, ValueError, "camera's view_angle is below 180 degrees"),
)


# Arguments of from_image(), and as above.
IMAGE = (
    ({"array": None}, ValueError, r"array has the shape \(\)"),
    ({"array": [[[1], [2, 3]]]}, ValueError, "array has rows of different lengths"),
    ({"array": np.zeros((3, 3))}, ValueError, r"array has the shape \(3, 3\); a volume has three dimensions"),
    ({"array": np.zeros((3, 3, 3, 5))}, ValueError, "a fourth one of 1 to 4 components"),
    ({"array": np.zeros((3, 1, 3))}, ValueError, r"array has the shape \(3, 1, 3\); .* at least 2 of"),
    ({"array": np.zeros((3, 0, 3)), "association": "cells"}, ValueError, "at least 1 of an image's cells"),
    ({"spacing": 1}, TypeError, "spacing has 3 numbers, not 1"),
    ({"spacing": (1, 1, 0)}, ValueError, "spacing is above 0, not 0"),
    ({"origin": (1, 2)}, ValueError, "origin has 3 numbers, not 2"),
    ({"axes": "xy"}, ValueError, "axes is 'xyz', 'zyx' or another order of these letters, not 'xy'"),
    ({"axes": 3}, ValueError, "axes is 'xyz'"),
    ({"association": "faces"}, ValueError, "association is 'points' or 'cells'"),
    ({"name": 3}, TypeError, "name is a text, not 3"))


class ArgumentsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.data = first_data.one_tetrahedron()
        cls.figure = vtktetmarch.figure(cls.data, size=SIZE)

    def check(self, error, text, call, *arguments, **named):
        with self.subTest(call=call.__name__, arguments=arguments, named=named), self.assertRaisesRegex(error, text):
            call(*arguments, **named)

    def test_of_volume(self):
        for name, wrong, error, text in VOLUME:
            for call in (vtktetmarch.volume, vtktetmarch.figure):
                self.check(error, text, call, self.data, **{name: wrong})
        for name, wrong, error, text in VOLUME:
            if name not in ("array", "association", "component", "range", "unit_distance", "cmap", "opacity"):
                self.check(error, text, vtktetmarch.configure, self.figure.volume, **{name: wrong})

    def test_of_figure(self):
        for name, wrong, error, text in FIGURE:
            self.check(error, text, vtktetmarch.figure, self.data, **{name: wrong})
        for name, wrong, error, text in FIGURE:
            if name == "size":
                self.check(error, text, self.figure.screenshot, size=wrong)
            elif name == "transparent":
                self.check(error, text, self.figure.screenshot, transparent=wrong)
            elif name == "camera":
                self.check(error, text, self.figure.look, wrong)

    def test_of_from_image(self):
        for wrong, error, text in IMAGE:
            self.check(error, text, vtktetmarch.from_image, **{"array": np.zeros((3, 3, 3)), **wrong})

    def test_a_wrong_argument_changes_nothing(self):
        before = self.figure.screenshot()
        planes = self.figure.mapper.GetClippingPlanes()
        for wrong in ({"error_tolerance": NAN}, {"view_range": (0, NAN)}, {"isosurface_values": [NAN]},
                      {"clipping_planes": [((0.2, 0.2, 0.2), (1, 0, 0)), 5]}):
            self.assertRaises((TypeError, ValueError), vtktetmarch.configure, self.figure.volume, **wrong)
        self.assertRaises(ValueError, self.figure.look, {"azimuth": 40, "zoom": NAN})
        self.assertRaises(ValueError, self.figure.screenshot, size=(9, NAN))
        self.assertIs(self.figure.mapper.GetClippingPlanes(), planes)
        self.assertTrue(np.array_equal(self.figure.screenshot(), before))

    def test_of_the_other_functions(self):
        for error, text, call, arguments in (
                (TypeError, "filename is the path of a file, not 5", self.figure.screenshot, (5,)),
                (TypeError, "title is a text or None, not 5", self.figure.scalar_bar, (5,)),
                (TypeError, "titles are texts of three axes, not 5", self.figure.axes, (5,)),
                (TypeError, "titles are texts of three axes, not 1", self.figure.axes, ((1, 2, 3),)),
                (ValueError, "titles are texts of three axes, not 2", self.figure.axes, ("xy",)),
                (TypeError, "each of props is a vtkProp", self.figure.add, ("actor",)),
                (TypeError, "the title is a text, not 5", self.figure.show, (5,)),
                (TypeError, "x is a number, not 'left'", self.figure.pick, ("left", 3)),
                (ValueError, "y is a finite number, not nan", self.figure.pick, (3, NAN)),
                (TypeError, "configure.. takes a vtkVolume that volume.. made, not 3", vtktetmarch.configure, (3,)),
                (TypeError, "no mapper of TetMarch", vtktetmarch.configure, (vtk.vtkVolume(),)),
                (TypeError, "data is a vtkDataObject, not 3", vtktetmarch.auto_transfer_functions, (3,)),
                (TypeError, "path is the path of a file, a NumPy array, .*, not 5", vtktetmarch.read, (5,)),
                (TypeError, "path is a list, which is no volume", vtktetmarch.read, ([5],)),
                (TypeError, "time_step is of files", vtktetmarch.read, (np.zeros((3, 3, 3)), 1)),
                (TypeError, "path is the path of a file, not None", vtktetmarch.time_values, (None,)),
                (TypeError, "structured_law, unless it is None, is True or False, not 'no'",
                 vtktetmarch.auto_transfer_functions, (self.data, None, None, None, None, "no")),
                (TypeError, "has no mapper of TetMarch", vtktetmarch.statistics, ("figure",)),
                (TypeError, "object is no data", vtktetmarch.figure, (object(),))):
            self.check(error, text, call, *arguments)

    def test_of_from_arrays(self):
        points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], float)
        cells = np.array([[0, 1, 2, 3]])
        for error, text, arguments in (
                (TypeError, "points has values of type object", (None, cells, "tetra")),
                (TypeError, "cells has values of type", (points, None, "tetra")),
                (TypeError, "each of cell_types, unless it is a name, is an integer, not None", (points, cells, None)),
                (TypeError, "each of cell_types, unless it is a name, is an integer, not 10.5", (points, cells, 10.5)),
                (TypeError, "each of cell_types, unless it is a name, is an integer", (points, cells, [10.5])),
                (ValueError, "points has rows of different lengths", ([(0, 0, 0), (1, 0)], cells, "tetra")),
                (TypeError, "point_data is a dict", (points, cells, "tetra", np.zeros(4))),
                (TypeError, "cell_data is a dict", (points, cells, "tetra", None, [("a", [1])]))):
            self.check(error, text, vtktetmarch.from_arrays, *arguments)

    def test_of_time_steps(self):
        for wrong in ("last", 1.5, NAN, True):
            self.check(TypeError, "time_step is an integer, not", vtktetmarch.read, MESH, wrong)


if __name__ == "__main__":
    unittest.main(verbosity=2)
