// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The error message for an array that is not there.
#ifndef TetMarchBlocksMissingScalars_h
#define TetMarchBlocksMissingScalars_h

#include <string>

class vtkDataSet;

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

/** Describes the array that is looked for. */
std::string describe(const ScalarSelection& selection);

/** Says which array was not found, which arrays there are, and how to choose one. `hasNo` begins
 * the sentence. */
std::string describeMissingScalars(
  vtkDataSet* data, const ScalarSelection& selection, const char* hasNo = "The grid has no ");

} // namespace tetmarch

#endif
