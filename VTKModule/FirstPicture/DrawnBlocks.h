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

// The data itself, or the leaves of a tree: those with cells that are no surfaces. Of a block with
// ghost arrays that don't fit it, which hide nothing, but which VTK reads by the number of a cell,
// a shallow copy without these.
std::vector<vtkSmartPointer<vtkDataSet>> drawnBlocks(vtkDataObject* data);

// When the data, or a leaf of a tree, was last modified.
vtkMTimeType timeOf(vtkDataObject* data);

} // namespace tetmarch

#endif
