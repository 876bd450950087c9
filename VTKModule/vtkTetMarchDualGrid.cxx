// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchDualGrid.h"

#include "Caching/WithinMemory.h"
#include "Leaves/DualGrid.h"
#include "Leaves/LeafList.h"

#include "vtkHyperTreeGrid.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUniformGridAMR.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkTetMarchDualGrid);

void vtkTetMarchDualGrid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

int vtkTetMarchDualGrid::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUniformGridAMR");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkHyperTreeGrid");
  return 1;
}

int vtkTetMarchDualGrid::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  auto* blocks = vtkUniformGridAMR::SafeDownCast(vtkDataObject::GetData(inputVector[0]));
  auto* tree = vtkHyperTreeGrid::GetData(inputVector[0]);
  std::string error;
  const std::string shortage = tetmarch::withinMemory("the cells between leaves",
    [&]
    {
      tetmarch::Leaves leaves;
      error = blocks ? tetmarch::findLeaves(blocks, leaves) : tetmarch::findLeaves(tree, leaves);
      if (error.empty())
      {
        tetmarch::makeGrid(
          leaves, tetmarch::dualCellsOf(leaves, tetmarch::cornersOf(leaves.All)), output);
      }
    });
  error = error.empty() ? shortage : error;
  if (!error.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< error);
  }
  return 1;
}
