# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files whose arrays contradict each other, and --check: UnsoundDataTest.py EXECUTABLE PROJECT_FOLDER."""
from make_inputs import CORNERS, binary_array, numbers, xml_array
from render_case import RenderCase, main

SIZE = ("--size", "16x12")


def cube(corners=CORNERS, ids=range(8), values=range(8)):
    """A hexahedron as .vtu."""
    return f"""<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">
<UnstructuredGrid><Piece NumberOfPoints="8" NumberOfCells="1">
<PointData>{binary_array("f", list(values))}</PointData>
<Points>{binary_array("Points", [x for corner in corners for x in corner], 3)}</Points>
<Cells>{xml_array("connectivity", "Int64", ids)}{xml_array("offsets", "Int64", [8])}{xml_array("types", "UInt8", [12])}
</Cells></Piece></UnstructuredGrid></VTKFile>
"""


def legacy(point_data, offsets="0 8"):
    return f"""# vtk DataFile Version 5.1
hexahedra
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 8 double
{numbers(x for corner in CORNERS for x in corner)}
CELLS {len(offsets.split())} 8
OFFSETS vtktypeint64
{offsets}
CONNECTIVITY vtktypeint64
0 1 2 3 4 5 6 7
CELL_TYPES {len(offsets.split()) - 1}
{numbers([12] * (len(offsets.split()) - 1))}
POINT_DATA 8
{point_data}
"""


FIELD = "FIELD FieldData 2\nshort 1 5 double\n1 2 3 4 5\nfits 1 8 double\n0 1 2 3 4 5 6 7"
POINT = "The connectivity of cell 0 names point 1000000000, but the grid has 8 points. Repair the grid's cell array."
SHORT = 'The scalar array "short" has 5 tuples, but the grid has 8 points.'


class UnsoundDataTest(RenderCase):
    def setUp(self):
        super().setUp()
        self.write("sound.vtu", cube())
        self.write("ids.vtu", cube(ids=[0, 1, 2, 3, 4, 5, 6, 10 ** 9]))
        self.write("falling.vtk", legacy(FIELD, "0 8 4"))
        self.write("short.vtk", legacy(FIELD))
        self.write("nan.vtu", cube(values=[float("nan")] * 8))
        self.write("tree.vtm", """<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>
<DataSet index="0" name="air" file="sound.vtu"/><DataSet index="1" name="wall" file="ids.vtu"/>
<DataSet index="2" file="ids.vtu"/></vtkMultiBlockDataSet></VTKFile>""")

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="ascii")

    def test_what_cannot_be_drawn_is_refused_before_anything_reads_it(self):
        for arguments in ((), ("--list",), ("--array", "f"), ("--preset", "ramp.json")):
            self.expect_failure(1, f"'ids.vtu' can't be drawn: {POINT}", "ids.vtu", *SIZE, *arguments)
            self.expect_failure(1, f"'tree.vtm' can't be drawn: Block \"wall\": {POINT}", "tree.vtm", *SIZE, *arguments)
            self.expect_failure(1, "let cell 1 begin at 8 and end at 4", "falling.vtk", *SIZE, *arguments)

    def test_check_prints_every_fault(self):
        def check(name, status, stdout, stderr):
            result = self.run_tool(name, "--check")
            self.assertEqual((result.returncode, result.stdout, result.stderr), (status, stdout, stderr))
        check("sound.vtu", 0, "no fault\n", "")
        check("ids.vtu", 1, POINT + "\n", "tetmarch-render: error: 'ids.vtu' has 1 fault\n")
        check("short.vtk", 1, SHORT + "\n", "tetmarch-render: error: 'short.vtk' has 1 fault\n")
        check("tree.vtm", 1, f'Block "wall": {POINT}\nBlock number 4: {POINT}\n',
              "tetmarch-render: error: 'tree.vtm' has 2 faults\n")
        self.expect_failure(1, "'surface.vtk' has no 3D cells", "surface.vtk", "--check")
        self.expect_failure(1, "cannot read 'none.vtu'", "none.vtu", "--check")
        self.assertEqual(list(self.folder.glob("*.png")), [])

    def test_an_array_that_does_not_fit_is_left_out(self):
        result = self.run_tool("short.vtk", *SIZE)
        self.assertEqual((result.returncode, result.stdout), (0, ""))
        self.assertEqual(result.stderr, "tetmarch-render: warning: point array 'short' is left out: it has 5 tuples, "
                         "but the grid has 8 points\n"
                         "tetmarch-render: note: drawing fits on points, 0 to 7 (--list shows all arrays)\n")

    def test_an_array_without_a_finite_value(self):
        result = self.run_tool("nan.vtu", "--list")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertRegex(result.stdout, r"\n\* +f +points +double +1 +- +- +not finite\n")
        result = self.run_tool("nan.vtu", *SIZE)
        self.assertIn("note: drawing f on points, no value is finite", result.stderr)

    def test_values_and_coordinates_at_the_ends_of_double_precision(self):
        most, least = 1.7e308, 5e-324
        scene = (*SIZE, "--array", "f", "--background", "0,0,0")
        sound = self.draw("sound.vtu", *scene)
        for scale in (1e-15, 1e45, 1e99):
            self.write("scaled.vtu", cube([[scale * x for x in corner] for corner in CORNERS]))
            self.assertLessEqual(max(abs(a - b) for row, other in zip(self.draw("scaled.vtu", *scene), sound)
                                     for p, q in zip(row, other) for a, b in zip(p, q)), 2, scale)
        for values in ([-most, most] * 4, [0, least, 2 * least, 3 * least] * 2):
            self.write("extreme.vtu", cube(values=values))
            picture = self.draw("extreme.vtu", *scene)
            self.assertGreater(max(max(p[:3]) for row in picture for p in row), 60, values)


if __name__ == "__main__":
    main()
