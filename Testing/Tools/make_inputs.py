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


def steps_vtu():
    """A unit voxel at three time steps, which the reader of VTK numbers. Its ramp along x ends at 1, then 2, then 3."""
    ramps = "".join(xml_array("ramp", "Float64", [(step + 1) * corner[0] for corner in CORNERS]).replace(
        "<DataArray ", f'<DataArray TimeStep="{step}" ') for step in range(3))
    return f"""<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">
<UnstructuredGrid TimeValues="0 1 2"><Piece NumberOfPoints="8" NumberOfCells="1">
<PointData>{ramps}</PointData>
<Points>{xml_array("Points", "Float32", [x for corner in CORNERS for x in corner], 3)}</Points>
<Cells>{xml_array("connectivity", "Int64", range(8))}
{xml_array("offsets", "Int64", [8])}
{xml_array("types", "UInt8", [12])}</Cells>
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


def polyhedron_vtu(faces):
    """A tetrahedron that is a polyhedron, and says how many faces it has."""
    return f"""<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">
<UnstructuredGrid><Piece NumberOfPoints="4" NumberOfCells="1">
<PointData>{xml_array("half", "Float64", [0.5] * 4)}</PointData>
<Points>{xml_array("Points", "Float32", [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], 3)}</Points>
<Cells>{xml_array("connectivity", "Int64", range(4))}
{xml_array("offsets", "Int64", [4])}
{xml_array("types", "UInt8", [42])}
{xml_array("faces", "Int64", [faces, 3, 0, 1, 2, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 2, 3])}
{xml_array("faceoffsets", "Int64", [17])}</Cells>
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


# Of the points of an image of a unit cube, 3 along each axis.
LATTICE = [(0.5 * i, 0.5 * j, 0.5 * k) for k in range(3) for j in range(3) for i in range(3)]


def image_arrays():
    """Of points: a constant, a ramp along x, a vector of length 0.5. Of the 8 cells: 0 and 1 along x, no numbers."""
    return f"""<PointData>{xml_array("half", "Float64", [0.5] * 27)}
{xml_array("ramp", "Float64", [x for x, _, _ in LATTICE])}
{binary_array("vector", [0.3, 0.4, 0] * 27, 3)}</PointData>
<CellData>{xml_array("side", "UInt8", [0, 1] * 4)}
{binary_array("unknown", [math.nan] * 8)}</CellData>"""


def image_vti(x=0):
    """A unit cube of 2 x 2 x 2 voxels, so far along x."""
    return f"""<?xml version="1.0"?>
<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian">
<ImageData WholeExtent="0 2 0 2 0 2" Origin="{x} 0 0" Spacing="0.5 0.5 0.5"><Piece Extent="0 2 0 2 0 2">
{image_arrays()}
</Piece></ImageData></VTKFile>
"""


def rectilinear_vtr():
    """The same cube; along z its cells are 0.1 and 0.9 long."""
    return f"""<?xml version="1.0"?>
<VTKFile type="RectilinearGrid" version="0.1" byte_order="LittleEndian">
<RectilinearGrid WholeExtent="0 2 0 2 0 2"><Piece Extent="0 2 0 2 0 2">
{image_arrays()}
<Coordinates>{xml_array("x", "Float64", [0, 0.5, 1])}{xml_array("y", "Float64", [0, 0.5, 1])}
{xml_array("z", "Float64", [0, 0.1, 1])}</Coordinates>
</Piece></RectilinearGrid></VTKFile>
"""


def legacy_image(dimensions, with_array=True):
    count = math.prod(dimensions)
    return (f"# vtk DataFile Version 3.0\nimage\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS {numbers(dimensions)}\n"
            f"ORIGIN 0 0 0\nSPACING 0.5 0.5 0.5\n" +
            (f"POINT_DATA {count}\nSCALARS half float 1\nLOOKUP_TABLE default\n{numbers([0.5] * count)}\n"
             if with_array else ""))


def images_vtm():
    """image.vti and the image beside it."""
    return """<?xml version="1.0"?>
<VTKFile type="vtkMultiBlockDataSet" version="1.0" byte_order="LittleEndian"><vtkMultiBlockDataSet>
<DataSet index="0" file="image.vti"/><DataSet index="1" file="image_beside.vti"/>
</vtkMultiBlockDataSet></VTKFile>
"""


def leaves_vthb():
    """image.vti as the only block of an adaptive mesh."""
    return """<?xml version="1.0"?>
<VTKFile type="vtkOverlappingAMR" version="1.1" byte_order="LittleEndian">
<vtkOverlappingAMR origin="0 0 0" grid_description="XYZ"><Block level="0" spacing="0.5 0.5 0.5">
<DataSet index="0" amr_box="0 1 0 1 0 1" file="image.vti"/>
</Block></vtkOverlappingAMR></VTKFile>
"""


def values_of_half(code, dimensions):
    """The bytes of an image that is 0.5 all over, by a code of struct."""
    count = math.prod(dimensions)
    return struct.pack(f"{code[0]}{count}{code[1]}", *[0.5] * count)


def meta_image():
    """A unit cube, 11 values along x."""
    return (b"ObjectType = Image\nNDims = 3\nDimSize = 11 3 3\nElementSpacing = 0.1 0.5 0.5\n"
            b"ElementType = MET_FLOAT\nElementDataFile = LOCAL\n" + values_of_half("<f", (11, 3, 3)))


def nrrd():
    return (b"NRRD0004\ntype: double\ndimension: 3\nsizes: 11 3 3\nspacings: 0.1 0.5 0.5\nendian: big\n"
            b"encoding: raw\n\n" + values_of_half(">d", (11, 3, 3)))


def write_all(folder):
    hexahedron = (12, range(8))
    texts = {
        "cube.vtu": cube_vtu(),
        "beside.vtu": cube_vtu(1),
        "blocks.vtm": blocks_vtm(),
        "steps.vtu": steps_vtu(),
        "polyhedron.vtu": polyhedron_vtu(4),
        "lying_faces.vtu": polyhedron_vtu(2000000000),
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
        "image.vti": image_vti(),
        "image_beside.vti": image_vti(1),
        "images.vtm": images_vtm(),
        "leaves.vthb": leaves_vthb(),
        "grid.vtr": rectilinear_vtr(),
        "image.vtk": legacy_image((3, 3, 3)),
        "flat.vtk": legacy_image((3, 3, 1)),
        "bare_image.vtk": legacy_image((3, 3, 3), with_array=False),
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
    files = {"image.mha": meta_image(), "image.nrrd": nrrd(), "image.raw": values_of_half(">f", (3, 3, 3)),
             "image_3x3x3_float64.raw": values_of_half("<d", (3, 3, 3))}
    for name, data in files.items():
        (folder / name).write_bytes(data)
