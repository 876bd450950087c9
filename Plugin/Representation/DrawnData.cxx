// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DrawnData.h"

#include "CellGrids.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridToUnstructuredGrid.h"
#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkUniformGridAMR.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <tuple>

namespace tetmarch
{
namespace
{

// Null if the data is no data set, and no vtkHyperTreeGrid that is to be changed.
vtkSmartPointer<vtkDataSet> copyOfDataSet(
  vtkDataObject* data, const std::function<void(vtkDataSet*)>& change)
{
  vtkSmartPointer<vtkDataSet> copy;
  if (auto* grid = vtkDataSet::SafeDownCast(data))
  {
    copy.TakeReference(grid->NewInstance());
    copy->ShallowCopy(grid);
  }
  else if (change && vtkHyperTreeGrid::SafeDownCast(data))
  {
    vtkNew<vtkHyperTreeGridToUnstructuredGrid> leaves;
    leaves->SetInputDataObject(data);
    leaves->Update();
    copy = vtkDataSet::SafeDownCast(leaves->GetOutputDataObject(0));
  }
  if (copy && change)
  {
    change(copy);
  }
  return copy;
}

// Number of points along each axis; false if the data is no lattice of them.
bool findDimensions(vtkDataSet* data, int dimensions[3])
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(dimensions);
    return true;
  }
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    grid->GetDimensions(dimensions);
    return true;
  }
  return false;
}

// The first and the last cell along each axis of those that are not another process's; false if
// all are.
bool findOwnCells(vtkUnsignedCharArray* ghosts, const int cells[3], int first[3], int last[3])
{
  std::copy_n(cells, 3, first);
  std::fill_n(last, 3, -1);
  vtkIdType cell = 0;
  int at[3];
  for (at[2] = 0; at[2] < cells[2]; ++at[2])
  {
    for (at[1] = 0; at[1] < cells[1]; ++at[1])
    {
      for (at[0] = 0; at[0] < cells[0]; ++at[0], ++cell)
      {
        if (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL)
        {
          continue;
        }
        for (int axis = 0; axis < 3; ++axis)
        {
          first[axis] = std::min(first[axis], at[axis]);
          last[axis] = std::max(last[axis], at[axis]);
        }
      }
    }
  }
  return last[0] >= 0;
}

vtkBoundingBox boundsOfDataSet(vtkDataSet* data)
{
  vtkUnsignedCharArray* ghosts = data->GetCellGhostArray();
  int points[3];
  if (!ghosts || ghosts->GetNumberOfValues() != data->GetNumberOfCells() ||
      data->GetNumberOfCells() == 0 || !findDimensions(data, points))
  {
    const vtkBoundingBox box(data->GetBounds());
    return box.IsValid() ? box : vtkBoundingBox();
  }
  int cells[3];
  std::transform(points, points + 3, cells, [](int count) { return std::max(count - 1, 1); });
  int first[3];
  int last[3];
  vtkBoundingBox box;
  if (!findOwnCells(ghosts, cells, first, last))
  {
    return box;
  }
  for (int corner = 0; corner < 8; ++corner) // of an image whose axes may have any direction
  {
    vtkIdType point = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      const int behind = std::min(last[axis] + 1, points[axis] - 1);
      point = point * points[axis] + ((corner >> axis) & 1 ? behind : first[axis]);
    }
    box.AddPoint(data->GetPoint(point));
  }
  return box;
}

} // namespace

bool isDrawnAsMesh(vtkDataObject* data)
{
  const bool isSurface = vtkPolyData::SafeDownCast(data) != nullptr;
  return (vtkPointSet::SafeDownCast(data) && !isSurface) || vtkDataObjectTree::SafeDownCast(data) ||
         vtkUniformGridAMR::SafeDownCast(data) || vtkHyperTreeGrid::SafeDownCast(data) ||
         isCellGrid(data);
}

vtkSmartPointer<vtkDataObject> copyToDraw(vtkDataObject* input, const BlockSelection& selection,
  const std::function<void(vtkDataSet*)>& change)
{
  if (const auto copy = copyOfDataSet(input, change))
  {
    return copy;
  }
  if (vtkUniformGridAMR::SafeDownCast(input) || vtkHyperTreeGrid::SafeDownCast(input) ||
      isCellGrid(input))
  {
    auto copy = vtkSmartPointer<vtkDataObject>::Take(input->NewInstance());
    copy->ShallowCopy(input);
    return copy;
  }
  auto* tree = vtkDataObjectTree::SafeDownCast(input);
  if (!tree)
  {
    return nullptr;
  }
  auto selected = selectBlocks(tree, selection);
  const auto at = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(selected->NewTreeIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    vtkDataObject* block = at->GetCurrentDataObject();
    if (change && !isCellGrid(block))
    {
      selected->SetDataSet(at, copyOfDataSet(block, change));
    }
  }
  return selected;
}

vtkBoundingBox boundsOf(vtkDataObject* data)
{
  vtkBoundingBox box;
  if (auto* grid = vtkDataSet::SafeDownCast(data))
  {
    return boundsOfDataSet(grid);
  }
  if (auto* trees = vtkHyperTreeGrid::SafeDownCast(data))
  {
    const double* bounds = trees->GetBounds();
    return bounds ? vtkBoundingBox(bounds) : box;
  }
  if (isCellGrid(data))
  {
    return boundsOfCellGrid(data);
  }
  if (auto* tree = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(tree->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      box.AddBox(boundsOf(at->GetCurrentDataObject()));
    }
  }
  return box;
}

vtkBoundingBox boundsOfAll(const vtkBoundingBox& box)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() < 2)
  {
    return box;
  }
  double low[3];
  double high[3];
  box.GetMinPoint(low[0], low[1], low[2]);
  box.GetMaxPoint(high[0], high[1], high[2]);
  double lowest[3];
  double highest[3];
  controller->AllReduce(low, lowest, 3, vtkCommunicator::MIN_OP);
  controller->AllReduce(high, highest, 3, vtkCommunicator::MAX_OP);
  return vtkBoundingBox(lowest[0], highest[0], lowest[1], highest[1], lowest[2], highest[2]);
}

std::array<double, 6> croppingPlanes(
  const vtkBoundingBox& box, const double origin[3], const double scale[3])
{
  std::array<double, 6> planes{};
  for (int axis = 0; axis < 3; ++axis)
  {
    std::tie(planes[2 * axis], planes[2 * axis + 1]) =
      std::minmax({ origin[axis] + scale[axis] * box.GetBound(2 * axis),
        origin[axis] + scale[axis] * box.GetBound(2 * axis + 1) });
  }
  return planes;
}

} // namespace tetmarch
