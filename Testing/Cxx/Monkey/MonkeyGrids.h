// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The data sets that the monkey test shows, each with steps of time
 */
#ifndef tetmarch_testing_MonkeyGrids_h
#define tetmarch_testing_MonkeyGrids_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <string>

namespace tetmarch::testing
{
constexpr int MonkeyDatasets = 10;
constexpr int MonkeySteps = 4;

/// The properties of a data set that the shader's variant and the errors depend on.
struct MonkeyTraits
{
  const char* Name;
  bool Convex = true;
  bool HasNan = false;
  bool HasHidden = false;
  int Components = 1; // of the scalars of points
};
const MonkeyTraits& traitsOf(int dataset);

/// A new object, as a reader makes one each time, with scalars "f" of points and "c" of cells. Of
/// other steps the scalars have another range; if moved, the points lie a little elsewhere.
vtkSmartPointer<vtkDataObject> makeMonkeyData(int dataset, int step, bool moved);
} // namespace tetmarch::testing

#endif
