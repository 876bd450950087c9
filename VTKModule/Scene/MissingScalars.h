// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What to say where the array that is to be drawn is not there.
#ifndef TetMarchSceneMissingScalars_h
#define TetMarchSceneMissingScalars_h

#include <string>

class vtkUnstructuredGrid;

namespace tetmarch
{

/** As vtkAbstractMapper has them: ScalarMode, ArrayAccessMode, ArrayId and ArrayName. */
struct ScalarSelection
{
  int Mode;
  int AccessMode;
  int Id;
  const char* Name; // may be nullptr
};

/** Which array was looked for in vain, which there are, and how to choose one. */
std::string describeMissingScalars(vtkUnstructuredGrid* grid, const ScalarSelection& selection);

} // namespace tetmarch

#endif
