// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A renderer that allocates next to no time to its props, whatever the window's update rate
 */
#ifndef tetmarch_testing_ScarceTime_h
#define tetmarch_testing_ScarceTime_h

#include "vtkCuller.h"
#include "vtkCullerCollection.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

namespace tetmarch::testing
{
/// The renderer shares its time among props by their parts of the sum that a culler returns.
class ScarceTime : public vtkCuller
{
public:
  static ScarceTime* New() { VTK_STANDARD_NEW_BODY(ScarceTime); }
  vtkTypeMacro(ScarceTime, vtkCuller);
  double Cull(vtkRenderer*, vtkProp**, int&, int&) override { return 1e30; }
};

inline void makeTimeScarce(vtkRenderer* renderer)
{
  renderer->GetCullers()->RemoveAllItems();
  renderer->AddCuller(vtkNew<ScarceTime>());
}
} // namespace tetmarch::testing

#endif
