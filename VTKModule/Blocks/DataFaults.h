// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Faults of data: one data set, or the blocks of a tree.
#ifndef TetMarchBlocksDataFaults_h
#define TetMarchBlocksDataFaults_h

#include <string>
#include <vector>

class vtkDataObject;

namespace tetmarch
{

/** Returns an empty string if the data are valid, or else the error of the first invalid block
 * (checkData). Surfaces of a tree are not checked, since they are not drawn. */
std::string checkBlocks(vtkDataObject* data);

/** All faults: one of the geometry of each block, and those of all its arrays. Empty if the data
 * are valid. */
std::vector<std::string> listFaults(vtkDataObject* data);

} // namespace tetmarch

#endif
