// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Values of a sample of cells.
#ifndef TetMarchFirstPictureSamples_h
#define TetMarchFirstPictureSamples_h

#include "FirstPicture/DrawnArray.h"

#include <vector>

namespace tetmarch
{

// The value of a cell, the mean of its points if the array is on points, and the volume of its
// bounding box.
struct Sample
{
  double Value;
  double Volume;
};

// The finite values of about a million cells of each block: every n-th along each axis of images
// and rectilinear grids, every n-th of other grids. Blocks without the array have none.
std::vector<Sample> takeSamples(const std::vector<vtkDataSet*>& blocks, const DrawnArray& drawn);

} // namespace tetmarch

#endif
