// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/DataFaults.h"

#include "Blocks/BlockList.h"
#include "Input/DataCheck.h"
#include "Input/SolidCells.h"
#include "Scalars/TupleCheck.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace tetmarch
{
namespace
{

struct CheckedBlock
{
  vtkDataSet* Data;
  std::string Prefix; // of its errors
};

std::vector<CheckedBlock> checkedBlocks(vtkDataObject* data)
{
  std::vector<CheckedBlock> blocks;
  if (auto* tree = vtkCompositeDataSet::SafeDownCast(data))
  {
    for (const Block& block : listBlocks(tree, {}))
    {
      if (!isSlice(block.Data)) // left out, as polygons are
      {
        blocks.push_back({ block.Data, "Block " + block.Name + ": " });
      }
    }
  }
  else if (auto* set = vtkDataSet::SafeDownCast(data); set && !vtkPolyData::SafeDownCast(set))
  {
    blocks.push_back({ set, {} });
  }
  return blocks;
}

void addFaultsOfArrays(const CheckedBlock& block, bool ofCells, std::vector<std::string>& faults)
{
  vtkDataSetAttributes* arrays = ofCells
                                   ? static_cast<vtkDataSetAttributes*>(block.Data->GetCellData())
                                   : block.Data->GetPointData();
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    const std::string wrong = checkTuples(block.Data, arrays->GetAbstractArray(i), ofCells);
    if (!wrong.empty())
    {
      faults.push_back(block.Prefix + wrong);
    }
  }
}

} // namespace

std::string checkBlocks(vtkDataObject* data)
{
  for (const CheckedBlock& block : checkedBlocks(data))
  {
    const std::string wrong = checkData(block.Data);
    if (!wrong.empty())
    {
      return block.Prefix + wrong;
    }
  }
  return {};
}

std::vector<std::string> listFaults(vtkDataObject* data)
{
  std::vector<std::string> faults;
  for (const CheckedBlock& block : checkedBlocks(data))
  {
    const std::string wrong = checkData(block.Data);
    if (!wrong.empty())
    {
      faults.push_back(block.Prefix + wrong);
    }
    addFaultsOfArrays(block, false, faults);
    addFaultsOfArrays(block, true, faults);
  }
  return faults;
}

} // namespace tetmarch
