// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/BlockArrays.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

vtkIdType countCells(const SharedBlocks& blocks)
{
  vtkIdType count = 0;
  for (vtkDataSet* block : blocks.Data)
  {
    count += block->GetNumberOfCells();
  }
  return count;
}

bool hasFloatPoints(vtkDataSet* block)
{
  auto* set = vtkPointSet::SafeDownCast(block);
  return set && set->GetPoints() && set->GetPoints()->GetDataType() == VTK_FLOAT;
}

vtkUnsignedCharArray* ghostsOf(vtkDataSetAttributes* data)
{
  return vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkDataSetAttributes::GhostArrayName()));
}

vtkIdType firstRepeated(const SharedBlocks& blocks)
{
  return blocks.Count - static_cast<vtkIdType>(blocks.Places.size());
}

void rename(vtkIdList* ids, const BlockPoints& points)
{
  for (vtkIdType& id : *ids)
  {
    id = points.Joined[static_cast<std::size_t>(id)];
  }
}

// The stream contains the number of faces, then for each its number of points and the points.
void renameStream(vtkIdList* stream, const BlockPoints& points)
{
  vtkIdType at = 1;
  while (at < stream->GetNumberOfIds())
  {
    for (vtkIdType corners = stream->GetId(at++); corners > 0; --corners, ++at)
    {
      stream->SetId(at, points.Joined[static_cast<std::size_t>(stream->GetId(at))]);
    }
  }
}

// The common type of all blocks, or double precision.
vtkSmartPointer<vtkDataArray> makeValues(const std::vector<vtkDataArray*>& arrays, vtkIdType tuples)
{
  vtkDataArray* like = arrays.front();
  const bool alike = std::all_of(arrays.begin(), arrays.end(),
    [like](vtkDataArray* array) { return array->GetDataType() == like->GetDataType(); });
  auto values = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(alike ? like->GetDataType() : VTK_DOUBLE));
  values->SetName(like->GetName());
  values->SetNumberOfComponents(like->GetNumberOfComponents());
  values->SetNumberOfTuples(tuples);
  return values;
}

// vtkDataArray::SetTuple() takes tuples of its own type alone.
void copyTuple(vtkDataArray* from, vtkIdType tuple, vtkDataArray* to, vtkIdType at)
{
  if (from->GetDataType() == to->GetDataType())
  {
    to->SetTuple(at, tuple, from);
    return;
  }
  for (int c = 0; c < to->GetNumberOfComponents(); ++c)
  {
    to->SetComponent(at, c, from->GetComponent(tuple, c));
  }
}

vtkSmartPointer<vtkUnsignedCharArray> makeGhosts(vtkIdType tuples, unsigned char value)
{
  auto ghosts = vtkSmartPointer<vtkUnsignedCharArray>::New();
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(tuples);
  std::fill_n(ghosts->GetPointer(0), tuples, value);
  return ghosts;
}

} // namespace

vtkSmartPointer<vtkPoints> joinPoints(const SharedBlocks& blocks)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(
    std::all_of(blocks.Data.begin(), blocks.Data.end(), hasFloatPoints) ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(blocks.Count);
  for (std::size_t b = 0; b < blocks.Data.size(); ++b)
  {
    for (const vtkIdType p : blocks.Points[b].Own)
    {
      double x[3];
      blocks.Data[b]->GetPoint(p, x);
      points->SetPoint(blocks.Points[b].Joined[static_cast<std::size_t>(p)], x);
    }
  }
  // Points that are shared by their ids may differ in their positions.
  for (std::size_t i = 0; i < blocks.Places.size(); ++i)
  {
    double x[3];
    points->GetPoint(blocks.Places[i], x);
    points->SetPoint(firstRepeated(blocks) + static_cast<vtkIdType>(i), x);
  }
  return points;
}

void joinCells(const SharedBlocks& blocks, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIdList> faces;
  grid->AllocateEstimate(countCells(blocks), 4);
  for (std::size_t b = 0; b < blocks.Data.size(); ++b)
  {
    vtkDataSet* block = blocks.Data[b];
    for (vtkIdType cell = 0; cell < block->GetNumberOfCells(); ++cell)
    {
      const bool refined =
        !blocks.Refined.empty() && blocks.Refined[b][static_cast<std::size_t>(cell)];
      const int type = refined ? VTK_EMPTY_CELL : block->GetCellType(cell);
      block->GetCellPoints(cell, ids);
      rename(ids, blocks.Points[b]);
      if (type == VTK_POLYHEDRON)
      {
        vtkUnstructuredGrid::SafeDownCast(block)->GetFaceStream(cell, faces);
        renameStream(faces, blocks.Points[b]);
        grid->InsertNextCell(
          type, ids->GetNumberOfIds(), ids->GetPointer(0), faces->GetId(0), faces->GetPointer(1));
      }
      else
      {
        grid->InsertNextCell(type, ids);
      }
    }
  }
}

vtkSmartPointer<vtkDataArray> joinPointValues(
  const SharedBlocks& blocks, const std::vector<vtkDataArray*>& arrays)
{
  auto values = makeValues(arrays, blocks.Count);
  for (std::size_t b = 0; b < blocks.Data.size(); ++b)
  {
    for (const vtkIdType p : blocks.Points[b].Own)
    {
      copyTuple(arrays[b], p, values, blocks.Points[b].Joined[static_cast<std::size_t>(p)]);
    }
  }
  return values;
}

bool valuesDiffer(
  const SharedBlocks& blocks, const std::vector<vtkDataArray*>& arrays, vtkDataArray* values)
{
  for (std::size_t b = 0; b < blocks.Data.size(); ++b)
  {
    for (const vtkIdType p : blocks.Points[b].Shared)
    {
      const vtkIdType joined = blocks.Points[b].Joined[static_cast<std::size_t>(p)];
      for (int k = 0; k < values->GetNumberOfComponents(); ++k)
      {
        const double own = arrays[b]->GetComponent(p, k);
        const double other = values->GetComponent(joined, k);
        if (own != other && !(std::isnan(own) && std::isnan(other)))
        {
          return true;
        }
      }
    }
  }
  return false;
}

vtkSmartPointer<vtkDataArray> joinCellValues(
  const SharedBlocks& blocks, const std::vector<vtkDataArray*>& arrays)
{
  auto values = makeValues(arrays, countCells(blocks));
  vtkIdType next = 0;
  for (std::size_t b = 0; b < blocks.Data.size(); ++b)
  {
    for (vtkIdType cell = 0; cell < blocks.Data[b]->GetNumberOfCells(); ++cell, ++next)
    {
      copyTuple(arrays[b], cell, values, next);
    }
  }
  return values;
}

vtkSmartPointer<vtkUnsignedCharArray> joinPointGhosts(const SharedBlocks& blocks)
{
  vtkSmartPointer<vtkUnsignedCharArray> joined;
  for (std::size_t b = 0; b < blocks.Data.size(); ++b)
  {
    if (ghostsOf(blocks.Data[b]->GetPointData()))
    {
      joined = makeGhosts(blocks.Count, 0xff);
    }
  }
  for (std::size_t b = 0; joined && b < blocks.Data.size(); ++b)
  {
    vtkUnsignedCharArray* ghosts = ghostsOf(blocks.Data[b]->GetPointData());
    const vtkIdType known = ghosts ? ghosts->GetNumberOfTuples() : 0;
    for (vtkIdType p = 0; p < blocks.Data[b]->GetNumberOfPoints(); ++p)
    {
      const vtkIdType joinedPoint = blocks.Points[b].Joined[static_cast<std::size_t>(p)];
      const vtkIdType repeated = joinedPoint - firstRepeated(blocks);
      const vtkIdType point =
        repeated < 0 ? joinedPoint : blocks.Places[static_cast<std::size_t>(repeated)];
      joined->SetValue(point, static_cast<unsigned char>(
                                joined->GetValue(point) & (p < known ? ghosts->GetValue(p) : 0)));
    }
  }
  for (std::size_t i = 0; joined && i < blocks.Places.size(); ++i)
  {
    joined->SetValue(
      firstRepeated(blocks) + static_cast<vtkIdType>(i), joined->GetValue(blocks.Places[i]));
  }
  return joined;
}

vtkSmartPointer<vtkUnsignedCharArray> joinCellGhosts(const SharedBlocks& blocks)
{
  vtkSmartPointer<vtkUnsignedCharArray> joined;
  vtkIdType next = 0;
  for (vtkDataSet* block : blocks.Data)
  {
    const vtkIdType count = block->GetNumberOfCells();
    if (vtkUnsignedCharArray* ghosts = ghostsOf(block->GetCellData()))
    {
      joined = joined ? joined : makeGhosts(countCells(blocks), 0);
      std::copy_n(ghosts->GetPointer(0), std::min(count, ghosts->GetNumberOfTuples()),
        joined->GetPointer(next));
    }
    next += count;
  }
  return joined;
}

} // namespace tetmarch
