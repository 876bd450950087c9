// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/MapperState.h"

#include "Diagnostics/ViewColors.h"
#include "Mapper/FrameOptions.h"

namespace tetmarch
{

MapperState::MapperState(vtkObject* mapper, int opacityLaw)
  : Settings(mapper, opacityLaw)
{
  setViewColors(this->ViewTable);
}

void MapperState::begin(bool selecting)
{
  if (selecting)
  {
    this->Chosen = this->Accuracy.used();
  }
  else
  {
    this->Chosen = this->Accuracy.begin(accuracyOptionsOf(this->Settings.get()));
    this->Statistics->Clear();
  }
  this->Level = this->Chosen.level();
}

} // namespace tetmarch
