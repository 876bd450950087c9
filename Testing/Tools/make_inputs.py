# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small input files for tetmarch-render, good and bad."""
import base64
import json
import math
import struct

CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))


def numbers(values):
    return " ".join(map(str, values))


def xml_array(name, data_type, values, components=1):
    return (f'<DataArray type="{data_type}" Name="{name}" NumberOfComponents="{components}" format="ascii">'
            f"{numbers(values)}</DataArray>")


def binary_array(name, values, components=1):
    """Of any values: text has no NaN that VTK reads."""
    data = struct.pack(f"<{len(values)}d", *values)
    code = base64.b64encode(struct.pack("<I", len(data)) + data).decode()
    return (f'<DataArray type="Float64" Name="{name}" NumberOfComponents="{components}" format="binary">'
            f"{code}</DataArray>")


def cube_vtu(x=0):
    """A unit hexahedron, so far along x, and a triangle, which is to be skipped."""
    return f"""<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">
<UnstructuredGrid><Piece NumberOfPoints="8" NumberOfCells="2">
<PointData>{xml_array("half", "Float64", [0.5] * 8)}
{xml_array("ramp", "Float64", [corner[0] for corner in CORNERS])}</PointData>
<CellData>{xml_array("material", "Int32", [2, 7])}</CellData>
<Points>{xml_array("Points", "Float32", [p + o for corner in CORNERS for p, o in zip(corner, (x, 0, 0))], 3)}</Points>
<Cells>{xml_array("connectivity", "Int64", [0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2])}
{xml_array("offsets", "Int64", [8, 11])}
{xml_array("types", "UInt8", [12, 5])}</Cells>
</Piece></UnstructuredGrid></VTKFile>
"""


def blocks_vtm():
    """cube.vtu and the cube beside it."""
    return """<?xml version="1.0"?>
<VTKFile type="vtkMultiBlockDataSet" version="1.0" byte_order="LittleEndian"><vtkMultiBlockDataSet>
<DataSet index="0" file="cube.vtu"/><DataSet index="1" file="beside.vtu"/>
</vtkMultiBlockDataSet></VTKFile>
"""


def vectors_vtu():
    """A unit voxel with a vector of length 0.5, and a number that is none."""
    return f"""<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">
<UnstructuredGrid><Piece NumberOfPoints="8" NumberOfCells="1">
<PointData>{binary_array("vector", [0.3, 0.4, 0] * 8, 3)}</PointData>
<CellData>{binary_array("unknown", [math.nan])}</CellData>
<Points>{xml_array("Points", "Float32", [x for corner in CORNERS for x in corner], 3)}</Points>
<Cells>{xml_array("connectivity", "Int64", range(8))}
{xml_array("offsets", "Int64", [8])}
{xml_array("types", "UInt8", [12])}</Cells>
</Piece></UnstructuredGrid></VTKFile>
"""


def legacy(cells, with_array=True):
    text = "# vtk DataFile Version 3.0\ncube\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n"
    text += "\n".join(map(numbers, CORNERS))
    text += f"\nCELLS {len(cells)} {sum(len(ids) + 1 for _, ids in cells)}\n"
    text += "\n".join(numbers([len(ids), *ids]) for _, ids in cells)
    text += f"\nCELL_TYPES {len(cells)}\n" + "\n".join(str(cell_type) for cell_type, _ in cells) + "\n"
    if with_array:
        text += "POINT_DATA 8\nSCALARS half double 1\nLOOKUP_TABLE default\n" + numbers([0.5] * 8) + "\n"
    return text


def plate():
    """A square of side 20 in the plane x = 2."""
    return ("# vtk DataFile Version 3.0\nplate\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
            "2 -10 -10\n2 10 -10\n2 10 10\n2 -10 10\nPOLYGONS 1 5\n4 0 1 2 3\n")


def write_all(folder):
    hexahedron = (12, range(8))
    texts = {
        "cube.vtu": cube_vtu(),
        "beside.vtu": cube_vtu(1),
        "blocks.vtm": blocks_vtm(),
        "truncated.vtu": cube_vtu()[:700],
        "garbage.vtu": "this is no XML",
        "empty.vtu": "",
        "cube.vtk": legacy([hexahedron]),
        "truncated.vtk": legacy([hexahedron])[:130],
        "garbage.vtk": "this is no VTK file",
        "bare.vtk": legacy([hexahedron], with_array=False),
        "surface.vtk": legacy([(5, (0, 1, 2)), (9, (0, 1, 2, 3))]),
        "plate.vtk": plate(),
        "vectors.vtu": vectors_vtu(),
        "garbage.ex2": "this is no Exodus file",
        "garbage.cgns": "this is no CGNS file",
        "notes.txt": "text",
        "constant.json": json.dumps([{"Name": "constant", "ColorSpace": "RGB",
                                      "RGBPoints": [0, 1, 0.5, 0.25, 1, 1, 0.5, 0.25],
                                      "Points": [0, 0.7, 0.5, 0, 1, 0.7, 0.5, 0]}]),
        "ramp.json": json.dumps([{"Name": "ramp", "ColorSpace": "RGB",
                                  "RGBPoints": [0, 1, 0.5, 0.25, 1, 1, 0.5, 0.25],
                                  "Points": [0, 0, 0.5, 0, 1, 1, 0.5, 0]}]),
        "malformed.json": '[\n  {\n    "Name" "x"\n  }\n]\n',
        "colourless.json": '[{"Name": "x", "Points": [0, 0, 0.5, 0]}]',
    }
    for name, text in texts.items():
        (folder / name).write_text(text)
