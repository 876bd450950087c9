# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small sound files of each kind that the programs read, from which others are made by damage."""
import json
import pathlib
import shutil
import struct

import vtkmodules.all as vtk

HERE = pathlib.Path(__file__).parent
# The writer of Exodus that vtkmodules.all puts in place of the serial one crashes without it in VTK 9.6.
CONTROLLER = vtk.vtkDummyController()  # VTK keeps no reference to it
vtk.vtkMultiProcessController.SetGlobalController(CONTROLLER)


def add_arrays(data):
    """Of points: x and a vector, of cells: a number."""
    for attributes, count, place in ((data.GetPointData(), data.GetNumberOfPoints(), data.GetPoint),
                                     (data.GetCellData(), data.GetNumberOfCells(), lambda i: (i, 1, 2))):
        scalar, vector = vtk.vtkFloatArray(), vtk.vtkDoubleArray()
        scalar.SetName("pressure")
        vector.SetName("velocity")
        vector.SetNumberOfComponents(3)
        for i in range(count):
            scalar.InsertNextValue(place(i)[0] + 0.5)
            vector.InsertNextTuple3(*place(i))
        attributes.SetScalars(scalar)
        attributes.AddArray(vector)
    return data


def mesh(polyhedron=True):
    """A hexahedron, and beside it a tetrahedron, a wedge and maybe a polyhedron."""
    grid = vtk.vtkUnstructuredGrid()
    points = vtk.vtkPoints()
    for i in range(8):
        points.InsertNextPoint(i & 1, i >> 1 & 1, i >> 2)
    for point in ((2, 0, 0), (2, 1, 0), (2, 0, 1), (3, 1, 1)):
        points.InsertNextPoint(point)
    grid.SetPoints(points)
    for kind, ids in ((vtk.VTK_VOXEL, range(8)), (vtk.VTK_TETRA, (1, 8, 3, 5)), (vtk.VTK_WEDGE, (1, 8, 5, 3, 9, 7))):
        grid.InsertNextCell(kind, len(ids), list(ids))
    faces = vtk.vtkIdList()
    if not polyhedron:
        return add_arrays(grid)
    for value in (4, 3, 8, 9, 10, 3, 8, 9, 11, 3, 9, 10, 11, 3, 8, 10, 11):
        faces.InsertNextId(value)
    grid.InsertNextCell(vtk.VTK_POLYHEDRON, faces)
    return add_arrays(grid)


def image():
    data = vtk.vtkImageData()
    data.SetDimensions(3, 3, 3)
    data.SetSpacing(0.5, 1, 2)
    return add_arrays(data)


def lattice():
    grid = vtk.vtkRectilinearGrid()
    grid.SetDimensions(3, 3, 3)
    for put in (grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates):
        places = vtk.vtkDoubleArray()
        for x in (0, 0.5, 2):
            places.InsertNextValue(x)
        put(places)
    return add_arrays(grid)


def curvilinear():
    grid = vtk.vtkStructuredGrid()
    grid.SetDimensions(2, 2, 3)
    points = vtk.vtkPoints()
    for i in range(12):
        points.InsertNextPoint(i & 1, i >> 1 & 1, (i >> 2) * 1.5)
    grid.SetPoints(points)
    return add_arrays(grid)


def blocks(kind, count=2):
    tree = vtk.vtkMultiBlockDataSet()
    for i in range(count):
        tree.SetBlock(i, kind())
    return tree


def write(folder, name, writer, data, **options):
    writer.SetFileName(str(folder / name))
    writer.SetInputData(data)
    for option, value in options.items():
        getattr(writer, option)(*value)
    writer.Write()
    return folder / name


def xml(writer_of, data, **modes):
    """(name of the mode, writer's options): text, base64 and appended bytes, deflated or not."""
    return [(name, writer_of(), data, options) for name, options in {
        "ascii": {"SetDataModeToAscii": ()},
        "binary": {"SetDataModeToBinary": (), "SetCompressorTypeToNone": ()},
        "appended": {"SetDataModeToAppended": (), "EncodeAppendedDataOff": ()},
    }.items() if name in modes.get("only", ("ascii", "binary", "appended"))]


def preset():
    return json.dumps([{"Name": "seed", "ColorSpace": "RGB", "RGBPoints": [0, 1, 0, 0, 1, 0, 0.5, 1],
                        "Points": [0, 0, 0.5, 0, 1, 0.8, 0.5, 0], "NanColor": [0, 0, 0]}])


def write_seeds(folder, session):
    """{kind: path of its seed}, each in a folder of its own beside the files that it names. session: text of one."""
    seeds = {}

    def place(kind):
        (folder / kind).mkdir(parents=True)
        return folder / kind

    def add(kind, name, text):
        path = place(kind) / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        seeds[kind] = path

    for ending, writer, data in (("vtu", vtk.vtkXMLUnstructuredGridWriter, mesh()),
                                 ("vti", vtk.vtkXMLImageDataWriter, image()),
                                 ("vtr", vtk.vtkXMLRectilinearGridWriter, lattice()),
                                 ("vts", vtk.vtkXMLStructuredGridWriter, curvilinear())):
        for mode, made, content, options in xml(writer, data):
            kind = f"{ending}-{mode}"
            seeds[kind] = write(place(kind), f"seed.{ending}", made, content, **options)
    for kind, writer, data in (("vtk-mesh", vtk.vtkUnstructuredGridWriter, mesh()),
                               ("vtk-image", vtk.vtkStructuredPointsWriter, image()),
                               ("vtk-lattice", vtk.vtkRectilinearGridWriter, lattice())):
        for mode, option in (("ascii", "SetFileTypeToASCII"), ("binary", "SetFileTypeToBinary")):
            seeds[f"{kind}-{mode}"] = write(place(f"{kind}-{mode}"), "seed.vtk", writer(), data, **{option: ()})
    seeds["pvtu"] = write(place("pvtu"), "seed.pvtu", vtk.vtkXMLPUnstructuredGridWriter(), mesh())
    seeds["pvti"] = write(place("pvti"), "seed.pvti", vtk.vtkXMLPImageDataWriter(), image())
    seeds["vtm"] = write(place("vtm"), "seed.vtm", vtk.vtkXMLMultiBlockDataWriter(), blocks(image))
    collection = vtk.vtkPartitionedDataSetCollection()
    collection.SetPartition(0, 0, mesh())
    seeds["vtpc"] = write(place("vtpc"), "seed.vtpc", vtk.vtkXMLPartitionedDataSetCollectionWriter(), collection)
    leaves, levels = vtk.vtkRandomHyperTreeGridSource(), vtk.vtkAMRGaussianPulseSource()
    leaves.SetDimensions(2, 3, 2)
    levels.SetDimension(3)
    for kind, writer, source in (("htg", vtk.vtkXMLHyperTreeGridWriter, leaves),
                                 ("vthb", vtk.vtkXMLUniformGridAMRWriter, levels)):
        source.Update()
        # Of compressed coordinates VTK's reader of trees takes gigabytes: see Documentation/Limits.md.
        seeds[kind] = write(place(kind), f"seed.{kind}", writer(), source.GetOutputDataObject(0),
                            SetCompressorTypeToNone=())
    add("p3d", "seed.p3d", '{"filenames": [{"time": 0.5, "xyz": "a.xyz", "q": "a.q"}]}')
    corners = [i >> axis & 1 for axis in range(3) for i in range(8)]
    (folder / "p3d" / "a.xyz").write_bytes(struct.pack("<3i24f", 2, 2, 2, *corners))
    (folder / "p3d" / "a.q").write_bytes(struct.pack("<3i44f", 2, 2, 2, *range(44)))
    for kind in ("pvd", "series"):
        write(place(kind), "a.vti", vtk.vtkXMLImageDataWriter(), image())
        write(folder / kind, "b.vtu", vtk.vtkXMLUnstructuredGridWriter(), mesh())
        seeds[kind] = folder / kind / f"seed.{kind}"
    seeds["pvd"].write_text('<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1"><Collection>'
                            '<DataSet timestep="0" part="0" file="a.vti"/><DataSet timestep="1.5" part="0" file="b.vtu"/>'
                            "</Collection></VTKFile>\n")
    seeds["series"].write_text('{"file-series-version": "1.0", "files": [{"name": "a.vti", "time": 0.0}, '
                               '{"name": "b.vtu", "time": 1.5}]}\n')
    seeds["exodus"] = write(place("exodus"), "seed.ex2", vtk.vtkExodusIIWriter(), mesh(polyhedron=False))
    seeds["metaimage"] = write(place("metaimage"), "seed.mha", vtk.vtkMetaImageWriter(), image(), SetCompression=(False,))
    seeds["metaimage-deflated"] = write(place("metaimage-deflated"), "seed.mha", vtk.vtkMetaImageWriter(), image())
    head = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 3 3 3\nspace: RAS\nspace directions: (1,0,0) (0,1,0) (0,0,2)\n"
    add("nrrd", "seed.nrrd", (head + "encoding: raw\nendian: little\n\n").encode() + bytes(range(27)))
    add("nrrd-text", "seed.nrrd", head + "encoding: ascii\n\n" + " ".join(map(str, range(27))))
    add("nhdr", "seed.nhdr", head + "encoding: raw\nline skip: 1\nbyte skip: 2\ndata file: values.bin\n")
    (folder / "nhdr" / "values.bin").write_bytes(b"line\n12" + bytes(range(27)))
    add("raw", "seed_3x3x3_uint16.raw", bytes(range(54)))
    for kind in ("adf", "hdf5"):
        add(f"cgns-{kind}", "seed.cgns", (HERE / "Seeds" / f"{kind}.cgns").read_bytes())
    add("preset", "preset.json", preset())
    add("session", "session.json", session)
    return seeds


def copy_seeds(seeds, folder):
    for kind, path in seeds.items():
        shutil.copytree(path.parent, folder / kind)
