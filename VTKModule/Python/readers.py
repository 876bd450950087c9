# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads files by VTK's readers, with Python's exceptions."""
import importlib
import os

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

from . import file_lists
from .checks import checked_integer, checked_path
from .errors import VtkErrors
from .foreign import foreign_data

# Extension: (module of VTK or our own, class).
READERS = {
    ".vtu": ("vtkIOXML", "vtkXMLUnstructuredGridReader"),
    ".vti": ("vtkIOXML", "vtkXMLImageDataReader"),
    ".vtr": ("vtkIOXML", "vtkXMLRectilinearGridReader"),
    ".vts": ("vtkIOXML", "vtkXMLStructuredGridReader"),
    ".vtp": ("vtkIOXML", "vtkXMLPolyDataReader"),
    ".vtm": ("vtkIOXML", "vtkXMLMultiBlockDataReader"),
    ".vtmb": ("vtkIOXML", "vtkXMLMultiBlockDataReader"),
    ".vtpd": ("vtkIOXML", "vtkXMLPartitionedDataSetReader"),
    ".vtpc": ("vtkIOXML", "vtkXMLPartitionedDataSetCollectionReader"),
    ".vth": ("vtkIOXML", "vtkXMLUniformGridAMRReader"),
    ".vthb": ("vtkIOXML", "vtkXMLUniformGridAMRReader"),
    ".htg": ("vtkIOXML", "vtkXMLHyperTreeGridReader"),
    ".dg": ("vtkIOCellGrid", "vtkCellGridReader"),  # of VTK 9.5 and later
    ".pvtp": ("vtkIOXML", "vtkXMLPPolyDataReader"),
    ".pvtu": ("vtkIOXML", "vtkXMLPUnstructuredGridReader"),
    ".pvti": ("vtkIOXML", "vtkXMLPImageDataReader"),
    ".pvtr": ("vtkIOXML", "vtkXMLPRectilinearGridReader"),
    ".pvts": ("vtkIOXML", "vtkXMLPStructuredGridReader"),
    ".vtk": ("vtkIOLegacy", "vtkGenericDataObjectReader"),
    ".hdf": ("vtkIOHDF", "vtkHDFReader"),
    ".vtkhdf": ("vtkIOHDF", "vtkHDFReader"),
    ".ex2": ("vtkIOExodus", "vtkExodusIIReader"),
    ".exo": ("vtkIOExodus", "vtkExodusIIReader"),
    ".exoii": ("vtkIOExodus", "vtkExodusIIReader"),
    ".e": ("vtkIOExodus", "vtkExodusIIReader"),
    ".g": ("vtkIOExodus", "vtkExodusIIReader"),
    ".cgns": ("vtkIOCGNSReader", "vtkCGNSReader"),
    ".p3d": ("vtkIOParallel", "vtkPlot3DMetaReader"),
    ".case": ("vtkIOEnSight", "vtkGenericEnSightReader"),
    ".foam": ("vtkIOGeometry", "vtkOpenFOAMReader"),
    ".inp": ("vtkIOGeometry", "vtkAVSucdReader"),
    ".mha": ("vtkRenderingTetMarch", "vtkTetMarchImageReader"),
    ".mhd": ("vtkRenderingTetMarch", "vtkTetMarchImageReader"),
    ".nrrd": ("vtkRenderingTetMarch", "vtkTetMarchImageReader"),
    ".nhdr": ("vtkRenderingTetMarch", "vtkTetMarchImageReader"),
    ".nii": ("vtkIOImage", "vtkNIFTIImageReader"),
    ".stl": ("vtkIOGeometry", "vtkSTLReader"),
    ".obj": ("vtkIOGeometry", "vtkOBJReader"),
    ".ply": ("vtkIOPLY", "vtkPLYReader"),
}
SET_NAME = {"vtkGenericEnSightReader": "SetCaseFileName"}
HDF5 = b"\x89HDF\r\n\x1a\n"
BEGINNINGS = {"vtkExodusIIReader": (b"CDF", HDF5), "vtkHDFReader": (HDF5,),
              "vtkCGNSReader": (b"@(#)ADF", b"\xc0\xa8\xa3\xa9ADF", HDF5)}


def enable_all(reader):
    """Enables all arrays, since readers of some formats read none or only some by default."""
    if reader.IsA("vtkGenericDataObjectReader"):
        for kind in ("Scalars", "Vectors", "Normals", "Tensors", "ColorScalars", "TCoords", "Fields"):
            getattr(reader, f"ReadAll{kind}On")()
        return
    if reader.IsA("vtkXMLUniformGridAMRReader"):
        reader.SetMaximumLevelsToReadByDefault(0)  # all
    reader.UpdateInformation()
    if reader.IsA("vtkExodusIIReader"):
        reader.SetAllArrayStatus(reader.NODAL, 1)
        reader.SetAllArrayStatus(reader.ELEM_BLOCK, 1)
        reader.GenerateObjectIdCellArrayOff()
    elif reader.IsA("vtkCGNSReader"):
        reader.EnableAllBases()
        reader.EnableAllFamilies()
        reader.EnableAllPointArrays()
        reader.EnableAllCellArrays()
    elif reader.IsA("vtkOpenFOAMReader"):
        reader.EnableAllCellArrays()
        reader.EnableAllPointArrays()


def check_beginning(path, name):
    """Checks a file for readers whose libraries print messages, or end the process, for other kinds of files."""
    with open(path, "rb") as file:
        begin = file.read(512)
    if name in BEGINNINGS and not begin.startswith(BEGINNINGS[name]):
        raise damaged(path, "")


def make_reader(module, name):
    package = __package__ if module == "vtkRenderingTetMarch" else "vtkmodules"
    return getattr(importlib.import_module(f"{package}.{module}"), name)()


def check_path(path):
    path = checked_path(path, "path")
    if not os.path.exists(path):
        raise FileNotFoundError(f"there is no file {path!r}")
    ending = os.path.splitext(path)[1].lower()
    if ending not in READERS and ending not in file_lists.ENDINGS:
        known = ", ".join([*READERS, *file_lists.ENDINGS])
        raise ValueError(f"the ending {ending!r} of {path!r} is none that can be read: {known}")
    if os.path.isdir(path):
        raise IsADirectoryError(f"{path!r} is a folder")
    if not os.access(path, os.R_OK):
        raise PermissionError(f"{path!r} may not be read")
    return path


def open_reader(path):
    """A reader of VTK for a file, with all arrays enabled and times read."""
    path = check_path(path)
    ending = os.path.splitext(path)[1].lower()
    module, name = READERS[ending]
    try:
        reader = make_reader(module, name)
    except (ImportError, AttributeError):
        raise ValueError(f"{path!r} needs {name} of vtkmodules.{module}, which this VTK doesn't have") from None
    check_beginning(path, name)
    # vtkPlot3DMetaReader takes the root's folder for one that isn't there.
    getattr(reader, SET_NAME.get(name, "SetFileName"))(os.path.abspath(path))
    enable_all(reader)
    return reader


def times_of(reader):
    information = reader.GetOutputInformation(0)
    key = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
    return tuple(information.Get(key, i) for i in range(information.Length(key))) if information.Has(key) else ()


def damaged(path, errors):
    return ValueError(f"{os.fspath(path)!r} can't be read: {errors or 'it is damaged, or not what its ending says'}")


def time_values(path):
    """The times of a file's data, in the file's unit, as a tuple; empty if it has none. Errors as in read()."""
    if file_lists.is_list(checked_path(path, "path")):
        return file_lists.steps_of(check_path(path))[0]
    with VtkErrors() as errors:
        reader = open_reader(path)
        reader.UpdateInformation()
        times = times_of(reader)
    if errors:
        raise damaged(path, errors)
    return times


def check_step(path, times, time_step):
    if time_step is not None and not -len(times) <= checked_integer(time_step, "time_step") < len(times):
        raise IndexError(f"there is no time step {time_step} in {os.fspath(path)!r}: "
                         + (f"it has {len(times)}, from 0" if times else "it has no time steps"))


def read_list(path, time_step):
    """One time step of a list of files: files of the same time are blocks."""
    times, steps = file_lists.steps_of(check_path(path))
    check_step(path, times, time_step)
    files = steps[-1 if time_step is None else time_step]
    for _, file in files:
        if not os.path.exists(file):
            raise FileNotFoundError(f"{os.fspath(path)!r} lists {file!r}, which isn't there")
    if len(files) == 1:
        return read(files[0][1])
    tree = vtkMultiBlockDataSet()
    for number, (name, file) in enumerate(files):
        tree.SetBlock(number, read(file))
        if name:
            tree.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), name)
    return tree


def read_foreign(data, time_step):
    """Data of VTK of what is in memory."""
    found = foreign_data(data, "path")
    if found is None:
        raise TypeError("path is the path of a file, a NumPy array, an xarray.DataArray or a meshio.Mesh, not "
                        f"{data!r}")
    if time_step is not None:
        raise TypeError(f"time_step is of files, not of a {type(data).__name__}, which was given as path")
    return found


def read(path, time_step=None):
    """The data of a file, by VTK's reader for its extension: a vtkDataSet, or a tree of such blocks.

    path: that of the file. Instead of it, a NumPy array, an xarray.DataArray or a meshio.Mesh is converted to VTK's
        data, as volume() does.
    time_step: index into time_values(), from 0, or from the end if negative; None: the last. The whole file is read,
    with all arrays.

    VTK's XML files (.vtu, .vti, .vtr, .vts, .vtp, .vtm, .vtpd, .vtpc, .vthb, .htg, .pvtu, .pvti, ...), .vtk, .vtkhdf;
    Exodus (.ex2, .exo, .e, .g), CGNS, PLOT3D (.p3d), EnSight (.case), OpenFOAM (.foam), AVS (.inp); images: MetaImage
    (.mha, .mhd), NRRD, NIfTI; surfaces: .stl, .obj, .ply. Lists of such files by time: ParaView's .pvd and .series.

    Raises FileNotFoundError, IsADirectoryError, PermissionError; ValueError for an unknown extension and a file that
    can't be read, with VTK's message; IndexError for an invalid time step.
    """
    if not isinstance(path, (str, bytes, os.PathLike)):
        return read_foreign(path, time_step)
    if file_lists.is_list(path):
        return read_list(path, time_step)
    with VtkErrors() as errors:
        reader = open_reader(path)
        reader.UpdateInformation()
        times = times_of(reader)
        check_step(path, times, time_step)
        if times:
            reader.UpdateTimeStep(times[-1 if time_step is None else time_step])
        else:
            reader.Update()
        data = reader.GetOutputDataObject(0)
        # Some readers only warn of a truncated file, and VTK 9.6's as it mixes up the time steps of a .vtu.
        errors.texts += [text for text in errors.warnings if reader.IsA("vtkImageReader2") or text.startswith("Error")
                         or (times and "already exists" in text)]
    if errors or data is None or reader.GetErrorCode():
        raise damaged(path, errors)
    return data
