// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The settings of a mapper, which other mappers may share.
#ifndef TetMarchMapperSettingsLink_h
#define TetMarchMapperSettingsLink_h

#include "vtkSmartPointer.h"
#include "vtkTetMarchSettings.h"

namespace tetmarch
{

/** A change of the settings modifies their owner. */
class SettingsLink
{
public:
  /** With settings of its own, of which the opacity law (vtkTetMarchSettings::OpacityLawType) is
   * that of the owner's kind of data. */
  SettingsLink(vtkObject* owner, int opacityLaw);
  ~SettingsLink();
  SettingsLink(const SettingsLink&) = delete;
  SettingsLink& operator=(const SettingsLink&) = delete;

  /** Null: new settings, as at the start. */
  void set(vtkTetMarchSettings* settings);
  /** Never null. */
  vtkTetMarchSettings* get() const { return this->Settings; }

private:
  void attach(vtkTetMarchSettings* settings);
  vtkSmartPointer<vtkTetMarchSettings> makeSettings() const;

  vtkObject* Owner;
  int OpacityLaw; // of new settings
  vtkSmartPointer<vtkTetMarchSettings> Settings;
  unsigned long Observer = 0;
};

} // namespace tetmarch

#endif
