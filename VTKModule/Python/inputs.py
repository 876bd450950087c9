# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts users' data to data of VTK that a mapper draws."""
import os

from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import (vtkCompositeDataSet, vtkDataObject, vtkDataSet, vtkExplicitStructuredGrid,
                                           vtkImageData, vtkNonOverlappingAMR, vtkOverlappingAMR, vtkPolyData,
                                           vtkRectilinearGrid, vtkStructuredGrid, vtkUnstructuredGrid)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput
from vtkmodules.vtkFiltersCore import vtkAppendFilter

from .foreign import foreign_data
from .readers import read
from .vtkRenderingTetMarch import vtkTetMarchFirstPicture

LATTICES = (vtkImageData, vtkRectilinearGrid)


def check_faults(data):
    """Raises an error for invalid data, which VTK's filters do not check."""
    first = vtkTetMarchFirstPicture()
    first.SetInputData(data)
    faults = vtkStringArray()
    first.ListFaults(faults)
    if faults.GetNumberOfValues() > 0:
        raise ValueError(" ".join(faults.GetValue(i) for i in range(faults.GetNumberOfValues())))


def joined(blocks):
    """The cells of several data sets as one vtkUnstructuredGrid."""
    append = vtkAppendFilter()
    append.SetOutputPointsPrecision(append.DEFAULT_PRECISION)
    for block in blocks:
        append.AddInputData(block)
    append.Update()
    return append.GetOutput()


def dimensions_of(grid):
    """The numbers of points along the dimensions of a vtkStructuredGrid, in every version of VTK."""
    found = [0, 0, 0]
    grid.GetDimensions(found)
    return found


def curvilinear(data):
    """The grid itself, or its cells as a vtkUnstructuredGrid."""
    check_faults(data)
    return data if isinstance(data, vtkStructuredGrid) and min(dimensions_of(data)) > 1 else joined([data])


def gets_a_grid(data):
    """Whether mappers make a grid of this, which is no vtkDataSet. VTK 9.1 has no vtkCellGrid."""
    return isinstance(data, vtkDataObject) and (data.IsA("vtkHyperTreeGrid") or data.IsA("vtkCellGrid"))


def leaves_of(tree):
    at = tree.NewIterator()
    at.InitTraversal()
    while not at.IsDoneWithTraversal():
        yield at.GetCurrentDataObject()
        at.GoToNextItem()


def blocks_of(tree):
    """The data sets of a tree with cells, surfaces left out."""
    for block in leaves_of(tree):
        if isinstance(block, vtkDataSet) and not isinstance(block, vtkPolyData) and block.GetNumberOfCells() > 0:
            yield block


def is_structured(data):
    """Whether the data consist of images and rectilinear grids only, and none is within another."""
    if isinstance(data, (vtkOverlappingAMR, vtkNonOverlappingAMR)):
        return False
    if isinstance(data, vtkCompositeDataSet):
        return (all(isinstance(block, LATTICES) for block in blocks_of(data))
                and not any(map(gets_a_grid, leaves_of(data))))
    return isinstance(data, LATTICES)


def vtk_data(data):
    """A vtkDataObject of `data`: itself, an algorithm's output, a file's path, an array, a meshio.Mesh, ..."""
    if isinstance(data, (str, os.PathLike)):
        return read(data)
    if isinstance(data, vtkAlgorithmOutput):
        data.GetProducer().Update(data.GetIndex())
        return data.GetProducer().GetOutputDataObject(data.GetIndex())
    if isinstance(data, vtkAlgorithm):
        data.Update()
        return data.GetOutputDataObject(0)
    if isinstance(data, vtkDataObject):
        return data
    if isinstance(getattr(data, "VTKObject", None), vtkDataObject):
        return data.VTKObject  # of vtkmodules.numpy_interface.dataset_adapter
    found = foreign_data(data)
    return data if found is None else found


def drawn_data(data):
    """Data of VTK that our mappers accept. Raises TypeError or ValueError with the remedy."""
    data = vtk_data(data)
    if isinstance(data, (vtkUnstructuredGrid, *LATTICES)):
        return data
    if isinstance(data, (vtkStructuredGrid, vtkExplicitStructuredGrid)):
        return curvilinear(data)
    if gets_a_grid(data):
        check_faults(data)
        return data
    if isinstance(data, vtkCompositeDataSet):
        if not any(True for _ in blocks_of(data)) and not any(map(gets_a_grid, leaves_of(data))):
            raise ValueError(f"the {data.GetClassName()} has no block with cells")
        return data
    if isinstance(data, vtkPolyData):
        raise TypeError("a vtkPolyData is a surface, which has no inside to draw; vtkDelaunay3D makes tetrahedra of "
                        "its points, and a vtkActor draws the surface")
    raise TypeError(f"{type(data).__name__} is no data that can be drawn: give data of VTK's or PyVista's, an "
                    "algorithm, the path of a file, a NumPy array of three dimensions, an xarray.DataArray, a "
                    "meshio.Mesh, or what from_arrays() makes")
