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
  /** With settings of its own. */
  explicit SettingsLink(vtkObject* owner);
  ~SettingsLink();
  SettingsLink(const SettingsLink&) = delete;
  SettingsLink& operator=(const SettingsLink&) = delete;

  /** Null: new settings with the default values. */
  void set(vtkTetMarchSettings* settings);
  /** Never null. */
  vtkTetMarchSettings* get() const { return this->Settings; }

private:
  void attach(vtkTetMarchSettings* settings);

  vtkObject* Owner;
  vtkSmartPointer<vtkTetMarchSettings> Settings;
  unsigned long Observer = 0;
};

} // namespace tetmarch

#endif
