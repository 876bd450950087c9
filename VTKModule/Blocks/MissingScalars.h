// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The error message for a missing array.
#ifndef TetMarchBlocksMissingScalars_h
#define TetMarchBlocksMissingScalars_h

#include <string>

class vtkDataSet;

namespace tetmarch
{

/** As in vtkAbstractMapper: ScalarMode, ArrayAccessMode, ArrayId and ArrayName. */
struct ScalarSelection
{
  int Mode;
  int AccessMode;
  int Id;
  const char* Name; // may be nullptr
};

/** Describes the selected array. */
std::string describe(const ScalarSelection& selection);

/** Names the missing array and the existing ones, and how to choose one. `hasNo` begins the
 * sentence. */
std::string describeMissingScalars(
  vtkDataSet* data, const ScalarSelection& selection, const char* hasNo = "The grid has no ");

} // namespace tetmarch

#endif
