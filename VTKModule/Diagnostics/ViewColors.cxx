// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Diagnostics/ViewColors.h"

#include "vtkColorTransferFunction.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"

namespace tetmarch
{

void setViewColors(vtkLookupTable* table)
{
  // CIE L* is 18, 38, 57, 77, 97; the darkest is distinguishable from black.
  vtkNew<vtkColorTransferFunction> colors;
  colors->SetColorSpaceToLab();
  colors->AddRGBPoint(0.0, 0.16, 0.13, 0.42);
  colors->AddRGBPoint(0.25, 0.57, 0.20, 0.52);
  colors->AddRGBPoint(0.5, 0.90, 0.37, 0.35);
  colors->AddRGBPoint(0.75, 0.98, 0.69, 0.33);
  colors->AddRGBPoint(1.0, 1.0, 0.97, 0.72);
  constexpr int count = 256;
  table->SetNumberOfTableValues(count);
  for (int i = 0; i < count; ++i)
  {
    double rgb[3];
    colors->GetColor(i / (count - 1.0), rgb);
    table->SetTableValue(i, rgb[0], rgb[1], rgb[2], 1.0);
  }
}

} // namespace tetmarch
