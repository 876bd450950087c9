// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What was read is checked before anything else reads it: files can hold anything.
 */
#ifndef tetmarch_DataChecking_h
#define tetmarch_DataChecking_h

#include <string>
#include <vector>

class vtkDataObject;

namespace tetmarch
{

/// Throws Failure that says what is wrong with points or cells. Takes arrays out of the blocks that
/// have not one tuple for each point or cell, with a warning.
void CheckData(vtkDataObject* data, const std::string& path);

/// All that is wrong with the data, one fault a line.
std::vector<std::string> ListFaults(vtkDataObject* data);

} // namespace tetmarch

#endif
