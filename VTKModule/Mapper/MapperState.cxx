// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/MapperState.h"

#include "Diagnostics/ViewColors.h"
#include "GL/Pipeline.h"
#include "Mapper/FrameOptions.h"

namespace tetmarch
{

MapperState::MapperState(vtkObject* mapper)
  : Settings(mapper)
{
  setViewColors(this->ViewTable);
}

void MapperState::begin(bool selecting)
{
  if (selecting)
  {
    this->Level = this->Accuracy.used().level();
  }
  else
  {
    this->Level = this->Accuracy.begin(accuracyOptionsOf(this->Settings.get()));
    this->Statistics->Clear();
  }
}

void MapperState::begin(Pipeline& pipeline, bool selecting) const
{
  const auto mostBytes = static_cast<std::uint64_t>(this->Settings.get()->GetMaxMemoryInBytes());
  selecting ? pipeline.beginPick(mostBytes) : pipeline.begin(mostBytes);
}

} // namespace tetmarch
