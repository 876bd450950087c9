// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/TreeLeafCells.h"

#include "Input/TreeCheck.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridToUnstructuredGrid.h"
#include "vtkUnstructuredGrid.h"

namespace tetmarch
{

Fingerprint versionOfTree(vtkDataObject* data)
{
  auto* tree = vtkHyperTreeGrid::SafeDownCast(data);
  Fingerprint version;
  add(version, tree);
  add(version, tree->GetCellData());
  add(version, tree->HasMask() ? tree->GetMask() : nullptr);
  add(version, tree->GetXCoordinates());
  add(version, tree->GetYCoordinates());
  add(version, tree->GetZCoordinates());
  return version;
}

std::string makeLeafCells(vtkDataObject* data, vtkSmartPointer<vtkUnstructuredGrid>& leaves)
{
  auto* tree = vtkHyperTreeGrid::SafeDownCast(data);
  std::string error = checkTree(tree);
  if (error.empty())
  {
    vtkNew<vtkHyperTreeGridToUnstructuredGrid> filter;
    filter->SetInputDataObject(tree);
    filter->Update();
    leaves = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  }
  return error;
}

} // namespace tetmarch
