// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What --list prints.
 */
#ifndef tetmarch_ArrayList_h
#define tetmarch_ArrayList_h

#include <string>
#include <vector>

class vtkTetMarchFirstPicture;

namespace tetmarch
{

/// A table of all arrays, with a star at the chosen one, and a line about the times.
std::string FormatArrayList(vtkTetMarchFirstPicture* choice, const std::vector<double>& times);

} // namespace tetmarch

#endif
