// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picking/SelectionPoints.h"

#include "vtkCommand.h"
#include "vtkHardwareSelector.h"

namespace tetmarch
{

const std::vector<PickedPoint>* SelectionPoints::find(
  vtkHardwareSelector* selector, const Fingerprint& madeFrom) const
{
  const bool later = selector->GetCurrentPass() != vtkHardwareSelector::ACTOR_PASS;
  return later && this->Selector == selector && this->MadeFrom == madeFrom ? &this->Points
                                                                           : nullptr;
}

void SelectionPoints::keep(
  vtkHardwareSelector* selector, Fingerprint madeFrom, std::vector<PickedPoint> points)
{
  this->clear();
  this->Selector = selector;
  this->Observer = selector->AddObserver(vtkCommand::EndEvent, this, &SelectionPoints::clear);
  this->MadeFrom = std::move(madeFrom);
  this->Points = std::move(points);
}

void SelectionPoints::clear()
{
  if (this->Selector)
  {
    this->Selector->RemoveObserver(this->Observer);
  }
  this->Selector = nullptr;
  this->MadeFrom.clear();
  this->Points = {};
}

} // namespace tetmarch
