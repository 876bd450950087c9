// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/MapperOptions.h"

#include "vtkAbstractMapper.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"

namespace tetmarch
{

FoundScalars findScalars(vtkDataSet* data, const ScalarSelection& selection)
{
  int place = 0; // 0: points, 1: cells, 2: field data
  vtkDataArray* array = vtkAbstractMapper::GetScalars(
    data, selection.Mode, selection.AccessMode, selection.Id, selection.Name, place);
  const bool usable = array && place != 2 && array->GetNumberOfComponents() >= 1;
  return usable ? FoundScalars{ array, place == 1 } : FoundScalars();
}

} // namespace tetmarch
