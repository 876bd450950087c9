// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AdaptiveData.h"

#include "ErrorText.h"
#include "Failure.h"

#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridToUnstructuredGrid.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkTetMarchDualGrid.h"
#include "vtkUniformGridAMR.h"

namespace
{
vtkSmartPointer<vtkDataObject> GetResult(vtkAlgorithm* filter, vtkDataObject* data)
{
  const tetmarch::ErrorText error(filter);
  filter->SetInputDataObject(data);
  filter->Update();
  if (!error.Get().empty())
  {
    throw tetmarch::Failure(error.Get());
  }
  return filter->GetOutputDataObject(0);
}
} // namespace

namespace tetmarch
{

bool IsAdaptive(vtkDataObject* data)
{
  return vtkUniformGridAMR::SafeDownCast(data) || vtkHyperTreeGrid::SafeDownCast(data);
}

vtkSmartPointer<vtkDataObject> ConvertAdaptive(vtkDataObject* data, bool continuous)
{
  if (IsAdaptive(data) && continuous)
  {
    return GetResult(vtkNew<vtkTetMarchDualGrid>(), data);
  }
  if (vtkHyperTreeGrid::SafeDownCast(data))
  {
    return GetResult(vtkNew<vtkHyperTreeGridToUnstructuredGrid>(), data);
  }
  if (auto* tree = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < tree->GetNumberOfBlocks(); ++i)
    {
      if (vtkDataObject* block = tree->GetBlock(i))
      {
        tree->SetBlock(i, ConvertAdaptive(block, continuous));
      }
    }
  }
  return data;
}

} // namespace tetmarch
