// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A selector without a window, in a pass that the test chooses
 */
#ifndef tetmarch_testing_PassSelector_h
#define tetmarch_testing_PassSelector_h

#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"

namespace tetmarch::testing
{
class PassSelector : public vtkHardwareSelector
{
public:
  static PassSelector* New();
  vtkTypeMacro(PassSelector, vtkHardwareSelector);
  void enter(int pass) { this->CurrentPass = pass; }
  vtkIdType greatestCell() const { return this->MaximumCellId; }
  void BeginRenderProp() override { ++this->Begun; }
  void EndRenderProp() override { ++this->Ended; }
  int Begun = 0;
  int Ended = 0;

protected:
  void BeginRenderProp(vtkRenderWindow*) override {}
  void EndRenderProp(vtkRenderWindow*) override {}
};
inline vtkStandardNewMacro(PassSelector);
} // namespace tetmarch::testing

#endif
