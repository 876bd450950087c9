// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/SettingsLink.h"

#include "vtkCommand.h"

namespace tetmarch
{

SettingsLink::SettingsLink(vtkObject* owner, int opacityLaw)
  : Owner(owner)
  , OpacityLaw(opacityLaw)
{
  this->attach(this->makeSettings());
}

SettingsLink::~SettingsLink() { this->Settings->RemoveObserver(this->Observer); }

void SettingsLink::set(vtkTetMarchSettings* settings)
{
  if (settings == this->Settings)
  {
    return;
  }
  this->Settings->RemoveObserver(this->Observer);
  this->attach(settings ? settings : this->makeSettings().Get());
  this->Owner->Modified();
}

vtkSmartPointer<vtkTetMarchSettings> SettingsLink::makeSettings() const
{
  auto settings = vtkSmartPointer<vtkTetMarchSettings>::New();
  settings->SetOpacityLaw(this->OpacityLaw);
  return settings;
}

void SettingsLink::attach(vtkTetMarchSettings* settings)
{
  this->Settings = settings;
  this->Observer =
    settings->AddObserver(vtkCommand::ModifiedEvent, this->Owner, &vtkObject::Modified);
}

} // namespace tetmarch
