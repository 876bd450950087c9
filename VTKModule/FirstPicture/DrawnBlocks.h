// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The blocks of the data that can be drawn.
#ifndef TetMarchFirstPictureDrawnBlocks_h
#define TetMarchFirstPictureDrawnBlocks_h

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkDataObject;

namespace tetmarch
{

// The data itself, or the leaves of a tree with cells, except surfaces. A block with ghost arrays
// of wrong length, which hide nothing, but which VTK indexes by cell, is replaced by a shallow copy
// without them.
std::vector<vtkSmartPointer<vtkDataSet>> drawnBlocks(vtkDataObject* data);

// The time of the last modification of the data, or of a leaf of a tree.
vtkMTimeType timeOf(vtkDataObject* data);

} // namespace tetmarch

#endif
