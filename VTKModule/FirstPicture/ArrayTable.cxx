// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/ArrayTable.h"

#include "FirstPicture/ArrayChoice.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <cmath>
#include <sstream>

namespace tetmarch
{

void listArrays(const std::vector<vtkDataSet*>& blocks, vtkTable* arrays)
{
  vtkNew<vtkStringArray> names, places, types, kinds;
  vtkNew<vtkIntArray> components;
  vtkNew<vtkDoubleArray> least, most;
  names->SetName("name");
  places->SetName("association");
  types->SetName("type");
  components->SetName("components");
  least->SetName("minimum");
  most->SetName("maximum");
  kinds->SetName("kind");
  static const char* const kindNames[] = { "values", "numbers", "constant", "not finite" };
  for (const FoundArray& found : findArrays(blocks))
  {
    names->InsertNextValue(found.Drawn.Array->GetName());
    places->InsertNextValue(found.Drawn.OfCells ? "cells" : "points");
    types->InsertNextValue(found.Drawn.Array->GetDataTypeAsString());
    components->InsertNextValue(found.Drawn.Array->GetNumberOfComponents());
    least->InsertNextValue(found.Range ? (*found.Range)[0] : std::nan(""));
    most->InsertNextValue(found.Range ? (*found.Range)[1] : std::nan(""));
    kinds->InsertNextValue(kindNames[static_cast<int>(found.Kind)]);
  }
  for (vtkAbstractArray* column : { static_cast<vtkAbstractArray*>(names),
         static_cast<vtkAbstractArray*>(places), static_cast<vtkAbstractArray*>(types),
         static_cast<vtkAbstractArray*>(components), static_cast<vtkAbstractArray*>(least),
         static_cast<vtkAbstractArray*>(most), static_cast<vtkAbstractArray*>(kinds) })
  {
    arrays->AddColumn(column);
  }
}

std::string describe(const std::vector<vtkDataSet*>& blocks, const DrawnArray& drawn)
{
  if (!drawn.Array)
  {
    return "no array";
  }
  const std::optional<std::array<double, 2>> range = rangeOf(blocks, drawn);
  std::ostringstream text;
  text << (drawn.Component < 0 ? "magnitude of " : "");
  if (drawn.Component >= 0 && drawn.Array->GetNumberOfComponents() > 1)
  {
    text << "component " << drawn.Component << " of ";
  }
  text << drawn.Array->GetName() << (drawn.OfCells ? " on cells, " : " on points, ");
  if (range)
  {
    text << (*range)[0] << " to " << (*range)[1];
  }
  else
  {
    text << "no value is finite";
  }
  return text.str();
}

} // namespace tetmarch
