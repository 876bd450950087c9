// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GridMerging.h"

#include "Failure.h"
#include "Messages.h"
#include "ProgressBar.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <cmath>
#include <map>
#include <string>

namespace
{
/// The first point of a grid with its arrays and no cell.
vtkSmartPointer<vtkUnstructuredGrid> MakeFirstPoint(vtkUnstructuredGrid* grid)
{
  auto first = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints()->GetDataType());
  points->InsertNextPoint(grid->GetPoint(0));
  first->SetPoints(points);
  first->GetPointData()->CopyAllOn();
  first->GetPointData()->CopyAllocate(grid->GetPointData(), 1);
  first->GetPointData()->CopyData(grid->GetPointData(), vtkIdType(0), vtkIdType(0));
  first->GetCellData()->CopyAllOn();
  first->GetCellData()->CopyAllocate(grid->GetCellData(), 0);
  return first;
}
bool IsSound(const double point[3])
{
  constexpr double most = 1e100; // beyond it no cell is drawn
  return std::abs(point[0]) <= most && std::abs(point[1]) <= most && std::abs(point[2]) <= most;
}

/// Points that no cell has may lie anywhere, even at infinity, but the search for equal points
/// recurses without end among them. In a copy of such a block they all lie at its first other
/// point.
vtkSmartPointer<vtkDataSet> MoveStrayPoints(vtkDataSet* block)
{
  auto* set = vtkPointSet::SafeDownCast(block);
  std::vector<vtkIdType> stray;
  vtkIdType other = -1;
  double point[3];
  for (vtkIdType i = 0; set && i < set->GetNumberOfPoints(); ++i)
  {
    set->GetPoint(i, point);
    if (!IsSound(point))
    {
      stray.push_back(i);
    }
    else if (other < 0)
    {
      other = i;
    }
  }
  if (stray.empty() || other < 0)
  {
    return block;
  }
  auto copy = vtk::TakeSmartPointer(set->NewInstance());
  copy->ShallowCopy(set);
  vtkNew<vtkPoints> points;
  points->DeepCopy(set->GetPoints());
  set->GetPoint(other, point);
  for (const vtkIdType i : stray)
  {
    points->SetPoint(i, point);
  }
  copy->SetPoints(points);
  return copy;
}
} // namespace

namespace tetmarch
{

void WarnOfPartialArrays(const std::vector<vtkDataSet*>& blocks)
{
  for (const bool cells : { false, true })
  {
    std::map<std::string, std::size_t> counts;
    for (vtkDataSet* block : blocks)
    {
      vtkDataSetAttributes* arrays =
        cells ? static_cast<vtkDataSetAttributes*>(block->GetCellData()) : block->GetPointData();
      for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
      {
        const char* name = arrays->GetArrayName(i);
        ++counts[name ? name : ""];
      }
    }
    for (const auto& [name, count] : counts)
    {
      if (count < blocks.size())
      {
        tetmarch::PrintMessage("warning",
          std::string(cells ? "cell" : "point") + " array '" + name + "' is left out: only " +
            std::to_string(count) + " of " + std::to_string(blocks.size()) + " blocks have it");
      }
    }
  }
}

vtkSmartPointer<vtkUnstructuredGrid> MergeBlocks(
  const std::vector<vtkDataSet*>& blocks, const ProgressReport& report)
{
  auto append = vtkSmartPointer<vtkAppendFilter>::New();
  append->MergePointsOn();
  for (vtkDataSet* block : blocks)
  {
    append->AddInputData(MoveStrayPoints(block));
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(blocks[0]);
  if (grid && blocks.size() == 1)
  {
    append->AddInputData(MakeFirstPoint(grid)); // one input alone would be passed through
  }
  tetmarch::ProgressBar progress("merging", append, report);
  append->Update();
  if (progress.IsStopped())
  {
    throw Cancelled("merging the blocks was cancelled");
  }
  return append->GetOutput();
}

} // namespace tetmarch
