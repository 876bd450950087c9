// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether what a vtkHyperTreeGrid says of its cells is there.
#ifndef TetMarchInputTreeCheck_h
#define TetMarchInputTreeCheck_h

#include <string>

class vtkHyperTreeGrid;

namespace tetmarch
{

/** An empty string, or why the tree's cells can't be read: its coordinates, its mask or one of its
 * arrays is too short. */
std::string checkTree(vtkHyperTreeGrid* tree);

} // namespace tetmarch

#endif
