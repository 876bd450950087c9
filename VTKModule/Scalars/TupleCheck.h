// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks whether an array has a value for each point or cell.
#ifndef TetMarchScalarsTupleCheck_h
#define TetMarchScalarsTupleCheck_h

#include <string>

class vtkAbstractArray;
class vtkDataSet;

namespace tetmarch
{

/** Returns an empty string if the array has one tuple for each point or cell of the data, or else
 * an error. */
std::string checkTuples(vtkDataSet* data, vtkAbstractArray* array, bool ofCells);

} // namespace tetmarch

#endif
