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
#include "vtkPoints.h"

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
    append->AddInputData(block);
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
