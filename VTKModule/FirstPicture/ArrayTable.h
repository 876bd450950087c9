// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Descriptions of arrays.
#ifndef TetMarchFirstPictureArrayTable_h
#define TetMarchFirstPictureArrayTable_h

#include "FirstPicture/DrawnArray.h"

#include <string>

class vtkTable;

namespace tetmarch
{

// One array per row, as described in vtkTetMarchFirstPicture::ListArrays().
void listArrays(const std::vector<vtkDataSet*>& blocks, vtkTable* arrays);

// "magnitude of velocity on points, 0 to 3.2"; "no array" without one.
std::string describe(const std::vector<vtkDataSet*>& blocks, const DrawnArray& drawn);

} // namespace tetmarch

#endif
