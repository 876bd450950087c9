// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/MissingScalars.h"

#include "vtkAbstractMapper.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

namespace tetmarch
{
namespace
{

std::string namesOf(vtkDataSetAttributes* data)
{
  std::string names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const char* name = data->GetArrayName(i);
    names += (i > 0 ? ", " : "") + std::string(name ? name : "(unnamed)");
  }
  return names.empty() ? std::string("none") : names;
}

} // namespace

std::string describe(const ScalarSelection& selection)
{
  const bool ofPoints = selection.Mode == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA;
  if (!ofPoints && selection.Mode != VTK_SCALAR_MODE_USE_CELL_FIELD_DATA)
  {
    return "active scalars";
  }
  const std::string array =
    selection.AccessMode == VTK_GET_ARRAY_BY_NAME
      ? "array named \"" + std::string(selection.Name ? selection.Name : "") + "\""
      : "array with the number " + std::to_string(selection.Id);
  return array + (ofPoints ? " in the point data" : " in the cell data");
}

std::string describeMissingScalars(
  vtkDataSet* data, const ScalarSelection& selection, const char* hasNo)
{
  if (selection.Mode == VTK_SCALAR_MODE_USE_FIELD_DATA)
  {
    return "Field data can't be volume rendered: set the scalar mode to point or cell data.";
  }
  return hasNo + describe(selection) +
         ", so nothing is drawn. Point arrays: " + namesOf(data->GetPointData()) +
         "; cell arrays: " + namesOf(data->GetCellData()) +
         ". Choose one with SelectScalarArray and SetScalarMode, or set active scalars; in "
         "ParaView, under Coloring.";
}

} // namespace tetmarch
