// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/SettingsLink.h"

#include "vtkCommand.h"
#include "vtkNew.h"

namespace tetmarch
{

SettingsLink::SettingsLink(vtkObject* owner)
  : Owner(owner)
{
  this->attach(vtkNew<vtkTetMarchSettings>());
}

SettingsLink::~SettingsLink() { this->Settings->RemoveObserver(this->Observer); }

void SettingsLink::set(vtkTetMarchSettings* settings)
{
  if (settings == this->Settings)
  {
    return;
  }
  this->Settings->RemoveObserver(this->Observer);
  this->attach(settings ? settings : vtkNew<vtkTetMarchSettings>().Get());
  this->Owner->Modified();
}

void SettingsLink::attach(vtkTetMarchSettings* settings)
{
  this->Settings = settings;
  this->Observer =
    settings->AddObserver(vtkCommand::ModifiedEvent, this->Owner, &vtkObject::Modified);
}

} // namespace tetmarch
