// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataChecking.h"

#include "ErrorText.h"
#include "Failure.h"
#include "Messages.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTetMarchFirstPicture.h"

namespace
{
void TakeOutMisfits(vtkDataSet* data, bool ofCells)
{
  vtkDataSetAttributes* arrays =
    ofCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData()) : data->GetPointData();
  const vtkIdType count = ofCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  for (int i = arrays->GetNumberOfArrays(); i-- > 0;)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != count)
    {
      tetmarch::PrintMessage(
        "warning", std::string(ofCells ? "cell" : "point") + " array '" +
                     (array->GetName() ? array->GetName() : "") + "' is left out: it has " +
                     std::to_string(array->GetNumberOfTuples()) + " tuples, but the grid has " +
                     std::to_string(count) + (ofCells ? " cells" : " points"));
      arrays->RemoveArray(i);
    }
  }
}

void TakeOutMisfits(vtkDataObject* data)
{
  if (auto* tree = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto at = vtk::TakeSmartPointer(tree->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      TakeOutMisfits(at->GetCurrentDataObject());
    }
  }
  else if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    TakeOutMisfits(set, false);
    TakeOutMisfits(set, true);
  }
}
} // namespace

namespace tetmarch
{

void CheckData(vtkDataObject* data, const std::string& path)
{
  vtkNew<vtkTetMarchFirstPicture> check;
  const ErrorText error(check);
  check->SetInputData(data);
  if (!check->CheckData())
  {
    throw Failure("'" + path + "' can't be drawn: " + error.Get());
  }
  TakeOutMisfits(data);
}

std::vector<std::string> ListFaults(vtkDataObject* data)
{
  vtkNew<vtkTetMarchFirstPicture> check;
  check->SetInputData(data);
  vtkNew<vtkStringArray> faults;
  check->ListFaults(faults);
  std::vector<std::string> list;
  for (vtkIdType i = 0; i < faults->GetNumberOfValues(); ++i)
  {
    list.push_back(faults->GetValue(i));
  }
  return list;
}

} // namespace tetmarch
