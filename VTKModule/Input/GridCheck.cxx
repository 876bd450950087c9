// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/GridCheck.h"

#include "Input/CellKind.h"
#include "Input/CellTypes.h"
#include "Input/HigherOrderCheck.h"
#include "Input/PointCheck.h"
#include "Input/PolyhedronCheck.h"
#include "Parallel/ParallelFor.h"

#include "vtkCellArray.h"
#include "vtkDataArrayRange.h"
#include "vtkPoints.h"

#include <algorithm>
#include <mutex>
#include <vector>

namespace tetmarch
{
namespace
{

std::string text(vtkIdType value) { return std::to_string(value); }

// The error of the smallest i in 0..count for which errorOf(i) is not empty. Parallel.
template <typename ErrorOf>
std::string firstError(vtkIdType count, const ErrorOf& errorOf)
{
  vtkIdType lowest = count;
  std::string error;
  std::mutex mutex;
  parallelFor(0, count,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        std::string found = errorOf(i);
        if (!found.empty())
        {
          const std::lock_guard<std::mutex> lock(mutex);
          if (i < lowest)
          {
            lowest = i;
            error = std::move(found);
          }
          return;
        }
      }
    });
  return error;
}

std::string checkSizes(vtkUnstructuredGrid* grid)
{
  const vtkIdType cells = grid->GetNumberOfCells();
  vtkPoints* points = grid->GetPoints();
  vtkDataArray* types = cellTypesOf(grid);
  if (cells < 0)
  {
    return "The offsets of the cell array are empty; they must have one value more than there are "
           "cells, the first of them 0.";
  }
  if (!points || !types)
  {
    return "The grid has " + text(cells) +
           " cells but no points or no cell types. Set them before "
           "rendering.";
  }
  if (types->GetNumberOfComponents() != 1 || types->GetNumberOfTuples() != cells)
  {
    return "The grid has " + text(cells) + " cells but " + text(types->GetNumberOfTuples()) +
           " cell types of " + text(types->GetNumberOfComponents()) +
           " components; it must have one value a cell.";
  }
  if (types->GetDataType() != VTK_UNSIGNED_CHAR)
  {
    return std::string("The cell types are values of type ") + types->GetDataTypeAsString() +
           "; they must be unsigned char.";
  }
  if (points->GetData()->GetNumberOfComponents() != 3)
  {
    return "The points have " + text(points->GetData()->GetNumberOfComponents()) +
           " components instead of 3.";
  }
  return checkCounts(cells, points->GetNumberOfPoints());
}

// A cell array as ranges of values.
template <typename Offsets, typename Connectivity>
struct CellIds
{
  const Offsets& Begins;
  const Connectivity& Ids;
  vtkIdType NumberOfPoints;

  vtkIdType sizeOf(vtkIdType cell) const { return this->Begins[cell + 1] - this->Begins[cell]; }

  std::string errorOf(vtkIdType cell) const
  {
    const vtkIdType begin = this->Begins[cell];
    const vtkIdType end = this->Begins[cell + 1];
    if (begin < 0 || end < begin || end > this->Ids.size() || (cell == 0 && begin != 0))
    {
      return "The offsets of the cell array let cell " + text(cell) + " begin at " + text(begin) +
             " and end at " + text(end) +
             "; they must begin with 0, not descend, and not go beyond the " +
             text(this->Ids.size()) + " values of the connectivity.";
    }
    for (vtkIdType i = begin; i < end; ++i)
    {
      const vtkIdType id = this->Ids[i];
      if (id < 0 || id >= this->NumberOfPoints)
      {
        return "The connectivity of cell " + text(cell) + " names point " + text(id) +
               ", but the grid has " + text(this->NumberOfPoints) +
               " points. Repair the grid's cell array.";
      }
    }
    return {};
  }
};

// The cells of one grid.
template <typename Offsets, typename Connectivity>
class CellChecker
{
public:
  CellChecker(vtkUnstructuredGrid* grid, const Offsets& offsets, const Connectivity& connectivity)
    : Cells{ offsets, connectivity, grid->GetNumberOfPoints() }
    , Types(grid)
    , Faces(grid)
    , HigherOrder(grid)
  {
  }

  std::string errorOf(vtkIdType cell) const
  {
    std::string error = this->Cells.errorOf(cell);
    if (!error.empty())
    {
      return error;
    }
    const int type = this->Types[cell];
    const CellKind& kind = this->Kinds[type];
    const vtkIdType size = this->Cells.sizeOf(cell);
    if (kind.Cut == CellCut::Tetrahedron && size == 4)
    {
      return {};
    }
    return this->errorOfKind(cell, type, kind, size);
  }

private:
  std::string errorOfKind(vtkIdType cell, int type, const CellKind& kind, vtkIdType points) const
  {
    if (kind.Cut == CellCut::Unknown)
    {
      return "The cell types say " + text(type) + " of cell " + text(cell) +
             ", which is no type of VTK. Repair the grid's cell types.";
    }
    if (points < kind.LeastPoints || points > kind.MostPoints)
    {
      return "The offsets of the cell array give cell " + text(cell) + ", a " +
             nameOfCellType(type) + ", " + text(points) + " points; it must have " +
             (kind.LeastPoints == kind.MostPoints ? "" : "at least ") + text(kind.LeastPoints) +
             ". Repair the grid's cell array.";
    }
    switch (kind.Cut)
    {
      case CellCut::Polyhedron:
        return this->Faces.errorOf(cell);
      case CellCut::ByVTK:
        return this->HigherOrder.errorOf(cell, type, points);
      default:
        return {};
    }
  }

  CellIds<Offsets, Connectivity> Cells;
  CellTypes Types;
  PolyhedronFaces Faces;
  HigherOrderArrays HigherOrder;
  const std::array<CellKind, 256>& Kinds = cellKinds();
};

struct CheckCells
{
  template <typename OffsetArray, typename ConnectivityArray>
  void operator()(OffsetArray* offsets, ConnectivityArray* connectivity, vtkUnstructuredGrid* grid)
  {
    const auto begins = vtk::DataArrayValueRange<1>(offsets);
    const auto ids = vtk::DataArrayValueRange<1>(connectivity);
    const CellChecker<decltype(begins), decltype(ids)> checker(grid, begins, ids);
    this->Error = firstError(
      grid->GetNumberOfCells(), [&checker](vtkIdType cell) { return checker.errorOf(cell); });
  }
  std::string Error;
};

std::string checkCells(vtkUnstructuredGrid* grid)
{
  vtkDataArray* offsets = grid->GetCells()->GetOffsetsArray();
  vtkDataArray* connectivity = grid->GetCells()->GetConnectivityArray();
  CheckCells check;
  if (!vtkArrayDispatch::Dispatch2ByArrayWithSameValueType<OffsetArrays,
        ConnectivityArrays>::Execute(offsets, connectivity, check, grid))
  {
    check(offsets, connectivity, grid);
  }
  if (!check.Error.empty())
  {
    return check.Error;
  }
  return PolyhedronFaces(grid).errorOfSharing(CellTypes(grid), grid->GetNumberOfCells());
}

// Only points of 3D cells are checked.
std::string checkPoints(vtkUnstructuredGrid* grid)
{
  const std::vector<char> sound = findSoundPoints(grid->GetPoints());
  if (sound.empty())
  {
    return {};
  }
  const CellTypes types(grid);
  const PolyhedronFaces faces(grid);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const CellCut cut = cellKinds()[types[cell]].Cut;
    if (cut == CellCut::Empty || cut == CellCut::LowDimensional || cut == CellCut::Unsupported)
    {
      continue;
    }
    grid->GetCells()->GetCellAtId(cell, ids);
    if (cut == CellCut::Polyhedron)
    {
      faces.addPoints(cell, ids);
    }
    const vtkIdType* wrong =
      std::find_if(ids->begin(), ids->end(), [&sound](vtkIdType id) { return !sound[id]; });
    if (wrong != ids->end())
    {
      return describeUnsoundPoint(grid->GetPoints(), *wrong, cell);
    }
  }
  return {};
}

} // namespace

std::string checkCounts(vtkIdType cells, vtkIdType points)
{
  if (cells < MostPointsOrCells && points < MostPointsOrCells)
  {
    return {};
  }
  return "The grid has " + text(cells) + " cells and " + text(points) + " points; less than " +
         text(MostPointsOrCells) + " of each can be rendered. Extract a part of it.";
}

std::string checkHexahedra(vtkCellArray* cells, vtkIdType count, vtkIdType points)
{
  if (!cells || cells->GetNumberOfCells() != count)
  {
    return "The grid has " + text(cells ? cells->GetNumberOfCells() : 0) +
           " cells, but its dimensions call for " + text(count) + ". Repair the grid's cell array.";
  }
  const auto begins = vtk::DataArrayValueRange<1>(cells->GetOffsetsArray());
  const auto ids = vtk::DataArrayValueRange<1>(cells->GetConnectivityArray());
  const CellIds<decltype(begins), decltype(ids)> checked{ begins, ids, points };
  return firstError(count,
    [&checked](vtkIdType cell)
    {
      std::string error = checked.errorOf(cell);
      return error.empty() && checked.sizeOf(cell) != 8
               ? "The offsets of the cell array give cell " + text(cell) + ", a vtkHexahedron, " +
                   text(checked.sizeOf(cell)) +
                   " points; it must have 8. Repair the grid's cell array."
               : error;
    });
}

std::string checkGrid(vtkUnstructuredGrid* grid)
{
  std::string error;
  if (grid->GetNumberOfCells() != 0)
  {
    error = checkSizes(grid);
    error = error.empty() ? checkCells(grid) : error;
    error = error.empty() ? checkPoints(grid) : error;
  }
  return error;
}

} // namespace tetmarch
