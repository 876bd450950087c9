// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SwissCheese.h"

#include "Grids.h"

#include "vtkNew.h"
#include "vtkThreshold.h"

namespace tetmarch::testing
{
Grid swissCheese(int n, int frequency)
{
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputData(jitteredLattice(n, 0.15, 1, noiseField(1, frequency)));
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "f");
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  threshold->SetUpperThreshold(0.4);
  threshold->AllScalarsOn();
  threshold->Update();
  return threshold->GetOutput();
}
} // namespace tetmarch::testing
