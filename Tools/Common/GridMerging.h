// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Blocks become one unstructured grid.
 */
#ifndef tetmarch_GridMerging_h
#define tetmarch_GridMerging_h

#include "ProgressBar.h"
#include "VolumeData.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

class vtkDataSet;

namespace tetmarch
{

/// Whether all blocks have an array of numbers of the same name and number of components, which is
/// the wanted one.
bool HaveCommonArray(const std::vector<vtkDataSet*>& blocks, const WantedArray& wanted);

/// Only arrays that all blocks have, with the same number of components, are kept; a warning names
/// the others.
void WarnOfPartialArrays(const std::vector<vtkDataSet*>& blocks);

/// Points of equal coordinates become one. Arrays whose types differ from block to block become
/// arrays of doubles. Throws Cancelled if the report asks to stop.
vtkSmartPointer<vtkUnstructuredGrid> MergeBlocks(
  const std::vector<vtkDataSet*>& blocks, const ProgressReport& report = {});

} // namespace tetmarch

#endif
