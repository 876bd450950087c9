// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * About a million values of the data, from which transfer functions are chosen.
 */
#ifndef tetmarch_Samples_h
#define tetmarch_Samples_h

#include "ArraySelection.h"

#include <vector>

namespace tetmarch
{

/// The value of a cell, the mean of its points if the array is on points, and the volume of its
/// bounding box.
struct Sample
{
  double Value;
  double Volume;
};

/// The finite values of about a million cells of each block: of images and rectilinear grids every
/// n-th along each axis, of other grids every n-th. Blocks without the array have none.
std::vector<Sample> TakeSamples(
  const std::vector<vtkDataSet*>& blocks, const ArraySelection& selection);

} // namespace tetmarch

#endif
