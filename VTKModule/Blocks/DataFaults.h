// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with data: one data set, or the blocks of a tree.
#ifndef TetMarchBlocksDataFaults_h
#define TetMarchBlocksDataFaults_h

#include <string>
#include <vector>

class vtkDataObject;

namespace tetmarch
{

/** Returns an empty string if the data can be read, or else what is wrong with the first block that
 * can't (checkData). Surfaces of a tree are not checked, since they are not drawn. */
std::string checkBlocks(vtkDataObject* data);

/** All faults, one of the geometry of each block, and of all its arrays. Empty if the data is
 * sound. */
std::vector<std::string> listFaults(vtkDataObject* data);

} // namespace tetmarch

#endif
