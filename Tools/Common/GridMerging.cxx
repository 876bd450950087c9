// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GridMerging.h"

#include "Failure.h"
#include "Messages.h"
#include "ProgressBar.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkTetMarchFirstPicture.h"

#include <cmath>
#include <map>
#include <set>
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

vtkDataSetAttributes* GetAttributes(vtkDataSet* block, bool cells)
{
  return cells ? static_cast<vtkDataSetAttributes*>(block->GetCellData()) : block->GetPointData();
}

/// The number of blocks that contain an array, and its types.
struct ArrayCount
{
  std::size_t Blocks = 0;
  std::set<int> Types;
};

/// By name and number of components.
std::map<std::pair<std::string, int>, ArrayCount> CountArrays(
  const std::vector<vtkDataSet*>& blocks, bool cells)
{
  std::map<std::pair<std::string, int>, ArrayCount> counts;
  for (vtkDataSet* block : blocks)
  {
    vtkDataSetAttributes* arrays = GetAttributes(block, cells);
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = arrays->GetAbstractArray(i);
      const char* name = array->GetName();
      ArrayCount& count = counts[{ name ? name : "", array->GetNumberOfComponents() }];
      ++count.Blocks;
      count.Types.insert(array->GetDataType());
    }
  }
  return counts;
}

/// vtkAppendFilter keeps arrays of one type. The block itself stays as it is.
vtkSmartPointer<vtkDataSet> WithDoubles(
  vtkDataSet* block, bool cells, const std::vector<std::string>& names)
{
  auto copy = vtk::TakeSmartPointer(block->NewInstance());
  copy->ShallowCopy(block);
  for (const std::string& name : names)
  {
    if (vtkDataArray* array = GetAttributes(block, cells)->GetArray(name.c_str()))
    {
      vtkNew<vtkDoubleArray> doubles;
      doubles->DeepCopy(array);
      doubles->SetName(name.c_str());
      GetAttributes(copy, cells)->AddArray(doubles);
    }
  }
  return copy;
}

std::vector<vtkSmartPointer<vtkDataSet>> WithEqualTypes(const std::vector<vtkDataSet*>& blocks)
{
  std::vector<vtkSmartPointer<vtkDataSet>> equal(blocks.begin(), blocks.end());
  for (const bool cells : { false, true })
  {
    std::vector<std::string> names;
    for (const auto& [array, count] : CountArrays(blocks, cells))
    {
      if (count.Blocks == blocks.size() && count.Types.size() > 1)
      {
        names.push_back(array.first);
      }
    }
    for (vtkSmartPointer<vtkDataSet>& block : equal)
    {
      block = names.empty() ? block : WithDoubles(block, cells, names);
    }
  }
  return equal;
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

bool HaveCommonArray(const std::vector<vtkDataSet*>& blocks, const WantedArray& wanted)
{
  for (const bool cells : { false, true })
  {
    const int association =
      cells ? vtkTetMarchFirstPicture::CELLS : vtkTetMarchFirstPicture::POINTS;
    if (wanted.Association != vtkTetMarchFirstPicture::ANY && wanted.Association != association)
    {
      continue;
    }
    for (const auto& [array, part] : CountArrays(blocks, cells))
    {
      const bool isDrawable = !array.first.empty() && part.Types.count(VTK_STRING) == 0 &&
                              array.first != vtkDataSetAttributes::GhostArrayName();
      const bool isWanted = wanted.Name.empty() || wanted.Name == array.first;
      if (isDrawable && isWanted && part.Blocks == blocks.size())
      {
        return true;
      }
    }
  }
  return false;
}

void WarnOfPartialArrays(const std::vector<vtkDataSet*>& blocks)
{
  for (const bool cells : { false, true })
  {
    for (const auto& [array, part] : CountArrays(blocks, cells))
    {
      if (part.Blocks < blocks.size())
      {
        const auto& [name, components] = array;
        PrintMessage("warning",
          std::string(cells ? "cell" : "point") + " array '" + name + "' is left out: only " +
            std::to_string(part.Blocks) + " of " + std::to_string(blocks.size()) +
            " blocks have it" +
            (components > 1 ? " with " + std::to_string(components) + " components" : ""));
      }
    }
  }
}

vtkSmartPointer<vtkUnstructuredGrid> MergeBlocks(
  const std::vector<vtkDataSet*>& blocks, const ProgressReport& report)
{
  auto append = vtkSmartPointer<vtkAppendFilter>::New();
  append->MergePointsOn();
  for (const auto& block : WithEqualTypes(blocks))
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
